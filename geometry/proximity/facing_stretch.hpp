// SPDX-License-Identifier: GPL-3.0-or-later
// Where one edge of a part faces one edge of another: the pieces from which facing zones are joined. Edges here are lines and
// circles; ellipses and splines come as their arcs (facing_general).
#pragma once
#include <optional>
#include <vector>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// A pair of points of two edges, by arc length along each edge.
struct EdgePair {
    double s1 = 0, s2 = 0;
    Vec2 x1{0, 0}, x2{0, 0};
    double gap = 0;
    double opposition = 0;  ///< -n1.n2, 1 where the normals oppose each other exactly
};

/// A stretch of edge1 that faces edge2: between begin and end every point of edge1 has its partner on edge2; the gap is
/// monotone. begin.s1 < end.s1, begin.s2 > end.s2.
struct FacingStretch {
    int edge1 = -1, edge2 = -1;
    EdgePair begin, end;
};

/// Normals oppose each other within 60 degrees: prisms of 60 degrees are drawn often, and count however they are turned.
inline constexpr double least_opposition = 0.5 - 1e-9;
/// The fraction of their distance to which neighbouring points may draw together on the way to the middle curve: at the centre
/// of curvature of either side the pairing folds back, and closer to it points have no partners.
inline constexpr double least_spread = 0.05;

/// Everything the search needs to know about the two parts, made once.
struct FacingModel {
    FacingModel(const Part& first, const Part& second, double search_distance);
    const Part& part1;
    const Part& part2;
    EdgeTree tree1, tree2;
    double distance;
    double size;  ///< both diagonals together
    double same;  ///< lengths below are rounding: same_fraction of the size
    double thin;  ///< gaps below are not looked into for material in between
    static constexpr double same_fraction = 1e-11;
};

/// The partner on edge2 (or its continuation) of the point at s1 of edge1; none where the normals do not oppose each other at
/// all.
std::optional<EdgePair> pair_on_edges(const FacingModel& model, int edge1, int edge2, double s1);

/// All stretches of an edge pair that meet distance, angle and line of sight. Cost: a few dozen closed-form pairs.
std::vector<FacingStretch> facing_stretches(const FacingModel& model, int edge1, int edge2);

}  // namespace abut::geometry
