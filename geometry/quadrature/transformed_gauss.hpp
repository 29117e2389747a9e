// SPDX-License-Identifier: GPL-3.0-or-later
// The dissertation's rule for cut cells, for integrands that are no polynomials [Grishin10, section 4.4 and eq 4.18]:
//   integral of phi = sum over (nu, mu) of (beta - alpha) g_nu g_mu (g(t_nu) - f(t_nu)) phi(t_nu, t_mu),
// Gauss points t_nu over [alpha, beta] along one axis, and from the boundary f to the boundary g along the other Gauss points
// again. With the subdivision of [Hoellig03]: [alpha, beta] ends wherever a contour of the element does, so that f and g are
// each one smooth piece of the boundary or one side of the cell.
//
//     +-----------+        Along y (dots: ends of contours) this cell has three patches, along x two: the axis is the one
//     |   .___....|        that takes fewer points.
//     |  /####\   |
//     |./######\..|
//     +-----------+
//
// Between a curve and something straight, t_nu are Gauss points in the curve's own parameter: circles at their extreme points
// and steep inflections are then as smooth as elsewhere. Between two curves they are Gauss points in the coordinate, or in the
// root of its distance from where f or g is about as steep as a circle beside its extreme point.
#pragma once
#include <vector>

#include "geometry/quadrature/quadrature.hpp"

namespace abut::geometry {

/// Rules of every element of every boundary cell, in the order of cell_rules, with all points inside the element (on true
/// curves, to rounding) and all weights positive; the rule of an element whose fraction is a rounding may be empty.
///   - Straight pieces: exact for products of two tensor polynomials of the given degree.
///   - Curves: the number of points follows from degree and curve as for cell_rules; measured errors of such polynomials are
///     below 1e-10 of the cell's area, and between two steep curves close to each other (thin rings) below 1e-7.
///   - Other integrands: `extra` more points each way in every patch. The order rises by two with each, in h; at fixed h the
///     error of smooth functions falls exponentially (tested: to 1/50 or less with every two, down to 1e-11).
/// What is between contours that end within sliver_fraction of a cell's height of each other is left out. Measured cost: 1 us
/// an element on lines, 2 us on circles, 7 us on ellipses and 14 us on splines; more between two curves, where each row of
/// points is a Newton iteration.
std::vector<CellRule> transformed_rules(const Part& part, const CutCells& cells, const Elements& elements, int degree,
                                        int extra = 0);

}  // namespace abut::geometry
