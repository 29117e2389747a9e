// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/contact/drawn_overlap.hpp"
#include "src/scene/scene.hpp"

namespace abut {

namespace {

/// Is a pair of edges searched at all? Without detection only what rules speak of.
bool is_searched(const Scene& scene, int rule) {
    return rule < 0 ? scene.contacts.detect
                    : scene.contacts.pairs[static_cast<std::size_t>(rule)].kind != PairRule::Kind::ignore;
}

/// What two parts have in common where no rule leaves it alone.
geometry::Overlap overlap_searched(const Scene& scene, const PairRules& rules, int first, int second, double touching) {
    const geometry::Part &a = part_of(scene, first), &b = part_of(scene, second);
    if (rules.none()) return is_searched(scene, -1) ? overlap(a, b, touching) : geometry::Overlap();
    std::vector<geometry::Overlap> all = overlaps(a, b, touching);
    std::erase_if(all, [&](const geometry::Overlap& o) {
        const auto on = [&](const geometry::Part& part, int edge) {
            return closest_parameter(part.edges[at(edge)].curve, o.at);
        };
        return !is_searched(scene, rules.of({first, o.edge1, on(a, o.edge1)}, {second, o.edge2, on(b, o.edge2)}));
    });
    return joined(all);
}

/// Overlaps deeper than this have faces that are not paired.
double deepest_paired(const SearchDistances& distances, int first, int second) {
    return std::min(distances.searched(first, second, 1), first_search_fraction * distances.size(first, second));
}

/// A zone whose faces have passed each other: where parts have nothing in common, and deeper than any fit, these are the far
/// sides of thin parts.
bool is_far_side(const geometry::FacingZone& zone, const geometry::Overlap& common, double touching, double deepest) {
    return zone.gap_min < -(common.depth > touching ? deepest : 2 * touching);
}

Candidate candidate_of(const Scene& scene, int first, int second, RuledZone&& ruled) {
    Candidate c{first, second, acting_zone(part_of(scene, first), part_of(scene, second), std::move(ruled.zone))};
    c.no_overlap = scene.contacts.overlap == "ignore";
    c.rule = ruled.rule;
    c.friction = scene.contacts.friction;
    if (c.rule >= 0) {
        const PairRule& rule = scene.contacts.pairs[static_cast<std::size_t>(c.rule)];
        c.interference = rule.interference;
        c.bonded = rule.kind == PairRule::Kind::bonded;
        c.friction = c.bonded ? 0 : rule.friction.value_or(c.friction);
    }
    return c;
}

/// Pairs run along the middle of both normals, at most 30 degrees from either: a zone along an overlap sees more than half of
/// its depth.
bool sees_depth(const geometry::FacingZone& zone, double depth) {
    return zone.gap_min <= -0.5 * depth;
}

std::vector<Candidate> in_order(std::vector<Encounter>&& encounters) {
    std::vector<Candidate> candidates;
    for (Encounter& m : encounters) std::move(m.candidates.begin(), m.candidates.end(), std::back_inserter(candidates));
    std::stable_sort(candidates.begin(), candidates.end(), comes_before);
    return candidates;
}

/// Does the zone begin or end at the closest points? At a corner: its pair there runs along the middle normal, at most 30
/// degrees from the shortest way.
bool ends_at_closest(const Scene& scene, const Encounter& m, const geometry::FacingZone& zone, double tolerance) {
    constexpr double beside = 0.6;  // above the tangent of 30 degrees
    const auto meets = [&](double s1, double guess) {
        const geometry::FacingPair p = pair_from_first(part_of(scene, m.first), part_of(scene, m.second), zone, s1, guess);
        const double off1 = (p.on1.x - m.closest->x1).norm(), off2 = (p.on2.x - m.closest->x2).norm();
        return std::min(off1, off2) <= tolerance && std::max(off1, off2) <= beside * std::abs(p.gap) + tolerance;
    };
    return m.closest && (meets(zone.begin1, zone.begin2) || meets(zone.end1, zone.end2));
}

}  // namespace

void begin_at(const geometry::FacingPair& pair, geometry::FacingZone& zone) {
    ENSURE(zone.closed, "a zone that goes all the way round begins anywhere");
    zone.begin1 = pair.s1;
    zone.end1 = pair.s1 + zone.chain1.length;
    zone.begin2 = pair.s2;
    zone.end2 = pair.s2 - zone.chain2.length;
}

double drawn_gap(const Scene& scene, const Encounter& m, const Candidate& c, double touching) {
    return ends_at_closest(scene, m, c.zone, touching) ? std::min(c.zone.gap_min, m.closest->distance) : c.zone.gap_min;
}

Encounter encounter_of(const Scene& scene, const PairRules& rules, const SearchDistances& distances, int first, int second,
                       const EncounterDistances& within) {
    ENSURE(first >= 0 && first < second && at(second) < scene.parts.size(), "two parts of the scene meet, in their order");
    ENSURE(within.search >= 0 && within.closest >= 0, "parts are searched up to distances");
    const geometry::Part &a = part_of(scene, first), &b = part_of(scene, second);
    const double touching = distances.touching(first, second), deepest = deepest_paired(distances, first, second);
    const geometry::Overlap common = overlap_searched(scene, rules, first, second, touching);
    Encounter m{first, second};
    m.closest = closest_points(a, b, std::max(within.closest, touching));
    bool paired = false, depth_seen = false;
    std::vector<geometry::FacingZone> zones = find_facing_zones(a, b, std::max(within.search, touching));
    if (within.cells) zones = within.cells->in_cells(scene, first, second, zones);
    for (geometry::FacingZone& zone : zones) {
        if (is_far_side(zone, common, touching, first_search_fraction * distances.size(first, second))) continue;
        paired = paired ||
                 (m.closest && (zone.gap_min <= m.closest->distance + touching || ends_at_closest(scene, m, zone, touching)));
        depth_seen = depth_seen || sees_depth(zone, common.depth);
        for (RuledZone& ruled : split_by_rules(scene, rules, first, second, zone))
            if (is_searched(scene, ruled.rule)) m.candidates.push_back(candidate_of(scene, first, second, std::move(ruled)));
    }
    for (Candidate& c : m.candidates) c.shown = drawn_gap(scene, m, c, touching) - c.interference <= within.shown;
    m.counts_as_touching = scene.contacts.overlap == "report" && common.depth <= distances.precision(first, second);
    // "touching" is no word of scenes: parts are where a solution has pressed them into each other
    if (m.counts_as_touching || scene.contacts.overlap == "touching")
        for (Candidate& c : m.candidates) c.apart = std::max(0.0, -c.zone.gap_min);
    if (common.depth > touching) {
        m.overlap = common;
        m.too_deep = common.depth > deepest || !depth_seen;
        m.is_refused = m.too_deep || (scene.contacts.overlap == "report" && !m.counts_as_touching);
    }
    m.unpaired =
        m.closest && !paired &&
        is_searched(scene, rules.of({first, m.closest->edge1, m.closest->t1}, {second, m.closest->edge2, m.closest->t2}));
    return m;
}

std::vector<Candidate> own_candidates(const Scene& scene, const PairRules& rules, int part, double distance) {
    ENSURE(part >= 0 && at(part) < scene.parts.size(), "the part is one of the scene");
    std::vector<Candidate> candidates;
    for (const geometry::FacingZone& zone : find_own_facing_zones(part_of(scene, part), distance))
        for (RuledZone& ruled : split_by_rules(scene, rules, part, part, zone))
            if (is_searched(scene, ruled.rule)) {
                candidates.push_back(candidate_of(scene, part, part, std::move(ruled)));
                candidates.back().shown = false;
            }
    return candidates;
}

std::vector<Encounter> find_encounters(const Scene& scene, double factor) {
    ENSURE(factor > 0, "a search goes some way");
    std::vector<Encounter> encounters;
    if (!searches_contacts(scene)) return encounters;
    const PairRules rules(scene);
    const SearchDistances distances(scene);
    const std::optional<CellSearch> cells = cell_search(scene);
    const int n = static_cast<int>(scene.parts.size());
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j) {
            if (cells) {
                const double all = cell_search_distance(scene);
                if (cells->case_of(i, j) != 'e')
                    encounters.push_back(encounter_of(scene, rules, distances, i, j, {all, all, all, &*cells}));
                continue;
            }
            const double distance = distances.searched(i, j, factor), shown = distances.shown(i, j);
            if (distances.within(i, j, distance))
                encounters.push_back(encounter_of(scene, rules, distances, i, j, {distance, shown, shown}));
        }
    for (int i : parts_with_themselves(scene.contacts))
        encounters.push_back({i, i, own_candidates(scene, rules, i, distances.searched(i, i, factor))});
    return encounters;
}

