// SPDX-License-Identifier: GPL-3.0-or-later
// A facing zone cut where it passes from one edge to the next on either part.
#pragma once
#include <array>
#include <vector>

#include "geometry/proximity/facing.hpp"

namespace abut::geometry {

/// A stretch of a zone that faces one edge of each part with one other.
struct ZonePiece {
    int edge1 = -1, edge2 = -1;
    double t1 = 0, t2 = 0;            ///< parameters of the edges half-way
    double begin1 = 0, end1 = 0;      ///< arc length on the zone's first chain
    double gap_min = 0, gap_max = 0;  ///< of a few pairs along it, ends included
};

/// The pieces of a zone, in its order, cut at others (arc lengths on its chains), too. Where a pair is not found (its partner
/// lies beyond an end by rounding) the piece is left out.
std::vector<ZonePiece> zone_pieces(const Part& part1, const Part& part2, const FacingZone& zone,
                                   const std::array<std::vector<double>, 2>& others = {});

/// The stretch [begin1, end1] of a zone, with its partners. Of closed zones it may run past the zone's end; whole.closed is
/// forgotten. Gaps are left to be filled in; what is no end of the whole is no limit of the search.
FacingZone stretch_of(const Part& part1, const Part& part2, const FacingZone& whole, double begin1, double end1);

}  // namespace abut::geometry
