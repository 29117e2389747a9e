// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's loads as what the solver takes, in the frame of a part's grid.
#pragma once
#include <vector>

#include "src/discretization/discretize.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/plan/effect_meter.hpp"

namespace abut {

/// Load vector of one part, and the size of the largest single load (sum of its magnitudes).
struct PartLoad {
    Eigen::VectorXd vector;
    Eigen::VectorXd weighted;  ///< the same loads on the weighted functions; empty without a structure
    double scale = 0;
    EffectUses uses;
};
/// Throws InputError where a load has no finite value.
PartLoad load_vector(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& on_grid);

/// What the temperatures on a part make it expand by where nothing restrains it, in its local frame; empty: none. Refers to the
/// scene.
std::function<double(const Vec2&)> free_strain(const Scene& scene, const PartOnGrid& on_grid);

bool is_edge_load(const Load& load);
/// Name in the plan of the effect that a load belongs to.
std::string effect_of(const Load& load);
/// Gravity, or a force, spin or temperature in this part or in all.
bool acts_on_volume_of(const Scene& scene, const Load& load, int part);
/// Force per volume of a volume load at a point of the part, in the assembly's frame; volume: of the part over its thickness.
Vec2 volume_force(const Scene& scene, const Load& load, int part, double volume, const Vec2& x);
/// Area of an edge load's portions, over which its force is spread.
double selected_area(const Scene& scene, const std::vector<EdgePortion>& portions);
/// Traction of an edge load at a point, in the assembly's frame; total_area: over which a force is spread.
Vec2 traction_at(const Load& load, const Vec2& x, const Vec2& normal, double total_area);

}  // namespace abut
