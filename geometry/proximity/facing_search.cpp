// SPDX-License-Identifier: GPL-3.0-or-later
// Facing zones of two parts, in four steps:
//   1. pairs of edges whose boxes come within the distance          (edge_tree)
//   2. the stretches of each such pair that face each other         (facing_stretch)
//   3. of several partners of one point the nearest                 (facing_nearest)
//   4. stretches that continue each other on both chains, joined    (here)
// Ellipses and splines are searched by their arcs first            (facing_general)
// No step samples the boundary at a chosen density: what a zone ends at (corner, distance, angle, nearer partner) is found to
// rounding, however long the edges and however small the distance.
#include "geometry/proximity/facing_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/curves/arc_spline.hpp"
#include "geometry/proximity/facing_general.hpp"
#include "geometry/proximity/facing_nearest.hpp"
#include "geometry/proximity/facing_stretch.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

/// A stretch by arc length along the chains.
struct ChainRun {
    int chain1 = -1, chain2 = -1;
    double begin1 = 0, end1 = 0, begin2 = 0, end2 = 0;
    double gap_begin = 0, gap_end = 0;
};

/// Which chain an edge belongs to, and where on it the edge begins.
struct Place {
    int chain = -1;
    double begin = 0;
};
std::vector<Place> places(const Part& part, const std::vector<Chain>& chains) {
    std::vector<Place> found(part.edges.size());
    for (std::size_t c = 0; c < chains.size(); ++c)
        for (std::size_t i = 0; i < chains[c].edges.size(); ++i)
            found[static_cast<std::size_t>(chains[c].edges[i])] = {static_cast<int>(c), chains[c].begin[i]};
    return found;
}

/// The chains of both parts, by the numbers that runs have.
struct BothChains {
    const std::vector<Chain>&first, &second;
    double joint_angle;
    const Chain& of1(const ChainRun& run) const { return first[static_cast<std::size_t>(run.chain1)]; }
    const Chain& of2(const ChainRun& run) const { return second[static_cast<std::size_t>(run.chain2)]; }
};

std::vector<FacingStretch> stretches_of(const FacingModel& model) {
    std::vector<FacingStretch> all;
    const Box2 box2 = bounding_box(model.part2);
    for (std::size_t e = 0; e < model.part1.edges.size(); ++e) {
        const Box2 box1 = bounding_box(model.part1.edges[e].curve);
        if (!box1.overlaps(box2, model.distance)) continue;
        for (const int other : model.tree2.near(box1, model.distance))
            for (const FacingStretch& s : facing_stretches(model, static_cast<int>(e), other)) all.push_back(s);
    }
    return all;
}

std::vector<ChainRun> runs_of(const FacingModel& model, const BothChains& chains, const std::vector<FacingStretch>& stretches) {
    const std::vector<Place> places1 = places(model.part1, chains.first), places2 = places(model.part2, chains.second);
    std::vector<ChainRun> runs;
    for (const FacingStretch& s : stretches) {
        const Place p1 = places1[static_cast<std::size_t>(s.edge1)], p2 = places2[static_cast<std::size_t>(s.edge2)];
        runs.push_back({p1.chain, p2.chain, p1.begin + s.begin.s1, p1.begin + s.end.s1, p2.begin + s.begin.s2,
                        p2.begin + s.end.s2, s.begin.gap, s.end.gap});
    }
    std::sort(runs.begin(), runs.end(), [](const ChainRun& a, const ChainRun& b) {
        if (a.chain1 != b.chain1) return a.chain1 < b.chain1;
        if (a.begin1 != b.begin1) return a.begin1 < b.begin1;
        return a.chain2 < b.chain2;
    });
    return runs;
}

/// a - b, modulo the chain's length on closed chains.
double difference(const Chain& chain, double a, double b) {
    return chain.closed ? std::remainder(a - b, chain.length) : a - b;
}

/// How far from each other two runs that meet at a joint may end: what the joint turns by moves the partner by that times the
/// gap.
double joint_slack(const FacingModel& model, const ChainRun& run, double joint_angle) {
    return 100 * model.same + 2 * joint_angle * std::abs(run.gap_end);
}

/// Does `next` begin where `run` ends, on both chains?
bool continues(const FacingModel& model, const BothChains& chains, const ChainRun& run, const ChainRun& next) {
    if (run.chain1 != next.chain1 || run.chain2 != next.chain2) return false;
    const double slack = joint_slack(model, run, chains.joint_angle);
    return std::abs(difference(chains.of1(run), next.begin1, run.end1)) <= slack &&
           std::abs(difference(chains.of2(run), next.begin2, run.end2)) <= slack;
}

/// Runs in the order in which they continue each other.
using Group = std::vector<ChainRun>;

