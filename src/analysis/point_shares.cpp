// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/point_shares.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/contact/independent_groups.hpp"
#include "src/analysis/singular_places.hpp"
#include "src/analysis/static_forces.hpp"
#include "src/base/index.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

/// Constraints that share less than this fraction with contacts change no force by more.
constexpr double least_shared = 1e-3;

/// By how much more a point yields to a unit force where cells are half as large: a wedge's tip (turn: of its boundary there),
/// in the mean over the directions of the force.
double yielding_of_halving(const PartOnGrid& grid, double turn) {
    const solver::Elasticity& d = grid.input.elasticity;
    const double modulus = d.d11 - d.d12 * d.d12 / d.d11, angle = std::numbers::pi - turn, s = std::sin(turn);
    return std::numbers::ln2 / (modulus * grid.input.thickness) * (1 / (angle + s) + 1 / (angle - s));
}

}  // namespace

std::vector<double> shares_of_points(const Scene& scene, const SolvedAssembly& solved, int threads) {
    const std::vector<solver::MeanConstraint>& constraints = solved.problem.constraints;
    const auto is_point = [&](const solver::MeanConstraint& c) {
        return scene.supports[at(c.tag)].kind == Support::Kind::points && !solved.grids[at(c.part)].is_rigid;
    };
    if (std::none_of(constraints.begin(), constraints.end(), is_point)) return {};
    const std::vector<double> shared = shared_with_contacts(solved);
    std::vector<double> yields(constraints.size(), 0);
    for (std::size_t k = 0; k < constraints.size(); ++k) {
        if (!is_point(constraints[k]) || shared[k] < least_shared) continue;
        const PartOnGrid& grid = solved.grids[at(constraints[k].part)];
        const Vec2& place = scene.supports[at(constraints[k].tag)].at.front();
        yields[k] =
            solved.solution.constraint_force[k] * yielding_of_halving(grid, turn_at(scene.parts[at(grid.part)].part, place));
    }
    if (std::all_of(yields.begin(), yields.end(), [](double y) { return y == 0; })) return {};
    SolvedAssembly yielding = solved;
    for (std::size_t k = 0; k < yields.size(); ++k) yielding.problem.constraints[k].value -= yields[k];
    yielding.solution = solver::solve_groups(yielding.problem, threads);
    std::vector<double> shares(solved.contacts.size(), 0);
    for (std::size_t k = 0; k < shares.size(); ++k) {
        if (solved.interface_of[k] < 0) continue;
        const Vec2 force = contact_force(solved, k).force;
        const bool is_solved = yielding.solution.mechanism.empty() && force.norm() > 0;
        shares[k] = is_solved ? std::min(1.0, (contact_force(yielding, k).force - force).norm() / force.norm()) : 1;
    }
    return shares;
}

}  // namespace abut
