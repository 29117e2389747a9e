// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/stress_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "geometry/curves/bezier_span.hpp"
#include "solver/assembly/ring.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "solver/terms/free_strain.hpp"
#include "solver/terms/stress.hpp"
#include "src/answers/field_results.hpp"
#include "src/solution/contact_measures.hpp"

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

/// In every interval of one direction, one after the other: a line rule, with the B-splines at its abscissas.
struct RuleOnLine {
    std::vector<double> at, weight;
    std::vector<solver::LineValues> displacement;
    std::vector<solver::LocalValues> stress;
};

RuleOnLine rule_on_line(const solver::SplineSpace& displacement, const solver::SplineSpace& stress, int axis,
                        const solver::LineRule& rule) {
    RuleOnLine line;
    for (int k = 0; k < displacement.n_intervals(axis); ++k) {
        const solver::IntervalKnots u = displacement.interval(axis, k), s = stress.interval(axis, k);
        const double begin = u.low(), length = u.high() - begin;
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            line.at.push_back(begin + rule.points[i] * length);
            line.weight.push_back(rule.weights[i] * length);
            line.displacement.emplace_back();
            evaluate(u, line.at.back(), line.displacement.back().value, line.displacement.back().slope);
            line.stress.emplace_back();
            evaluate(s, line.at.back(), line.stress.back());
        }
    }
    return line;
}

/// As twice_error() in full cells, by products of lines; of parts without a structure.
void add_full_cells(const solver::PartInput& input, const solver::StressOf& raw, const solver::StressField& smoothed,
                    std::vector<double>& errors) {
    const solver::SplineSpace& space = input.space;
    const RuleOnLine x = rule_on_line(space, *smoothed.space, 0, input.line_rule),
                     y = rule_on_line(space, *smoothed.space, 1, input.line_rule);
    const std::size_t n = input.line_rule.points.size();
    for (std::size_t cell = 0; cell < static_cast<std::size_t>(space.n_cells()); ++cell) {
        if (space.fraction[cell] != 1) continue;
        const int element = static_cast<int>(cell);
        const solver::StressOf::OnElement raw_here(raw, element);
        const solver::LocalSpline<3> smoothed_here = local_stress(smoothed, element);
        const std::size_t column = n * static_cast<std::size_t>(space.column_of(element)),
                          row = n * static_cast<std::size_t>(space.row_of(element));
        double twice = 0;
        for (std::size_t j = row; j < row + n; ++j)
            for (std::size_t i = column; i < column + n; ++i)
                twice +=
                    x.weight[i] * y.weight[j] *
                    twice_density(input.elasticity, smoothed_here.value(x.stress[i], y.stress[j]) -
                                                        raw_here({x.at[i], y.at[j]}, x.displacement[i], y.displacement[j]));
        errors[cell] = 0.5 * input.thickness * twice;
    }
}

/// Of what a temperature would store in a restrained part: the energy of a part that expands freely is rounding below this.
constexpr double energy_rounding = 1e-12;
/// Parts that are drawn against each other strain each other by the rounding of their places, which shows where nothing else
/// does.
constexpr double strain_rounding = geometry::coordinate_roundings * std::numeric_limits<double>::epsilon();

double rounding_energy(const SolvedAssembly& solved) {
    double sum = 0;
    for (const PartOnGrid& g : solved.grids) {
        if (g.is_rigid) continue;
        const double volume = measure(g.input) * g.input.thickness;
        if (solved.problem.load_scale == 0) sum += 0.5 * strain_rounding * strain_rounding * g.input.elasticity.d11 * volume;
        if (!g.input.free_strain) continue;
        const double stress = solver::largest_restrained_stress(g.input);
        sum += energy_rounding * 0.5 * stress * stress / g.input.elasticity.d33 * volume;
    }
    return sum;
}

}  // namespace

