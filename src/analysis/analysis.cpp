// SPDX-License-Identifier: GPL-3.0-or-later
// The walk: conditions -> candidates -> passes (grids, solution, new grids from the contacts found) -> results.
#include "src/analysis/analysis.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "solver/linear_algebra/blas_threads.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "src/analysis/accuracy_results.hpp"
#include "src/analysis/adaptive.hpp"
#include "src/analysis/analyzed.hpp"
#include "src/analysis/assumptions.hpp"
#include "src/analysis/drawn_touches.hpp"
#include "src/analysis/effect_answers.hpp"
#include "src/analysis/follow_motion.hpp"
#include "src/analysis/held_contacts.hpp"
#include "src/analysis/idle_holds.hpp"
#include "src/analysis/motions_at_limit.hpp"
#include "src/analysis/moved_pairs.hpp"
#include "src/analysis/moved_parts.hpp"
#include "src/analysis/needed_friction.hpp"
#include "src/analysis/point_shares.hpp"
#include "src/analysis/second_order.hpp"
#include "src/analysis/self_contact.hpp"
#include "src/analysis/singular_places.hpp"
#include "src/analysis/slender_parts.hpp"
#include "src/analysis/static_forces.hpp"
#include "src/analysis/turned_contacts.hpp"
#include "src/answers/contact_results.hpp"
#include "src/answers/equilibrium.hpp"
#include "src/answers/field_results.hpp"
#include "src/answers/mobility.hpp"
#include "src/answers/motion_text.hpp"
#include "src/answers/part_results.hpp"
#include "src/answers/probes.hpp"
#include "src/base/index.hpp"
#include "src/contact/candidate_faces.hpp"
#include "src/contact/cell_search.hpp"
#include "src/io/number_text.hpp"
#include "src/plan/inclined_cuts.hpp"
#include "src/plan/plan.hpp"
#include "src/plan/stray_selections.hpp"
#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"
#include "src/results/verdict.hpp"
#include "src/scene/dissertation_method.hpp"
#include "src/scene/load_cases.hpp"
#include "src/solution/assembled_condition.hpp"
#include "src/solution/contact_measures.hpp"
#include "src/solution/rigid_pairs.hpp"

