// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/cut_quality.hpp"

#include <algorithm>

#include "geometry/quadrature/rule_check.hpp"

namespace abut {

namespace {

/// The rules as the solver has them, which is what is to be checked.
std::vector<geometry::CellRule> rules_in_use(const PartOnGrid& grid) {
    std::vector<geometry::CellRule> rules;
    for (const solver::CellRule& r : grid.input.cut_rules) rules.push_back({r.element, r.points, r.weights});
    return rules;
}

}  // namespace

CutQuality cut_quality(const PartOnGrid& grid) {
    CutQuality quality;
    for (double fraction : grid.elements.fraction)
        if (fraction > 0) quality.smallest_fraction = std::min(quality.smallest_fraction, fraction);
    const solver::SplineSpace& space = grid.input.space;
    quality.split_cells = static_cast<int>(grid.elements.cell_of_extra.size());
    quality.extended = space.n_extended;
    quality.taken_apart = space.taken_apart();
    const int degree = std::max(space.x.degree, space.y.degree);
    const geometry::RuleCheck c = check_rules(grid.local, grid.cells, grid.elements, rules_in_use(grid), degree);
    quality.self_check = {c.area, c.centroid, c.divergence, c.points, c.negative_weights, c.outside_cell};
    return quality;
}

}  // namespace abut
