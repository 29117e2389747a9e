// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/adaptive.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "solver/blas_threads.hpp"
#include "src/accuracy_goal.hpp"
#include "src/contact_measures.hpp"
#include "src/next_candidates.hpp"
#include "src/plan.hpp"
#include "src/stress_error.hpp"

namespace abut {

namespace {

constexpr int max_search_widenings = 5;
constexpr double search_widening = 3;
constexpr int max_passes = 7;  // on the same candidates

/// Cells at the free ends of a contact that was just found, of its length. From one grid to the next they become finer by a
/// factor between these two: as fine as the end is known, which is about this times the end's relative error. None is finer
/// than the last.
constexpr double first_end_fraction = 1.0 / 8, least_refinement = 4, end_refinement = 8, end_known = 0.6;
constexpr double least_end_fraction = 1e-4;
/// On the same grids, until the ends are where they were expected.
constexpr int max_knot_moves = 3;
/// Unknowns that end the path at the standard target, and as a multiple of the first grids'.
constexpr double affordable_unknowns = 30000, affordable_growth = 12;
/// Cells along the contact, and at its corners of its length, likewise.
constexpr double first_cells = 8, cell_refinement = 1.3, first_corner_fraction = 1.0 / 30, corner_refinement = 2;
/// Relative L2 error of a pressure with one free end, cells h there, over a length L, is about this times h / L (Hertz'
/// problem, with the pressure's double knot where the end was expected to within half a cell: 0.12 to 0.25).
constexpr double end_error = 0.2;
/// Where the estimate missed its target the next cells aim at less, within these factors.
constexpr double aim = 0.7, least_shrink = 0.25;
/// Of the sizes that the shape asks for: first and second grids only locate the contacts, and show what the shape's cells do.
constexpr double first_coarsening = 2, coarsening_step = 1.4, least_step = 1.2;

/// Are all grids given, so that there is nothing to adapt?
bool grids_are_fixed(const Scene& scene) {
    if (scene.accuracy.adapt) return !*scene.accuracy.adapt;
    return scene.accuracy.cell_size || !scene.accuracy.grids.empty();
}

std::vector<std::pair<int, int>> touching_pairs(const std::vector<Candidate>& candidates) {
    std::vector<std::pair<int, int>> pairs;
    for (const Candidate& c : candidates) pairs.emplace_back(c.first, c.second);
    return pairs;
}

/// Cells that the next grids are to have.
struct NextGrids {
    double target;
    double coarseness;                          ///< of the shape's cells, at the target
    double coarsening;                          ///< of these, on the next grids
    std::vector<double> goal;                   ///< by contact: fraction of its length that reaches the target at its ends
    std::vector<ContactResolution> resolution;  ///< by contact, on the next grids

    double next_coarseness() const { return std::max(coarseness, coarsening); }
    /// The last step is no smaller than the others, or there would be nothing to see in it.
    void coarsen_less() {
        coarsening /= coarsening_step;
        if (coarsening < least_step * coarseness) coarsening = coarseness;
    }
};

bool is_solved(const SolvedAssembly& s) {
    return s.failure.empty() && s.solution.mechanism.empty();
}

int free_ends(const std::vector<ContactRun>& runs) {
    int n = 0;
    for (const ContactRun& run : runs) n += (run.from_start ? 0 : 1) + (run.to_end ? 0 : 1);
    return std::max(1, n);
}

void first_goals(const SolvedAssembly& solved, NextGrids& next) {
    next.goal.clear();
    next.resolution.clear();
    for (const auto& runs : solved.runs) {
        const double per_run =
            static_cast<double>(free_ends(runs)) / static_cast<double>(std::max<std::size_t>(1, runs.size()));
        next.goal.push_back(std::clamp(next.target / (end_error * per_run), least_end_fraction, first_end_fraction));
        next.resolution.push_back({first_cells, std::max(next.goal.back(), first_end_fraction), first_corner_fraction});
    }
}

/// Is a contact resolved well enough, as far as the strongest one's pressure is the measure?
bool is_good(const ErrorEstimate& error, std::size_t k, double target) {
    if (k >= error.contacts.size() || !error.contacts[k]) return false;
    const ContactError& c = *error.contacts[k];
    return c.share * std::max(c.pressure, c.at_corner ? 0.0 : c.peak) <= aim * target;
}

/// Do the contacts that are not good yet have the cells that they aimed at?
bool at_goal(const ErrorEstimate& error, const NextGrids& next) {
    for (std::size_t k = 0; k < next.goal.size(); ++k)
        if (!is_good(error, k, next.target) && next.resolution[k].end_fraction > next.goal[k]) return false;
    return next.coarsening <= next.coarseness;
}

/// Contacts whose error counts get smaller goals; the shape's cells follow slowly.
void shrink_goals(const ErrorEstimate& error, NextGrids& next) {
    const double missed = std::clamp(aim * next.target / *error.contact_pressure, least_shrink, aim);
    for (std::size_t k = 0; k < next.goal.size(); ++k)
        if (error.contacts[k] && error.contacts[k]->ends > 0.5 * next.target)
            next.goal[k] = std::max(least_end_fraction, missed * next.goal[k]);
    bool inside = false;
    for (const auto& c : error.contacts) inside = inside || (c && c->inside > 0.5 * next.target && c->inside > c->ends);
    if (inside) next.coarseness *= std::cbrt(missed);
}

void refine(const ErrorEstimate& error, NextGrids& next) {
    if (at_goal(error, next) && error.contact_pressure) shrink_goals(error, next);
    for (std::size_t k = 0; k < next.goal.size(); ++k) {
        if (is_good(error, k, next.target)) continue;
        const double known = error.contacts.size() > k && error.contacts[k] ? end_known * error.contacts[k]->ends : 0.0;
        next.resolution[k].cells *= cell_refinement;
        next.resolution[k].corner_fraction /= corner_refinement;
        const double last = next.resolution[k].end_fraction;
        next.resolution[k].end_fraction =
            std::max({next.goal[k], last / end_refinement, std::min(known, last / least_refinement)});
    }
    next.coarsen_less();
}

class Path {
public:
    Path(const Scene& scene, const ResolvedConditions& conditions, const AnalyzeOptions& options, Stopwatches& seconds)
        : scene_(scene),
          conditions_(conditions),
          options_(options),
          seconds_(seconds),
          threads_(solver::usable_threads(options.threads)) {
        out_.target = target_of(scene.accuracy);
        next_ = {out_.target, 1, 1, {}, {}};
    }