namespace abut {

namespace {

bool has_friction(const Outcome& out) {
    return std::any_of(out.candidates.begin(), out.candidates.end(), [](const Candidate& c) { return c.friction > 0; });
}

/// What friction would hold a mechanism, where some would and some is there.
std::string holding_friction(const Outcome& out) {
    const double factor = out.solved.solution.holding_factor;
    std::set<double> coefficients;
    for (const Candidate& c : out.candidates)
        if (c.friction > 0 && !c.bonded) coefficients.insert(c.friction);
    constexpr double most_usual = 5;  // what scenes are warned of: with more, bodies would roll or tip instead
    if (factor == 0 || coefficients.empty() || factor * *coefficients.rbegin() > most_usual) return "";
    if (coefficients.size() == 1)
        return ". A coefficient of friction of " + number_beside(*coefficients.begin() * factor, *coefficients.begin(), 4) +
               " would hold it, " + number_text(*coefficients.begin(), 4) + " does not";
    return ". Coefficients of friction " + number_beside(factor, 1, 4) + " times as large would hold it";
}

/// What friction does not hold where it is drawn, and what would.
std::string not_held(const Scene& scene, const Outcome& out) {
    const std::vector<solver::PartMotion>& mechanism = out.solved.solution.mechanism;
    if (mechanism.empty() || !has_friction(out)) return "";
    return "where it is drawn friction does not hold it: " + motions_text(scene, out.solved, mechanism) + holding_friction(out);
}

/// Where a part slides by so little of the loads that the digits of its drawing may be why.
std::string small_drive(const SolvedAssembly& solved) {
    constexpr double small = 1e-4;  // of the largest load: four digits of a size
    const std::vector<solver::PartMotion>& mechanism = solved.solution.mechanism;
    if (mechanism.size() != 1 || solved.grids[at(mechanism.front().part)].is_rigid) return "";
    const solver::PartMotion& m = mechanism.front();
    const PartOnGrid& g = solved.grids[at(m.part)];
    const double way = m.motion.translation.norm(),
                 work = coefficients_of(g.input.space, m.motion).dot(solved.problem.parts[at(m.part)].load);
    if (std::abs(m.motion.rotation) * g.size > small * way || !(std::abs(work) < small * way * solved.problem.load_scale))
        return "";
    return ", by " + number_text(std::abs(work) / (way * solved.problem.load_scale), 2) +
           " of the largest load: of the size of what coordinates with few digits incline faces by; give friction, or more "
           "digits";
}

void fill_failure(const Scene& scene, const Outcome& out, Result& result) {
    const SolvedAssembly& solved = out.solved;
    result.status = "failed";
    result.solver.converged = false;
    if (!solved.failure.empty()) {
        result.message = solved.failure;
        return;
    }
    warn_of_unused_rules(scene, out, result);
    result.driven = twists_of(solved, solved.solution.mechanism);
    result.message =
        "the loads move a part that nothing holds: " + motions_text(scene, solved, solved.solution.mechanism) +
        small_drive(solved) + holding_friction(out) +
        ". Add a support, or a part that it can rest on; contacts.search_distance says how far contacts are looked for";
    if (scene.in_steps && has_friction(out))
        result.message += ". Where friction gives way in a later step parts are not followed from there; as \"cases\" they are";
    if (const std::string rigid = rigid_stops(scene, out.candidates, solved); !rigid.empty()) result.message += ". " + rigid;
    if (const std::string touches = unpaired_touches(scene); !touches.empty())
        result.message +=
            ". Sharp edges are no contacts, of whose faces none oppose the other part's within 60 degrees: round those of " +
            touches;
}

void fill_largest(const LargestStress& largest, const Material& material, PartResult& part) {
    part.max_displacement = largest.displacement;
    part.max_von_mises = largest.von_mises;
    part.max_von_mises_error = largest.error;
    part.max_von_mises_at_corner = largest.at_corner;
    if (material.yield) part.utilisation = largest.von_mises.value / *material.yield;
}

/// Displacements and stresses of all parts that have some, side by side. False: one has no stresses.
bool fill_fields(const Scene& scene, const Outcome& out, int threads, Result& result) {
    const SolvedAssembly& solved = out.solved;
    geometry::Box2 model;
    std::size_t cells = 0;
    for (const PartOnGrid& g : solved.grids) {
        model.extend(bounding_box(scene.parts[at(g.part)].part));
        cells += g.cells.cell_class.size();
    }
    solver::parallel_for(static_cast<int>(solved.grids.size()), threads, [&](int k) {
        if (!out.stress[at(k)].failure.empty()) return;
        const auto i = at(solved.grids[at(k)].part);
        fill_largest(out.largest[at(k)], scene.materials[at(scene.parts[i].material)], result.parts[i]);
        result.fields[i] = part_field(solved.grids[at(k)], solved.solution.displacement[at(k)], out.stress[at(k)],
                                      drawn_patch * model.diagonal(), cells);
    });
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        if (out.stress[k].failure.empty()) continue;
        result.status = "failed";
        result.message = "part " + scene.parts[at(solved.grids[k].part)].name + ": " + out.stress[k].failure +
                         "; its cells are too coarse where it is thin: set accuracy.refine there, or a higher accuracy.level";
        return false;
    }
    return true;
}

void tell_neutral_motions(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    std::map<std::string, Finding> findings;  // by motion: each once
    for (const solver::PartMotion& m : solved.solution.neutral) {
        const solver::PartMotion back{m.part, {-m.motion.translation, -m.motion.rotation, m.motion.center}};
        const std::string text = std::max(motion_text(scene, solved, m), motion_text(scene, solved, back));  // to either side
        findings[text] = {0, text, "nothing holds a motion that no load drives (the answer of least motion is given): " + text};
    }
    remark(values_of(findings), result);
}

/// Does anything press on the part where it touches others, or is it bonded to one?
bool is_pressed(const SolvedAssembly& solved, std::size_t grid) {
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        for (const int of : solved.contacts[k].face.part)
            if (at(of) == grid && (solved.contacts[k].face.bilateral || !solved.stretches[k].empty())) return true;
    return false;
}

/// Parts that only contact keeps in place, while nothing presses on them: they lie anywhere within their clearances.
void tell_floating(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    std::vector<Finding> findings;
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        const std::string& name = scene.parts[at(solved.grids[k].part)].name;
        const auto is_told = [&](const solver::PartMotion& m) { return at(m.part) == k; };
        const std::vector<solver::PartMotion>& neutral = solved.solution.neutral;
        if (std::any_of(neutral.begin(), neutral.end(), is_told) || is_pressed(solved, k) ||
            motions_left_to_contacts(solved, k).empty())
            continue;
        findings.push_back({0, name,
                            "part " + name +
                                " lies loose, nothing presses it on another: it may be anywhere within its "
                                "clearances, and its displacements are those of one place there"});
    }
    remark(std::move(findings), result);
}

