// SPDX-License-Identifier: GPL-3.0-or-later
// What the loads of a scene are to its parts as rigid bodies.
#pragma once
#include <vector>

#include "src/plan/boundary_conditions.hpp"

namespace abut {

/// The resultant of all loads on one part; 0 where they balance each other but for rounding.
struct RigidLoad {
    Vec2 force{0, 0};
    double moment = 0;  ///< about the part's centroid
    /// What the moment falls by over a turn of the part: forces that keep their direction turn back what they stretch. Of those
    /// that are given; pressures go along, and what acts in the centroid does neither.
    double stretch = 0;
};

/// The resultant of the loads on each part. Loads that vary by the place are not resolved (why_not_followed).
std::vector<RigidLoad> rigid_loads(const Scene& scene, const ResolvedConditions& conditions);

}  // namespace abut
