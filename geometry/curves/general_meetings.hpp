// SPDX-License-Identifier: GPL-3.0-or-later
// meeting_points (curve_meetings.hpp) where at least one of the curves is an ellipse or a spline.
#pragma once
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// Points within `tolerance` of both curves, in four steps:
/// 1. Arcs of both curves' arc splines whose boxes come within the tolerances.         (piece_pairs)
/// 2. Where these arcs meet within the tolerances: starting points, in closed form.    (curve_meetings)
/// 3. From each, the crossing and the closest approach of the true curves by Newton.   (curve_polish)
///    Where the closest approach is a penetration, the crossings on both sides of it: two curves may cross twice inside the
///    arcs' tolerance.
/// 4. What lies within `tolerance` of both curves is kept; of a stretch that the curves share, its ends (and theirs).
std::vector<Vec2> general_meeting_points(const Curve& a, const Curve& b, double tolerance);

}  // namespace abut::geometry
