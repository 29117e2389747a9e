// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's loads as what the solver takes, in the frame of a part's grid.
#pragma once
#include <vector>

#include "src/discretization/discretize.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/plan/effect_meter.hpp"

namespace abut {

/// The load vector of one part, and the size of the largest single load (sum of its magnitudes).
struct PartLoad {
    Eigen::VectorXd vector;
    Eigen::VectorXd weighted;  ///< the same loads on the weighted functions; empty without a structure
    double scale = 0;
    EffectUses uses;
};
/// The load vector of a part. Throws InputError where a load has no finite value.
PartLoad load_vector(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& on_grid);

/// The strain that the temperatures on a part make it expand by where nothing restrains it, in its local frame; empty: none.
/// Refers to the scene.
std::function<double(const Vec2&)> free_strain(const Scene& scene, const PartOnGrid& on_grid);

}  // namespace abut
