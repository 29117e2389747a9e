// SPDX-License-Identifier: GPL-3.0-or-later
// Which effects a scene calls for; made before anything is computed.
#pragma once
#include <vector>

#include "src/plan/boundary_conditions.hpp"
#include "src/results/result.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// The Poisson's ratio from which on materials that are not in plane stress have their volume strain projected
/// (solver/terms/dilatation.hpp). Measured on the thick ring and a field of varying pressure, degrees 1 to 4: without the
/// projection the errors of stresses are 2 to 3.5 times those at 0.3 here, 10 to 20 times at 0.49, a thousand times at 0.4999;
/// with it they stay the same.
inline constexpr double projection_from = 0.45;
bool is_nearly_incompressible(const Scene& scene, const Material& material);

/// Every effect that abut knows, on or off, and why. An effect that is off runs no code.
std::vector<Effect> plan_effects(const Scene& scene);
/// Every effect, with the parts that it concerns and the pairs of parts: those that will be searched (effect_scope.cpp).
std::vector<Effect> plan_effects(const Scene& scene, const ResolvedConditions& conditions);

/// Which parts to solve. Parts that need no solution carry no load, and touch nothing that does. touching: pairs of part
/// indices; closing: those of them that an interference or a drawn overlap presses together.
std::vector<bool> parts_to_solve(const Scene& scene, const ResolvedConditions& conditions,
                                 const std::vector<std::pair<int, int>>& touching,
                                 const std::vector<std::pair<int, int>>& closing = {});

}  // namespace abut
