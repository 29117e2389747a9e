// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/overlap.hpp"
#include "src/pair_rules.hpp"
#include "src/svg.hpp"

namespace abut {

namespace {

const geometry::Part& part_of(const Scene& scene, int i) {
    return scene.parts[static_cast<std::size_t>(i)].part;
}

void check_overlap(const Scene& scene, const Candidate& c, double allowed, std::vector<Problem>& problems) {
    if (c.zone.gap_min >= -allowed) return;
    const ScenePart &a = scene.parts[static_cast<std::size_t>(c.first)], &b = scene.parts[static_cast<std::size_t>(c.second)];
    const std::string edges = a.name + "/" + a.part.edges[static_cast<std::size_t>(c.zone.chain1.edges.front())].name +
                              " and " + b.name + "/" + b.part.edges[static_cast<std::size_t>(c.zone.chain2.edges.front())].name;
    problems.push_back(
        {a.where, "parts " + a.name + " and " + b.name + " overlap by " + number_text(-c.zone.gap_min, 4) + " at " + edges,
         "move them apart, or set contacts.overlap to \"press_fit\" or \"ignore\""});
}

/// A part drawn inside another's material: no boundaries need to meet.
void check_containment(const Scene& scene, int i, int j, double allowed, std::vector<Problem>& problems) {
    const auto inside = [&](const geometry::Part& outer, const geometry::Part& inner) {
        const Vec2 p = point(inner.edges.front().curve, 0.5);
        double away = std::numeric_limits<double>::infinity();
        for (const geometry::Edge& e : outer.edges)
            away = std::min(away, (point(e.curve, closest_parameter(e.curve, p)) - p).norm());
        return away > allowed && contains(outer, p);
    };
    const geometry::Part &a = part_of(scene, i), &b = part_of(scene, j);
    const bool same_place = std::abs(area(a) - area(b)) <= allowed * perimeter(a) &&
                            (centroid(a) - centroid(b)).norm() <= allowed && std::abs(perimeter(a) - perimeter(b)) <= allowed &&
                            overlap(a, b, allowed).area > 0.5 * area(a);
    if (!same_place && !inside(a, b) && !inside(b, a)) return;
    const ScenePart &first = scene.parts[static_cast<std::size_t>(i)], &second = scene.parts[static_cast<std::size_t>(j)];
    problems.push_back({second.where, "parts " + first.name + " and " + second.name + " lie in the same place",
                        "move one of them, or cut the one out of the other"});
}

}  // namespace

double search_distance(const Scene& scene, int first, int second, double factor) {
    if (scene.contacts.search_distance) return *scene.contacts.search_distance;
    const double size =
        std::min(bounding_box(part_of(scene, first)).diagonal(), bounding_box(part_of(scene, second)).diagonal());
    return factor * first_search_fraction * size;
}

std::vector<Candidate> find_candidates(const Scene& scene, double factor) {
    std::vector<Candidate> candidates;
    std::vector<Problem> problems;
    if (!scene.contacts.detect && scene.contacts.pairs.empty()) return candidates;
    const int n = static_cast<int>(scene.parts.size());
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j) {
            const auto box_i = bounding_box(part_of(scene, i)), box_j = bounding_box(part_of(scene, j));
            const double size = std::min(box_i.diagonal(), box_j.diagonal());
            const double distance = search_distance(scene, i, j, factor);
            if (!box_i.overlaps(box_j, distance)) continue;
            if (factor == 1 && scene.contacts.overlap == "report")
                check_containment(scene, i, j, overlap_fraction * size, problems);
            const double deepest = -first_search_fraction * size;
            for (geometry::FacingZone& zone : find_facing_zones(part_of(scene, i), part_of(scene, j), distance)) {
                if (zone.gap_min < deepest && distance > first_search_fraction * size) continue;  // a far side, not an overlap
                const Candidate whole{i, j, acting_zone(part_of(scene, i), part_of(scene, j), std::move(zone)), 0,
                                      scene.contacts.overlap == "ignore"};
                for (Ruled& ruled : split_by_rules(scene, whole)) {
                    Candidate& c = ruled.candidate;
                    const PairRule* rule =
                        ruled.rule < 0 ? nullptr : &scene.contacts.pairs[static_cast<std::size_t>(ruled.rule)];
                    if (rule ? rule->kind == PairRule::Kind::ignore : !scene.contacts.detect) continue;
                    if (rule) c.closing = rule->interference;
                    c.bonded = rule && rule->kind == PairRule::Kind::bonded;
                    c.rule = ruled.rule;
                    if (factor == 1 && scene.contacts.overlap == "report")
                        check_overlap(scene, c, overlap_fraction * size, problems);
                    candidates.push_back(std::move(c));
                }
            }
        }
    if (!problems.empty()) throw InputError(problems);
    return candidates;
}

PartPairs touching_pairs(const std::vector<Candidate>& candidates) {
    PartPairs pairs;
    for (const Candidate& c : candidates) pairs.emplace_back(c.first, c.second);
    return pairs;
}

PartPairs closing_pairs(const Scene& scene, const std::vector<Candidate>& candidates) {
    PartPairs pairs;
    for (const Candidate& c : candidates)
        if (c.closing != 0 || scene.contacts.overlap == "press_fit") pairs.emplace_back(c.first, c.second);
    return pairs;
}

}  // namespace abut