    Outcome walk() {
        search();
        start_over();
        while (!step()) continue;
        return std::move(out_);
    }

private:
    void search() {
        const auto begin = std::chrono::steady_clock::now();
        out_.candidates = find_candidates(scene_, factor_);
        seconds_["geometry"] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

    /// Nothing is known of the contacts.
    void start_over() {
        next_.coarseness = coarseness_of(scene_.accuracy, !out_.candidates.empty());
        const bool nothing_to_find = grids_are_fixed(scene_) || out_.candidates.empty();
        next_.coarsening = nothing_to_find ? next_.coarseness : first_coarsening;
        next_.goal.clear();
        wanted_ = first_sizes(scene_, out_.candidates, next_.next_coarseness());
    }

    SolvedAssembly solve() {
        out_.stress.clear();
        if (options_.progress) options_.progress("pass " + std::to_string(out_.passes.size() + 1));
        const std::vector<bool> parts = parts_to_solve(scene_, conditions_, touching_pairs(out_.candidates));
        SolvedAssembly now =
            solve_pass(scene_, conditions_, out_.candidates, parts, wanted_, next_.next_coarseness(), seconds_, threads_);
        out_.factorizations += static_cast<int>(now.problem.parts.size());
        out_.iterations += now.solution.iterations;
        follow_ends(now);
        return now;
    }

    /// Knots move to where contact was found to end, and the contact alone is solved again.
    void follow_ends(SolvedAssembly& now) {
        if (scene_.contacts.penalty) return;
        for (int n = 0; n < max_knot_moves && is_solved(now) && ends_moved(scene_, now, out_.candidates); ++n) {
            expect_ends(scene_, now, out_.candidates);
            solve_contacts_again(scene_, out_.candidates, now, seconds_, threads_);
            out_.iterations += now.solution.iterations;
        }
    }

    bool may_widen() const {
        return !scene_.contacts.search_distance && widenings_ < max_search_widenings && scene_.contacts.detect &&
               scene_.parts.size() > 1;
    }

    /// Looks farther; where the parts rest on nothing, until there is more to rest on.
    void widen(const SolvedAssembly& now, double needed, bool stuck) {
        ++widenings_;
        factor_ = std::max(search_widening * factor_, needed);
        const std::size_t before = out_.candidates.size();
        search();
        for (; stuck && out_.candidates.size() == before && widenings_ < max_search_widenings; ++widenings_) {
            factor_ *= search_widening;
            search();
        }
        comparable_from_ = out_.passes.size();
        start_over();
        if (!stuck && any_run(now) && now.contacts.size() == out_.candidates.size()) {
            first_goals(now, next_);
            wanted_ = sizes_from(scene_, now, next_.resolution);
        }
    }

    /// Once a pass, and only where it is asked for: it costs as much as a good part of the solution.
    void recover_stress(const SolvedAssembly& now) {
        if (!out_.stress.empty() || !is_solved(now)) return;
        const auto begin = std::chrono::steady_clock::now();
        out_.stress = stress_fields(now);
        ErrorEstimate& error = out_.errors.back();
        error.energy = energy_error(now, out_.stress);
        if (error.energy) error.stress = std::sqrt(*error.energy);
        seconds_["recovery"] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

    bool end(SolvedAssembly&& now, PathEnd why) {
        recover_stress(now);
        out_.solved = std::move(now);
        out_.end = why;
        return true;
    }

    ErrorEstimate errors_of_last(bool stuck) const {
        if (stuck) return {};
        const bool first = out_.passes.size() <= comparable_from_ + 1;
        return estimate_errors(std::span(out_.passes).subspan(comparable_from_), first ? ErrorEstimate{} : out_.errors.back());
    }

    bool on_final_cells() const { return next_.coarsening <= next_.coarseness; }

    /// Without contact: finer grids only for a target of its own.
    bool step_without_contact(SolvedAssembly&& now) {
        recover_stress(now);
        if (on_final_cells()) {
            const ErrorEstimate& error = out_.errors.back();
            if (!scene_.accuracy.target || !error.stress) return end(std::move(now), PathEnd::no_need);
            if (*error.stress <= out_.target) return end(std::move(now), PathEnd::reached);
            if (now.limited_grids > 0) return end(std::move(now), PathEnd::out_of_cells);
            if (out_of_passes()) return end(std::move(now), PathEnd::out_of_passes);
            next_.coarseness /= coarsening_step;
        }
        next_.coarsen_less();
        wanted_ = first_sizes(scene_, out_.candidates, next_.next_coarseness());
        return false;
    }

    /// Finer grids would cost more than a user of this level would expect.
    bool too_dear() const {
        const double affordable = std::max(affordable_unknowns * std::sqrt(standard_target / out_.target),
                                           affordable_growth * out_.passes[comparable_from_].unknowns);
        return out_.passes.back().unknowns > affordable;
    }

    bool out_of_passes() const { return out_.passes.size() >= comparable_from_ + max_passes; }

    /// One solution; true: the last one.
    bool step() {
        SolvedAssembly now = solve();
        const bool stuck = !is_solved(now);
        out_.passes.push_back(stuck ? PassRecord{} : record_of(now, seconds_so_far()));
        out_.errors.push_back(errors_of_last(stuck));
        if (!now.failure.empty() && !on_final_cells()) {  // a wall too thin for the first cells
            comparable_from_ = out_.passes.size();
            start_over();
            next_.coarsening = next_.coarseness;
            wanted_ = first_sizes(scene_, out_.candidates, next_.next_coarseness());
            return false;
        }
        const double needed = stuck ? 0.0 : needed_search_factor(scene_, now);
        if (now.failure.empty() && may_widen() &&
            (!now.solution.mechanism.empty() || zone_too_short(now) || needed > factor_)) {
            widen(now, needed, stuck);
            return false;
        }
        out_.search_too_short = !stuck && scene_.parts.size() > 1 && scene_.contacts.detect &&
                                (zone_too_short(now) || (!scene_.contacts.search_distance && needed > factor_));
        if (stuck || grids_are_fixed(scene_)) return end(std::move(now), PathEnd::no_need);
        if (!any_run(now)) return step_without_contact(std::move(now));
        const ErrorEstimate& error = out_.errors.back();
        if (error.contact_pressure && std::max(*error.contact_pressure, *error.peak) <= out_.target)
            return end(std::move(now), PathEnd::reached);
        if (on_final_cells() && now.limited_grids > 0) return end(std::move(now), PathEnd::out_of_cells);
        if (out_of_passes()) return end(std::move(now), PathEnd::out_of_passes);
        if (too_dear()) return end(std::move(now), PathEnd::out_of_cells);
        prepare_next(now, error);
        return false;
    }

    void prepare_next(const SolvedAssembly& now, const ErrorEstimate& error) {
        if (next_.goal.empty()) {
            first_goals(now, next_);
            next_.coarsen_less();
        } else {
            refine(error, next_);
        }
        wanted_ = sizes_from(scene_, now, next_.resolution);
        move_seams(scene_, now, out_.candidates);
        expect_ends(scene_, now, out_.candidates);
    }

    double seconds_so_far() const { return seconds_["geometry"] + seconds_["assembly"] + seconds_["solve"]; }

    const Scene& scene_;
    const ResolvedConditions& conditions_;
    const AnalyzeOptions& options_;
    Stopwatches& seconds_;
    int threads_;
    Outcome out_;
    NextGrids next_;
    WantedSizes wanted_;
    double factor_ = 1;
    int widenings_ = 0;
    std::size_t comparable_from_ = 0;  // passes before have other candidates
};

}  // namespace

Outcome solve_adaptively(const Scene& scene, const ResolvedConditions& conditions, const AnalyzeOptions& options,
                         Stopwatches& seconds) {
    return Path(scene, conditions, options, seconds).walk();
}

}  // namespace abut
