// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact/pair_rules.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "geometry/proximity/zone_pieces.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

using geometry::FacingZone;

/// Pieces of a zone one after the other that fall under one rule.
struct Run {
    int rule;
    double begin1, end1, gap_min, gap_max;
};

void go_on(Run& run, double end1, double gap_min, double gap_max) {
    run.end1 = end1;
    run.gap_min = std::min(run.gap_min, gap_min);
    run.gap_max = std::max(run.gap_max, gap_max);
}

/// The stretch of a zone that a run is.
FacingZone stretch_of(const Scene& scene, int first, int second, const FacingZone& whole, const Run& run) {
    FacingZone z = geometry::stretch_of(part_of(scene, first), part_of(scene, second), whole, run.begin1, run.end1);
    z.gap_min = run.gap_min;
    z.gap_max = run.gap_max;
    return z;
}

/// The portions of an edge, among sorted ones.
std::span<const EdgePortion> portions_on(const std::vector<EdgePortion>& portions, int part, int edge) {
    const auto of_edge = [](const EdgePortion& p) { return std::pair(p.part, p.edge); };
    return std::ranges::equal_range(portions, std::pair(part, edge), {}, of_edge);
}

bool holds(const std::vector<EdgePortion>& portions, const BoundaryPlace& place) {
    const auto own = portions_on(portions, place.part, place.edge);
    return std::any_of(own.begin(), own.end(), [&](const EdgePortion& p) { return p.t0 <= place.t && place.t <= p.t1; });
}

bool share(const std::vector<EdgePortion>& a, const std::vector<EdgePortion>& b) {
    return std::any_of(a.begin(), a.end(), [&](const EdgePortion& p) {
        const auto there = portions_on(b, p.part, p.edge);
        return std::any_of(there.begin(), there.end(),
                           [&](const EdgePortion& q) { return std::max(p.t0, q.t0) < std::min(p.t1, q.t1); });
    });
}

/// The arc lengths of a chain where rules begin or end inside its edges.
std::vector<double> ends_along(const Scene& scene, const PairRules& rules, int part, const geometry::Chain& chain) {
    std::vector<double> ends;
    for (std::size_t k = 0; k < chain.edges.size(); ++k)
        for (const double t : rules.ends_on(part, chain.edges[k]))
            ends.push_back(chain.begin[k] + length(part_of(scene, part).edges[at(chain.edges[k])].curve, 0, t));
    return ends;
}

}  // namespace

PairRules::PairRules(const Scene& scene) {
    for (const PairRule& rule : scene.contacts.pairs) on_.push_back(rule.on);
}

int PairRules::of(const BoundaryPlace& a, const BoundaryPlace& b) const {
    for (int r = static_cast<int>(on_.size()) - 1; r >= 0; --r) {
        const auto& [one, other] = on_[at(r)];
        if ((holds(one, a) && holds(other, b)) || (holds(one, b) && holds(other, a))) return r;
    }
    return -1;
}

int PairRules::later_than(int r) const {
    const auto& [one, other] = on_[at(r)];
    for (int q = static_cast<int>(on_.size()) - 1; q > r; --q) {
        const auto& [a, b] = on_[at(q)];
        if ((share(one, a) && share(other, b)) || (share(one, b) && share(other, a))) return q;
    }
    return -1;
}

std::vector<double> PairRules::ends_on(int part, int edge) const {
    std::vector<double> ends;
    for (const auto& sides : on_)
        for (const std::vector<EdgePortion>& side : sides)
            for (const EdgePortion& p : portions_on(side, part, edge))
                for (const double t : {p.t0, p.t1})
                    if (t > 0 && t < 1) ends.push_back(t);
    return ends;
}

std::vector<RuledZone> split_by_rules(const Scene& scene, const PairRules& rules, int first, int second,
                                      const FacingZone& zone) {
    if (rules.none()) return {{zone, -1}};
    std::vector<Run> runs;
    for (const geometry::ZonePiece& p :
         zone_pieces(part_of(scene, first), part_of(scene, second), zone,
                     {ends_along(scene, rules, first, zone.chain1), ends_along(scene, rules, second, zone.chain2)})) {
        const int rule = rules.of({first, p.edge1, p.t1}, {second, p.edge2, p.t2});
        if (runs.empty() || runs.back().rule != rule)
            runs.push_back({rule, p.begin1, p.end1, p.gap_min, p.gap_max});
        else
            go_on(runs.back(), p.end1, p.gap_min, p.gap_max);
    }
    if (runs.size() == 1) return {{zone, runs[0].rule}};
    if (zone.closed && runs.front().rule == runs.back().rule) {  // where a closed zone begins is no end
        const Run& first_run = runs.front();
        go_on(runs.back(), first_run.end1 + zone.chain1.length, first_run.gap_min, first_run.gap_max);
        runs.erase(runs.begin());
    }
    std::vector<RuledZone> stretches;
    for (const Run& run : runs) stretches.push_back({stretch_of(scene, first, second, zone, run), run.rule});
    return stretches;
}

}  // namespace abut
