// SPDX-License-Identifier: GPL-3.0-or-later
// The lines that contact forces act on, see facing.hpp.
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/proximity/facing.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// Of the curvature beside a straight stretch: less than any curvature that is drawn.
constexpr double flat_sharpness = 1e-12;
/// Sides that are less inclined than this are parallel.
constexpr double parallel = 1e-9;
/// Curvatures of one circle differ by less, relative.
constexpr double same_circle = 1e-9;
/// Of its radius: what a round part may still slide by, tangentially, until it rests in a hollow that it is said to rest in.
constexpr double far_slide = 0.05;

/// What a stretch of a chain has of an edge.
struct PieceOfChain {
    const Curve* curve;
    double begin, end;  ///< arc lengths
};
std::vector<PieceOfChain> pieces_of(const Part& part, const Chain& chain, double low, double high) {
    std::vector<PieceOfChain> pieces;
    for (std::size_t k = 0; k < chain.edges.size(); ++k) {
        const double end = k + 1 < chain.begin.size() ? chain.begin[k + 1] : chain.length;
        const double turns = chain.closed ? chain.length * std::ceil((low - end) / chain.length) : 0;
        if (chain.begin[k] + turns >= high || end + turns <= low) continue;
        pieces.push_back(
            {&part.edges[at(chain.edges[k])].curve, std::max(low, chain.begin[k] + turns), std::min(high, end + turns)});
    }
    return pieces;
}

/// The largest curvature of the edges that a stretch of a chain has a part of.
double largest_curvature(const Part& part, const Chain& chain, double low, double high) {
    double largest = 0;
    for (const PieceOfChain& piece : pieces_of(part, chain, low, high))
        for (double t : {0.0, 0.5, 1.0}) largest = std::max(largest, std::abs(curvature(*piece.curve, t)));
    return largest;
}

/// The curvature of a stretch that is all of one circle, positive convex; 0: it is not.
double curvature_if_round(const Part& part, const Chain& chain, double low, double high) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const PieceOfChain& piece : pieces_of(part, chain, low, high))
        for (double t : {0.0, 0.5, 1.0}) {
            least = std::min(least, curvature(*piece.curve, t));
            most = std::max(most, curvature(*piece.curve, t));
        }
    return least > (1 - same_circle) * most ? most : 0;
}

/// How far s lies on the way from one place to another.
double share(double s, double from, double to) {
    return (s - from) / (to - from);
}

/// Is a side (0, 1) of a zone round, and rests in a hollow of the other that it fits, beside which there are other faces?
bool rests_in_hollow(const Part& part1, const Part& part2, const FacingZone& zone, std::size_t side) {
    constexpr int samples = 8;
    constexpr double fits = 0.5;  // hollows of up to twice its radius, as in weights()
    const bool first = side == 0;
    const double round = first ? curvature_if_round(part1, zone.chain1, zone.begin1, zone.end1)
                               : curvature_if_round(part2, zone.chain2, zone.end2, zone.begin2);
    if (round == 0) return false;
    std::vector<PieceOfChain> hollows =
        first ? pieces_of(part2, zone.chain2, zone.end2, zone.begin2) : pieces_of(part1, zone.chain1, zone.begin1, zone.end1);
    const std::size_t n_faces = hollows.size();
    std::erase_if(hollows, [&](const PieceOfChain& piece) { return curvature(*piece.curve, 0.5) > -fits * round; });
    if (hollows.size() == n_faces) return false;
    double least_gap = std::numeric_limits<double>::infinity();
    for (const PieceOfChain& hollow : hollows)
        for (int k = 0; k <= samples; ++k) {
            const double s = hollow.begin + (hollow.end - hollow.begin) * k / samples;
            const FacingPair pair = first
                                        ? pair_from_second(part1, part2, zone, s,
                                                           std::lerp(zone.begin1, zone.end1, share(s, zone.begin2, zone.end2)))
                                        : pair_from_first(part1, part2, zone, s,
                                                          std::lerp(zone.begin2, zone.end2, share(s, zone.begin1, zone.end1)));
            if (pair.found) least_gap = std::min(least_gap, pair.gap);
        }
    return least_gap <= zone.gap_min + 0.5 * far_slide * far_slide / round;
}

bool is_end(const Chain& chain, double s) {
    const double slack = end_slack * chain.length;
    return !chain.closed && (s <= slack || s >= chain.length - slack);
}

