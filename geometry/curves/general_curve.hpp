// SPDX-License-Identifier: GPL-3.0-or-later
// What curves without closed forms (ellipses, splines) answer numerically.
#pragma once
#include <array>
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// The point and the first two derivatives by t of an ellipse or a spline.
std::array<Vec2, 3> general_values(const Curve& curve, double t);
/// The signed arc length from t0 to t1, by Gauss rules on pieces halved until two rules agree to rounding.
double general_length(const Curve& curve, double t0, double t1);
/// length_by_gauss: the arc length from t0 to t1 by one rule on all of it. lengths_agree: does the sum of two halves by the
/// rule agree with the whole to rounding? total: the length of the whole curve.
double length_by_gauss(const Curve& curve, double t0, double t1);
bool lengths_agree(double halves, double whole, double total);
/// The speed of a flat ellipse is singular at complex parameters as near to the real ones as b / a: log2(a / b) halvings.
inline constexpr int most_length_halvings = 50;
/// The parameter at arc length s, the inverse of general_length(curve, 0, t), by safeguarded Newton.
double general_parameter_at_length(const Curve& curve, double s);
/// The parameter of the point closest to p; the smallest of those that are equally close within rounding. Control boxes of
/// spans bound the distance from below; on spans within reach all minima are found by the changes of sign of the Bernstein
/// coefficients of (x(t) - p) . x'(t), then by safeguarded Newton on the curve itself. Allocates nothing; 2-10 microseconds.
double general_closest_parameter(const Curve& curve, const Vec2& p);
/// The parameter in [t0, t1], on which coordinate `axis` is monotone, where that coordinate is c (the nearer end where it is
/// not reached): bisection and Newton down to rounding.
double monotone_crossing(const Curve& curve, double t0, double t1, int axis, double c);

}  // namespace abut::geometry