/// Groups of runs that continue each other; runs are sorted, so that a successor stands later but for the seam of a chain.
std::vector<Group> grouped(const FacingModel& model, const BothChains& chains, const std::vector<ChainRun>& runs) {
    std::vector<Group> groups;
    std::vector<std::size_t> open;  // groups that may still grow: those of the current chain of part 1
    for (const ChainRun& run : runs) {
        if (!groups.empty() && groups.back().front().chain1 != run.chain1) open.clear();
        const auto fits = [&](std::size_t g) { return continues(model, chains, groups[g].back(), run); };
        const auto found = std::find_if(open.rbegin(), open.rend(), fits);
        if (found != open.rend()) {
            groups[*found].push_back(run);
        } else {
            open.push_back(groups.size());
            groups.push_back({run});
        }
    }
    return groups;
}

/// Joins across the seam of closed chains of part 1: the group that ends there takes in the one that begins there.
void join_across_seams(const FacingModel& model, const BothChains& chains, std::vector<Group>& groups) {
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const Chain& chain = chains.of1(groups[i].back());
        const double slack = joint_slack(model, groups[i].back(), chains.joint_angle - chain_angle);
        if (!chain.closed || std::abs(groups[i].back().end1 - chain.length) > slack) continue;
        for (std::size_t k = 0; k < groups.size(); ++k) {
            if (k == i || !continues(model, chains, groups[i].back(), groups[k].front())) continue;
            groups[i].insert(groups[i].end(), groups[k].begin(), groups[k].end());
            groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(k));
            if (k < i) --i;
            break;
        }
    }
}

bool is_full_turn(const FacingModel& model, const BothChains& chains, const Group& group) {
    if (!chains.of1(group.front()).closed || !chains.of2(group.front()).closed) return false;
    return continues(model, chains, group.back(), group.front());
}

/// Full turns begin where the gap is largest, uniform ones at the start of the chain: the runs are monotone, so that this is
/// the beginning of one of them.
void turn_to_largest_gap(const FacingModel& model, Group& group) {
    auto first = group.begin(), largest = group.begin();
    for (auto run = group.begin(); run != group.end(); ++run) {
        if (run->begin1 < first->begin1) first = run;
        if (run->gap_begin > largest->gap_begin + 100 * model.same) largest = run;
    }
    const bool uniform = largest->gap_begin <= first->gap_begin + 100 * model.same;
    std::rotate(group.begin(), uniform ? first : largest, group.end());
}

FacingZone zone_of(const FacingModel& model, const BothChains& chains, const Group& group, bool closed) {
    FacingZone zone;
    zone.chain1 = chains.of1(group.front());
    zone.chain2 = chains.of2(group.front());
    zone.closed = closed;
    const ChainRun &first = group.front(), &last = group.back();
    const double length1 = zone.chain1.length, length2 = zone.chain2.length;

    zone.begin1 = first.begin1;
    zone.end1 = zone.closed ? zone.begin1 + length1 : last.end1 + (last.end1 <= first.begin1 ? length1 : 0.0);
    zone.begin2 = first.begin2;
    zone.end2 = zone.closed ? zone.begin2 - length2 : last.end2;
    if (zone.chain2.closed) {  // end2 in [0, length), begin2 above it
        const double drop = zone.closed ? length2 : std::fmod(zone.begin2 - zone.end2 + 2 * length2, length2);
        zone.end2 -= length2 * std::floor(zone.end2 / length2);
        zone.begin2 = zone.end2 + drop;
    }

    zone.gap_min = zone.gap_max = first.gap_begin;
    for (const ChainRun& run : group) {
        zone.gap_min = std::min({zone.gap_min, run.gap_begin, run.gap_end});
        zone.gap_max = std::max({zone.gap_max, run.gap_begin, run.gap_end});
    }
    const auto at_distance = [&](double gap) { return std::abs(std::abs(gap) - model.distance) <= 1e-9 * model.distance; };
    const auto at_corner = [](const Chain& chain, double s) { return !chain.closed && (s <= 0 || s >= chain.length); };
    zone.begin_is_limit = !zone.closed && at_distance(first.gap_begin) && !at_corner(zone.chain1, zone.begin1) &&
                          !at_corner(zone.chain2, zone.begin2);
    zone.end_is_limit =
        !zone.closed && at_distance(last.gap_end) && !at_corner(zone.chain1, zone.end1) && !at_corner(zone.chain2, zone.end2);
    return zone;
}

