// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/next_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

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
        for (const PressedStretch& stretch : s.stretches[k])
            if (!s.contacts[k].face.bilateral && ((stretch.from_start && s.contacts[k].zone.begin_is_limit) ||
                                                  (stretch.to_end && s.contacts[k].zone.end_is_limit)))
                return true;
    return false;
}

double needed_search_factor(const Scene& scene, const SolvedAssembly& s) {
    std::vector<double> moved(scene.parts.size(), 0.0);
    for (std::size_t k = 0; k < s.grids.size(); ++k) {
        const double largest = solver::largest_displacement(s.grids[k].input, s.solution.displacement[k]);
        moved[at(s.grids[k].part)] = std::max(moved[at(s.grids[k].part)], largest);
    }
    const SearchDistances parts(scene);
    const std::optional<double> by_cells =
        is_by_dissertation(scene) ? std::optional(cell_search_distance(scene)) : std::nullopt;
    double factor = 0;
    for (int i = 0; i < static_cast<int>(scene.parts.size()); ++i)
        for (int j = i + 1; j < static_cast<int>(scene.parts.size()); ++j) {
            const double closing = moved[at(i)] + moved[at(j)];
            const double first = by_cells.value_or(first_search_fraction * parts.size(i, j));
            if (parts.within(i, j, closing)) factor = std::max(factor, closing / first);
        }
    for (int i : parts_with_themselves(scene.contacts))
        factor = std::max(factor, 2 * moved[at(i)] / (first_search_fraction * parts.size(i, i)));
    return factor;
}

void move_seams(const Scene& scene, const SolvedAssembly& s, std::vector<Candidate>& candidates) {
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const std::vector<PressedStretch>& stretches = s.stretches[k];
        geometry::FacingZone& zone = candidates[k].zone;
        if (!zone.closed || stretches.empty() || (!stretches.front().from_start && !stretches.back().to_end)) continue;
        double middle = 0, longest = 0;
        for (std::size_t r = 0; r + 1 < stretches.size(); ++r)
            if (const double open = stretches[r + 1].begin - stretches[r].end; open > longest) {
                longest = open;
                middle = 0.5 * (stretches[r].end + stretches[r + 1].begin);
            }
        const double total = s.contacts[k].s.back();
        if (const double open = total - stretches.back().end; !stretches.back().to_end && open > longest) {
            longest = open;
            middle = 0.5 * (total + stretches.back().end);
        }
        if (stretches.front().begin > longest) {
            longest = stretches.front().begin;
            middle = 0.5 * stretches.front().begin;
        }
        if (longest == 0) continue;  // pressed all round
        const geometry::FacingPair pair = pair_at(scene, s.contacts[k], middle);
        if (pair.found) begin_at(pair, zone);
    }
}

namespace {

std::vector<ExpectedEnd> free_ends(const Scene& scene, const SolvedAssembly& s, const PressedStretches& stretches,
                                   std::size_t contact) {
    std::vector<ExpectedEnd> ends;
    if (s.contacts[contact].face.bilateral) return ends;
    const auto append = [&](double at_s, int outward) {
        const geometry::FacingPair pair = pair_at(scene, s.contacts[contact], at_s);
        if (pair.found) ends.push_back({pair.s1, outward});
    };
    for (const PressedStretch& stretch : stretches[contact]) {
        if (!stretch.from_start) append(stretch.begin, -1);
        if (!stretch.to_end) append(stretch.end, 1);
    }
    return ends;
}

/// Knot spacing beside a free end, from its reach.
double spacing_at(const SolvedAssembly& s, std::size_t contact) {
    double spacing = std::numeric_limits<double>::infinity();
    for (const PressedStretch& stretch : s.stretches[contact])
        for (const StretchEnd& end : {stretch.at_begin, stretch.at_end})
            if (end.kind == StretchEnd::Kind::free) spacing = std::min(spacing, end.reach / error_reach);
    return spacing;
}

}  // namespace

void expect_ends(const Scene& scene, const SolvedAssembly& s, const PressedStretches& stretches,
                 std::vector<Candidate>& candidates) {
    for (std::size_t k = 0; k < candidates.size(); ++k) candidates[k].ends = free_ends(scene, s, stretches, k);
}

void expect_ends(const Scene& scene, const SolvedAssembly& s, const std::vector<std::size_t>& contacts,
                 std::vector<Candidate>& candidates) {
    for (std::size_t k : contacts) candidates[k].ends = free_ends(scene, s, s.stretches, k);
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

namespace {

/// By how much arc lengths on the first chain of `before` differ from those of the same faces in `now`: turns of a closed
/// chain. None: other faces, or other stretches of them.
std::optional<double> turns_between(const Candidate& before, const Candidate& now) {
    const geometry::FacingZone &a = before.zone, &b = now.zone;
    if (before.first != now.first || before.second != now.second || a.chain1.edges != b.chain1.edges ||
        a.chain2.edges != b.chain2.edges)
        return std::nullopt;
    const double period = a.chain1.closed ? a.chain1.length : 0, apart = 0.5 * (b.begin1 + b.end1) - 0.5 * (a.begin1 + a.end1),
                 turns = period > 0 ? period * std::round(apart / period) : 0;
    if (a.begin1 + turns > b.end1 || a.end1 + turns < b.begin1) return std::nullopt;
    return turns;
}

}  // namespace

void inherit_expected(const std::vector<Candidate>& before, std::vector<Candidate>& candidates) {
    for (Candidate& now : candidates) {
        std::vector<std::pair<double, double>> expected;  // place, pressure
        for (const Candidate& b : before) {
            const std::optional<double> turns = turns_between(b, now);
            if (!turns) continue;
            for (const ExpectedEnd& end : b.ends) now.ends.push_back({end.s1 + *turns, end.outward});
            for (std::size_t k = 0; k < b.expected.s1.size(); ++k)
                expected.emplace_back(b.expected.s1[k] + *turns, b.expected.pressure[k]);
        }
        std::sort(expected.begin(), expected.end());
        for (const auto& [s1, pressure] : expected) {
            now.expected.s1.push_back(s1);
            now.expected.pressure.push_back(pressure);
        }
    }
}

std::vector<std::size_t> moved_ends(const Scene& scene, const SolvedAssembly& s, const std::vector<Candidate>& candidates) {
    const auto peak_of = [&](std::size_t k) {
        return s.interface_of[k] < 0 || s.stretches[k].empty() ? 0 : pressure_of(s, k).cwiseAbs().maxCoeff();
    };
    double strongest = 0;
    for (std::size_t k = 0; k < candidates.size(); ++k) strongest = std::max(strongest, peak_of(k));
    std::vector<std::size_t> moved;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const std::vector<ExpectedEnd> now = free_ends(scene, s, s.stretches, k), &expected = candidates[k].ends;
        const double share = strongest > 0 ? peak_of(k) / strongest : 1, limit = noted_move * spacing_at(s, k);
        bool has_moved = now.size() != expected.size() && (share == 0 || share > noted_move);
        for (std::size_t i = 0; i < std::min(now.size(), expected.size()); ++i)
            has_moved = has_moved || share * std::abs(now[i].s1 - expected[i].s1) > limit;
        if (has_moved) moved.push_back(k);
    }
    return moved;
}

}  // namespace abut
