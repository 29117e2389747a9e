// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of edges are found where parts are drawn. Here they are found once more where the solution has put the parts.
#pragma once
#include <vector>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// What the largest pressure of each contact errs by, relative to it, since its pairs are those of where its parts are drawn:
/// by contact; 0 of what is open, or moves nowhere.
std::vector<double> moved_pair_errors(const Scene& scene, const SolvedAssembly& solved);

}  // namespace abut
