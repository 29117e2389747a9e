// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/grid_walk.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "solver/linear_algebra/blas_threads.hpp"
#include "src/analysis/deep_cells.hpp"
#include "src/analysis/extent_by_theory.hpp"
#include "src/analysis/follow_ends.hpp"
#include "src/analysis/grading.hpp"
#include "src/analysis/lost_parts.hpp"
#include "src/analysis/missed_contacts.hpp"
#include "src/analysis/next_candidates.hpp"
#include "src/analysis/next_grids.hpp"
#include "src/analysis/singular_errors.hpp"
#include "src/analysis/stiff_parts.hpp"
#include "src/analysis/stress_error.hpp"
#include "src/analysis/stress_raisers.hpp"
#include "src/analysis/tipping.hpp"
#include "src/base/index.hpp"
#include "src/plan/plan.hpp"
#include "src/scene/accuracy_goal.hpp"
#include "src/scene/dissertation_method.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

constexpr int max_search_widenings = 5;
/// The search goes no farther than the smaller part is large: what moves farther is not paired where it comes to rest.
constexpr double search_widening = 3, farthest_search = 1 / first_search_fraction;
/// On the same candidates, since contacts were last found or lost; in all so many times as many; without any answer.
constexpr int max_passes = 7, most_beginnings = 4, max_unanswered = 3;
/// For the largest stress alone, where all else is known.
constexpr int max_sharpenings = 2;
/// The last pressure's middle is a sixth as far from the end from pass to pass: this many tell a thousandth of a zone.
constexpr int max_tippings = 5;
/// On the same grids, until the ends are where they were expected; on grids that only prepare for others they need only be
/// near.
constexpr int max_knot_moves = 3, knot_moves_before = 2;
/// Error of the energy, of the target, below which the pressures lack nothing by the shape's cells.
constexpr double aimed_energy = 0.5;
/// Rounding times condition number, of the target: from here on changes of the energy are not those of the grids.
constexpr double rounding_share = 0.1;

}  // namespace

std::vector<Candidate> search_scene(const Scene& scene, double factor, Stopwatches& seconds, EffectUses& uses) {
    if (!searches_contacts(scene)) return {};
    const auto begin = std::chrono::steady_clock::now();
    const MeteredCall call(uses, "contact");
    std::vector<Candidate> candidates = find_candidates(scene, factor);
    seconds["geometry"] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return candidates;
}

class GridWalk::Path {
public:
    Path(const Scene& scene, const ResolvedConditions& conditions, Stopwatches& seconds, PartGroup group,
         const std::vector<Candidate>& candidates, int threads)
        : group_(std::move(group)), scene_(scene), conditions_(conditions), seconds_(seconds), threads_(threads) {
        out_.target = energy_target_ = target_of(scene.accuracy);
        next_ = {out_.target, 1, 1};
        raisers_.resize(scene.parts.size());
        take_own(candidates);
        start_over();
    }

