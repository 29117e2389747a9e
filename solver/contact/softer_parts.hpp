// SPDX-License-Identifier: GPL-3.0-or-later
// What parts that yield more than they were computed to do to the contacts between them.
#pragma once
#include <vector>

#include "solver/contact/assembly_solve.hpp"

namespace abut::solver {

/// The pressures and constraint forces where each part yields more by a fraction (by part) of what its loads, its contacts and
/// its constraints displace it by; not of what it is moved by, or expands by. To first order, and without friction's way: what
/// an error of the parts' strain energies does to forces that are small differences. Springs are left as they are: parts that
/// have some yield as computed. Nothing else is filled in; not converged: it has no answer. Cost: a contact problem from a
/// neighbour's answer, and two solutions of every part.
AssemblySolution solve_with_softer_parts(const AssemblyProblem& problem, const AssemblySolution& solution,
                                         const std::vector<double>& more, int threads);

}  // namespace abut::solver
