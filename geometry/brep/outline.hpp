// SPDX-License-Identifier: GPL-3.0-or-later
// The outer loops of parts.
#pragma once
#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// The first loop of a part, the outer one, as a part by itself.
Part outer_outline(const Part& part);

/// The number of separate pieces that a part consists of: its outer loops.
int count_pieces(const Part& part);

/// Gives each edge the number of the piece that it bounds, from outside or within, in the order of outer loops.
std::vector<int> pieces_of_edges(const Part& part);

/// Lies the part inside the other's outer outline, in its material, in its holes, or partly in both? Corners and middles of its
/// edges tell: of outlines that cross one of these is outside as a rule.
bool lies_in_outline(const Part& inner, const Part& outer);

}  // namespace abut::geometry
