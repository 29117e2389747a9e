// SPDX-License-Identifier: GPL-3.0-or-later
// What a pass will take, from its grids and from what the last one took.
#pragma once
#include <string>
#include <vector>

#include "src/discretization/grid_design.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/scene/scene.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Solution time grows a little faster than unknowns.
inline constexpr double time_growth_exponent = 1.2;

/// Estimated: memory within a factor of 2, time as far as it grows like that.
struct PassCost {
    double unknowns = 0;
    double seconds = 0;
    double bytes = 0;  ///< at the peak
};

/// The cost of a pass on grids that are wanted; now, last_seconds: the last one and what it took. The grids are designed for
/// it, and nothing is made on them.
PassCost cost_of_pass(const Scene& scene, const ResolvedConditions& conditions, const std::vector<bool>& parts,
                      const WantedSizes& wanted, double coarseness, const SolvedAssembly& now, double last_seconds);

/// Does a pass take more than is left of a budget? spent: seconds so far.
bool is_beyond(const Budget& budget, double spent, const PassCost& cost);

/// "of about 12000 unknowns, in 3.1 s and 0.05 GB"
std::string cost_text(const PassCost& cost);

}  // namespace abut
