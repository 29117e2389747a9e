// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/results/result.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Fills what is known of every part without its fields: grid, cells, unknowns, quality of the cut; and their sums.
void fill_parts(const Scene& scene, const SolvedAssembly& solved, Result& result);

}  // namespace abut