    PassAsk ask() const {
        std::vector<bool> parts =
            parts_to_solve(scene_, conditions_, touching_pairs(out_.candidates), closing_pairs(scene_, out_.candidates));
        for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = parts[i] && group_[i];
        return {std::move(parts), with_bonded(wanted_, out_.candidates), next_.next_coarseness(), out_.next};
    }
    const std::vector<Candidate>& candidates() const { return out_.candidates; }
    bool meets_others() const { return meets_others_; }
    std::size_t n_passes() const { return out_.passes.size(); }
    bool is_over() const { return is_over_; }
    bool has_answer() const {
        if (!is_answered_ || any_missed(missed_)) return false;
        const std::optional<double> error = steering(out_.errors.back());
        return error && *error <= most_target;
    }
    int n_widenings() const { return widenings_; }
    const std::string& failed() const { return failed_; }
    std::unique_ptr<Path> unsolved() {
        auto solved = std::exchange(out_.solved, {}), last = std::exchange(last_, {});
        auto stress = std::exchange(out_.stress, {});  // as large as the solution, and the next pass begins without
        auto copy = std::make_unique<Path>(*this);
        std::swap(out_.solved, solved);
        std::swap(last_, last);
        std::swap(out_.stress, stress);
        return copy;
    }
    void begin_like(const Path& other) {
        begins_like_another_ = out_.passes.empty() && other.widenings_ == widenings_ &&
                               other.out_.candidates.size() == out_.candidates.size() && !other.next_.goal.empty();
        if (!begins_like_another_) return;
        next_ = other.next_;
        passes_before_ = other.passes_before_ + other.out_.passes.size() - 1;  // without the one that this walk takes, too
    }
    void end_with_next(const std::string& why, bool is_again) {
        why_end_ = why;
        is_over_ = false;
        if (!is_again || out_.passes.size() <= comparable_from_) return;
        out_.passes.pop_back();
        out_.errors.pop_back();
    }
    /// The same grids, but where the stress is largest.
    bool sharpen() {
        const SolvedAssembly& now = out_.solved;
        if (out_.end != PathEnd::reached || !is_in_contact(now) || !is_stress_doubtful(now)) return false;
        ++sharpened_;
        add_largest_stress(scene_, conditions_, now, out_.stress, out_.largest, raisers_);
        const PressedStretches stretches = want(now, now.stretches);
        if (exceeds_budget(now)) return false;
        expect(now, stretches);
        is_over_ = false;
        if (scene_.in_steps) last_ = std::move(out_.solved);
        return true;
    }
    const SolvedAssembly& last() const { return is_over_ ? out_.solved : last_; }
    Outcome take_outcome() {
        recover_stress(out_.solved);
        return std::move(out_);
    }

    bool take(SolvedAssembly now) {
        out_.stress.clear();
        for (const PartOnGrid& g : now.grids) out_.factorizations += g.is_rigid || g.model >= 0 ? 0 : 1;
        out_.iterations += now.solution.iterations;
        if (!has_to_widen(now)) follow(now, next_.on_final_cells() ? max_knot_moves : knot_moves_before);
        if (scene_.in_steps && now.solution.mechanism.empty())
            now.solution.mechanism = std::move(now.solution.sliding);  // nothing follows on it
        add_uses(out_.uses, now.uses);
        is_answered_ = false;
        failed_.clear();
        is_over_ = step(now);
        last_ = scene_.in_steps && !is_over_ ? std::move(now) : SolvedAssembly{};
        return is_over_;
    }

private:
    /// False: the ends are there.
    bool follow(SolvedAssembly& now, int moves) {
        const EndsFollowed followed = follow_ends(scene_, now, out_.candidates, moves, seconds_, threads_);
        out_.iterations += followed.iterations;
        return followed.moves > 0;
    }

    void search() { take_own(search_scene(scene_, factor_, seconds_, out_.uses)); }
    void take_own(const std::vector<Candidate>& candidates) {
        const auto is_own = [&](int part) { return group_[static_cast<std::size_t>(part)]; };
        out_.candidates.clear();
        for (const Candidate& c : candidates) {
            if (is_own(c.first) && is_own(c.second)) out_.candidates.push_back(c);
            meets_others_ = meets_others_ || is_own(c.first) != is_own(c.second);
        }
    }

    /// Nothing is known of the contacts.
    void start_over() {
        next_.coarseness = coarseness_of(scene_.accuracy, !out_.candidates.empty());
        const bool nothing_to_find = grids_are_fixed(scene_) || out_.candidates.empty();
        next_.coarsening = nothing_to_find ? next_.coarseness : first_coarsening;
        next_.goal.clear();
        out_.largest.clear();
        theory_ = {};
        wanted_ = first_sizes(scene_, out_.candidates, next_.next_coarseness());
    }

    bool may_widen() const {
        return !scene_.contacts.search_distance && !is_by_dissertation(scene_) && widenings_ < max_search_widenings &&
               factor_ < farthest_search && scene_.contacts.detect && searches_contacts(scene_);
    }

    /// Of the search. What slides goes so far as the brake lets it, which says nothing.
    double needed_factor(const SolvedAssembly& now) const {
        return is_solved(now) && now.solution.sliding.empty() ? needed_search_factor(scene_, now) : 0;
    }

    bool has_to_widen(const SolvedAssembly& now) const {
        return now.failure.empty() && may_widen() &&
               (!now.solution.mechanism.empty() || zone_too_short(now) || needed_factor(now) > factor_);
    }

