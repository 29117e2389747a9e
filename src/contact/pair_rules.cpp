// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact/pair_rules.hpp"

#include <algorithm>

#include "geometry/proximity/zone_pieces.hpp"
#include "src/scene/scene.hpp"
#include "src/scene/selection.hpp"

namespace abut {

namespace {

using geometry::FacingZone;

/// Pieces of a zone one after the other that fall under one rule.
struct Run {
    int rule;
    double begin1, end1, gap_min, gap_max;
};

/// The stretch of a zone that a run is.
FacingZone stretch_of(const Scene& scene, int first, int second, const FacingZone& whole, const Run& run) {
    FacingZone z = geometry::stretch_of(part_of(scene, first), part_of(scene, second), whole, run.begin1, run.end1);
    z.gap_min = run.gap_min;
    z.gap_max = run.gap_max;
    return z;
}

}  // namespace

PairRules::PairRules(const Scene& scene) {
    const auto edges_of = [&](const Selection& side) {
        Edges edges;
        for (const EdgePortion& portion : select(scene, side)) edges.insert({portion.part, portion.edge});
        return edges;
    };
    for (const PairRule& rule : scene.contacts.pairs) edges_.push_back({edges_of(rule.between[0]), edges_of(rule.between[1])});
}

int PairRules::of(int part1, int edge1, int part2, int edge2) const {
    const std::array<int, 2> a{part1, edge1}, b{part2, edge2};
    for (int r = static_cast<int>(edges_.size()) - 1; r >= 0; --r) {
        const auto& [one, other] = edges_[static_cast<std::size_t>(r)];
        if ((one.count(a) && other.count(b)) || (one.count(b) && other.count(a))) return r;
    }
    return -1;
}

int PairRules::later_than(int r) const {
    const auto share = [](const Edges& a, const Edges& b) {
        return std::any_of(a.begin(), a.end(), [&](const auto& edge) { return b.count(edge) > 0; });
    };
    const auto& [one, other] = edges_[static_cast<std::size_t>(r)];
    for (int q = static_cast<int>(edges_.size()) - 1; q > r; --q) {
        const auto& [a, b] = edges_[static_cast<std::size_t>(q)];
        if ((share(one, a) && share(other, b)) || (share(one, b) && share(other, a))) return q;
    }
    return -1;
}

std::vector<RuledZone> split_by_rules(const Scene& scene, const PairRules& rules, int first, int second,
                                      const FacingZone& zone) {
    if (rules.none()) return {{zone, -1}};
    std::vector<Run> runs;
    for (const geometry::ZonePiece& p : zone_pieces(part_of(scene, first), part_of(scene, second), zone)) {
        const int rule = rules.of(first, p.edge1, second, p.edge2);
        if (runs.empty() || runs.back().rule != rule) {
            runs.push_back({rule, p.begin1, p.end1, p.gap_min, p.gap_max});
            continue;
        }
        runs.back().end1 = p.end1;
        runs.back().gap_min = std::min(runs.back().gap_min, p.gap_min);
        runs.back().gap_max = std::max(runs.back().gap_max, p.gap_max);
    }
    if (runs.size() == 1) return {{zone, runs[0].rule}};
    std::vector<RuledZone> stretches;
    for (const Run& run : runs) stretches.push_back({stretch_of(scene, first, second, zone, run), run.rule});
    return stretches;
}

}  // namespace abut
