// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/interfaces/facing_edges.hpp"

#include <algorithm>

namespace abut::geometry {

FacingEdges facing_edges(const Part& first, const Part& second, const FacingZone& zone, const ZonePiece& piece) {
    const auto partner = [&](double s1) {
        const double share = zone.end1 == zone.begin1 ? 0 : (s1 - zone.begin1) / (zone.end1 - zone.begin1);
        return pair_from_first(first, second, zone, s1, zone.begin2 + share * (zone.end2 - zone.begin2));
    };
    const FacingPair begin = partner(piece.begin1), end = partner(piece.end1);
    return {piece.edge1,
            piece.edge2,
            {begin.on1.x, end.on1.x},
            begin.found && end.found ? piece.end1 - piece.begin1 : 0.0,
            piece.gap_min};
}

void put_first(std::vector<FacingEdges>& stretches, int edge1, int edge2) {
    std::stable_sort(stretches.begin(), stretches.end(), [&](const FacingEdges& a, const FacingEdges& b) {
        const bool carries_a = a.edge1 == edge1 && a.edge2 == edge2, carries_b = b.edge1 == edge1 && b.edge2 == edge2;
        return carries_a != carries_b ? carries_a : a.length > b.length;
    });
}

}  // namespace abut::geometry