/// Parts that CHOLMOD was asked for and has no factor of.
void note_own_factors(const Scene& scene, const Outcome& out, Result& result) {
    for (const PartOnGrid& g : out.solved.grids)
        if (g.input.by_cholmod && g.input.is_projected)
            result.notes.push_back("part " + scene.parts[at(g.part)].name +
                                   ": factorised by abut itself, since its volume strain is projected");
}

/// Sound answers meet the conditions of contact to rounding, 1e-12 and less.
void tell_contact_residual(const SolvedAssembly& solved, Result& result) {
    constexpr double noted = 1e-6;
    if (!std::any_of(solved.stretches.begin(), solved.stretches.end(),
                     [](const auto& stretches) { return !stretches.empty(); }))
        return;
    const double residual = solved.solution.residual;
    result.solver.contact_residual = residual;
    if (residual <= noted) return;
    const std::string text = "the conditions of contact are met to " + number_text(residual, 2) + " only";
    tell({{residual, "", text + ", of the largest pressure or closing: pressures may be wrong by more than their errors say",
           text}},
         "contact_residual", result);
}

void fill_answers(const Scene& scene, const ResolvedConditions& conditions, const Outcome& out, int threads,
                  Stopwatches& seconds, Result& result) {
    const SolvedAssembly& solved = out.solved;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        result.contacts.push_back(contact_result(scene, solved, out.candidates[k], k));
        result.contacts.back().functional = faces_of(scene, out.candidates[k]).functional;
    }
    result.under_load = mobility_under_load(scene, conditions, result.contacts);
    result.strain_energy = energy_of(solved);
    result.energy_rounding = energy_rounding_of(solved);
    if (result.strain_energy < 0 && result.strain_energy >= -result.energy_rounding) result.strain_energy = 0;
    fill_equilibrium(scene, solved, result);
    for (const PreloadState& cut : solved.preloads)
        result.preloads.push_back({scene.parts[at(solved.grids[at(cut.grid)].part)].name, cut.across, cut.force, cut.shortening,
                                   cut.force_under_load});
    tell_contact_residual(solved, result);
    std::vector<Vec2> peaks;
    for (const ContactResult& c : result.contacts) peaks.push_back(c.max_pressure.at);
    fill_errors(out,
                {moved_pair_errors(scene, solved), turned_shares(scene, solved), shares_of_points(scene, solved, threads),
                 peaks_at_bond_ends(scene, conditions, solved, peaks)},
                result);
    fill_missed(out, result);
    const auto begin = std::chrono::steady_clock::now();
    if (!fill_fields(scene, out, threads, result)) return;
    fill_stress_errors(out, result);
    warn_of_largest_stress(out, result);
    fill_displacement_errors(out, result);
    fill_probes(scene, solved, out.stress, result);
    seconds["recovery"] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    tell_neutral_motions(scene, solved, result);
    tell_floating(scene, solved, result);
    warn_of_motions_at_limit(scene, solved, result);
    note_idle_holds(scene, solved, result);
    check_assumptions(scene, conditions, out, result);
    warn_of_turned_contacts(scene, out, result);
    warn_of_unstable_balance(scene, solved, result);
    warn_of_second_order(scene, out, threads, result);
    warn_of_moved_parts(scene, solved, result);
    warn_of_buckling(scene, out, result);
    note_own_factors(scene, out, result);
    if (solved.solution.is_way_broken)
        tell({{0, "",
               "on the way of the loads there are some under which no state of sticking and slipping was found: what friction "
               "holds where these have passed may be far off; give steps in which contacts close before what pulls along them",
               "friction holds nothing under some loads on the way to these"}},
             "load_path", result);
    if (solved.solution.is_one_of_several)
        result.warnings.push_back(
            "friction is so large that this is one of several answers: another state of sticking and slipping balances the "
            "same "
            "loads; which one comes about depends on how they were applied, which steps say");
    warn_of_held_contacts(scene, conditions, out, result);
    warn_of_held_loads(scene, conditions, out, result);
    note_needed_friction(scene, conditions, result);
    warn_of_drawn_touches(scene, solved, result);
}

