// SPDX-License-Identifier: GPL-3.0-or-later
// How what a load gives in total (a force, a moment, the force of a pin) is spread over edges.
#pragma once
#include <vector>

#include "src/scene/selection.hpp"

namespace abut {

/// The traction t(x, n) = even + turning z x (x - center) - n max(0, -n . pressing), n the outward normal: the first two are
/// what a force and a moment make of edges that take them like a rigid plate on an even bed of springs; the last is the
/// pressure of a pin, a cosine over what of a hole faces it. In the assembly's frame.
struct EdgeTraction {
    Vec2 even{0, 0};      ///< force per area
    Vec2 center{0, 0};    ///< centroid of the edges' area
    double turning = 0;   ///< force per area and length
    Vec2 pressing{0, 0};  ///< force per area
};

/// What an edge load of the kinds edge_force, edge_moment and bearing comes to; even = 0 for those that say their traction
/// themselves. `portions` as resolve_conditions gives them.
EdgeTraction edge_traction(const Scene& scene, const Load& load, const std::vector<EdgePortion>& portions);

/// The portions that a pin presses which pushes with the load's force, cut where its pressure ends; empty where the edges have
/// nothing that could carry this force.
std::vector<EdgePortion> pressed_portions(const Scene& scene, const Load& load, const std::vector<EdgePortion>& portions);

}  // namespace abut
