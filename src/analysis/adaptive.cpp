// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/adaptive.hpp"

#include <algorithm>
#include <new>
#include <optional>
#include <utility>

#include "solver/linear_algebra/blas_threads.hpp"
#include "src/analysis/grid_walk.hpp"
#include "src/analysis/part_groups.hpp"

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
            for (GridWalk& walk : walks) walk.end_with_next(failed);
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
    const int threads = solver::usable_threads(options.threads);
    EffectUses uses;
    const std::vector<Candidate> candidates = search_scene(*cases.front().scene, 1, seconds, uses);
    std::vector<GridWalk> walks;
    for (const CaseProblem& c : cases)
        walks.emplace_back(*c.scene, *c.conditions, seconds, PartGroup(c.scene->parts.size(), true), candidates, threads);
    Scene unloaded = *cases.front().scene;  // what a part is made of is the same in all cases
    unloaded.loads.clear();
    const ResolvedConditions held{cases.front().conditions->supports, {}};
    // All answers are of the same last grids. On those before, only cases that lack something are solved: the others have
    // nothing to ask for.
    const auto have_all = [&] {
        return std::all_of(walks.begin(), walks.end(), [](const GridWalk& w) { return w.is_over(); });
    };
    // A case is like the one before it: the first few find out what grids they want, in every pass twice as many take part,
    // with the sizes that those before them have come to, and all where these lack nothing. Steps without friction, which are
    // the same in any order, begin at once.
    constexpr std::size_t first_cases = 4;
    const bool begin_in_turn = !scene.in_steps || has_friction(candidates);
    std::size_t n_begun = begin_in_turn ? 0 : cases.size();
    walk_to_end(walks, [&] {
        const PassAsk ask = joined(walks);
        tell_pass(walks.front(), ask, options);
        const SolvedAssembly prepared =
            prepare_parts(unloaded, held, walks.front().candidates(), ask.parts, ask.wanted, ask.coarseness, seconds, threads);
        const auto solve = [&](std::size_t k) {
            const SolvedAssembly* before = scene.in_steps && k > 0 ? &walks[k - 1].last() : nullptr;
            if (before && !has_answer(*before)) {
                walks[k].take(without_answer(scene, scene.cases[k - 1].name));
                return;
            }
            walks[k].take(solve_case(*cases[k].scene, *cases[k].conditions, walks[k].candidates(), walks[k].ask().parts,
                                     prepared, before, seconds, threads));
        };
        std::vector<std::size_t> later;
        const std::size_t n_before = n_begun, may_begin = std::max(first_cases, 2 * n_begun);
        bool is_lacking = false;
        for (std::size_t k = 0; k < cases.size() && (k < may_begin || !is_lacking); ++k) {
            if (walks[k].is_over() && !scene.in_steps) {
                later.push_back(k);
                continue;
            }
            if (k >= n_before && n_before > 0) walks[k].begin_like(walks[k - 1]);
            solve(k);
            n_begun = std::max(n_begun, k + 1);
            is_lacking = is_lacking || !walks[k].is_over();
        }
        if (!have_all()) return false;
        std::for_each(later.begin(), later.end(), solve);
        return have_all() && std::count_if(walks.begin(), walks.end(), [](GridWalk& w) { return w.sharpen(); }) == 0;
    });
    std::vector<Outcome> outcomes;
    for (GridWalk& walk : walks) {
        outcomes.push_back(walk.take_outcome());
        add_uses(outcomes.back().uses, uses);
    }
    return outcomes;
}

}  // namespace abut
