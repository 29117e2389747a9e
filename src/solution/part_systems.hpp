// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a pass as the solver's systems: supports, loads, factors.
#pragma once
#include "src/plan/boundary_conditions.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Makes the system of every part of solved.grids, with supports and loads, side by side; what cannot be solved is told in
/// solved.failure.
void make_systems(const Scene& scene, const ResolvedConditions& conditions, int threads, SolvedAssembly& solved);

/// The systems of solved.grids, which are of the prepared parts, under other loads: they share the factors. Parts that
/// temperatures act on, rigid ones, and those whose system could not be made before are made anew.
void load_systems(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& prepared, int threads,
                  SolvedAssembly& solved);

}  // namespace abut