double strain_energy(const solver::PartInput& input, const solver::StressOf& stress, const solver::CellRule& cell) {
    const solver::StressOf::OnElement in_plane(stress, cell.element);
    double twice = 0;
    for (std::size_t q = 0; q < cell.points.size(); ++q) {
        const Eigen::Vector3d s = in_plane(cell.points[q]);
        twice +=
            cell.weights[q] *
            (input.axis ? twice_density_of_ring(input.elasticity, {s[0], s[1], s[2], stress.zz(cell.element, cell.points[q])})
                        : twice_density(input.elasticity, s));
    }
    return 0.5 * input.thickness * twice;
}

std::vector<double> element_errors(const solver::PartInput& input, const Eigen::VectorXd& displacement,
                                   const solver::StressField& smoothed) {
    const solver::StressOf raw(input, displacement);
    const auto error_in = input.axis ? twice_error_of_ring : twice_error;
    std::vector<double> errors(input.space.fraction.size(), 0.0);
    const auto add = [&](const solver::CellRule& cell) {
        errors[static_cast<std::size_t>(cell.element)] = 0.5 * input.thickness * error_in(input, raw, smoothed, cell);
    };
    if (input.axis || input.structure) {
        for_all_cells(input, add);
        return errors;
    }
    add_full_cells(input, raw, smoothed, errors);
    for (const solver::CellRule& rule : input.cut_rules) add(rule);
    return errors;
}

double strain_error(const solver::PartInput& input, const Eigen::VectorXd& displacement, const solver::StressField& smoothed,
                    int element) {
    const solver::StressOf raw(input, displacement);
    const auto error_in = input.axis ? twice_error_of_ring : twice_error;
    double twice = 0, volume = 0;
    for_all_cells(input, [&](const solver::CellRule& cell) {
        if (cell.element != element) return;
        twice += error_in(input, raw, smoothed, cell);
        volume = std::accumulate(cell.weights.begin(), cell.weights.end(), volume);
    });
    return volume > 0 ? std::sqrt(std::max(0.0, twice) / volume / (2 * input.elasticity.d33)) : 0;
}

std::vector<solver::StressField> stress_fields(const SolvedAssembly& solved, int threads) {
    std::vector<solver::StressField> fields(solved.grids.size());
    std::array<std::vector<std::size_t>, 2> in_turn;  // what fits have in common is of the first, whatever the threads
    std::set<const Once<solver::StressFitFactor>*> filled;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const Once<solver::StressFitFactor>* common = solved.grids[k].fit.get();
        in_turn[common && !filled.insert(common).second ? 1 : 0].push_back(k);
    }
    const int each = solved.grids.empty() ? 1 : solved.grids.front().input.threads;
    for (const std::vector<std::size_t>& parts : in_turn)
        solver::parallel_for(static_cast<int>(parts.size()), std::max(1, threads / each), [&](int i) {
            const std::size_t k = parts[static_cast<std::size_t>(i)];
            fields[k] = stress_field(solved.grids[k], solved.solution.displacement[k]);
        });
    return fields;
}

bool is_strained(const SolvedAssembly& solved) {
    return energy_of(solved) > rounding_energy(solved);
}

std::optional<std::vector<double>> energy_errors(const SolvedAssembly& solved, const std::vector<solver::StressField>& stress,
                                                 int threads) {
    if (!is_strained(solved)) return std::nullopt;
    const auto has_failed = [](const solver::StressField& s) { return !s.failure.empty(); };
    if (std::any_of(stress.begin(), stress.end(), has_failed)) return std::nullopt;
    std::vector<double> error(solved.grids.size(), 0);
    solver::parallel_for(static_cast<int>(error.size()), threads, [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        if (solved.grids[k].is_rigid) return;
        const std::vector<double> errors = element_errors(solved.grids[k].input, solved.solution.displacement[k], stress[k]);
        error[k] = std::max(0.0, std::accumulate(errors.begin(), errors.end(), 0.0));
    });
    return error;
}

std::vector<double> of_own_energy(const SolvedAssembly& solved, std::vector<double> energy) {
    for (std::size_t k = 0; k < energy.size(); ++k)
        if (const double own = energy_of_part(solved, k); own > 0) energy[k] /= own;
    return energy;
}

}  // namespace abut
