// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/around_axis.hpp"

#include "src/base/index.hpp"
#include "src/plan/axisymmetric.hpp"

namespace abut {

void put_around_axis(const Scene& scene, PartOnGrid& g) {
    const ScenePart& part = scene.parts[at(g.part)];
    const double merge = merge_length(part.part), front = g.cells.grid.x.front(), axis = -g.frame.shift.x();
    if (g.frame.s != 0)
        throw InputError("/accuracy/grids/" + part.name + "/angle", "a turned grid does not follow the axis",
                         "leave 'angle' out in an axisymmetric analysis");
    if (front < axis - merge)
        throw InputError("/accuracy/grids/" + part.name, "the grid of part " + part.name + " reaches over the axis x = 0",
                         "begin its x lines at 0 or beyond");
    solver::PartInput& input = g.input;
    input.touches_axis = touches_axis(part.part);
    // the part's edge is on that line but for rounding, and so is the radius 0
    input.axis = input.touches_axis ? front : axis;
    for (solver::CellRule& rule : input.cut_rules) {
        solver::CellRule kept{rule.element, {}, {}};
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const double r = rule.points[k].x() - *input.axis;
            if (r <= 0) continue;  // of weight 0
            kept.points.push_back(rule.points[k]);
            kept.weights.push_back(r * rule.weights[k]);
        }
        rule = std::move(kept);
    }
}

}  // namespace abut
