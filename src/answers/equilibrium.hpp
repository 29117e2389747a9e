// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/results/result.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Fills reactions and equilibrium: resultants of what acts on the assembly and of what its supports give back.
void fill_equilibrium(const Scene& scene, const SolvedAssembly& solved, Result& result);

}  // namespace abut
