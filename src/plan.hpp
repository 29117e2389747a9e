// SPDX-License-Identifier: GPL-3.0-or-later
// Which effects a scene calls for; made before anything is computed.
#pragma once
#include <vector>

#include "src/boundary_conditions.hpp"
#include "src/result.hpp"
#include "src/scene.hpp"

namespace abut {

/// Every effect that abut knows, on or off, and why. An effect that is off runs no code.
std::vector<Effect> plan_effects(const Scene& scene);

/// Parts that need no solution: they carry no load, and touch nothing that does. touching: pairs of part indices.
std::vector<bool> parts_to_solve(const Scene& scene, const ResolvedConditions& conditions,
                                 const std::vector<std::pair<int, int>>& touching);

}  // namespace abut
