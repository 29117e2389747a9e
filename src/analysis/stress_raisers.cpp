// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/stress_raisers.hpp"

#include <algorithm>

#include "src/analysis/stress_error.hpp"
#include "src/discretization/grid_design.hpp"

namespace abut {

namespace {

/// Cells that together hold this much of the squared error are refined, where they are no more than this fraction of all.
constexpr double refined_share = 0.5, few = 0.2;
/// From one grid to the next. Energy errors of a smooth field fall with the fourth power and more; at a corner of 270 degrees
/// with the 1.1th.
constexpr double refinement = 1.0 / 3;

struct CellError {
    std::size_t grid;
    int element;
    double value;
};

std::vector<CellError> largest_first(const SolvedAssembly& solved, const std::vector<solver::StressField>& stress) {
    std::vector<CellError> all;
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        if (solved.grids[k].is_rigid) continue;
        const std::vector<double> errors = element_errors(solved.grids[k].input, solved.solution.displacement[k], stress[k]);
        for (std::size_t e = 0; e < errors.size(); ++e)
            if (solved.grids[k].input.space.fraction[e] > 0) all.push_back({k, static_cast<int>(e), errors[e]});
    }
    std::stable_sort(all.begin(), all.end(), [](const CellError& a, const CellError& b) { return a.value > b.value; });
    return all;
}

/// How many of the first hold the share.
std::size_t count_of_share(const std::vector<CellError>& errors) {
    double total = 0, sum = 0;
    for (const CellError& e : errors) total += e.value;
    std::size_t n = 0;
    while (n < errors.size() && sum < refined_share * total) sum += errors[n++].value;
    return n;
}

WantedSize smaller_cell(const PartOnGrid& grid, int element) {
    const solver::SplineSpace& space = grid.input.space;
    const Vec2 size = space.cell_size(element);
    return {{grid.frame.to_global(space.low_corner(element) + 0.5 * size)}, refinement * size.maxCoeff(), size_growth};
}

}  // namespace

bool add_stress_raisers(const SolvedAssembly& solved, const std::vector<solver::StressField>& stress, WantedSizes& wanted) {
    const std::vector<CellError> errors = largest_first(solved, stress);
    const std::size_t n = count_of_share(errors);
    if (static_cast<double>(n) > few * static_cast<double>(errors.size())) return false;
    for (std::size_t i = 0; i < n; ++i) {
        const PartOnGrid& grid = solved.grids[errors[i].grid];
        wanted[static_cast<std::size_t>(grid.part)].push_back(smaller_cell(grid, errors[i].element));
    }
    return n > 0;
}

void add_largest_stress(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved,
                        const std::vector<solver::StressField>& stress, const std::vector<LargestStress>& largest,
                        WantedSizes& wanted) {
    const LargestStress* most = strongest(largest);
    if (!most) return;
    const auto k = static_cast<std::size_t>(most - largest.data());
    std::vector<WantedSize>& own = wanted[static_cast<std::size_t>(solved.grids[k].part)];
    own.push_back({{most->von_mises.at}, refinement * most->cell, size_growth});
    for (const int element : elements_as_large(scene, conditions, solved, k, stress[k], *most))
        own.push_back(smaller_cell(solved.grids[k], element));
}

}  // namespace abut
