// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/stress_error.hpp"

#include <algorithm>
#include <numeric>

#include "solver/free_strain.hpp"
#include "solver/ring.hpp"
#include "solver/stress.hpp"
#include "src/contact_measures.hpp"
#include "src/field_results.hpp"

namespace abut {

namespace {

/// Twice the strain energy per volume of a plane stress state.
double twice_density(const solver::Elasticity& d, const Eigen::Vector3d& s) {
    const double determinant = d.d11 * d.d11 - d.d12 * d.d12;
    return (d.d11 * (s[0] * s[0] + s[1] * s[1]) - 2 * d.d12 * s[0] * s[1]) / determinant + s[2] * s[2] / d.d33;
}

/// The same in three dimensions, zz among the stresses.
double twice_density_of_ring(const solver::Elasticity& d, const Eigen::Vector4d& s) {
    const double twice_mu = 2 * d.d33, trace = s[0] + s[1] + s[3];
    const double squares = s[0] * s[0] + s[1] * s[1] + s[3] * s[3] + 2 * s[2] * s[2];
    return (squares - d.d12 / (twice_mu + 3 * d.d12) * trace * trace) / twice_mu;
}

/// Twice the energy of the difference between smoothed stresses and those of a displacement in one cell; of the stresses in the
/// plane, and around an axis.
double twice_error(const solver::PartInput& input, const solver::StressOf& raw, const solver::StressField& smoothed,
                   const solver::CellRule& cell) {
    const solver::StressOf::OnElement raw_here(raw, cell.element);
    const solver::LocalSpline<3> smoothed_here = local_stress(smoothed, cell.element);
    double twice = 0;
    for (std::size_t q = 0; q < cell.points.size(); ++q)
        twice +=
            cell.weights[q] * twice_density(input.elasticity, smoothed_here.value(cell.points[q]) - raw_here(cell.points[q]));
    return twice;
}
double twice_error_of_ring(const solver::PartInput& input, const solver::StressOf& raw, const solver::StressField& smoothed,
                           const solver::CellRule& cell) {
    const solver::StressOf::OnElement raw_here(raw, cell.element);
    double twice = 0;
    for (std::size_t q = 0; q < cell.points.size(); ++q) {
        const Vec2& x = cell.points[q];
        Eigen::Vector4d away = solver::stress_at(smoothed, cell.element, x);
        away.head<3>() -= raw_here(x);
        away[3] -= raw.zz(cell.element, x);
        twice += cell.weights[q] * twice_density_of_ring(input.elasticity, away);
    }
    return twice;
}

/// Of what a temperature would store in a restrained part: the energy of a part that expands freely is rounding below this.
constexpr double energy_rounding = 1e-12;

double restrained_energy(const SolvedAssembly& solved) {
    double sum = 0;
    for (const PartOnGrid& g : solved.grids) {
        if (!g.input.free_strain) continue;
        const double stress = solver::largest_restrained_stress(g.input);
        sum += 0.5 * stress * stress / g.input.elasticity.d33 * measure(g.input) * g.input.thickness;
    }
    return sum;
}

}  // namespace

std::vector<double> element_errors(const solver::PartInput& input, const Eigen::VectorXd& displacement,
                                   const solver::StressField& smoothed) {
    const solver::StressOf raw(input, displacement);
    const auto error_in = input.axis ? twice_error_of_ring : twice_error;
    std::vector<double> errors(input.space.fraction.size(), 0.0);
    for_all_cells(input, [&](const solver::CellRule& cell) {
        errors[static_cast<std::size_t>(cell.element)] = 0.5 * input.thickness * error_in(input, raw, smoothed, cell);
    });
    return errors;
}

std::vector<solver::StressField> stress_fields(const SolvedAssembly& solved) {
    std::vector<solver::StressField> fields;
    for (std::size_t k = 0; k < solved.grids.size(); ++k)
        fields.push_back(stress_field(solved.grids[k], solved.solution.displacement[k]));
    return fields;
}

std::optional<double> energy_error(const SolvedAssembly& solved, const std::vector<solver::StressField>& stress) {
    const double energy = energy_of(solved);
    if (!(energy > 0) || energy <= energy_rounding * restrained_energy(solved)) return std::nullopt;
    double error = 0;
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        if (solved.grids[k].is_rigid) continue;
        if (!stress[k].failure.empty()) return std::nullopt;
        const std::vector<double> errors = element_errors(solved.grids[k].input, solved.solution.displacement[k], stress[k]);
        error += std::accumulate(errors.begin(), errors.end(), 0.0);
    }
    return std::max(0.0, error) / energy;
}

}  // namespace abut
