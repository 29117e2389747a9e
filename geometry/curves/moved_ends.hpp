// SPDX-License-Identifier: GPL-3.0-or-later
// Ellipses and splines brought to begin and end at given places near their own ends.
#pragma once
#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// The curve (an elliptic arc or a spline) from `from` to `to`, to rounding; no point moves by much more than the ends do.
/// 1. An ellipse whose ends come to one place, and are near each other, becomes a full one.
/// 2. Where the ends are well apart, the curve is turned and scaled as a whole.
/// 3. Where they are not (the curve nearly closes on itself, and a small change of the distance of its ends would scale it by
/// any
///    factor), each point moves by what the ends move, in the proportion of the parameter. An ellipse becomes a spline by that;
///    where a spline's spans join, the tangent may get a corner of the angle move / length of a span.
Curve with_moved_ends(const Curve& curve, const Vec2& from, const Vec2& to);

}  // namespace abut::geometry
