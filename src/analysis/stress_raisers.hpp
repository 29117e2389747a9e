// SPDX-License-Identifier: GPL-3.0-or-later
// Where the stresses of a solution are worst: re-entrant corners, ends of loads and supports, small holes.
#pragma once
#include <vector>

#include "solver/recovery/recovery.hpp"
#include "src/analysis/largest_stress.hpp"
#include "src/discretization/grid_design.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Adds smaller cells where few cells hold half of the squared error of the stresses (smoothed against those of the
/// displacement). False: the error lies everywhere, and nothing is added. stress: by part of solved.grids.
bool add_stress_raisers(const SolvedAssembly& solved, const std::vector<solver::StressField>& stress, WantedSizes& wanted);

/// Adds smaller cells where the largest stress of all parts stands, and wherever its part's stress is as large within the error
/// of that: around a bore it is so all the way round.
void add_largest_stress(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved,
                        const std::vector<solver::StressField>& stress, const std::vector<LargestStress>& largest,
                        WantedSizes& wanted);

}  // namespace abut
