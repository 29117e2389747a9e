// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/adaptive.hpp"

#include <algorithm>
#include <chrono>

#include "src/contact_measures.hpp"
#include "src/plan.hpp"

namespace abut {

namespace {

constexpr int max_search_widenings = 5;
constexpr double search_widening = 3;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

int max_passes(const Scene& scene) {
    if (scene.accuracy.level == "draft") return 3;
    return scene.accuracy.level == "fine" ? 7 : 6;
}

/// Are all grids given, so that there is nothing to adapt?
bool grids_are_fixed(const Scene& scene) {
    if (scene.accuracy.adapt) return !*scene.accuracy.adapt;
    return scene.accuracy.cell_size || !scene.accuracy.grids.empty();
}

/// Has contact reached an end of a candidate zone that could be longer?
bool zone_too_short(const SolvedAssembly& s) {
    for (std::size_t k = 0; k < s.contacts.size(); ++k)
        for (const ContactRun& run : s.runs[k])
            if (!s.contacts[k].face.bilateral &&
                ((run.from_start && s.contacts[k].zone.begin_is_limit) || (run.to_end && s.contacts[k].zone.end_is_limit)))
                return true;
    return false;
}

/// How far the search must reach, as a factor on the first search distance, for every pair that the displacements could close.
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

/// A zone all the way round starts where the gap is largest; where contact reaches that seam all the same (a pin drawn in the
/// middle of its hole), the seam moves to the middle of the longest open stretch.
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

std::vector<std::pair<int, int>> touching_pairs(const std::vector<Candidate>& candidates) {
    std::vector<std::pair<int, int>> pairs;
    for (const Candidate& c : candidates) pairs.emplace_back(c.first, c.second);
    return pairs;
}

}  // namespace

Outcome solve_adaptively(const Scene& scene, const ResolvedConditions& conditions, const AnalyzeOptions& options,
                         Stopwatches& seconds) {
    Outcome out;
    const double coarseness = coarseness_of(scene);
    double factor = 1;
    const auto search = [&] {
        const auto begin = std::chrono::steady_clock::now();
        out.candidates = find_candidates(scene, factor);
        seconds["geometry"] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    search();
    WantedSizes wanted = first_sizes(scene, out.candidates, coarseness);
    int widenings = 0;
    for (;;) {
        if (options.progress) options.progress("pass " + std::to_string(out.passes + 1));
        const std::vector<bool> solve = parts_to_solve(scene, conditions, touching_pairs(out.candidates));
        SolvedAssembly now = solve_pass(scene, conditions, out.candidates, solve, wanted, coarseness, seconds);
        ++out.passes;
        out.factorizations += static_cast<int>(now.problem.parts.size());
        out.iterations += now.solution.iterations;
        const bool stuck = !now.failure.empty() || !now.solution.mechanism.empty();
        const bool may_widen = !scene.contacts.search_distance && widenings < max_search_widenings && scene.contacts.detect &&
                               scene.parts.size() > 1;
        const double needed = stuck ? 0.0 : needed_search_factor(scene, now);
        if (now.failure.empty() && may_widen && (!now.solution.mechanism.empty() || zone_too_short(now) || needed > factor)) {
            ++widenings;
            factor = std::max(search_widening * factor, needed);
            const std::size_t before = out.candidates.size();
            search();
            // nothing more to rest on: look farther before anything is solved again
            for (; stuck && out.candidates.size() == before && widenings < max_search_widenings; ++widenings) {
                factor *= search_widening;
                search();
            }
            out.have_previous = false;
            if (stuck || !any_run(now))
                wanted = first_sizes(scene, out.candidates, coarseness);
            else
                wanted = sizes_from(scene, now, coarseness);
            continue;
        }
        out.search_too_short = !stuck && scene.parts.size() > 1 && scene.contacts.detect &&
                               (zone_too_short(now) || (!scene.contacts.search_distance && needed > factor));
        if (stuck || grids_are_fixed(scene) || !any_run(now)) {
            out.solved = std::move(now);
            return out;
        }
        const bool settled = out.have_previous && same_contacts(now, out.solved);
        if (settled || out.passes >= max_passes(scene) + widenings) {
            out.settled = settled;
            out.solved = std::move(now);
            return out;
        }
        wanted = sizes_from(scene, now, coarseness);
        move_seams(scene, now, out.candidates);
        out.have_previous = true;
        out.previous_energy = energy_of(now);
        out.previous_peak.clear();
        for (std::size_t k = 0; k < now.contacts.size(); ++k) out.previous_peak.push_back(peak_of(now, k));
        out.solved = std::move(now);
    }
}

}  // namespace abut
