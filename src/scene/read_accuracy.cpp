// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_accuracy.hpp"

#include "src/io/number_text.hpp"
#include "src/scene/accuracy_goal.hpp"
#include "src/scene/scene_words.hpp"

namespace abut {

namespace {

std::optional<Refinement> read_refinement(SceneReading& reading, const JsonValue& value) {
    if (!check_object(reading, value, {"near", "radius", "cell_size"})) return std::nullopt;
    const auto near = required_member(reading, value, "near", read_vector, dimension::length);
    const auto radius = required_member(reading, value, "radius", read_positive, dimension::length);
    const auto cell_size = required_member(reading, value, "cell_size", read_positive, dimension::length);
    if (!near || !radius || !cell_size) return std::nullopt;
    return Refinement{*near, *radius, *cell_size};
}

std::vector<Refinement> read_refinements(SceneReading& reading, const JsonValue& value) {
    std::vector<Refinement> refinements;
    if (!check_list(reading, value, 0, "refinements")) return refinements;
    for (const JsonValue& item : value.items) {
        if (const auto refinement = read_refinement(reading, item)) refinements.push_back(*refinement);
    }
    return refinements;
}

std::optional<double> read_target(SceneReading& reading, const JsonValue& value) {
    const std::optional<double> target = read_number(reading, value, dimension::none);
    if (!target || is_target(*target)) return target;
    report_problem(reading, value,
                   "a relative error to aim at is from " + number_text(least_target, 1) + " to " + number_text(most_target, 1),
                   "0.01 is one percent");
    return std::nullopt;
}

Budget read_budget(SceneReading& reading, const JsonValue& value) {
    const std::optional<std::string> text = read_text(reading, value);
    if (!text) return {};
    try {
        return parse_budget(*text);
    } catch (const InputError& error) {
        for (const Problem& problem : error.problems()) report_problem(reading, value, problem.what, problem.hint);
        return {};
    }
}

std::string word_or(SceneReading& reading, const JsonValue& object, const char* key, const std::string& otherwise,
                    const Words& words) {
    const JsonValue* value = find_member(object, key);
    return value ? read_word(reading, *value, words).value_or(otherwise) : otherwise;
}

/// Keys that the dissertation's method decides or has no use for, and weights without a structure to weigh.
void refuse_beside_method(SceneReading& reading, const JsonValue& accuracy, const Accuracy& read) {
    const JsonValue* weights = find_member(accuracy, "weights");
    if (read.method != "dissertation") {
        if (weights && read.dirichlet != "solution_structure")
            report_problem(reading, *weights, "'weights' belong to the solution structure",
                           "give \"dirichlet\": \"solution_structure\", or leave them out");
        return;
    }
    for (const char* key : {"level", "target", "refine", "basis", "dirichlet", "adapt", "budget"})
        if (const JsonValue* member = find_member(accuracy, key))
            report_problem(
                reading, *member, "'" + std::string(key) + "' does not go with the dissertation's method",
                "it has one basis, one way to hold edges and uniform grids: give 'cell_size' or 'grids', and leave '" +
                    std::string(key) + "' out");
}

}  // namespace

Accuracy read_accuracy(SceneReading& reading, const JsonValue& accuracy) {
    Accuracy result;
    const Words keys{"level",     "target",  "degree", "cell_size", "refine", "method", "basis",
                     "dirichlet", "weights", "grids",  "adapt",     "solver", "budget"};
    if (!check_object(reading, accuracy, keys)) return result;
    result.level = word_or(reading, accuracy, "level", result.level, accuracy_levels());
    if (find_member(accuracy, "level") && find_member(accuracy, "target"))
        report_problem(reading, *find_member(accuracy, "target"), "'target' stands for a level of its own",
                       "take 'level' away");
    if (const JsonValue* target = find_member(accuracy, "target")) result.target = read_target(reading, *target);
    if (const JsonValue* degree = find_member(accuracy, "degree")) {
        result.degree = read_integer(reading, *degree, least_degree, most_degree).value_or(result.degree);
    }
    if (const JsonValue* size = find_member(accuracy, "cell_size"))
        result.cell_size = read_positive(reading, *size, dimension::length);
    if (const JsonValue* refine = find_member(accuracy, "refine")) result.refine = read_refinements(reading, *refine);
    result.basis = word_or(reading, accuracy, "basis", result.basis, {"auto", "plain", "normalized", "web"});
    result.dirichlet =
        word_or(reading, accuracy, "dirichlet", result.dirichlet, {"auto", "aligned", "nitsche", "solution_structure"});
    result.method = word_or(reading, accuracy, "method", result.method, {"auto", "dissertation"});
    result.weights = word_or(reading, accuracy, "weights", result.weights, {"auto", "joined", "r_function", "blended"});
    refuse_beside_method(reading, accuracy, result);
    result.by_cholmod = word_or(reading, accuracy, "solver", "auto", {"auto", "cholmod"}) == "cholmod";
    if (const JsonValue* grids = find_member(accuracy, "grids")) {
        result.grids = read_grids(reading, *grids);
        for (const auto& [part, grid] : result.grids)
            if (result.method == "dissertation" && !grid.refine.empty())
                report_problem(reading, *grids,
                               "'refine' of the grid of " + part + " does not go with the dissertation's method",
                               "it has tensor grids: give 'x' and 'y', or 'cells', alone");
    }
    if (const JsonValue* budget = find_member(accuracy, "budget")) result.budget = read_budget(reading, *budget);
    if (const JsonValue* adapt = find_member(accuracy, "adapt")) result.adapt = read_flag(reading, *adapt);
    return result;
}

}  // namespace abut