/// The runs' ends one after the other, unwrapped on closed chains so that they continue each other.
std::vector<FoundZone::Break> breaks_of(const FacingZone& zone, const Group& group) {
    std::vector<FoundZone::Break> breaks{{zone.begin1, zone.begin2}};
    const auto add = [&](double s1, double s2) {
        const FoundZone::Break& last = breaks.back();
        breaks.push_back({last.s1 + difference(zone.chain1, s1, last.s1), last.s2 + difference(zone.chain2, s2, last.s2)});
    };
    constexpr int steps = 4;  // a run may be all of a closed chain; a step must be less than half of it
    for (const ChainRun& run : group)
        for (int k = 0; k <= steps; ++k) {
            const double share = static_cast<double>(k) / steps;
            add(run.begin1 + share * (run.end1 - run.begin1), run.begin2 + share * (run.end2 - run.begin2));
        }
    breaks.push_back({zone.end1, zone.end2});
    return breaks;
}

FoundZone found_zone(const FacingModel& model, const BothChains& chains, Group group) {
    const bool closed = is_full_turn(model, chains, group);
    if (closed) turn_to_largest_gap(model, group);
    FoundZone found;
    found.chain1 = group.front().chain1;
    found.chain2 = group.front().chain2;
    found.zone = zone_of(model, chains, group, closed);
    found.breaks = breaks_of(found.zone, group);
    return found;
}

/// A part faces itself along every zone from both sides.
bool is_mirrored(const FoundZone& found) {
    const auto turned_back = [](const Chain& chain, double s) {
        return chain.closed ? s - chain.length * std::floor(s / chain.length) : s;
    };
    const FacingZone& z = found.zone;
    return std::pair(found.chain1, turned_back(z.chain1, z.begin1)) > std::pair(found.chain2, turned_back(z.chain2, z.end2));
}

}  // namespace

std::vector<FoundZone> search_zones(const Part& part1, const std::vector<Chain>& chains1, const Part& part2,
                                    const std::vector<Chain>& chains2, double distance, double joint_angle, bool own) {
    std::vector<FoundZone> zones;
    const FacingModel model(part1, part2, distance);
    const BothChains chains{chains1, chains2, joint_angle};
    std::vector<FacingStretch> stretches = stretches_of(model);
    if (own) std::erase_if(stretches, [](const FacingStretch& s) { return s.begin.gap + s.end.gap <= 0; });
    std::vector<Group> groups = grouped(model, chains, runs_of(model, chains, nearest_only(model, stretches)));
    join_across_seams(model, chains, groups);
    const double shortest = shortest_zone_fraction * model.size;
    for (const Group& group : groups) {
        const FoundZone found = found_zone(model, chains, group);
        if (found.zone.end1 - found.zone.begin1 > shortest && !(own && is_mirrored(found))) zones.push_back(found);
    }
    return zones;
}

namespace {

std::vector<FacingZone> facing_zones(const Part& part1, const Part& part2, double distance, bool own) {
    if (has_general_curves(part1) || has_general_curves(part2)) return general_facing_zones(part1, part2, distance, own);
    std::vector<FacingZone> zones;
    for (const FoundZone& found :
         search_zones(part1, smooth_chains(part1), part2, smooth_chains(part2), distance, chain_angle, own))
        zones.push_back(found.zone);
    return zones;
}

/// The length of the boundary between two points of one loop, the shorter way round.
double way_along(const Part& part, const ChainPoint& from, const ChainPoint& to) {
    for (const Loop& loop : part.loops) {
        double all = 0, begin = -1, end = -1;
        for (const int e : loop.edges) {
            const Curve& curve = curve_of(part, e);
            if (e == from.edge) begin = all + length(curve, 0, from.t);
            if (e == to.edge) end = all + length(curve, 0, to.t);
            all += length(curve);
        }
        if (begin >= 0 && end >= 0) return std::min(std::abs(end - begin), all - std::abs(end - begin));
    }
    return std::numeric_limits<double>::infinity();
}

bool is_notch(const Part& part, const FacingZone& zone) {
    const auto is_near = [&](double s1, double s2) {
        const ChainPoint a = chain_point(part, zone.chain1, s1), b = chain_point(part, zone.chain2, s2);
        return way_along(part, a, b) <= least_way * (b.x - a.x).norm();
    };
    return is_near(zone.begin1, zone.begin2) && is_near(zone.end1, zone.end2);
}

}  // namespace

std::vector<FacingZone> find_facing_zones(const Part& part1, const Part& part2, double distance) {
    ENSURE(distance >= 0, "zones are searched up to a distance");
    if (!bounding_box(part1).overlaps(bounding_box(part2), distance)) return {};
    return facing_zones(part1, part2, distance, false);
}

std::vector<FacingZone> find_own_facing_zones(const Part& part, double distance) {
    ENSURE(distance >= 0, "zones are searched up to a distance");
    std::vector<FacingZone> zones = facing_zones(part, part, distance, true);
    std::erase_if(zones, [&](const FacingZone& zone) { return is_notch(part, zone); });
    return zones;
}

}  // namespace abut::geometry
