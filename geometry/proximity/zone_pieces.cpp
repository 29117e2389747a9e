// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/proximity/zone_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

/// Shorter pieces are rounding at the joint of two edges, as a fraction of the zone.
constexpr double shortest_piece = 1e-9;
constexpr int samples = 8;

/// Joints of a chain's edges and other places strictly inside (low, high), modulo the length on closed chains.
std::vector<double> joints_between(const Chain& chain, std::vector<double> others, double low, double high) {
    std::vector<double> found;
    others.insert(others.end(), chain.begin.begin(), chain.begin.end());
    for (const double begin : others) {
        const double first = chain.closed ? begin + chain.length * std::ceil((low - begin) / chain.length) : begin;
        for (double s = first; s < high; s += chain.length) {
            if (s > low) found.push_back(s);
            if (!chain.closed) break;
        }
    }
    return found;
}

/// On a closed chain the arc length inside the zone that names the same point.
double into_zone(const FacingZone& zone, double s1) {
    if (!zone.chain1.closed) return s1;
    return s1 + zone.chain1.length * std::ceil((zone.begin1 - s1) / zone.chain1.length);
}

std::vector<double> cuts_of(const Part& part1, const Part& part2, const FacingZone& zone,
                            const std::array<std::vector<double>, 2>& others) {
    std::vector<double> cuts{zone.begin1, zone.end1};
    for (const double s1 : joints_between(zone.chain1, others[0], zone.begin1, zone.end1)) cuts.push_back(s1);
    for (const double s2 : joints_between(zone.chain2, others[1], zone.end2, zone.begin2)) {
        const double share = (zone.begin2 - s2) / (zone.begin2 - zone.end2);
        const FacingPair pair = pair_from_second(part1, part2, zone, s2, zone.begin1 + share * (zone.end1 - zone.begin1));
        if (pair.found) cuts.push_back(std::clamp(into_zone(zone, pair.s1), zone.begin1, zone.end1));
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

std::optional<ZonePiece> piece_between(const Part& part1, const Part& part2, const FacingZone& zone, double a, double b,
                                       double& guess) {
    std::optional<ZonePiece> piece;
    for (int i = 0; i <= samples; ++i) {
        const FacingPair pair = pair_from_first(part1, part2, zone, a + (b - a) * i / samples, guess);
        if (!pair.found) continue;
        guess = pair.s2;
        if (!piece) piece = ZonePiece{-1, -1, 0, 0, a, b, pair.gap, pair.gap};
        piece->gap_min = std::min(piece->gap_min, pair.gap);
        piece->gap_max = std::max(piece->gap_max, pair.gap);
        if (2 * i != samples) continue;
        piece->edge1 = pair.on1.edge;  // at the ends rounding may put a point on the neighbour
        piece->edge2 = pair.on2.edge;
        piece->t1 = pair.on1.t;
        piece->t2 = pair.on2.t;
    }
    return piece && piece->edge1 >= 0 ? piece : std::nullopt;
}

}  // namespace

std::vector<ZonePiece> zone_pieces(const Part& part1, const Part& part2, const FacingZone& zone,
                                   const std::array<std::vector<double>, 2>& others) {
    ENSURE(!zone.chain1.edges.empty() && !zone.chain2.edges.empty(), "a zone is a stretch of two chains");
    const std::vector<double> cuts = cuts_of(part1, part2, zone, others);
    const double shortest = shortest_piece * (zone.end1 - zone.begin1);
    std::vector<ZonePiece> pieces;
    double guess = zone.begin2, from = cuts.front();
    for (const double to : cuts) {
        if (to - from <= shortest) continue;
        if (const auto piece = piece_between(part1, part2, zone, from, to, guess)) pieces.push_back(*piece);
        from = to;
    }
    return pieces;
}

FacingZone stretch_of(const Part& part1, const Part& part2, const FacingZone& whole, double begin1, double end1) {
    ENSURE(begin1 < end1 && whole.begin1 < whole.end1, "a stretch of a zone has a length");
    FacingZone z = whole;
    const auto partner = [&](double s1, double otherwise) {
        const double guess = whole.begin2 + (s1 - whole.begin1) / (whole.end1 - whole.begin1) * (whole.end2 - whole.begin2);
        const FacingPair pair = pair_from_first(part1, part2, whole, s1, guess);
        return pair.found ? pair.s2 : otherwise;
    };
    z.closed = false;
    z.begin_is_limit = whole.begin_is_limit && begin1 == whole.begin1;
    z.end_is_limit = whole.end_is_limit && end1 == whole.end1;
    z.begin1 = begin1;
    z.end1 = end1;
    z.begin2 = partner(begin1, whole.begin2);
    z.end2 = partner(end1, whole.end2);
    return z;
}

}  // namespace abut::geometry
