// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// A pair of rigid parts whose faces overlap after the solution, in words; empty: none. Rigid parts cannot be pressed against
/// each other: no pressure follows. Cost: that of some hundred pairs of points for each candidate between rigid parts.
std::string rigid_pair_failure(const Scene& scene, const std::vector<Candidate>& candidates, const SolvedAssembly& solved);

/// Rigid parts that would stop a mechanism's rigid parts if pressures followed between them, in words; empty: none.
std::string rigid_stops(const Scene& scene, const std::vector<Candidate>& candidates, const SolvedAssembly& solved);

}  // namespace abut
