// SPDX-License-Identifier: GPL-3.0-or-later
// Does the quadrature of a part know its area, its centroid and the divergence theorem?
#pragma once
#include <vector>

#include "geometry/quadrature/quadrature.hpp"

namespace abut::geometry {

/// How well a part's quadrature knows the part.
struct RuleCheck {
    double area = 0;        ///< error relative to the part's area
    double centroid = 0;    ///< distance from the part's centroid, in diagonals of the grid
    double divergence = 0;  ///< largest |integral of div F - integral of F.n| over the part's area, |div F| <= 1
    std::size_t points = 0;
    std::size_t negative_weights = 0;
    std::size_t outside_cell = 0;  ///< points outside their element's cell by more than the merge length
};

/// Checks the rules of all boundary cells together with the inner cells, which count as exact. The fields F are products of
/// Legendre polynomials over the grid's box, up to degree 2 `degree` in x, in y and in both; their flux is taken by
/// boundary_rule. Errors of exact rules are a few hundred roundings of the grid's area over the part's: 1e-13 and less. A cell
/// forgotten, a degree too low, or a grid that misses some of the part show. Cost: 15 ns a point, and boundary_rule along all
/// edges with 2 degree + 1 points a piece; measured, 1 to 3 times that of cell_rules.
RuleCheck check_rules(const Part& part, const CutCells& cells, const Elements& elements, const std::vector<CellRule>& rules,
                      int degree);

}  // namespace abut::geometry