bool comes_before(const Candidate& a, const Candidate& b) {
    return std::tuple(!a.shown, a.first, a.second) < std::tuple(!b.shown, b.first, b.second);
}

std::vector<Candidate> find_candidates(const Scene& scene, double factor) {
    std::vector<Encounter> encounters = find_encounters(scene, factor);
    std::vector<Problem> problems;
    if (factor == 1) check_overlaps(scene, encounters, problems);
    if (!problems.empty()) throw InputError(problems);
    return in_order(std::move(encounters));
}

std::vector<Candidate> find_candidates_anyway(const Scene& scene, double factor) {
    return in_order(find_encounters(scene, factor));
}

PartPairs touching_pairs(const std::vector<Candidate>& candidates) {
    PartPairs pairs;
    for (const Candidate& c : candidates) pairs.emplace_back(c.first, c.second);
    return pairs;
}

PartPairs closing_pairs(const Scene& scene, const std::vector<Candidate>& candidates) {
    PartPairs pairs;
    for (const Candidate& c : candidates)
        if (c.interference != 0 || scene.contacts.overlap == "press_fit") pairs.emplace_back(c.first, c.second);
    return pairs;
}

bool has_friction(const std::vector<Candidate>& candidates) {
    return std::any_of(candidates.begin(), candidates.end(), [](const Candidate& c) { return !c.bonded && c.friction > 0; });
}

}  // namespace abut
