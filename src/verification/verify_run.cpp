// SPDX-License-Identifier: GPL-3.0-or-later
// Solves verification problems and compares their quantities with the references.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "src/analysis/analysis.hpp"
#include "src/io/nearest_name.hpp"
#include "src/scene/dissertation_method.hpp"
#include "src/scene/read_scene.hpp"
#include "src/verification/verify.hpp"

namespace abut {

namespace {

std::vector<VerifyProblem> all_problems() {
    std::vector<VerifyProblem> all;
    for (const auto& group :
         {patch_problems(), beam_problems(), plate_problems(), ring_problems(), membrane_problems(), corner_problems(),
          half_plane_problems(), spline_beam_problems(), hertz_problems(), block_problems(), pin_problems(), support_problems(),
          preload_problems(), spin_problems(), thermal_problems(), friction_problems(), load_path_problems(), motion_problems(),
          axisymmetric_problems()})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

std::string group_of(const VerifyProblem& problem) {
    return problem.name.substr(0, problem.name.find('-'));
}

bool is_called(const VerifyProblem& problem, const std::string& name) {
    return problem.name == name || group_of(problem) == name;
}

std::vector<std::string> known_names() {
    std::vector<std::string> names;
    for (const VerifyProblem& problem : verify_problems())
        for (const std::string& name : {group_of(problem), problem.name})
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    return names;
}

Problem unknown_name(const std::string& name) {
    return {"", "there is no verification problem '" + shortened(name) + "'",
            "did you mean '" + nearest_name(name, known_names()) + "'? abut verify --list shows all"};
}

/// Why the answers cannot be compared; empty where they can.
std::string failure_of(const VerifyProblem& problem, const Answers& answers) {
    for (const Result& answer : answers) {
        if (answer.status != "ok" && !problem.expects_failure) return "the analysis failed: " + answer.message;
        if (answer.status == "ok" && problem.expects_failure) return "the analysis should have failed and did not";
    }
    return "";
}

}  // namespace

const std::vector<VerifyProblem>& verify_problems() {
    static const std::vector<VerifyProblem> problems = all_problems();
    return problems;
}

std::vector<VerifyProblem> chosen_problems(const std::vector<std::string>& names) {
    if (names.empty()) return verify_problems();
    std::vector<Problem> unknown;
    std::vector<bool> is_chosen(verify_problems().size());
    for (const std::string& name : names) {
        bool known = false;
        for (std::size_t k = 0; k < is_chosen.size(); ++k) {
            const bool called = is_called(verify_problems()[k], name);
            is_chosen[k] = is_chosen[k] || called;
            known = known || called;
        }
        if (!known) unknown.push_back(unknown_name(name));
    }
    if (!unknown.empty()) throw InputError(std::move(unknown));
    std::vector<VerifyProblem> chosen;
    for (std::size_t k = 0; k < is_chosen.size(); ++k)
        if (is_chosen[k]) chosen.push_back(verify_problems()[k]);
    return chosen;
}

Scene scene_of_run(const VerifyRun& run, const std::string& data_folder) {
    Scene scene = read_scene(data_folder + "/" + run.scene, run.parameters);
    if (run.analysis) scene.analysis = *run.analysis;
    if (run.penalty) scene.contacts.penalty = run.penalty;
    if (run.by_dissertation) take_dissertation_method(scene);
    return scene;
}

Result answer_of(const VerifyRun& run, const std::string& data_folder) {
    return analyze(scene_of_run(run, data_folder), {});
}

Answers answers_of(const VerifyRun& run, const std::string& data_folder) {
    const Scene scene = scene_of_run(run, data_folder);
    if (scene.cases.empty()) return {analyze(scene, {})};
    Answers answers;
    for (CaseResult& c : analyze_cases(scene, {})) answers.push_back(std::move(c.result));
    return answers;
}

VerifyRow compared(const Quantity& quantity, double value) {
    VerifyRow row;
    row.quantity = quantity.what;
    row.value = value;
    row.reference = quantity.reference;
    row.tolerance = quantity.tolerance;
    const double scale = quantity.scale > 0 ? quantity.scale : std::abs(quantity.reference);
    row.relative_error = std::abs(value - quantity.reference) / scale;
    row.pass = quantity.tolerance ? row.relative_error <= *quantity.tolerance : std::isfinite(value);
    return row;
}

std::vector<VerifyRow> verify(const VerifyProblem& problem, const std::string& data_folder) {
    const auto begin = std::chrono::steady_clock::now();
    Answers answers;
    for (const VerifyRun& run : problem.runs) {
        Answers own = answers_of(run, data_folder);
        std::move(own.begin(), own.end(), std::back_inserter(answers));
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const std::string failure = failure_of(problem, answers);
    std::vector<VerifyRow> rows;
    for (const Quantity& quantity : problem.quantities) {
        const double value = failure.empty() ? quantity.value(answers) : std::numeric_limits<double>::quiet_NaN();
        VerifyRow row = compared(quantity, value);
        row.name = problem.name;
        row.seconds = seconds;
        row.failure = failure;
        for (const Result& answer : answers) row.unknowns = std::max(row.unknowns, answer.unknowns + answer.multipliers);
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace abut
