// SPDX-License-Identifier: GPL-3.0-or-later
// What the loads of a scene act on, and how strongly at a point.
#pragma once
#include <string>
#include <vector>

#include "src/plan/edge_traction.hpp"
#include "src/scene/selection.hpp"

namespace abut {

/// Does the load act on edges: pressure, traction, bearing, or a force or moment on some?
bool is_edge_load(const Load& load);
/// The name in the plan of the effect that a load belongs to.
std::string effect_of(const Load& load);
/// Does the load act on the volume of the part: gravity, or a force, spin or temperature in this part or in all?
bool acts_on_volume_of(const Scene& scene, const Load& load, int part);
/// What the force or moment on a whole part is spread over.
struct PartMeasure {
    double volume = 1;        ///< over the thickness
    Vec2 center{0, 0};        ///< for moments: the centroid
    double polar_moment = 1;  ///< for moments: the integral of the squared distance from the centroid
};
PartMeasure part_measure(const geometry::Part& part, const Load& load, double volume);
/// The force per volume of a volume load at a point of the part, in the assembly's frame.
Vec2 volume_force(const Scene& scene, const Load& load, int part, const PartMeasure& measure, const Vec2& x);
/// The traction of an edge load at a point, in the assembly's frame; spread: what edge_traction gives for the load.
Vec2 traction_at(const Load& load, const EdgeTraction& spread, const Vec2& x, const Vec2& normal);

}  // namespace abut
