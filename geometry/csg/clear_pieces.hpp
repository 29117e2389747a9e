// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and arcs of an outline that interval arithmetic proves to have nothing but corners in common: all but a few of the
// pairs that come near each other.
#pragma once
#include <array>
#include <vector>

#include "geometry/brep/edge_tree.hpp"

namespace abut::geometry {

/// The line from `from` to `to`, or the circle arc there through `middle`, as exact as these doubles are. It is, or follows,
/// the portion [t0, t1] of an edge of a part.
struct OutlinePiece {
    Vec2 from, middle, to;
    int turn = 0;  ///< 0: a line; 1: an arc that turns left, -1: right
    int edge = -1;
    double t0 = 0, t1 = 1;

    bool begins_edge() const { return t0 == 0; }
};

/// The point of a piece of at most a quarter turn above the point of its chord that is `share` of it away from its begin; and
/// the share of a point of it.
Vec2 point_above(const OutlinePiece& piece, double share);
double share_of(const OutlinePiece& piece, const Vec2& p);

/// Each point of a piece lies in `hull`, a convex polygon that runs counter-clockwise (of a line: its ends). Its corners are
/// known to lie in boxes.
struct HulledPiece {
    OutlinePiece piece;
    std::vector<Box2> hull;
    Box2 box;  ///< of the hull
};

/// A piece with its hull: of an arc its ends, and where the tangents there meet the one at its middle. Without hull where
/// rounding hides that (an arc of a full turn, all but a bit).
HulledPiece hulled(const OutlinePiece& piece);

/// The pieces of an outline, loop after loop, and a tree of their boxes.
struct Outline {
    std::vector<HulledPiece> pieces;
    std::vector<std::size_t> begin_of_loop;  ///< and the number of pieces
    EdgeTree tree;
    bool is_sound = true;  ///< every piece has a hull and two ends
};
Outline outline_of(const std::vector<std::vector<OutlinePiece>>& loops);

/// Ends that both have: none, one or two.
std::vector<Vec2> shared_corners(const OutlinePiece& a, const OutlinePiece& b);

/// Is it certain that the pieces have nothing in common but the corners that they share? Cost some microseconds at most.
bool clearly_meet_at_corners_only(const HulledPiece& a, const HulledPiece& b);

}  // namespace abut::geometry
