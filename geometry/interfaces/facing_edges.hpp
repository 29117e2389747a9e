// SPDX-License-Identifier: GPL-3.0-or-later
// Zones as stretches along which one edge of a part faces one of another.
#pragma once
#include <vector>

#include "geometry/interfaces/functional_interface.hpp"
#include "geometry/proximity/zone_pieces.hpp"

namespace abut::geometry {

/// A zone's piece as a stretch of two edges, its ends on the first part; length 0 where a pair at an end is not found.
FacingEdges facing_edges(const Part& first, const Part& second, const FacingZone& zone, const ZonePiece& piece);

/// Puts the stretches of the pair of edges that carries most to the front, the longest of them first.
void put_first(std::vector<FacingEdges>& stretches, int edge1, int edge2);

}  // namespace abut::geometry
