// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/singular_errors.hpp"

#include <algorithm>
#include <cmath>

#include "solver/terms/stress.hpp"
#include "src/analysis/load_ends.hpp"
#include "src/analysis/singular_places.hpp"
#include "src/analysis/stress_error.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

/// Energy within a distance of a re-entrant right angle grows with this power of it; places that are less sharp with a higher
/// one.
constexpr double order_of_corner = 1.1, order_of_jump = 2;
/// Of jump^2 / E and the cell's area, beside what smoothed stresses see: 0.01 to 0.026 of pressures on strips of a block's
/// face, 0.005 to 0.045 of shear there; cells of a fourth to a twentieth of the strip, turned by 0, 17 and 45 degrees, nu 0 to
/// 0.45.
constexpr double missed_at_jump = 0.02;

/// Of the target: the rest is left for all that is not singular.
constexpr double aimed_share = 0.5;

void append_errors(const SolvedAssembly& solved, std::size_t k, const std::vector<SingularPlace>& places,
                   std::vector<SingularError>& errors) {
    const PartOnGrid& grid = solved.grids[k];
    const solver::SplineSpace& space = grid.input.space;
    const std::size_t first = errors.size();
    std::vector<geometry::Box2> around;  // cells that overlap it
    for (const SingularPlace& place : places) {
        const Vec2 local = grid.frame.to_local(place.at);
        const double cell = space.cell_size(space.cell_at(local)).maxCoeff();
        errors.push_back({k, place.at, place.is_of_contact, cell, 0, order_of_corner});
        around.push_back({local - Vec2::Constant(cell), local + Vec2::Constant(cell)});
    }
    const solver::StressOf stress(grid.input, solved.solution.displacement[k]);
    for_all_cells(grid.input, [&](const solver::CellRule& cell) {
        const Vec2 low = space.low_corner(cell.element), high = low + space.cell_size(cell.element);
        double energy = -1;
        for (std::size_t p = 0; p < around.size(); ++p) {
            // half open: of what lies on a line the cell behind it
            if (!((around[p].min.array() < high.array()).all() && (low.array() <= around[p].max.array()).all())) continue;
            if (energy < 0) energy = strain_energy(grid.input, stress, cell);
            errors[first + p].energy += places[p].missed_share * energy;
        }
    });
}

void append_load_ends(const PartOnGrid& grid, std::size_t k, const std::vector<LoadEnd>& ends,
                      std::vector<SingularError>& errors) {
    const solver::SplineSpace& space = grid.input.space;
    const solver::Elasticity& d = grid.input.elasticity;
    const double modulus = d.d11 - d.d12 * d.d12 / d.d11;
    for (const LoadEnd& end : ends) {
        const Vec2 cell = space.cell_size(space.cell_at(grid.frame.to_local(end.at)));
        const double width = grid.input.thickness * (grid.input.axis ? end.at.x() : 1);
        errors.push_back({k, end.at, false, cell.maxCoeff(),
                          missed_at_jump * end.jump.squaredNorm() / modulus * cell.prod() * width, order_of_jump});
    }
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
        append_load_ends(solved.grids[k], k, load_ends(scene, conditions, solved, solved.grids[k].part), errors);
    }
    return errors;
}

void add_singular_cells(const SolvedAssembly& solved, const std::vector<SingularError>& errors, double target,
                        WantedSizes& wanted) {
    constexpr double nothing = 1e-9;  // of what each may miss: it asks for cells as large as the part
    const double each = aimed_share * target * energy_of(solved) / static_cast<double>(errors.size());
    for (const SingularError& e : errors)
        if (e.energy > nothing * each && !e.is_of_contact)
            wanted[static_cast<std::size_t>(solved.grids[e.grid].part)].push_back(
                {{e.at}, e.cell * std::pow(each / e.energy, 1 / e.order), size_growth});
}

}  // namespace abut
