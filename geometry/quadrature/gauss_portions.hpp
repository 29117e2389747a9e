// SPDX-License-Identifier: GPL-3.0-or-later
// How many Gauss points a portion of a curve takes, so that integrals of polynomials along it are right to rounding.
//
// Lines: the exact count. Circles: the integrand is a trigonometric polynomial; points for its degree times the angle, which
// hold the patch test on discs to 1e-9. Ellipses and splines: Gauss's error for n points is at most
//     (64/15) M rho^-2(n-1) / (1 - rho^-2)    [Trefethen13, theorem 19.3]
// with M the integrand's largest value on the Bernstein ellipse of parameter rho around the portion. M has a closed bound:
//   sigma = (rho + 1/rho) / 2, on which a polynomial with Bernstein coefficients a_i over the portion is <= max|a_i| sigma^n;
//   weights between c - d and c + d over the portion: |w| >= c - d sigma^n, which is how the ratio of the weights limits rho;
//   points: |x - x_m| <= delta max(w) sigma^n / (c - d sigma^n), x_m the middle of the portion's control points;
//   the density ds/dz = root of (x' + i y')(x' - i y'): coefficients of the velocity within r of their middle v, seen as
//   complex numbers, keep it off zero where r sigma^m < |v|;
//
//   ellipses about the portion's middle, v = half angle x sigma:
//   |x - x_m| <= |x'_m| sinh v + |x_m - center| (cosh v - 1).
//
// The rho that asks for the fewest points is taken; where that are still many, the portion is halved. Polynomial splines take
// no more than their exact count.
#pragma once
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// n Gauss points over the parameters [t0, t1].
struct GaussPortion {
    double t0, t1;
    int n;
};

/// Appends portions that cover [t0, t1], no knot inside, for integrals of F(x, y) dy with F of degree 2 degree + 1 in x and 2
/// degree in y. `cell`: the lengths of a cell's sides, the portion inside it; errors are below gauss_tolerance for polynomials
/// of size 1 on the cell, in units of its area. Cost: some 10 ns for lines and circles, 1 us for the others.
void append_area_portions(std::vector<GaussPortion>& portions, const Curve& curve, double t0, double t1, int degree,
                          const Vec2& cell);

/// Appends portions that cover [t0, t1] for integrals of f(x, y) ds with f of total degree 2n - 1: n points on lines; errors in
/// units of the portion's length.
void append_length_portions(std::vector<GaussPortion>& portions, const Curve& curve, double t0, double t1, int n,
                            const Vec2& cell);

inline constexpr double gauss_tolerance = 1e-14;

}  // namespace abut::geometry
