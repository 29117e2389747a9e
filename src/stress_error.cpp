// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/stress_error.hpp"

#include <algorithm>

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

/// Strain energy of the difference between smoothed stresses and those of the displacement.
double difference_energy(const solver::PartInput& input, const Eigen::VectorXd& displacement,
                         const solver::StressField& smoothed) {
    const solver::StressOf raw(input, displacement);
    double twice = 0;
    for_all_cells(input, [&](const solver::CellRule& cell) {
        for (std::size_t q = 0; q < cell.points.size(); ++q) {
            const Eigen::Vector3d s = solver::stress_at(smoothed, cell.element, cell.points[q]).head<3>();
            twice += cell.weights[q] * twice_density(input.elasticity, s - raw(cell.element, cell.points[q]));
        }
    });
    return 0.5 * input.thickness * twice;
}

}  // namespace

std::vector<solver::StressField> stress_fields(const SolvedAssembly& solved) {
    std::vector<solver::StressField> fields;
    for (std::size_t k = 0; k < solved.grids.size(); ++k)
        fields.push_back(stress_field(solved.grids[k], solved.solution.displacement[k]));
    return fields;
}

std::optional<double> energy_error(const SolvedAssembly& solved, const std::vector<solver::StressField>& stress) {
    const double energy = energy_of(solved);
    if (!(energy > 0)) return std::nullopt;
    double error = 0;
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        if (solved.grids[k].is_rigid) continue;
        if (!stress[k].failure.empty()) return std::nullopt;
        error += difference_energy(solved.grids[k].input, solved.solution.displacement[k], stress[k]);
    }
    return std::max(0.0, error) / energy;
}

}  // namespace abut
