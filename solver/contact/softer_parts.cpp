// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/softer_parts.hpp"

#include <utility>

#include "solver/contact/assembly_rows.hpp"
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

}  // namespace

AssemblySolution solve_with_softer_parts(const AssemblyProblem& problem, const AssemblySolution& solution,
                                         const std::vector<double>& more, int threads) {
    ENSURE(more.size() == problem.parts.size() && solution.load.size() == more.size(), "every part yields more, or not");
    AssemblyRows all = assembly_rows(problem, threads);
    all.expected = multipliers_of(problem, all, solution);
    std::vector<VectorXd> opening(more.size());
    parallel_for(static_cast<int>(more.size()), threads, [&](int k) {
        const PartSystem& part = problem.parts[at(k)];
        if (more[at(k)] > 0 && !part.body && part.springs.empty())
            opening[at(k)] = opening_of(all.rows, at(k), response(part, solution.load[at(k)] - part.held_load));
    });
    for (std::size_t k = 0; k < more.size(); ++k)
        if (opening[k].size() > 0) all.rows.gap0 += more[k] * opening[k];
    auto [softer, multipliers] = solve_rows(problem, all, candidate_resistance(problem), threads);
    softer.converged = softer.converged && softer.mechanism.empty();
    if (softer.mechanism.empty()) split_multipliers(problem, all, multipliers, softer);
    return std::move(softer);
}

}  // namespace abut::solver
