// SPDX-License-Identifier: GPL-3.0-or-later
// Parts are stiffer on their grids than they are: by what their strain energies miss. Where a contact bears what is left
// between how far a part would go and how far it may, that is a small difference, which misses far more.
#pragma once
#include <vector>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// The fraction by which contacts' forces (the integrals of their pressures and of friction's tractions) change where parts
/// yield as much more as their strain energies miss (missed: by solved part, of its own energy); 1 where a contact would open,
/// 0 where it is open, and where forces follow from statics. By a penalty, and where that has no answer, nothing is known: 0.
/// Cost: as of `solver::solve_with_softer_parts`, none where all forces follow from statics.
std::vector<double> shares_of_stiffness(const SolvedAssembly& solved, const std::vector<double>& missed, int threads);

}  // namespace abut
