// SPDX-License-Identifier: GPL-3.0-or-later
// What exact arithmetic says of a part's outline, whatever it came from. CGAL stays behind this header, in one file.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "geometry/brep/part.hpp"
#include "geometry/csg/clear_pieces.hpp"

namespace abut::geometry {

/// What is wrong with an outline, in words for the user, and where.
struct OutlineFault {
    std::string what;
    std::string hint;
    Vec2 at{0, 0};
};

/// Puts the part's loops into an arrangement of lines and circle arcs in exact arithmetic and looks at it: its edges must have
/// nothing but corners in common, and the winding number of every face be 0 or 1, by which loops are closed, do not cross or
/// coincide, run the right way round and lie within each other as they should. Loops may touch at a corner, and what
/// two edges that leave a corner along one tangent do within the merge length of it is rounding. Corners are the
/// doubles of where an edge begins; an arc is the one through its ends and its middle; ellipses and splines are taken by their
/// arc splines. Empty: nothing is wrong. Cost O(n log n), that of is_surely_right for nearly all that is right, and that of
/// swept_fault besides for the rest.
std::optional<OutlineFault> exact_fault(const Part& part);

/// What exact_fault finds, by CGAL's sweep over the whole outline, whatever is wrong with it. Cost O(n log n), some 15
/// microseconds for each line and 40 for each arc.
std::optional<OutlineFault> swept_fault(const Part& part);

/// Is there a proof, by exact arithmetic on the pairs of edges that come near each other, that swept_fault finds nothing? Some
/// 2 to 5 microseconds for each line or arc.
bool is_surely_right(const Part& part);

/// The outline as lines and arcs of at most a quarter turn; ellipses and splines by their arc splines within `tolerance`. What
/// lies wholly off the box `near` is drawn straight, or left out where it closes by itself: places in the box do not see that.
Outline fine_outline(const Part& part, double tolerance, const Box2& near);

/// A point that two pieces have in common, or a stretch of both; rounded.
struct CommonOfPieces {
    Vec2 begin{0, 0}, end{0, 0};  ///< in no particular order; of a point the same
    bool is_stretch = false;
    bool is_shared_corner = false;  ///< exactly
};
/// What pieces of two outlines have in common. Keeps the exact curves made of each piece.
class PieceMeetings {
public:
    /// The outlines must outlive it.
    PieceMeetings(const Outline& a, const Outline& b);
    ~PieceMeetings();
    PieceMeetings(const PieceMeetings&) = delete;
    PieceMeetings& operator=(const PieceMeetings&) = delete;
    /// All that piece i of a and piece j of b have in common, some points twice. Cost 10 to 500 microseconds.
    std::vector<CommonOfPieces> of(std::size_t i, std::size_t j);

private:
    struct Known;
    std::unique_ptr<Known> known_;
};

/// A place exactly on a piece, within rounding of point_above(piece, share).
struct PlaceOnPiece {
    OutlinePiece piece;
    double share = 0.5;
};
/// How often an outline winds around each place, moved up by some d as small as you like, and to the right by d^1.5: it is then
/// on no chord and no circle. Cost O(n log n) for the outline's pieces, and a few microseconds a place; 100 where it lies
/// within rounding of the outline.
std::vector<int> windings_around(const Outline& outline, const std::vector<PlaceOnPiece>& places);

}  // namespace abut::geometry
