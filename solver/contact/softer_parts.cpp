// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/softer_parts.hpp"

#include <cmath>

#include "solver/contact/assembly_rows.hpp"
#include "solver/contact/condensation.hpp"
#include "solver/contact/friction.hpp"
#include "solver/contact/neutral_motions.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// The multipliers of a solution, by row.
VectorXd multipliers_of(const AssemblyProblem& problem, const AssemblyRows& all, const AssemblySolution& solution) {
    VectorXd multipliers(all.rows.n);
    for (std::size_t f = 0; f < problem.interfaces.size(); ++f) {
        const int n = n_rows(problem.interfaces[f]);
        multipliers.segment(all.first_row[f], n) = solution.pressure[f].head(n);  // those after are the first ones once more
    }
    const auto n = static_cast<Index>(solution.constraint_force.size());
    multipliers.tail(n) = Eigen::Map<const VectorXd>(solution.constraint_force.data(), n);
    return multipliers;
}

/// Pressure's rows that bear something, with their friction's, and all of those that hold.
std::vector<char> bearing(const AssemblyRows& all, const VectorXd& multipliers) {
    std::vector<char> taken(at(all.rows.n));
    for (int row = 0; row < all.rows.n; ++row)
        taken[at(row)] = static_cast<char>(!all.rows.unilateral[at(row)] || multipliers[row] != 0);
    for (const FrictionRow& f : all.friction) taken[at(f.tangential)] = taken[at(f.normal)];
    return taken;
}

/// All of them closed, and what is at its limit slips.
std::vector<char> states_under(const ContactQp& qp, const VectorXd& forces) {
    constexpr double at_limit = 1 - 1e-6;  // of tractions that were balanced and refined
    std::vector<char> states(static_cast<std::size_t>(forces.size()), row_state::closed);
    for (const FrictionRow& f : qp.friction)
        if (std::abs(forces[f.tangential]) >= at_limit * f.coefficient * forces[f.normal])
            states[at(f.tangential)] = forces[f.tangential] < 0 ? row_state::slips_forward : row_state::slips_backward;
    return states;
}

}  // namespace

AssemblySolution solve_with_softer_parts(const AssemblyProblem& problem, const AssemblySolution& solution,
                                         const std::vector<double>& more, int threads) {
    ENSURE(more.size() == problem.parts.size() && solution.load.size() == more.size(), "every part yields more, or not");
    const AssemblyRows all = assembly_rows(problem, threads);
    VectorXd multipliers = multipliers_of(problem, all, solution);
    const std::vector<char> taken = bearing(all, multipliers);
    const AssemblyRows own = rows_among(all, taken);
    std::vector<VectorXd> opening(more.size());
    parallel_for(static_cast<int>(more.size()), threads, [&](int k) {
        const PartSystem& part = problem.parts[at(k)];
        if (more[at(k)] > 0 && !part.body && part.springs.empty())
            opening[at(k)] = more[at(k)] * opening_of(own.rows, at(k), response(part, solution.load[at(k)] - part.held_load));
    });
    ContactQp qp = condense(problem.parts, own.rows, problem.load_scale, threads);
    qp.gap.setZero();
    for (const VectorXd& o : opening)
        if (o.size() > 0) qp.gap += o;
    scale_rows(qp, own.rows.weight);
    qp.modes = times_few(qp.modes, split_motions(problem, candidate_resistance(problem), qp.modes).resisted);
    qp.mode_load = VectorXd::Zero(qp.modes.cols());
    qp.friction = own.friction;
    const std::vector<Index> rows = members(taken);
    AssemblySolution softer;
    VectorXd forces, motion;
    softer.converged = solve_on_set(qp, states_under(qp, multipliers(rows).cwiseProduct(own.rows.weight)), forces, motion) &&
                       forces.allFinite();
    if (!softer.converged) return softer;
    multipliers(rows) += forces.cwiseQuotient(own.rows.weight);
    split_multipliers(problem, all, multipliers, softer);
    return softer;
}

}  // namespace abut::solver
