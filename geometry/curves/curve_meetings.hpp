// SPDX-License-Identifier: GPL-3.0-or-later
// Where two curves come together.
#pragma once
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// Points that lie within `tolerance` of both curves: crossings, touching points, ends that lie on the other curve, and the
/// ends of stretches that the curves share. Not empty whenever the curves come closer than the tolerance; points may repeat.
std::vector<Vec2> meeting_points(const Curve& a, const Curve& b, double tolerance);

}  // namespace abut::geometry
