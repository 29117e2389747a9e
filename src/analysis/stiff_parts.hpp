// SPDX-License-Identifier: GPL-3.0-or-later
// Parts are stiffer on their grids than they are: by what their strain energies miss. Where a contact bears what is left
// between how far a part would go and how far it may, that is a small difference, which misses far more.
#pragma once
#include <vector>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// The contacts whose forces the stiffness of parts decides (by contact): neither open, nor bonds, nor given by statics. By a
/// penalty nothing is known: none.
std::vector<char> depend_on_stiffness(const SolvedAssembly& solved);

/// The fraction by which the forces of these contacts (the integrals of their pressures and of friction's tractions) change
/// where parts yield as much more as their strain energies miss (missed: by solved part, of its own energy; empty: not known);
/// 1 where a contact would open, 0 of all others, and where that has no answer. Cost: as of `solver::solve_with_softer_parts`.
std::vector<double> shares_of_stiffness(const SolvedAssembly& solved, const std::vector<char>& depend,
                                        const std::vector<double>& missed, int threads);

}  // namespace abut
