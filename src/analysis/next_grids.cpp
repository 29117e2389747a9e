// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/next_grids.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "src/base/index.hpp"

namespace abut {

namespace {

/// Cells at the free ends of a contact that was just found, of its length. From one grid to the next they become finer by this
/// factor at least, or as fine as the end is known, which is about end_known times the end's relative error. None is finer than
/// the last.
/// Penalty's ends are no roots, and its points no knots: half steps.
constexpr double first_end_fraction = 1.0 / 32, first_of_penalty = 1.0 / 8, least_refinement = 4, end_known = 0.6;
constexpr double least_end_fraction = 1e-4;
/// Cells along the contact, and at its corners of its length, likewise.
constexpr double first_cells = 8, cell_refinement = 1.3, first_corner_fraction = 1.0 / 30, corner_refinement = 2;
/// Relative L2 error of a pressure with one free end, cells h there, over a length L, is at most about this times h / L (Hertz'
/// problem, with the pressure's double knot where the end was expected to within half a cell: 0.12 to 0.25).
constexpr double end_error = 0.25;
/// Where the end is known well this share of it (Hertz' problem, targets of 1 to 0.1 %: 0.54 to 0.67).
constexpr double usual_end_error = 0.75;
/// Where the estimate missed its target the next cells aim at less, within these factors: less than half as large they may be
/// the same halves as before.
constexpr double aim = 0.7, least_shrink = 0.25, most_shrink = 0.5;
constexpr double least_step = 1.2;  // of the coarsening, before the last one

int free_ends(const std::vector<PressedStretch>& stretches) {
    int n = 0;
    for (const PressedStretch& stretch : stretches) n += (stretch.from_start ? 0 : 1) + (stretch.to_end ? 0 : 1);
    return std::max(1, n);
}

/// Is a contact resolved well enough, as far as the strongest one's pressure is the measure? An open one is; where it closes on
/// other grids, it begins with the first cells of a contact.
bool is_good(const ErrorEstimate& error, std::size_t k, double target) {
    if (k >= error.contacts.size() || !error.contacts[k]) return true;
    const ContactError& c = *error.contacts[k];
    return std::max(c.share * c.pressure, c.at_corner ? 0.0 : c.share_of_peak * c.peak) <= aim * target;
}

/// Do the contacts that are not good yet have the cells that they aimed at?
bool at_goal(const ErrorEstimate& error, const NextGrids& next) {
    for (std::size_t k = 0; k < next.goal.size(); ++k)
        if (!is_good(error, k, next.target) && next.resolution[k].end_fraction > next.goal[k]) return false;
    return next.on_final_cells();
}

/// Does an error of a contact count, where the strongest one's pressure is the measure?
bool counts(const ContactError& c, double error, double target) {
    return c.share * error > 0.5 * target;
}

/// Contacts whose ends' error counts get smaller goals, each by what it missed.
void shrink_goals(const ErrorEstimate& error, NextGrids& next) {
    for (std::size_t k = 0; k < next.goal.size(); ++k) {
        if (!error.contacts[k] || !counts(*error.contacts[k], error.contacts[k]->ends, next.target)) continue;
        const ContactError& c = *error.contacts[k];
        const double missed = std::clamp(aim * next.target / (c.share * c.pressure), least_shrink, most_shrink);
        next.goal[k] = std::max(least_end_fraction, missed * next.goal[k]);
    }
}

}  // namespace

double NextGrids::next_coarseness() const {
    return std::max(coarseness, coarsening);
}

void coarsen_less(NextGrids& next) {
    next.coarsening /= coarsening_step;
    if (next.coarsening < least_step * next.coarseness) next.coarsening = next.coarseness;
}

void set_first_goals(const SolvedAssembly& solved, const PressedStretches& stretches_of_all, NextGrids& next) {
    next.goal.clear();
    next.resolution.clear();
    for (std::size_t k = 0; k < stretches_of_all.size(); ++k) {
        const std::vector<PressedStretch>& stretches = stretches_of_all[k];
        const double first = solved.contacts[k].pairing == Pairing::middle ? first_end_fraction : first_of_penalty;
        const double per_stretch =
            static_cast<double>(free_ends(stretches)) / static_cast<double>(std::max<std::size_t>(1, stretches.size()));
        next.goal.push_back(std::clamp(next.target / (end_error * per_stretch), least_end_fraction, first));
        next.resolution.push_back({first_cells, first, first_corner_fraction});
    }
}

void aim_at_goals(NextGrids& next) {
    next.coarsening = next.coarseness;
    for (std::size_t k = 0; k < next.goal.size(); ++k) {
        double& end_fraction = next.resolution[k].end_fraction;
        end_fraction = std::min(end_fraction, next.goal[k] / usual_end_error);
    }
}

bool may_lack_shape(const ErrorEstimate& error, const NextGrids& next) {
    return at_goal(error, next) && std::any_of(error.contacts.begin(), error.contacts.end(), [&](const auto& c) {
               return c && counts(*c, c->inside, next.target) && c->inside > c->ends;
           });
}

void refine(const ErrorEstimate& error, NextGrids& next) {
    if (at_goal(error, next)) shrink_goals(error, next);
    for (std::size_t k = 0; k < next.goal.size(); ++k) {
        if (is_good(error, k, next.target)) continue;
        next.resolution[k].cells *= cell_refinement;
        next.resolution[k].corner_fraction /= corner_refinement;
        double& end_fraction = next.resolution[k].end_fraction;
        const double finer = end_fraction / least_refinement;
        end_fraction = std::max(next.goal[k], std::min(end_known * error.contacts[k]->ends, finer));
    }
    coarsen_less(next);
}

void refine_all(NextGrids& next) {
    for (ContactResolution& r : next.resolution) {
        r.cells *= cell_refinement;
        r.corner_fraction /= corner_refinement;
        r.end_fraction = std::max(least_end_fraction, r.end_fraction / least_refinement);
    }
    next.coarseness /= coarsening_step;
    coarsen_less(next);
}

WantedSizes with_bonded(const WantedSizes& wanted, const std::vector<Candidate>& candidates) {
    std::vector<std::size_t> body(wanted.size());
    std::iota(body.begin(), body.end(), std::size_t{0});
    for (const Candidate& c : candidates)
        if (c.bonded && body[at(c.first)] != body[at(c.second)])
            std::replace(body.begin(), body.end(), std::size_t{body[at(c.second)]}, std::size_t{body[at(c.first)]});
    WantedSizes all(wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
        for (std::size_t j = 0; j < wanted.size(); ++j)
            if (body[i] == body[j]) all[i].insert(all[i].end(), wanted[j].begin(), wanted[j].end());
    return all;
}

}  // namespace abut
