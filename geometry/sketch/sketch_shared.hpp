// SPDX-License-Identifier: GPL-3.0-or-later
// Closed chains that run along each other.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_chains.hpp"

namespace abut::geometry {

/// Does an entity (by number) share a stretch with an entity of another closed chain, and lie the insides of both on the same
/// side of it? One of the two is inside the other then, and its boundary is not all its own: such outlines have to be cut
/// apart. Parts side by side, which touch along a stretch, are left alone. `tolerance`: below it the two curves are one.
std::vector<bool> shared_from_inside(const std::vector<SketchPiece>& entities, const std::vector<EntityChain>& chains,
                                     double tolerance);

}  // namespace abut::geometry
