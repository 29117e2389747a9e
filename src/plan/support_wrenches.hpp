// SPDX-License-Identifier: GPL-3.0-or-later
// What the supports of a scene hold of its parts as rigid bodies [Grishin10, section 2.2].
#pragma once
#include <optional>
#include <vector>

#include "geometry/interfaces/screw.hpp"
#include "src/plan/boundary_conditions.hpp"

namespace abut {

/// Where moments of a scene's wrenches are measured: about the middle of all parts, in their size.
geometry::ScrewScale screw_scale(const Scene& scene);

/// The wrenches, by part, of each support that holds it, springs among them, reduced to a basis; about the origin.
std::vector<std::vector<geometry::Screw>> support_wrenches(const Scene& scene, const ResolvedConditions& conditions);

/// Finds a piece, of a part of several, that supports of its own edges leave free to move: a point of its outline.
std::optional<Vec2> piece_not_held(const Scene& scene, const ResolvedConditions& conditions, int part);

}  // namespace abut