    /// Looks farther; where the parts rest on nothing, until there is more to rest on.
    void widen(const SolvedAssembly& now, double needed, bool stuck) {
        ++widenings_;
        factor_ = std::min(farthest_search, std::max(search_widening * factor_, needed));
        std::vector<Candidate> before = std::move(out_.candidates);
        search();
        for (; stuck && out_.candidates.size() == before.size() && may_widen(); ++widenings_) {
            factor_ = std::min(farthest_search, search_widening * factor_);
            search();
        }
        comparable_from_ = out_.passes.size();
        start_over();
        if (stuck) return;
        PressedStretches stretches = now.stretches;
        if (is_in_contact(now) && before.size() == out_.candidates.size()) {
            stretches = with_missed(contacts_by_theory(scene_, now).stretches, followed_);
            set_first_goals(now, stretches, next_);
            wanted_ = sizes_from(scene_, now, stretches, next_.resolution);
        }
        expect_ends(scene_, now, stretches, before);
        expect_pressures(now, before);
        inherit_expected(before, out_.candidates);
    }

    /// Once a pass, and only where it is asked for: it costs as much as a good part of the solution.
    void recover_stress(const SolvedAssembly& now) {
        if (!out_.stress.empty() || !is_solved(now)) return;
        const auto begin = std::chrono::steady_clock::now();
        out_.stress = stress_fields(now, threads_);
        ErrorEstimate& error = out_.errors.back();
        if (std::optional<std::vector<double>> missed = energy_errors(now, out_.stress, threads_)) {
            const double energy = energy_of(now);
            error.smoothing = std::accumulate(missed->begin(), missed->end(), 0.0) / energy;
            for (const SingularError& e : singular_errors(scene_, conditions_, now)) (*missed)[e.grid] += e.energy;
            error.energy = std::accumulate(missed->begin(), missed->end(), 0.0) / energy;
            error.own_energy = of_own_energy(now, std::move(*missed));
        }
        const std::size_t n = out_.errors.size();
        const bool compares = !is_in_contact(now);  // grids that follow contacts do not follow stresses
        if (compares && error.smoothing && n > comparable_from_ + 1 && out_.errors[n - 2].smoothing)
            error.energy = energy_error_of({out_.passes[n - 2].energy, *out_.errors[n - 2].smoothing},
                                           {out_.passes[n - 1].energy, *error.smoothing});
        if (error.energy) error.stress = std::sqrt(*error.energy);
        out_.largest = largest_stresses(scene_, conditions_, now, out_.stress,
                                        compares ? out_.largest : std::vector<LargestStress>(), threads_);
        if (const LargestStress* most = strongest(out_.largest)) error.largest_stress = most->error;
        seconds_["recovery"] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

    /// Of contacts' forces: what they miss by the stiffness of their parts, as far as the strongest one's pressure is the
    /// measure. The stress that it needs is asked for at the end anyway.
    double missed_by_stiffness(const SolvedAssembly& now) {
        ErrorEstimate& error = out_.errors.back();
        const bool is_new = std::exchange(looked_at_, out_.passes.size()) != out_.passes.size();
        const std::vector<char> depend = is_new ? depend_on_stiffness(now) : std::vector<char>();
        if (std::count(depend.begin(), depend.end(), 1) > 0) {
            recover_stress(now);
            const std::vector<double> shares = shares_of_stiffness(now, depend, error.own_energy, threads_);
            for (std::size_t k = 0; k < shares.size(); ++k)
                if (error.contacts[k]) error.contacts[k]->of_stiffness = shares[k];
        }
        double most = 0;
        for (const std::optional<ContactError>& c : error.contacts)
            if (c) most = std::max(most, c->share * c->of_stiffness);
        return most;
    }

    /// Does that ask for an energy that is known better?
    bool lacks_stiffness(const SolvedAssembly& now) {
        const double missed = missed_by_stiffness(now);
        if (missed <= out_.target) return false;
        if (energy_target_ == out_.target) aimed_from_ = out_.passes.size() - 1;
        energy_target_ = std::min(energy_target_, *out_.errors.back().energy * out_.target / missed);
        return true;
    }

    bool end(SolvedAssembly&& now, PathEnd why) {
        if (is_answered_ && is_in_contact(now)) missed_by_stiffness(now);
        if (!meets_others_ && now.solution.mechanism.empty() && !now.is_lost) failed_ = failure_of(now);
        out_.solved = std::move(now);
        out_.end = why;
        return true;
    }

    ErrorEstimate errors_of_last(bool stuck) const {
        if (stuck) return {};
        const bool first = out_.passes.size() <= comparable_from_ + 1;
        return estimate_errors(std::span(out_.passes).subspan(comparable_from_), first ? ErrorEstimate{} : out_.errors.back(),
                               theory_.pressure);
    }

    /// Has the answer fewer digits than a finer grid could show?
    bool is_lost_in_rounding(const SolvedAssembly& now) const {
        return std::numeric_limits<double>::epsilon() * largest_condition(now, threads_) > rounding_share * out_.target;
    }

    /// Without contact the stress is aimed at, its largest value as well. What smoothed stresses alone say of it holds where it
    /// is smooth; beside stress raisers it takes a second grid to know.
    bool step_without_contact(SolvedAssembly&& now) {
        recover_stress(now);
        if (next_.on_final_cells()) {
            const ErrorEstimate& error = out_.errors.back();
            if (!error.stress) return end(std::move(now), PathEnd::no_need);
            const bool is_low_on_the_whole = *error.stress <= out_.target,
                       is_low_at_most = !error.largest_stress || *error.largest_stress <= out_.target,
                       is_low = is_low_on_the_whole && is_low_at_most, is_first = out_.passes.size() == comparable_from_ + 1;
            if (is_low && !is_first) return end(std::move(now), PathEnd::reached);
            if (is_lost_in_rounding(now)) return end(std::move(now), is_low ? PathEnd::reached : PathEnd::out_of_digits);
            const bool has_raisers = (is_first || !is_low_on_the_whole) && add_stress_raisers(now, out_.stress, raisers_);
            if (is_low && !has_raisers) return end(std::move(now), PathEnd::reached);
            if (is_too_deep(now)) return end_too_deep(std::move(now));
            if (now.limited_grids > 0) return end(std::move(now), PathEnd::out_of_cells);
            if (out_of_passes()) return end(std::move(now), PathEnd::out_of_passes);
            if (!is_low_at_most) add_largest_stress(scene_, conditions_, now, out_.stress, out_.largest, raisers_);
            if (!has_raisers && !is_low_on_the_whole) next_.coarseness /= coarsening_step;
        }
        coarsen_less(next_);
        wanted_ = first_sizes(scene_, out_.candidates, next_.next_coarseness());
        if (has_bonds(now))  // whose ends no part's own stresses follow on both sides
            add_singular_cells(now, singular_errors(scene_, conditions_, now), out_.target * out_.target, wanted_);
        add_raisers();
        if (exceeds_budget(now)) return end(std::move(now), PathEnd::out_of_budget);
        return false;
    }

    void add_raisers() {
        for (std::size_t i = 0; i < wanted_.size(); ++i)
            wanted_[i].insert(wanted_[i].end(), raisers_[i].begin(), raisers_[i].end());
    }

    std::span<const ErrorEstimate> comparable_errors() const { return std::span(out_.errors).subspan(comparable_from_); }

    /// What a pressure lacks by the cells away from it is of the size of what the energy lacks: cells become smaller where that
    /// error is, if it counts; and everywhere if it does not, but the contacts' own cells did not help.
    void refine_shape(const SolvedAssembly& now) {
        recover_stress(now);
        const std::optional<double>& energy = out_.errors.back().energy;
        const bool is_low = energy && *energy <= aimed_energy * energy_target_;
        if (is_low && has_fallen(comparable_errors())) return;
        if (is_low || !add_stress_raisers(now, out_.stress, raisers_)) next_.coarseness /= coarsening_step;
    }

    /// Would the next grids take more than the user gives?
    bool exceeds_budget(const SolvedAssembly& now) {
        const Budget& budget = scene_.accuracy.budget;
        if (!budget.is_given()) return false;
        const std::size_t n = out_.passes.size();
        const PassAsk next = ask();
        const double last_seconds = out_.passes.back().seconds - (n > 1 ? out_.passes[n - 2].seconds : 0);
        out_.next = cost_of_pass(scene_, conditions_, next.parts, next.wanted, next.coarseness, now, last_seconds);
        const double spent = seconds_so_far() + seconds_["recovery"];
        return is_beyond(budget, spent, *out_.next);
    }

    bool out_of_passes() const {
        const std::size_t n = passes_before_ + out_.passes.size(), from = std::max(comparable_from_, aimed_from_);
        return unanswered_ >= max_unanswered || n >= std::max(settled_from_, from) + max_passes ||
               n >= from + most_beginnings * max_passes ||
               (n >= from + max_passes && go_astray(std::span(out_.errors).subspan(from), max_passes / 2));
    }

    /// Did the last pass miss or close other contacts than the one before?
    bool has_changed_contacts() const {
        const std::size_t n = out_.passes.size();
        if (n < comparable_from_ + 2) return true;
        if (!std::equal(missed_.begin(), missed_.end(), missed_before_.begin(), missed_before_.end(),
                        [](const auto& a, const auto& b) { return a.empty() == b.empty(); }))
            return true;
        const std::vector<ContactRecord>&now = out_.passes[n - 1].contacts, &before = out_.passes[n - 2].contacts;
        return !std::equal(
            now.begin(), now.end(), before.begin(), before.end(),
            [](const ContactRecord& a, const ContactRecord& b) { return a.stretches.empty() == b.stretches.empty(); });
    }

    void record(SolvedAssembly& now) {
        const bool stuck = !is_solved(now);
        if (!stuck && now.part_energy.empty()) {
            std::vector<double> energies;
            for (std::size_t k = 0; k < now.grids.size(); ++k) energies.push_back(energy_of_part(now, k));
            now.part_energy = std::move(energies);
        }
        out_.passes.push_back(stuck ? PassRecord{} : record_of(now, seconds_so_far()));
        if (!stuck) renew_pressures(scene_, now, theory_);
        out_.errors.push_back(errors_of_last(stuck));
        settled_from_ = std::max(settled_from_, comparable_from_);
        if (has_changed_contacts()) settled_from_ = out_.passes.size() - 1;
    }

    /// Also where the grids were too coarse to see it.
    bool is_in_contact(const SolvedAssembly& now) const { return any_stretch(now) || any_missed(missed_); }

    void look_for_missed(const SolvedAssembly& now) {
        missed_before_ = std::move(missed_);
        out_.seen = is_solved(now) ? look_at_contacts(scene_, now, threads_) : std::vector<SeenContact>(now.contacts.size());
        missed_ = is_solved(now) ? missed_contacts(now, out_.seen, out_.target) : MissedContacts(now.contacts.size());
        if (!any_missed(missed_) || followed_.size() != missed_.size()) followed_ = missed_;
        for (std::size_t k = 0; is_solved(now) && k < missed_.size(); ++k)
            if (!missed_[k].empty() || !now.stretches[k].empty()) followed_[k] = missed_[k];
    }

    /// What slides on the first cells may rest on those that follow the contacts; where it does not, that is the motion.
    void tell_sliding(SolvedAssembly& now) {
        if (!is_solved(now) || now.solution.converged) return;
        const bool had_slid = !slid_.sliding.empty();
        if (!now.solution.sliding.empty()) slid_ = {now.solution.sliding, now.solution.holding_factor};
        if (!had_slid && !grids_are_fixed(scene_)) return;
        now.solution.mechanism = slid_.sliding;
        now.solution.holding_factor = slid_.factor;
    }

    /// After one solution; true: it is the last one, and taken.
    bool step(SolvedAssembly& now) {
        const bool stuck = !is_solved(now);
        look_for_missed(now);
        record(now);
        if (!now.failure.empty() && !next_.on_final_cells()) {  // a wall too thin for the first cells
            comparable_from_ = out_.passes.size();
            start_over();
            next_.coarsening = next_.coarseness;
            wanted_ = first_sizes(scene_, out_.candidates, next_.next_coarseness());
            return false;
        }
        if (now.failure.empty() && !grids_are_fixed(scene_) && tipped_ < max_tippings &&
            add_tipping_ends(scene_, out_.candidates, now, raisers_)) {
            ++tipped_;
            comparable_from_ = out_.passes.size();
            add_raisers();
            return false;
        }
        if (has_to_widen(now)) {
            widen(now, needed_factor(now), stuck);
            return false;
        }
        out_.search_too_short = !stuck && searches_contacts(scene_) && scene_.contacts.detect &&
                                (zone_too_short(now) || (!scene_.contacts.search_distance && needed_factor(now) > factor_));
        tell_sliding(now);
        if (now.failure.empty() && now.solution.sliding.empty()) tell_lost(scene_, now);
        if (!is_solved(now)) return end(std::move(now), PathEnd::no_need);
        is_answered_ = now.solution.converged;
        unanswered_ = is_answered_ ? 0 : unanswered_ + 1;
        failed_ = failure_of(now);  // speaks only where grids before had answers
        if (!why_end_.empty()) {
            out_.why = why_end_;
            return end(std::move(now), PathEnd::finer_failed);
        }
        if (grids_are_fixed(scene_))
            return end(std::move(now), scene_.accuracy.target ? PathEnd::fixed_grids : PathEnd::no_need);
        if (!is_in_contact(now)) return step_without_contact(std::move(now));
        if (is_reached() && !next_.on_final_cells() && follow(now, max_knot_moves - knot_moves_before)) {
            out_.passes.pop_back();
            out_.errors.pop_back();
            record(now);
            if (!is_solved(now)) return end(std::move(now), PathEnd::no_need);
            look_for_missed(now);
        }
        if (is_reached() && !lacks_stiffness(now)) return end(std::move(now), PathEnd::reached);
        if (next_.on_final_cells() && is_too_deep(now)) return end_too_deep(std::move(now));
        if (next_.on_final_cells() && now.limited_grids > 0 && !is_improving(comparable_errors()))
            return end(std::move(now), PathEnd::out_of_cells);
        if (out_of_passes()) return end(std::move(now), PathEnd::out_of_passes);
        const PressedStretches stretches = ask_for_next(now, out_.errors.back());
        if (exceeds_budget(now)) return end(std::move(now), PathEnd::out_of_budget);
        expect(now, stretches);
        return false;
    }

    void expect(const SolvedAssembly& now, const PressedStretches& stretches) {
        move_seams(scene_, now, out_.candidates);
        expect_ends(scene_, now, stretches, out_.candidates);
        expect_pressures(now, out_.candidates);
    }

    /// Where no grid came to an error that anybody could aim at there is no answer.
    bool end_too_deep(SolvedAssembly&& now) {
        out_.why = text_of_too_deep(scene_, now);
        const auto could_be_aimed_at = [](const ErrorEstimate& e) {
            return e.contact_pressure && std::max(*e.contact_pressure, *e.peak) <= most_target;
        };
        if (out_.errors.back().contact_pressure && std::none_of(out_.errors.begin(), out_.errors.end(), could_be_aimed_at))
            now.failure = out_.why;
        return end(std::move(now), PathEnd::too_deep);
    }

    bool is_reached() const {
        const ErrorEstimate& error = out_.errors.back();
        return error.contact_pressure && std::max(*error.contact_pressure, *error.peak) <= out_.target && !any_missed(missed_);
    }

    /// Is it worth another grid that the largest stress is known badly, which pressures do not say?
    bool is_stress_doubtful(const SolvedAssembly& now) {
        if (sharpened_ >= max_sharpenings || now.limited_grids > 0 || is_too_deep(now) || out_of_passes()) return false;
        recover_stress(now);
        const LargestStress* most = strongest(out_.largest);
        return most && !most->corner && most->error.value_or(0) > doubtful;
    }

    /// The sizes that the contacts as they are expected ask for, and what raises stresses.
    PressedStretches want(const SolvedAssembly& now, PressedStretches stretches) {
        wanted_ = sizes_from(scene_, now, stretches, next_.resolution);
        add_singular_cells(now, singular_errors(scene_, conditions_, now), energy_target_, wanted_);
        add_raisers();
        return stretches;
    }

    /// The contacts as they are expected.
    PressedStretches ask_for_next(const SolvedAssembly& now, const ErrorEstimate& error) {
        const bool is_first = next_.goal.empty(), has_goals = begins_like_another_ && out_.passes.size() == 1;
        if (is_first || has_goals) theory_ = contacts_by_theory(scene_, now);
        if (is_first) {
            set_first_goals(now, with_missed(theory_.stretches, followed_), next_);
            if (theory_.is_close && !any_missed(missed_))
                aim_at_goals(next_);
            else
                coarsen_less(next_);
        } else if (!has_goals) {
            const bool may_be_stiff = is_reached() || !has_fallen(comparable_errors());
            if ((may_be_stiff && lacks_stiffness(now)) || may_lack_shape(error, next_)) refine_shape(now);
            is_answered_ ? refine(error, next_) : refine_all(next_);
        }
        return want(now, with_missed(is_first ? theory_.stretches : now.stretches, followed_));
    }

    double seconds_so_far() const { return seconds_["geometry"] + seconds_["assembly"] + seconds_["solve"]; }

    PartGroup group_;
    const Scene& scene_;
    const ResolvedConditions& conditions_;
    Stopwatches& seconds_;
    int threads_;
    Outcome out_;
    SolvedAssembly last_;  // of steps that are not over
    NextGrids next_;
    WantedSizes wanted_;
    WantedSizes raisers_;                    // where stresses turned out to be worst
    TheoryOfContacts theory_;                // of the first solution's contacts, with the forces of the last
    MissedContacts missed_, missed_before_;  // of the last solution, and of the one before
    MissedContacts followed_;                // and those before, while any are missed: cells that leave one miss it again
    struct {
        std::vector<solver::PartMotion> sliding{};
        double factor = 0;
    } slid_;  // how bodies slid that friction did not hold, and what would
    double factor_ = 1;
    int widenings_ = 0, tipped_ = 0, sharpened_ = 0, unanswered_ = 0;
    bool is_over_ = false, is_answered_ = false, begins_like_another_ = false, meets_others_ = false;
    double energy_target_;  // of the strain energy: where forces are small differences, less than that of pressures
    std::string failed_, why_end_;
    std::size_t passes_before_ = 0;    // of the walk that this one begins like
    std::size_t comparable_from_ = 0;  // passes before have other candidates
    std::size_t settled_from_ = 0;     // passes before closed or missed other contacts
    std::size_t aimed_from_ = 0;       // passes before did not know that the energy is to be known better
    std::size_t looked_at_ = 0;        // of passes: the last one whose parts' stiffness was looked at
};

GridWalk::GridWalk(const Scene& scene, const ResolvedConditions& conditions, Stopwatches& seconds, PartGroup group,
                   const std::vector<Candidate>& candidates, int threads)
    : path_(std::make_unique<Path>(scene, conditions, seconds, std::move(group), candidates, threads)) {}
GridWalk::GridWalk(std::unique_ptr<Path> path) : path_(std::move(path)) {}
GridWalk::GridWalk(GridWalk&&) noexcept = default;
GridWalk& GridWalk::operator=(GridWalk&&) noexcept = default;
GridWalk::~GridWalk() = default;

PassAsk GridWalk::ask() const {
    return path_->ask();
}
const std::vector<Candidate>& GridWalk::candidates() const {
    return path_->candidates();
}
bool GridWalk::take(SolvedAssembly solved) {
    return path_->take(std::move(solved));
}
bool GridWalk::sharpen() {
    return path_->sharpen();
}
bool GridWalk::is_over() const {
    return path_->is_over();
}
bool GridWalk::has_answer() const {
    return path_->has_answer();
}
int GridWalk::n_widenings() const {
    return path_->n_widenings();
}
const std::string& GridWalk::failed() const {
    return path_->failed();
}
GridWalk GridWalk::unsolved() {
    return GridWalk(path_->unsolved());
}
void GridWalk::begin_like(const GridWalk& other) {
    path_->begin_like(*other.path_);
}
void GridWalk::end_with_next(const std::string& why, bool is_again) {
    path_->end_with_next(why, is_again);
}
bool GridWalk::meets_others() const {
    return path_->meets_others();
}
const SolvedAssembly& GridWalk::last() const {
    return path_->last();
}
std::size_t GridWalk::n_passes() const {
    return path_->n_passes();
}
Outcome GridWalk::take_outcome() {
    return path_->take_outcome();
}

}  // namespace abut