/// "assembly" holds the factorisations, too.
std::vector<std::pair<std::string, double>> fine_stages(Stopwatches& seconds) {
    return {{"geometry", seconds["geometry"]},
            {"assembly", seconds["assembly"] - seconds["factorisation"]},
            {"factorisation", seconds["factorisation"]},
            {"contact", seconds["solve"]},
            {"recovery", seconds["recovery"]}};
}

/// An analysis on its way: what is known of it before anything is solved.
struct Begun {
    ResolvedConditions conditions;
    Result result;
    Settling settling{};
    std::optional<Rest> rest{};  ///< where parts settle
    std::string not_held{};      ///< in words: what goes there since friction does not hold it
};

/// from: where parts are before; empty: where they are drawn.
Begun begin_analysis(const Scene& drawn, Stopwatches& seconds, const std::vector<Placement>& from = {}) {
    Begun begun;
    Result& result = begun.result;
    result.title = drawn.title;
    result.length_unit = drawn.length_unit;
    result.force_unit = drawn.force_unit;
    result.degree = drawn.accuracy.degree;
    result.warnings = drawn.warnings;
    result.notes = drawn.notes;
    if (is_by_dissertation(drawn))
        result.notes.push_back(
            "by the dissertation's method, as accuracy.method asks: one solution on grids that do not adapt, contact by "
            "penalty along what its search on cells of " +
            with_unit(search_cell(drawn), 4, drawn.length_unit) + " lets in");
    check_probes(drawn);
    begun.conditions = resolve_conditions(drawn);
    for (const std::string& stray : stray_selections(drawn)) result.warnings.push_back(stray);
    for (const std::string& cut : inclined_cuts(drawn)) result.warnings.push_back(cut);
    result.effects = plan_effects(drawn, begun.conditions);
    const auto begin = std::chrono::steady_clock::now();
    begun.settling = settle(drawn, begun.conditions, from);
    begun.rest = rest_of(drawn, begun.conditions, begun.settling);
    seconds["geometry"] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return begun;
}

