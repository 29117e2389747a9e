// SPDX-License-Identifier: GPL-3.0-or-later
// What the loads of a scene act on, and how strongly at a point.
#pragma once
#include <string>
#include <vector>

#include "src/scene/selection.hpp"

namespace abut {

bool is_edge_load(const Load& load);
/// The name in the plan of the effect that a load belongs to.
std::string effect_of(const Load& load);
/// Does the load act on the volume of the part: gravity, or a force, spin or temperature in this part or in all?
bool acts_on_volume_of(const Scene& scene, const Load& load, int part);
/// The force per volume of a volume load at a point of the part, in the assembly's frame; volume: of the part over its
/// thickness.
Vec2 volume_force(const Scene& scene, const Load& load, int part, double volume, const Vec2& x);
/// The area of an edge load's portions, over which its force is spread.
double selected_area(const Scene& scene, const std::vector<EdgePortion>& portions);
/// The traction of an edge load at a point, in the assembly's frame; total_area: over which a force is spread.
Vec2 traction_at(const Load& load, const Vec2& x, const Vec2& normal, double total_area);

}  // namespace abut
