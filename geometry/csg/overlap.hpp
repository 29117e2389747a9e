// SPDX-License-Identifier: GPL-3.0-or-later
// What two parts have in common.
#pragma once
#include <vector>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// The region that two parts have in common: its area and how deep it is, and where.
struct Overlap {
    double area = 0;
    double depth = 0;            ///< how far the boundary of one part reaches into the other's material, at most
    int edge1 = -1, edge2 = -1;  ///< there: the edge that reaches in, and the one of the other part that is nearest
    Vec2 at{0, 0};               ///< on the edge that reaches in
};

/// The region common to both parts, by exact arithmetic (common_boundary), and its area by Green's theorem over its boundary.
/// What is no deeper than `tolerance` is rounding: parts that only touch have nothing in common. The depth is that of the
/// deepest of some points along each stretch of the boundary, its middle among them: short by some thousandths where the
/// deepest point lies elsewhere. Of parts that coincide no boundary lies inside: the depth is then the mean thickness, twice
/// the area over the perimeter. Cost O((edges + pairs that come near) log(edges)).
Overlap overlap(const Part& part1, const Part& part2, double tolerance);

/// Finds the overlap within each loop of that region's boundary by itself, in no particular order. Cost: of the square of the
/// loops' stretches, too.
std::vector<Overlap> overlaps(const Part& part1, const Part& part2, double tolerance);

/// Joins several to one: the deepest, with the area of all.
Overlap joined(const std::vector<Overlap>& overlaps);

}  // namespace abut::geometry
