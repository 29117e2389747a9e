// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/next_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/base/index.hpp"
#include "src/contact/cell_search.hpp"
#include "src/scene/dissertation_method.hpp"
#include "src/solution/table.hpp"

namespace abut {

namespace {

/// Of the knot spacing there, times the pressure's share of the strongest contact's: ends that are found so near to where they
/// were expected need no other knots.
constexpr double noted_move = 0.08;

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
    const PartReach parts(scene);
    const std::optional<double> by_cells = is_by_dissertation(scene) ? std::optional(search_reach(scene)) : std::nullopt;
    double factor = 0;
    for (int i = 0; i < static_cast<int>(scene.parts.size()); ++i)
        for (int j = i + 1; j < static_cast<int>(scene.parts.size()); ++j) {
            const double closing = reach[at(i)] + reach[at(j)];
            const double first = by_cells.value_or(first_search_fraction * parts.size(i, j));
            if (parts.within(i, j, closing)) factor = std::max(factor, closing / first);
        }
    for (int i : scene.contacts.of_one_part)
        factor = std::max(factor, 2 * reach[at(i)] / (first_search_fraction * parts.size(i, i)));
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
        if (pair.found) begin_at(pair, zone);
    }
}

namespace {

std::vector<ExpectedEnd> free_ends(const Scene& scene, const SolvedAssembly& s, const ContactRuns& runs, std::size_t contact) {
    std::vector<ExpectedEnd> ends;
    if (s.contacts[contact].face.bilateral) return ends;
    const auto append = [&](double at_s, int outward) {
        const geometry::FacingPair pair = pair_at(scene, s.contacts[contact], at_s);
        if (pair.found) ends.push_back({pair.s1, outward});
    };
    for (const ContactRun& run : runs[contact]) {
        if (!run.from_start) append(run.begin, -1);
        if (!run.to_end) append(run.end, 1);
    }
    return ends;
}

/// Knot spacing beside a free end, from its reach.
double spacing_at(const SolvedAssembly& s, std::size_t contact) {
    double spacing = std::numeric_limits<double>::infinity();
    for (const ContactRun& run : s.runs[contact])
        for (const RunEnd& end : {run.at_begin, run.at_end})
            if (end.kind == RunEnd::Kind::free) spacing = std::min(spacing, end.reach / error_reach);
    return spacing;
}

}  // namespace

void expect_ends(const Scene& scene, const SolvedAssembly& s, const ContactRuns& runs, std::vector<Candidate>& candidates) {
    for (std::size_t k = 0; k < candidates.size(); ++k) candidates[k].ends = free_ends(scene, s, runs, k);
}

void expect_ends(const Scene& scene, const SolvedAssembly& s, const std::vector<std::size_t>& contacts,
                 std::vector<Candidate>& candidates) {
    for (std::size_t k : contacts) candidates[k].ends = free_ends(scene, s, s.runs, k);
}

void expect_pressures(const SolvedAssembly& s, std::vector<Candidate>& candidates) {
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const ContactInterface& contact = s.contacts[k];
        candidates[k].expected = {};
        if (s.interface_of[k] < 0 || contact.pairing != Pairing::middle) continue;
        for (int f = 0; f < contact.face.pressure.n_functions(); ++f) {
            const double place = solver::greville(contact.face.pressure, f);
            if (place < contact.s.front() || place > contact.s.back()) continue;  // comes again on the other side of the seam
            candidates[k].expected.s1.push_back(interpolate(contact.s, contact.s1, place));
            candidates[k].expected.pressure.push_back(pressure_of(s, k)[f]);
        }
    }
}

std::vector<std::size_t> moved_ends(const Scene& scene, const SolvedAssembly& s, const std::vector<Candidate>& candidates) {
    const auto peak_of = [&](std::size_t k) {
        return s.interface_of[k] < 0 || s.runs[k].empty() ? 0 : pressure_of(s, k).cwiseAbs().maxCoeff();
    };
    double strongest = 0;
    for (std::size_t k = 0; k < candidates.size(); ++k) strongest = std::max(strongest, peak_of(k));
    std::vector<std::size_t> moved;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const std::vector<ExpectedEnd> now = free_ends(scene, s, s.runs, k), &expected = candidates[k].ends;
        const double share = strongest > 0 ? peak_of(k) / strongest : 1, limit = noted_move * spacing_at(s, k);
        bool has_moved = now.size() != expected.size() && (share == 0 || share > noted_move);
        for (std::size_t i = 0; i < std::min(now.size(), expected.size()); ++i)
            has_moved = has_moved || share * std::abs(now[i].s1 - expected[i].s1) > limit;
        if (has_moved) moved.push_back(k);
    }
    return moved;
}

}  // namespace abut