/// Fills in what the solution where parts rest answers. begin: of the whole run.
Analyzed finish_analysis(const Scene& drawn, Begun begun, Outcome out, int threads, std::chrono::steady_clock::time_point begin,
                         Stopwatches& seconds) {
    const ResolvedConditions& conditions = begun.conditions;
    Result& result = begun.result;
    std::optional<Rest> rest = std::move(begun.rest);
    const Scene& scene = rest ? rest->scene : drawn;
    result.support_marks = support_marks(scene, conditions);
    result.load_marks = load_marks(scene, conditions);
    fill_parts(scene, out.solved, result);
    tell_motion(drawn, conditions, rest, begun.settling, out, result);
    if (rest && !begun.not_held.empty()) result.warnings.push_back(begun.not_held);
    result.as_drawn = mobility_as_drawn(scene, conditions, out.candidates);
    result.multipliers = out.solved.solution.n_multipliers;
    result.solver = {static_cast<int>(out.passes.size()),
                     out.factorizations,
                     out.iterations,
                     largest_condition(out.solved, threads),
                     out.solved.solution.converged,
                     out.solved.solution.groups,
                     out.solved.solution.contact_problems};
    if (scene.in_steps || has_friction(out)) result.solver.increments = out.solved.solution.increments;
    if (is_by_dissertation(scene)) result.solver.assembled_condition = assembled_condition(out.solved);
    if (!out.solved.failure.empty() || !out.solved.solution.mechanism.empty()) {
        fill_failure(scene, out, result);
    } else {
        if (!out.solved.solution.converged) {
            result.status = "failed";
            result.message = "the contact iterations did not converge";
            if (has_friction(out))
                result.message +=
                    ": no state of sticking and slipping was found; the loads are near what friction holds, or beyond";
        }
        if (const std::string pressed = rigid_pair_failure(scene, out.candidates, out.solved); !pressed.empty()) {
            result.status = "failed";
            result.message = pressed;
        }
        fill_answers(scene, conditions, out, threads, seconds, result);
        if (const std::string impossible = impossible_in(result); result.status == "ok" && !impossible.empty()) {
            result.status = "failed";
            result.message = "what was computed is no answer: " + impossible;
        }
    }
    const double total = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    fill_effects(scene, out, total, result);
    for (const char* stage : {"import", "geometry", "assembly", "solve", "recovery"})
        result.timing.emplace_back(stage, seconds[stage]);
    result.stages = fine_stages(seconds);
    result.timing.emplace_back("output", 0);
    result.timing.emplace_back("total", total);
    predict_next_level(result);
    return {std::move(result), std::move(out), std::move(rest)};
}

/// The scene with parts whose own faces may touch each other.
Scene with_own_contacts(Scene scene, const std::set<int>& parts) {
    scene.contacts.of_one_part.insert(parts.begin(), parts.end());
    return scene;
}

Stopwatches fresh_stopwatches() {
    return {{"import", 0}, {"geometry", 0}, {"assembly", 0}, {"solve", 0}, {"recovery", 0}};
}

using Time = std::chrono::steady_clock::time_point;

Analyzed analyze_checked(const Scene& scene, const AnalyzeOptions& options, Time begin = std::chrono::steady_clock::now(),
                         Stopwatches seconds = fresh_stopwatches()) {
    Begun begun = begin_analysis(scene, seconds);
    Outcome out = solve_adaptively(begun.rest ? begun.rest->scene : scene, begun.conditions, options, seconds);
    begun.not_held = not_held(scene, out);
    follow_motion(scene, begun.conditions, begun.settling, options, seconds, out, begun.rest);
    if (const std::set<int> closed = closed_on_themselves(begun.rest ? begun.rest->scene : scene, out.solved); !closed.empty())
        return analyze_checked(with_own_contacts(scene, closed), options, begin, std::move(seconds));
    return finish_analysis(scene, std::move(begun), std::move(out), solver::usable_threads(options.threads), begin, seconds);
}

/// What one case alone is refused for names it.
template <class F>
auto with_case_named(const LoadCase& c, F work) {
    try {
        return work();
    } catch (const InputError& error) {
        std::vector<Problem> problems = error.problems();
        for (Problem& p : problems) p.what += " (load case '" + c.name + "')";
        throw InputError(std::move(problems));
    }
}

