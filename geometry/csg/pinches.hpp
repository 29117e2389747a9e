// SPDX-License-Identifier: GPL-3.0-or-later
// Loops that touch: which pieces then bound one region.
#pragma once
#include <vector>

#include "geometry/csg/csg_names.hpp"

namespace abut::geometry {

/// Cuts loops that touch, so that each bounds one region or a hole.
/// Where loops come within the merge length of each other or of themselves, there are several ways to go on. Which of them a
/// Boolean takes depends on roundings; here it is decided once: every loop bounds one region, or a hole of one region, whose
/// inside hangs together.
///   - A loop that touches itself is cut in two.
///   - Holes that touch their region's outer loop and each other in a ring of touching points cut the region into several:
///   there
///     the loops change over to each other. A circle inscribed in a square leaves four corner pieces.
///   - A hole that touches in one point, and regions that touch each other, stay as they are.
/// Neighbouring pieces of a loop are taken to touch at their common end only.
std::vector<std::vector<Piece>> cut_pinches(std::vector<std::vector<Piece>> loops, const std::vector<PlacedSource>& sources);

}  // namespace abut::geometry
