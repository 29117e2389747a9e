// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a pass as the solver's systems: supports, loads, factors.
#pragma once
#include "src/plan/boundary_conditions.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Makes the system of every part of solved.grids, with supports and loads, side by side; what cannot be solved is told in
/// solved.failure.
void make_systems(const Scene& scene, const ResolvedConditions& conditions, int threads, SolvedAssembly& solved);

/// The same parts under the loads of another case: systems that share the factors of `of_parts`, whose grids they are on. Parts
/// that temperatures act on, and rigid ones, are made anew.
void load_systems(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& of_parts, int threads,
                  SolvedAssembly& solved);

}  // namespace abut
