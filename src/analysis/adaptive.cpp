// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/adaptive.hpp"

#include <algorithm>
#include <limits>
#include <new>
#include <numeric>
#include <optional>
#include <utility>

#include "solver/linear_algebra/blas_threads.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "src/analysis/grid_walk.hpp"
#include "src/analysis/part_groups.hpp"
#include "src/analysis/pass_cost.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

/// Everything that any of the walks asks for.
PassAsk joined(const std::vector<GridWalk>& walks) {
    PassAsk all = walks.front().ask();
    for (std::size_t k = 1; k < walks.size(); ++k) {
        const PassAsk own = walks[k].ask();
        all.coarseness = std::min(all.coarseness, own.coarseness);
        for (std::size_t i = 0; i < all.parts.size(); ++i) {
            all.parts[i] = all.parts[i] || own.parts[i];
            all.wanted[i].insert(all.wanted[i].end(), own.wanted[i].begin(), own.wanted[i].end());
        }
    }
    return all;
}

void tell_pass(const GridWalk& walk, const PassAsk& ask, const AnalyzeOptions& options) {
    if (!options.progress) return;
    options.progress("pass " + std::to_string(walk.n_passes() + 1) + (ask.cost ? " " + cost_text(*ask.cost) : ""));
}

/// Takes passes until take_pass says that one was the last. Where one fails by its grids or numbers after others gave answers,
/// the last of these is taken again, which costs its time but no memory beside the passes after it, and is the end. What
/// moves because nothing holds it moves on any grid: that is the answer however late it is found.
template <class TakePass>
void walk_to_end(std::vector<GridWalk>& walks, TakePass take_pass) {
    std::vector<GridWalk> good;  // before the last pass with answers
    for (bool is_last = false; !is_last;) {
        std::vector<GridWalk> before;
        for (GridWalk& walk : walks) before.push_back(walk.unsolved());
        std::string failed;
        try {
            is_last = take_pass();
            for (std::size_t k = walks.size(); k-- > 0;)
                if (before[k].failed().empty() && !walks[k].failed().empty()) failed = walks[k].failed();
        } catch (const std::bad_alloc&) {
            if (good.empty()) throw;
            failed = "they need more memory than there is";
        }
        if (!failed.empty() && !good.empty()) {
            walks = std::exchange(good, {});
            for (GridWalk& walk : walks) walk.end_with_next("finer grids gave no answer: " + failed);
            is_last = false;
        } else if (!std::equal(walks.begin(), walks.end(), before.begin(), before.end(),
                               [](const GridWalk& a, const GridWalk& b) { return a.n_widenings() == b.n_widenings(); })) {
            good.clear();
        } else if (std::all_of(walks.begin(), walks.end(), [](const GridWalk& w) { return w.is_over() || w.has_answer(); })) {
            good = std::move(before);
        }
    }
}

/// Nothing where a wider search met parts of other groups: these are one problem.
std::optional<Outcome> walk_group(const CaseProblem& problem, const PartGroup& group, const std::vector<Candidate>& candidates,
                                  const AnalyzeOptions& options, Stopwatches& seconds) {
    const int threads = solver::usable_threads(options.threads);
    std::vector<GridWalk> walks;
    walks.emplace_back(*problem.scene, *problem.conditions, seconds, group, candidates, threads);
    if (walks[0].meets_others()) return std::nullopt;
    walk_to_end(walks, [&] {
        GridWalk& walk = walks[0];
        const PassAsk ask = walk.ask();
        tell_pass(walk, ask, options);
        const bool is_over = walk.take(solve_pass(*problem.scene, *problem.conditions, walk.candidates(), ask.parts, ask.wanted,
                                                  ask.coarseness, seconds, threads));
        return (is_over && !walk.sharpen()) || walk.meets_others();
    });
    if (walks[0].meets_others()) return std::nullopt;
    return walks[0].take_outcome();
}

bool has_answer(const SolvedAssembly& s) {
    return s.failure.empty() && s.solution.mechanism.empty() && s.solution.converged;
}

/// A step that cannot begin, since the one before it has no answer.
SolvedAssembly without_answer(const Scene& scene, const std::string& step_before) {
    SolvedAssembly none;
    none.solver_part.assign(scene.parts.size(), -1);
    none.failure = "the step before it, '" + step_before + "', has no answer";
    none.is_lost = true;  // as it is, or for what is told of that step
    return none;
}

/// Cells that other cases want and halving does not reach are none that this one lacks.
void forget_others_too_fine(const WantedSizes& own, SolvedAssembly& solved) {
    for (PartOnGrid& g : solved.grids) {
        if (g.too_fine == 0) continue;
        double smallest = std::numeric_limits<double>::infinity(), finest = smallest;
        for (const WantedSize& w : own[at(g.part)]) smallest = std::min(smallest, w.size);
        for (int cell = 0; cell < static_cast<int>(g.cells.cell_class.size()); ++cell)
            finest = std::min(finest, g.cells.grid.box(cell).size().maxCoeff());
        g.too_fine = smallest < finest ? smallest : 0;
    }
}

