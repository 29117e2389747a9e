// SPDX-License-Identifier: GPL-3.0-or-later
// One rational Bezier span over s in [0, 1]: what the spans of a spline answer, and its faults are found on.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "geometry/curves/vec2.hpp"

namespace abut::geometry {

/// One rational Bezier span, a view; weights are empty where they are all equal.
struct BezierSpan {
    std::span<const Vec2> points;
    std::span<const double> weights;
};

/// The point and the first two derivatives by s. The ends are the control points bit for bit. At an end where the curve stands
/// still, the derivative is the one a rounding of s further in: its direction is the limit of the tangents.
std::array<Vec2, 3> evaluate(const BezierSpan& span, double s);
/// The arc length from s0 to s1, signed, to rounding.
double length(const BezierSpan& span, double s0, double s1);

/// Bernstein coefficients of a positive multiple of dx/ds (axis 0) or dy/ds (axis 1), and bounds of their errors for points
/// that are known to rounding.
struct Velocity {
    std::vector<double> coefficients, errors;
};
Velocity velocity(const BezierSpan& span, int axis);

/// The length of the control polygon, no shorter than the curve.
double polygon_length(std::span<const Vec2> points);

/// How far rounding takes points: coordinate_roundings of the largest coordinate.
double rounding_length(std::span<const Vec2> points);
inline constexpr double coordinate_roundings = 8;

}  // namespace abut::geometry
