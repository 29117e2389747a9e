// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/pair_rules.hpp"

#include <algorithm>
#include <limits>

#include "src/selection.hpp"

namespace abut {

namespace {

const geometry::Part& part_of(const Scene& scene, int i) {
    return scene.parts[static_cast<std::size_t>(i)].part;
}

bool selector_matches(const Scene& scene, const Selector& selector, int part, int edge) {
    const ScenePart& p = scene.parts[static_cast<std::size_t>(part)];
    if (selector.pattern == p.name) return true;
    Selector probe = selector;
    std::vector<EdgePortion> portions;
    try {
        portions = select(scene, {probe});
    } catch (const InputError&) {
        return false;  // reported where the rules are read
    }
    return std::any_of(portions.begin(), portions.end(),
                       [&](const EdgePortion& e) { return e.part == part && e.edge == edge; });
}

/// The last rule that speaks of a pair of edges, or -1: later rules are for exceptions.
int rule_for(const Scene& scene, const Candidate& c, int edge1, int edge2) {
    for (int r = static_cast<int>(scene.contacts.pairs.size()) - 1; r >= 0; --r) {
        const auto& between = scene.contacts.pairs[static_cast<std::size_t>(r)].between;
        for (int swap : {0, 1})
            if (selector_matches(scene, between[static_cast<std::size_t>(swap)], c.first, edge1) &&
                selector_matches(scene, between[static_cast<std::size_t>(1 - swap)], c.second, edge2))
                return r;
    }
    return -1;
}

/// Arc lengths on chain 1 within a zone where an edge of either chain ends, with the zone's own ends.
std::vector<double> edge_ends(const Scene& scene, const Candidate& c) {
    const geometry::FacingZone& z = c.zone;
    std::vector<double> cuts{z.begin1, z.end1};
    const auto add = [&](const geometry::Chain& chain, double low, double high, auto to_first) {
        for (std::size_t k = 0; k < chain.edges.size(); ++k)
            for (double s = chain.begin[k]; s < high; s += chain.length) {
                if (s > low) to_first(s);
                if (!chain.closed) break;
            }
    };
    add(z.chain1, z.begin1, z.end1, [&](double s) { cuts.push_back(s); });
    add(z.chain2, std::min(z.begin2, z.end2), std::max(z.begin2, z.end2), [&](double s2) {
        const double guess = z.begin1 + (s2 - z.begin2) / (z.end2 - z.begin2) * (z.end1 - z.begin1);
        const geometry::FacingPair pair = pair_from_second(part_of(scene, c.first), part_of(scene, c.second), z, s2, guess);
        if (pair.found && pair.s1 > z.begin1 && pair.s1 < z.end1) cuts.push_back(pair.s1);
    });
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

geometry::FacingPair pair_in(const Scene& scene, const Candidate& c, double s1) {
    const geometry::FacingZone& z = c.zone;
    const double guess = z.begin2 + (s1 - z.begin1) / (z.end1 - z.begin1) * (z.end2 - z.begin2);
    return pair_from_first(part_of(scene, c.first), part_of(scene, c.second), z, s1, guess);
}

/// The stretch [from, to] of a candidate's zone.
Candidate stretch_of(const Scene& scene, const Candidate& c, double from, double to) {
    constexpr int samples = 17;
    Candidate part = c;
    geometry::FacingZone& z = part.zone;
    const geometry::FacingPair first = pair_in(scene, c, from), last = pair_in(scene, c, to);
    z.closed = false;
    z.begin_is_limit = c.zone.begin_is_limit && from == c.zone.begin1;
    z.end_is_limit = c.zone.end_is_limit && to == c.zone.end1;
    z.begin1 = from;
    z.end1 = to;
    if (first.found) z.begin2 = first.s2;
    if (last.found) z.end2 = last.s2;
    z.gap_min = std::numeric_limits<double>::infinity();
    z.gap_max = -z.gap_min;
    for (int k = 0; k < samples; ++k) {
        const geometry::FacingPair pair = pair_in(scene, c, from + (to - from) * k / (samples - 1));
        if (!pair.found) continue;
        z.gap_min = std::min(z.gap_min, pair.gap);
        z.gap_max = std::max(z.gap_max, pair.gap);
    }
    return part;
}

}  // namespace

std::vector<Ruled> split_by_rules(const Scene& scene, const Candidate& c) {
    if (scene.contacts.pairs.empty()) return {{c, -1}};
    const std::vector<double> cuts = edge_ends(scene, c);
    struct Run {
        double from, to;
        int rule;
    };
    std::vector<Run> runs;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        if (cuts[k + 1] - cuts[k] <= overlap_fraction * (c.zone.end1 - c.zone.begin1)) continue;
        const geometry::FacingPair pair = pair_in(scene, c, 0.5 * (cuts[k] + cuts[k + 1]));
        const int rule = pair.found ? rule_for(scene, c, pair.on1.edge, pair.on2.edge) : -1;
        if (!runs.empty() && runs.back().rule == rule)
            runs.back().to = cuts[k + 1];
        else
            runs.push_back({cuts[k], cuts[k + 1], rule});
    }
    if (runs.size() == 1) return {{c, runs[0].rule}};
    std::vector<Ruled> parts;
    for (const Run& run : runs) parts.push_back({stretch_of(scene, c, run.from, run.to), run.rule});
    return parts;
}

}  // namespace abut