/// The walks of several cases over common grids. All answers are of the same last ones; on those before, only cases that lack
/// something are solved: the others have nothing to ask for. Cases are solved side by side, steps one after the other.
class CaseWalks {
public:
    CaseWalks(const Scene& scene, const std::vector<CaseProblem>& cases, const AnalyzeOptions& options, Stopwatches& seconds)
        : scene_(scene),
          cases_(cases),
          options_(options),
          seconds_(seconds),
          threads_(solver::usable_threads(options.threads)),
          side_by_side_(scene.in_steps ? 1 : std::min(threads_, static_cast<int>(cases.size()))),
          unloaded_(*cases.front().scene),
          held_{cases.front().conditions->supports, {}} {
        const std::vector<Candidate> candidates = search_scene(*cases.front().scene, 1, seconds, uses_);
        own_seconds_.resize(cases.size(), seconds);
        for (std::size_t k = 0; k < cases.size(); ++k)
            walks_.emplace_back(*cases[k].scene, *cases[k].conditions, own_seconds_[k],
                                PartGroup(cases[k].scene->parts.size(), true), candidates, threads_of_one());
        unloaded_.loads.clear();  // what a part is made of is the same in all cases
        const bool begin_in_turn = !scene.in_steps || has_friction(candidates);
        if (!begin_in_turn) n_begun_ = cases.size();
    }

    std::vector<Outcome> outcomes() {
        walk_to_end(walks_, [&] { return is_last_pass(); });
        std::vector<Outcome> all(walks_.size());
        for_each(numbers(0, walks_.size()), [&](std::size_t k) { all[k] = walks_[k].take_outcome(); });
        for (Outcome& out : all) add_uses(out.uses, uses_);
        return all;
    }

private:
    /// The first few find out what grids they want.
    static constexpr std::size_t first_cases = 4;
    /// By unknown: the solution of a case, beside what all have in common.
    static constexpr double bytes_of_case = 1.8e3;

    static std::vector<std::size_t> numbers(std::size_t begin, std::size_t end) {
        std::vector<std::size_t> all(end - begin);
        std::iota(all.begin(), all.end(), begin);
        return all;
    }

    int threads_of_one() const { return threads_ / side_by_side_; }

    /// Whose seconds count as much less as there are others at the same time.
    template <class Work>
    void for_each(const std::vector<std::size_t>& those, const Work& work) {
        const Stopwatches before = seconds_;
        std::fill(own_seconds_.begin(), own_seconds_.end(), before);
        solver::parallel_for(static_cast<int>(those.size()), side_by_side_, [&](int i) { work(those[at(i)]); });
        for (const Stopwatches& own : own_seconds_)
            for (const auto& [stage, sum] : own)
                seconds_[stage] += (sum - (before.contains(stage) ? before.at(stage) : 0.0)) / side_by_side_;
    }

    bool have_ended(std::size_t n) const {
        return std::all_of(walks_.begin(), walks_.begin() + static_cast<std::ptrdiff_t>(n),
                           [](const GridWalk& w) { return w.is_over(); });
    }

    void solve(std::size_t k, const SolvedAssembly& prepared) {
        GridWalk& walk = walks_[k];
        const SolvedAssembly* before = scene_.in_steps && k > 0 ? &walks_[k - 1].last() : nullptr;
        if (before && !has_answer(*before)) {
            walk.take(without_answer(scene_, scene_.cases[k - 1].name));
            return;
        }
        const PassAsk own = walk.ask();
        SolvedAssembly solved = solve_case(*cases_[k].scene, *cases_[k].conditions, walk.candidates(), own.parts, prepared,
                                           before, own_seconds_[k], threads_of_one());
        forget_others_too_fine(own.wanted, solved);
        walk.take(std::move(solved));
    }

    /// A case is like those before it: in every pass twice as many take part, with the sizes that these have come to, and so on
    /// while they lack nothing. Steps without friction, which are the same in any order, begin at once.
    void solve_lacking(const SolvedAssembly& prepared) {
        const auto solve_one = [&](std::size_t k) { solve(k, prepared); };
        std::vector<std::size_t> begun = numbers(0, n_begun_);
        if (!scene_.in_steps) std::erase_if(begun, [&](std::size_t k) { return walks_[k].is_over(); });
        for_each(begun, solve_one);
        bool lacks_nothing = true;
        while (n_begun_ < cases_.size() && lacks_nothing) {
            const std::size_t n_before = n_begun_;
            n_begun_ = std::min(cases_.size(), std::max(first_cases, 2 * n_before));
            const std::vector<std::size_t> beginners = numbers(n_before, n_begun_);
            if (n_before > 0)
                for (std::size_t k : beginners) walks_[k].begin_like(walks_[n_before - 1]);
            for_each(beginners, solve_one);
            lacks_nothing = have_ended(n_begun_);
        }
    }

