// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/step_path.hpp"

#include "src/plan/boundary_conditions.hpp"
#include "src/scene/load_cases.hpp"
#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

constexpr int most_halvings = 4;
constexpr double most_changed = 0.25;  // of what is closed, in one increment

bool has_answer_of_step(const SolvedAssembly& s) {
    return s.failure.empty() && s.solution.mechanism.empty() && s.solution.converged;
}

SolvedAssembly solve_at(const StepOnGrids& s, double fraction, const SolvedAssembly* before) {
    const std::vector<bool> parts = s.walk.ask().parts;
    if (fraction == 1)
        return solve_case(*s.problem.scene, *s.problem.conditions, s.walk.candidates(), parts, s.prepared, before, s.seconds,
                          s.threads);
    const LoadCase none{};
    Scene scene =
        scene_of_case(s.scene, between(s.step > 0 ? s.scene.cases[s.step - 1] : none, s.scene.cases[s.step], fraction));
    scene.loads_of_all_cases = s.problem.scene->loads_of_all_cases;
    return solve_case(scene, resolve_conditions(scene), s.walk.candidates(), parts, s.prepared, before, s.seconds, s.threads);
}

/// Adds what came before within the step.
void continue_from(const SolvedAssembly& half, SolvedAssembly& now) {
    now.increments += half.increments;
    now.dissipated = half.dissipated;
    now.dissipated.resize(now.contacts.size(), 0);
    for (std::size_t k = 0; k < half.contacts.size(); ++k)
        if (friction_of(half, k) > 0) now.dissipated[k] += friction_sums(half, k).dissipated;
}

SolvedAssembly advance(const StepOnGrids& s, double from, double to, const SolvedAssembly* before, int halvings) {
    SolvedAssembly now = solve_at(s, to, before);
    if (now.solution.mechanism.empty()) now.solution.mechanism = std::move(now.solution.sliding);  // nothing follows on it
    if (halvings == 0 || !now.failure.empty() || !now.solution.mechanism.empty()) return now;
    if (now.solution.converged && changed_share(now, before ? *before : SolvedAssembly{}) <= most_changed) return now;
    const double middle = 0.5 * (from + to);
    const SolvedAssembly half = advance(s, from, middle, before, halvings - 1);
    if (!has_answer_of_step(half)) return now;
    SolvedAssembly end = advance(s, middle, to, &half, halvings - 1);
    if (has_answer_of_step(end)) {
        const std::vector<double> own = end.dissipated;
        continue_from(half, end);
        for (std::size_t k = 0; k < own.size(); ++k) end.dissipated[k] += own[k];
    }
    return end;
}

}  // namespace

SolvedAssembly solve_step(const StepOnGrids& step, const SolvedAssembly* before) {
    if (!before || has_answer_of_step(*before)) return advance(step, 0, 1, before, most_halvings);
    SolvedAssembly none;
    none.solver_part.assign(step.scene.parts.size(), -1);
    none.failure = "the step before it, '" + step.scene.cases[step.step - 1].name + "', has no answer";
    none.is_lost = true;  // as it is, or for what is told of that step
    return none;
}

}  // namespace abut