std::vector<CaseResult> analyze_cases_checked(const Scene& scene, const AnalyzeOptions& options,
                                              Time begin = std::chrono::steady_clock::now(),
                                              Stopwatches seconds = fresh_stopwatches()) {
    std::vector<Scene> scenes;
    std::vector<Begun> begun;
    std::vector<Placement> from;  // of steps: where the one before ends
    for (const LoadCase& c : scene.cases) {
        scenes.push_back(scene_of_case(scene, c));
        scenes.back().loads_of_all_cases = acting_loads(scene);
        begun.push_back(with_case_named(c, [&] { return begin_analysis(scenes.back(), seconds, from); }));
        if (scene.in_steps) from = begun.back().settling.placements;
    }
    const bool any_rests = std::any_of(begun.begin(), begun.end(), [](const Begun& b) { return b.rest.has_value(); });
    // where parts move far, grids are no longer common: of a case its own, of steps, which have no friction then, all
    const auto is_alone = [&](const Begun& b) { return b.rest || (scene.in_steps && any_rests); };
    std::vector<CaseProblem> problems;
    for (std::size_t k = 0; k < scenes.size(); ++k)
        if (!is_alone(begun[k])) problems.push_back({&scenes[k], &begun[k].conditions});
    std::vector<Outcome> common;
    if (!problems.empty()) common = solve_cases_adaptively(scene, problems, options, seconds);
    std::reverse(common.begin(), common.end());
    std::vector<Outcome> outcomes;
    for (std::size_t k = 0; k < begun.size(); ++k) {
        const Begun& b = begun[k];
        if (is_alone(b)) {
            outcomes.push_back(solve_adaptively(b.rest ? b.rest->scene : scenes[k], b.conditions, options, seconds));
        } else {
            outcomes.push_back(std::move(common.back()));
            common.pop_back();
        }
    }
    if (scene.in_steps && !any_rests)
        if (const std::optional<Rest> there = let_go(scenes.front(), begun.front().conditions, outcomes.front())) {
            // friction remembers on grids that all steps share: all of them are where the first takes the parts
            problems.clear();
            begun.front().not_held = not_held(scenes.front(), outcomes.front());
            for (std::size_t k = 0; k < scenes.size(); ++k) {
                begun[k].rest = rest_at(scenes[k], begun[k].conditions, there->placements, there->is_held);
                problems.push_back({&begun[k].rest->scene, &begun[k].conditions});
            }
            outcomes =
                solve_cases_adaptively(placed(scene, resolve_conditions(scene), there->placements), problems, options, seconds);
        }
    std::set<int> closed;
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        if (!begun[k].rest) begun[k].not_held = not_held(scenes[k], outcomes[k]);
        follow_motion(scenes[k], begun[k].conditions, begun[k].settling, options, seconds, outcomes[k], begun[k].rest);
        closed.merge(closed_on_themselves(begun[k].rest ? begun[k].rest->scene : scenes[k], outcomes[k].solved));
    }
    if (!closed.empty()) return analyze_cases_checked(with_own_contacts(scene, closed), options, begin, std::move(seconds));
    std::vector<CaseResult> results(scenes.size());
    const int threads = solver::usable_threads(options.threads),
              side_by_side = std::min(threads, static_cast<int>(results.size()));
    solver::parallel_for(static_cast<int>(results.size()), side_by_side, [&](int i) {
        const std::size_t k = at(i);
        Stopwatches own = seconds;
        results[k] = {
            scene.cases[k].name, scene.cases[k].factors,
            finish_analysis(scenes[k], std::move(begun[k]), std::move(outcomes[k]), threads / side_by_side, begin, own).result,
            scene.in_steps};
    });
    return results;
}

/// What is said of a pointer names the file, too.
template <class F>
auto with_file_named(const Scene& scene, F analysis) {
    try {
        return analysis();
    } catch (const InputError& error) {
        std::vector<Problem> problems = error.problems();
        for (Problem& p : problems)
            if (p.where.starts_with('/')) p.where = scene.file + " " + p.where;
        throw InputError(std::move(problems));
    }
}

}  // namespace

Analyzed analyze_and_keep(const Scene& scene, const AnalyzeOptions& options) {
    refuse_cases(scene);
    return with_file_named(scene, [&] { return analyze_checked(scene, options); });
}

Result analyze(const Scene& scene, const AnalyzeOptions& options) {
    return analyze_and_keep(scene, options).result;
}

std::vector<CaseResult> analyze_cases(const Scene& scene, const AnalyzeOptions& options) {
    return with_file_named(scene, [&] { return analyze_cases_checked(scene, options); });
}

}  // namespace abut