    double seconds_so_far() const {
        return seconds_["geometry"] + seconds_["assembly"] + seconds_["solve"] + seconds_["recovery"];
    }

    /// Where the next grids, of all cases, would go beyond what the user gives the last ones stay.
    void keep_to_budget(const SolvedAssembly& last, const PassAsk& ask_of_last, double seconds_of_last) {
        const Budget& budget = scene_.accuracy.budget;
        if (!budget.is_given() || kept_) return;
        const PassAsk next = joined(walks_);
        PassCost cost = cost_of_pass(unloaded_, held_, next.parts, next.wanted, next.coarseness, last, seconds_of_last);
        cost.bytes += cost.unknowns * bytes_of_case * static_cast<double>(cases_.size());
        if (is_beyond(budget, seconds_so_far(), cost))
            kept_ = {ask_of_last.wanted, ask_of_last.coarseness,
                     "the next grids of all cases, " + cost_text(cost) + ", would go beyond the budget"};
    }

    /// All are solved once more on the grids that stay.
    void take_kept_grids(PassAsk& ask) {
        ask.wanted = kept_->wanted;
        ask.coarseness = kept_->coarseness;
        n_begun_ = cases_.size();
        for (std::size_t k = 0; k < walks_.size(); ++k)
            walks_[k].end_with_next(kept_->why, walks_[k].n_passes() > passes_before_[k]);
    }

    bool is_last_pass() {
        PassAsk ask = joined(walks_);
        if (kept_) take_kept_grids(ask);
        tell_pass(walks_.front(), ask, options_);
        const double before = seconds_so_far();
        passes_before_.clear();
        for (const GridWalk& walk : walks_) passes_before_.push_back(walk.n_passes());
        const SolvedAssembly prepared = prepare_parts(unloaded_, held_, walks_.front().candidates(), ask.parts, ask.wanted,
                                                      ask.coarseness, seconds_, threads_);
        const bool is_last = ends_on(prepared);
        if (!is_last) keep_to_budget(prepared, ask, seconds_so_far() - before);
        return is_last;
    }

    bool ends_on(const SolvedAssembly& prepared) {
        std::vector<std::size_t> later = numbers(0, scene_.in_steps ? 0 : n_begun_);
        std::erase_if(later, [&](std::size_t k) { return !walks_[k].is_over(); });
        solve_lacking(prepared);
        if (!have_ended(walks_.size())) return false;
        for_each(later, [&](std::size_t k) { solve(k, prepared); });
        if (!have_ended(walks_.size())) return false;
        std::vector<char> goes_on(walks_.size());
        for_each(numbers(0, walks_.size()), [&](std::size_t k) { goes_on[k] = walks_[k].sharpen(); });
        return std::count(goes_on.begin(), goes_on.end(), 1) == 0;
    }

    const Scene& scene_;
    const std::vector<CaseProblem>& cases_;
    const AnalyzeOptions& options_;
    Stopwatches& seconds_;
    int threads_, side_by_side_;
    Scene unloaded_;
    ResolvedConditions held_;
    EffectUses uses_;
    std::vector<Stopwatches> own_seconds_;  // by case
    std::vector<GridWalk> walks_;
    std::size_t n_begun_ = 0;
    std::vector<std::size_t> passes_before_;  // the last one, by case
    struct KeptGrids {
        WantedSizes wanted;
        double coarseness;
        std::string why;
    };
    std::optional<KeptGrids> kept_{};  // once others would go beyond the budget
};

}  // namespace

Outcome solve_adaptively(const Scene& scene, const ResolvedConditions& conditions, const AnalyzeOptions& options,
                         Stopwatches& seconds) {
    EffectUses uses;
    const CaseProblem problem{&scene, &conditions};
    const std::vector<Candidate> candidates = search_scene(scene, 1, seconds, uses);
    std::vector<Outcome> outcomes;
    for (const PartGroup& group : part_groups(scene, conditions, candidates)) {
        std::optional<Outcome> own = walk_group(problem, group, candidates, options, seconds);
        if (own) add_uses(uses, own->uses);
        if (own) outcomes.push_back(std::move(*own));
        if (own) continue;
        const PartGroup all(scene.parts.size(), true);
        outcomes.clear();
        outcomes.push_back(*walk_group(problem, all, candidates, options, seconds));
        add_uses(uses, outcomes[0].uses);
        break;
    }
    Outcome out = merged(std::move(outcomes));
    out.uses = std::move(uses);
    return out;
}

std::vector<Outcome> solve_cases_adaptively(const Scene& scene, const std::vector<CaseProblem>& cases,
                                            const AnalyzeOptions& options, Stopwatches& seconds) {
    return CaseWalks(scene, cases, options, seconds).outcomes();
}

}  // namespace abut
