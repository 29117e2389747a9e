// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of parts that no interface joins are separate problems.
#pragma once
#include <vector>

#include "solver/contact/assembly_solve.hpp"

namespace abut::solver {

/// The parts of each group, ascending; groups in the order of their first parts.
std::vector<std::vector<int>> independent_groups(const AssemblyProblem& problem);

/// Adds one group's outcome to the whole's: counts add up, the worst residual stands, all have to converge.
void add_outcome(const AssemblySolution& from, AssemblySolution& to);

/// Solves each group's problem by itself, as solve_assembly would solve it alone, bit for bit, given part_load. The problem's
/// parts and interfaces are moved out and back meanwhile. A mechanism in one group leaves nothing filled in.
AssemblySolution solve_groups(AssemblyProblem& problem, int threads = 1);

}  // namespace abut::solver
