// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "src/answers/field_results.hpp"
#include "src/results/result.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Throws InputError with all probes that lie outside their part.
void check_probes(const Scene& scene);

/// Fills in displacement and stress at the probes; stress: smoothed, by solver part.
void fill_probes(const Scene& scene, const SolvedAssembly& solved, const std::vector<solver::StressField>& stress,
                 Result& result);

}  // namespace abut