/// Where a chain ends in a hollow corner there is no point. Of a corner that is drawn into a face, the faces on either side
/// share its depth: zones end beside it.
bool ends_in_point(const Part& part, const Chain& chain, double s, double gap) {
    constexpr double beside = 2;  // depths
    const double off = std::min(std::abs(s), std::abs(chain.length - s));
    if (chain.closed || (!is_end(chain, s) && off > -beside * gap)) return false;
    return s < 0.5 * chain.length ? is_convex_corner(part, chain.edges.front(), 0)
                                  : is_convex_corner(part, chain.edges.back(), 1);
}

/// Does the gap have its least value at a corner of a side, and open from there?
std::array<bool, 2> is_gap_least_at_corner(const Part& part1, const Part& part2, const FacingZone& zone) {
    const FacingPair begin = pair_from_first(part1, part2, zone, zone.begin1, zone.begin2),
                     end = pair_from_first(part1, part2, zone, zone.end1, zone.end2);
    const double rounding = end_slack * (zone.chain1.length + zone.chain2.length);
    const bool at_begin = begin.gap <= end.gap;
    const FacingPair& nearest = at_begin ? begin : end;
    const bool opens = std::abs(cross(nearest.on1.normal, nearest.on2.normal)) > parallel;
    if (!opens || nearest.gap > zone.gap_min + rounding) return {false, false};
    return {ends_in_point(part1, zone.chain1, at_begin ? zone.begin1 : zone.end1, nearest.gap),
            ends_in_point(part2, zone.chain2, at_begin ? zone.begin2 : zone.end2, nearest.gap)};
}

/// The pair at the same sum of the lengths run along both chains, so that neither is preferred.
FacingPair pair_in_middle(const Part& part1, const Part& part2, const FacingZone& zone, double s1, double s2) {
    constexpr int max_steps = 20;
    const double sum = s1 - s2, rounding = 1e-14 * (zone.chain1.length + zone.chain2.length);
    FacingPair pair;
    for (int step = 0; step < max_steps; ++step) {
        pair = pair_from_first(part1, part2, zone, s1, s2);
        const double left = sum - (pair.s1 - pair.s2);
        if (!pair.found || std::abs(left) <= rounding) break;
        s2 = pair.s2;
        s1 += left / (1 - pair.slope);
    }
    return pair;
}

/// One end of the zone: the pair of the chain that ends there, of the first where both do, in the middle where none does.
void pair_end(const Part& part1, const Part& part2, const FacingZone& zone, double& s1, double& s2) {
    const bool first_ends = is_end(zone.chain1, s1), second_ends = is_end(zone.chain2, s2);
    FacingPair pair;
    if (!first_ends && !second_ends) pair = pair_in_middle(part1, part2, zone, s1, s2);
    if (!pair.found && !second_ends) pair = pair_from_first(part1, part2, zone, s1, s2);
    if (!pair.found) pair = pair_from_second(part1, part2, zone, s2, s1);
    if (!pair.found) pair = pair_from_first(part1, part2, zone, s1, s2);
    if (!pair.found) return;
    s1 = pair.s1;
    s2 = pair.s2;
}

}  // namespace

FacingZone acting_zone(const Part& part1, const Part& part2, FacingZone zone) {
    ENSURE(zone.begin1 < zone.end1 && !zone.chain1.edges.empty() && !zone.chain2.edges.empty(),
           "a zone is a stretch of two chains");
    const FacingZone found = zone;
    zone.at_corner = is_gap_least_at_corner(part1, part2, zone);
    zone.in_hollow = {rests_in_hollow(part1, part2, zone, 0), rests_in_hollow(part1, part2, zone, 1)};
    zone.sharpness = {flat_sharpness * largest_curvature(part1, zone.chain1, zone.begin1, zone.end1),
                      flat_sharpness * largest_curvature(part2, zone.chain2, zone.end2, zone.begin2)};
    zone.is_acting = true;
    pair_end(part1, part2, zone, zone.begin1, zone.begin2);
    if (zone.closed) {
        zone.end1 = zone.begin1 + zone.chain1.length;
        zone.end2 = zone.begin2 - zone.chain2.length;
    } else {
        pair_end(part1, part2, zone, zone.end1, zone.end2);
    }
    const bool has_pairs = zone.begin1 < zone.end1 && zone.begin2 > zone.end2;
    return has_pairs ? zone : found;
}

}  // namespace abut::geometry
