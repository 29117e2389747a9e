// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/next_candidates.hpp"

#include <algorithm>

namespace abut {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

}  // namespace

bool zone_too_short(const SolvedAssembly& s) {
    for (std::size_t k = 0; k < s.contacts.size(); ++k)
        for (const ContactRun& run : s.runs[k])
            if (!s.contacts[k].face.bilateral &&
                ((run.from_start && s.contacts[k].zone.begin_is_limit) || (run.to_end && s.contacts[k].zone.end_is_limit)))
                return true;
    return false;
}

double needed_search_factor(const Scene& scene, const SolvedAssembly& s) {
    std::vector<double> reach(scene.parts.size(), 0.0);
    for (std::size_t k = 0; k < s.grids.size(); ++k) {
        const double largest = solver::largest_displacement(s.grids[k].input, s.solution.displacement[k]);
        reach[at(s.grids[k].part)] = std::max(reach[at(s.grids[k].part)], largest);
    }
    double factor = 0;
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        for (std::size_t j = i + 1; j < scene.parts.size(); ++j) {
            const auto a = bounding_box(scene.parts[i].part), b = bounding_box(scene.parts[j].part);
            const double closing = reach[i] + reach[j];
            if (a.overlaps(b, closing))
                factor = std::max(factor, closing / (first_search_fraction * std::min(a.diagonal(), b.diagonal())));
        }
    return factor;
}

void move_seams(const Scene& scene, const SolvedAssembly& s, std::vector<Candidate>& candidates) {
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const std::vector<ContactRun>& runs = s.runs[k];
        geometry::FacingZone& zone = candidates[k].zone;
        if (!zone.closed || runs.empty() || (!runs.front().from_start && !runs.back().to_end)) continue;
        double middle = 0, longest = 0;
        for (std::size_t r = 0; r + 1 < runs.size(); ++r)
            if (const double open = runs[r + 1].begin - runs[r].end; open > longest) {
                longest = open;
                middle = 0.5 * (runs[r].end + runs[r + 1].begin);
            }
        const double total = s.contacts[k].s.back();
        if (const double open = total - runs.back().end; !runs.back().to_end && open > longest) {
            longest = open;
            middle = 0.5 * (total + runs.back().end);
        }
        if (runs.front().begin > longest) {
            longest = runs.front().begin;
            middle = 0.5 * runs.front().begin;
        }
        if (longest == 0) continue;  // pressed all round
        const geometry::FacingPair pair = pair_at(scene, s.contacts[k], middle);
        if (!pair.found) continue;
        zone.begin1 = pair.s1;
        zone.end1 = pair.s1 + zone.chain1.length;
        zone.begin2 = pair.s2;
        zone.end2 = pair.s2 - zone.chain2.length;
    }
}

void expect_ends(const Scene& scene, const SolvedAssembly& s, std::vector<Candidate>& candidates) {
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        candidates[k].ends.clear();
        if (s.contacts[k].face.bilateral) continue;
        for (const ContactRun& run : s.runs[k]) {
            const geometry::FacingPair begin = pair_at(scene, s.contacts[k], run.begin),
                                       end = pair_at(scene, s.contacts[k], run.end);
            if (!run.from_start && begin.found) candidates[k].ends.push_back({begin.s1, -1});
            if (!run.to_end && end.found) candidates[k].ends.push_back({end.s1, 1});
        }
    }
}

}  // namespace abut
