// SPDX-License-Identifier: GPL-3.0-or-later
// What curves without closed forms (ellipses, splines) answer numerically.
#pragma once
#include <array>
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// Point and the first two derivatives by t of an ellipse or a spline.
std::array<Vec2, 3> general_values(const Curve& curve, double t);
/// Signed arc length from t0 to t1, by Gauss rules on pieces halved until two rules agree to rounding.
double general_length(const Curve& curve, double t0, double t1);
/// The rule on [t0, t1] alone; do the rule's lengths of two halves agree with that of the whole to rounding? total: of the
/// curve.
double length_by_gauss(const Curve& curve, double t0, double t1);
bool lengths_agree(double halves, double whole, double total);
/// The speed of a flat ellipse is singular at complex parameters as near to the real ones as b / a: log2(a / b) halvings.
inline constexpr int most_length_halvings = 50;
/// Inverse of general_length(curve, 0, t), by safeguarded Newton.
double general_parameter_at_length(const Curve& curve, double s);
/// Global minimum of the distance to p; the smallest parameter of those that are equally close within rounding. Control boxes
/// of spans bound the distance from below; on spans within reach all minima are found by the changes of sign of the Bernstein
/// coefficients of (x(t) - p) . x'(t), then by safeguarded Newton on the curve itself. Allocates nothing; 2-10 microseconds.
double general_closest_parameter(const Curve& curve, const Vec2& p);
/// The parameter in [t0, t1], on which coordinate `axis` is monotone, where that coordinate is c (the nearer end where it is
/// not reached): bisection and Newton down to rounding.
double monotone_crossing(const Curve& curve, double t0, double t1, int axis, double c);

}  // namespace abut::geometry
