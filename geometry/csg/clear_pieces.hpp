// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and arcs of an outline that interval arithmetic proves to have nothing but corners in common: all but a few of the
// pairs that come near each other.
#pragma once
#include <array>
#include <vector>

#include "geometry/curves/vec2.hpp"

namespace abut::geometry {

/// The line from `from` to `to`, or the circle arc there through `middle`, as exact as these doubles are.
struct OutlinePiece {
    Vec2 from, middle, to;
    int turn = 0;              ///< 0: a line; 1: an arc that turns left, -1: right
    bool begins_edge = false;  ///< an edge of the part begins at `from`
};

/// Each point of a piece lies in `hull`, a convex polygon that runs counter-clockwise (of a line: its ends). Its corners are
/// known to lie in boxes.
struct HulledPiece {
    OutlinePiece piece;
    std::vector<Box2> hull;
    Box2 box;  ///< of the hull
};

/// Of an arc the ends and where the tangents at its ends meet the one at its middle. Without hull where rounding hides that
/// (an arc of a full turn, all but a bit).
HulledPiece hulled(const OutlinePiece& piece);

/// Ends that both have: none, one or two.
std::vector<Vec2> shared_corners(const OutlinePiece& a, const OutlinePiece& b);

/// Is it certain that the pieces have nothing in common but the corners that they share? Cost some microseconds at most.
bool clearly_meet_at_corners_only(const HulledPiece& a, const HulledPiece& b);

}  // namespace abut::geometry
