// SPDX-License-Identifier: GPL-3.0-or-later
// What parts that yield more than they were computed to do to the contacts between them.
#pragma once
#include <vector>

#include "solver/contact/assembly_solve.hpp"

namespace abut::solver {

/// The pressures, tractions and constraint forces where each part yields more by a fraction (by part) of what its loads, its
/// contacts and its constraints displace it by; not of what it is moved by, or expands by. To first order: what is closed stays
/// so, what sticks sticks, and what slips bears what its pressure lets it. Springs are left as they are: parts that have some
/// yield as computed. Nothing else is filled in; not converged: the set has no answer. Cost: the compliance of the rows that
/// bear something, one factor of it, and a solution of every part.
AssemblySolution solve_with_softer_parts(const AssemblyProblem& problem, const AssemblySolution& solution,
                                         const std::vector<double>& more, int threads);

}  // namespace abut::solver
