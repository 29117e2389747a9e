// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/singular_errors.hpp"

#include <algorithm>
#include <cmath>

#include "solver/terms/stress.hpp"
#include "src/analysis/singular_places.hpp"
#include "src/analysis/stress_error.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

/// Energy within a distance of a re-entrant right angle grows with this power of it; places that are less sharp with a higher
/// one.
constexpr double power = 1.1;

/// Of the target: the rest is left for all that is not singular.
constexpr double aimed_share = 0.5;

/// Columns and rows of a space's cells, ends excluded.
struct CellRange {
    int columns[2], rows[2];

    bool holds(int column, int row) const {
        return columns[0] <= column && column < columns[1] && rows[0] <= row && row < rows[1];
    }
};

int interval_of(const std::vector<double>& lines, double v) {
    const auto after = std::upper_bound(lines.begin() + 1, lines.end() - 1, v);
    return static_cast<int>(after - lines.begin()) - 1;
}

void cells_between(const std::vector<double>& lines, double low, double high, int (&range)[2]) {
    range[0] = interval_of(lines, low);
    range[1] = interval_of(lines, high) + 1;
}

void append_errors(const SolvedAssembly& solved, std::size_t k, const std::vector<SingularPlace>& places,
                   std::vector<SingularError>& errors) {
    const PartOnGrid& grid = solved.grids[k];
    const solver::SplineSpace& space = grid.input.space;
    const std::vector<double>&x = space.x.breakpoints, &y = space.y.breakpoints;
    const std::size_t first = errors.size();
    std::vector<CellRange> around;
    for (const SingularPlace& place : places) {
        const Vec2 local = grid.frame.to_local(place.at);
        const auto i = static_cast<std::size_t>(interval_of(x, local.x())),
                   j = static_cast<std::size_t>(interval_of(y, local.y()));
        const double cell = std::max(x[i + 1] - x[i], y[j + 1] - y[j]);
        errors.push_back({k, place.at, place.is_of_contact, cell, 0});
        CellRange& range = around.emplace_back();
        cells_between(x, local.x() - cell, local.x() + cell, range.columns);
        cells_between(y, local.y() - cell, local.y() + cell, range.rows);
    }
    const solver::StressOf stress(grid.input, solved.solution.displacement[k]);
    for_all_cells(grid.input, [&](const solver::CellRule& cell) {
        const int column = space.column_of(cell.element), row = space.row_of(cell.element);
        double energy = -1;
        for (std::size_t p = 0; p < around.size(); ++p) {
            if (!around[p].holds(column, row)) continue;
            if (energy < 0) energy = strain_energy(grid.input, stress, cell);
            errors[first + p].energy += places[p].missed_share * energy;
        }
    });
}

}  // namespace

std::vector<SingularError> singular_errors(const Scene& scene, const ResolvedConditions& conditions,
                                           const SolvedAssembly& solved) {
    std::vector<SingularError> errors;
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        if (solved.grids[k].is_rigid) continue;
        std::vector<SingularPlace> places = singular_places(scene, conditions, solved, solved.grids[k].part);
        std::erase_if(places, [](const SingularPlace& place) { return place.missed_share == 0; });
        if (!places.empty()) append_errors(solved, k, places, errors);
    }
    return errors;
}

void add_singular_cells(const SolvedAssembly& solved, const std::vector<SingularError>& errors, double target,
                        WantedSizes& wanted) {
    const double each = aimed_share * target * energy_of(solved) / static_cast<double>(errors.size());
    for (const SingularError& e : errors)
        if (e.energy > each && !e.is_of_contact)
            wanted[static_cast<std::size_t>(solved.grids[e.grid].part)].push_back(
                {{e.at}, e.cell * std::pow(each / e.energy, 1 / power), size_growth});
}

}  // namespace abut
