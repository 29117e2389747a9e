// SPDX-License-Identifier: GPL-3.0-or-later
// Portions of general curves as rational Bezier spans of homogeneous coordinates: of fixed size, so that the loops that halve
// them allocate nothing. Ellipses are rational quadratics.
#pragma once
#include <array>

#include "geometry/curves/elliptic_arc.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry {

/// Polynomial on [0, 1] by its Bernstein coefficients. The highest degree that occurs: (c - p) . c' of a rational span.
struct Bernstein {
    static constexpr int max_degree = 3 * max_spline_degree - 1;
    int degree = 0;
    std::array<double, max_degree + 1> c{};
    double& operator[](int i) { return c[static_cast<std::size_t>(i)]; }
    double operator[](int i) const { return c[static_cast<std::size_t>(i)]; }
};

/// n over k, exact; n up to Bernstein::max_degree.
double binomial(std::size_t n, std::size_t k);

Bernstein operator+(const Bernstein& a, const Bernstein& b);  ///< of equal degree
Bernstein operator-(const Bernstein& a, const Bernstein& b);  ///< of equal degree
Bernstein operator*(double factor, const Bernstein& a);
Bernstein operator*(const Bernstein& a, const Bernstein& b);
Bernstein derivative(const Bernstein& a);
/// The polynomial over [0, 1/2] and over [1/2, 1], and over [s0, s1], each with coefficients on a [0, 1] of its own.
std::array<Bernstein, 2> halves(const Bernstein& a);
Bernstein portion(const Bernstein& a, double s0, double s1);
double largest(const Bernstein& a);  ///< absolute value of a coefficient

/// A portion of a curve as points (x, y) / w, relative to an origin. Where not rational, w is 1 and of degree 0.
struct HomogeneousSpan {
    Bernstein x, y, w;
    bool rational = false;
};

/// Span k of a spline's shape in homogeneous coordinates.
HomogeneousSpan homogeneous_span(const SplineShape& shape, std::size_t k, const Vec2& origin);
/// The ellipse of these axes (its start and sweep do not matter) between two eccentric angles less than pi apart. Its parameter
/// s belongs to the angle (u0 + u1) / 2 + 2 atan((2s - 1) tan((u1 - u0) / 4)).
HomogeneousSpan homogeneous_span(const EllipticArc& ellipse, double u0, double u1, const Vec2& origin);
HomogeneousSpan portion(const HomogeneousSpan& span, double s0, double s1);
/// The box of the control points, which holds the span.
Box2 control_box(const HomogeneousSpan& span);
/// An upper bound of the angle by which the tangent turns, left and right turns both counted positive: that of the control
/// polygon of the tangent's direction, on four portions.
double turning_bound(const HomogeneousSpan& span);

}  // namespace abut::geometry
