// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/pass_cost.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "src/base/index.hpp"
#include "src/discretization/shared_grids.hpp"
#include "src/io/number_text.hpp"
#include "src/plan/rigid_parts.hpp"

namespace abut {

namespace {

double n_filled(const PartOnGrid& grid) {
    const std::vector<geometry::CellClass>& classes = grid.cells.cell_class;
    return static_cast<double>(classes.size()) -
           static_cast<double>(std::count(classes.begin(), classes.end(), geometry::CellClass::outer));
}

}  // namespace

PassCost cost_of_pass(const Scene& scene, const ResolvedConditions& conditions, const std::vector<bool>& parts,
                      const WantedSizes& wanted, double coarseness, const SolvedAssembly& now, double last_seconds) {
    double unknowns = 0, cells = 0, next_cells = 0;
    for (const PartOnGrid& grid : now.grids) {
        if (grid.is_rigid) continue;
        unknowns += 2 * grid.input.space.n_functions;
        cells += n_filled(grid);
    }
    std::map<int, double> of_model;  // and of its copies
    for (const DesignedGrid& next : design_grids(scene, conditions, parts, wanted, coarseness, 1)) {
        if (!why_rigid(scene, next.part).empty()) continue;
        if (next.model < 0) of_model[next.part] = n_filled(next.grid.local, next.grid.grid);
        next_cells += of_model.at(next.model < 0 ? next.part : next.model);
    }
    if (cells == 0) return {};
    const double growth = next_cells / cells;
    return {growth * unknowns, last_seconds * std::pow(growth, time_growth_exponent), growth * unknowns * bytes_per_unknown};
}

bool is_beyond(const Budget& budget, double spent, const PassCost& cost) {
    return (budget.seconds && spent + cost.seconds > *budget.seconds) || (budget.bytes && cost.bytes > *budget.bytes);
}

std::string cost_text(const PassCost& cost) {
    return "of about " + number_text(cost.unknowns, 2) + " unknowns, in " + number_text(cost.seconds, 2) + " s and " +
           number_text(cost.bytes / 1e9, 2) + " GB";
}

}  // namespace abut
