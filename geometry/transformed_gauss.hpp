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
// Where f or g is about as steep as a circle beside its extreme point, as the root of a distance d from it, points are Gauss's
// in the root of the distance, which makes the integrand smooth again.
#pragma once
#include <vector>

#include "geometry/quadrature.hpp"

namespace abut::geometry {

/// All points are inside the element (on true curves, to rounding), all weights positive. One rule for every element of every
/// boundary cell, as of cell_rules; of elements whose fraction is a rounding it may be empty.
///   - Straight pieces: exact for products of two tensor polynomials of the given degree.
///   - Curves: the number of points follows from degree and curve as for cell_rules; measured errors of such polynomials are
///     below 1e-10 of the cell's area, and fall exponentially with `extra`.
///   - Other integrands: `extra` more points in each direction and patch, each of which raises the order by two.
/// Where several contours end within sliver_fraction of a cell's height of each other, what is between is left out.
/// Cost about 1 us an element and 20 ns a point along curves.
std::vector<CellRule> transformed_rules(const Part& part, const CutCells& cells, const Elements& elements, int degree,
                                        int extra = 0);

}  // namespace abut::geometry
