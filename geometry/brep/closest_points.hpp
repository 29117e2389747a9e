// SPDX-License-Identifier: GPL-3.0-or-later
// The closest points of two boundaries.
#pragma once
#include <optional>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// A pair of points of two boundaries, one on each, with the edges that they are on.
struct ClosestPoints {
    double distance = 0;  ///< 0 where the boundaries cross or touch
    int edge1 = -1, edge2 = -1;
    double t1 = 0, t2 = 0;  ///< parameters of the edges' curves
    Vec2 x1{0, 0}, x2{0, 0};
};

/// Closest points of two curves. Exact: ends, crossings and parallel normals are the only candidates.
ClosestPoints closest_points(const Curve& curve1, const Curve& curve2);

/// Closest points of two boundaries; none where these are farther apart than `limit`. Of equally close pairs (within rounding)
/// the first along part 1.
std::optional<ClosestPoints> closest_points(const Part& part1, const Part& part2, double limit);

}  // namespace abut::geometry
