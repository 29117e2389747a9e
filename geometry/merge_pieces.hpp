// SPDX-License-Identifier: GPL-3.0-or-later
// Joins what a Boolean leaves behind (halves of circles, split lines) to whole pieces of the primitives' edges.
#pragma once
#include <limits>
#include <vector>

#include "geometry/csg_names.hpp"

namespace abut::geometry {

/// Sources that are no primitive's edge.
inline constexpr int bridge_source = std::numeric_limits<int>::max();   ///< joins two tangential edges, see boolean.hpp
inline constexpr int far_source = std::numeric_limits<int>::max() - 1;  ///< the artificial end of a half plane

/// A monotone piece of a boundary as the exact arithmetic gives it, rounded.
struct RawPiece {
    int source = -1;
    Vec2 from, to;
    int from_vertex = -1;  ///< equal numbers: the same point exactly
    int turn = 0;          ///< 0 line, +1 counter-clockwise arc, -1 clockwise arc
};

/// Ends nearer than this fraction of the size (plus distance from the origin) are one point; loops thinner than it in the mean
/// are what rounding leaves between two edges meant to coincide, and are dropped.
inline constexpr double sliver_width_fraction = 1e-12;

/// Splits loops where they touch themselves, drops bridges and slivers, merges adjacent pieces of one source edge, and restores
/// the curves from their sources. A circle that survives as a whole is one piece from its own angle 0.
std::vector<std::vector<Piece>> merge_pieces(const std::vector<std::vector<RawPiece>>& loops,
                                             const std::vector<PlacedSource>& sources);

}  // namespace abut::geometry
