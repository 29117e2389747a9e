// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/verification/expectations.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "src/analysis/analysis.hpp"
#include "src/io/folder_walk.hpp"
#include "src/io/json_document.hpp"
#include "src/io/nearest_name.hpp"
#include "src/scene/load_cases.hpp"
#include "src/scene/read_scene.hpp"

namespace abut {

namespace {

namespace fs = std::filesystem;
using ResultJson = nlohmann::json;

/// The steps of "contacts[0].max_pressure.value", or of the JSON pointer "/contacts/0/max_pressure/value".
std::vector<std::string> steps_of(const std::string& path) {
    const bool is_pointer = path.starts_with('/');
    std::vector<std::string> steps(1);
    for (std::size_t k = is_pointer ? 1 : 0; k < path.size(); ++k) {
        const char c = path[k];
        if (c == ']') continue;
        if (c == '/' || (!is_pointer && (c == '.' || c == '[')))
            steps.emplace_back();
        else
            steps.back() += c;
    }
    return steps;
}

/// The member of an object or the item of a list; nullptr with the reason where there is none.
const ResultJson* step_into(const ResultJson& value, const std::string& step, std::string& failure) {
    if (value.is_object()) {
        const auto found = value.find(step);
        if (found != value.end()) return &*found;
        std::vector<std::string> known;
        for (const auto& item : value.items()) known.push_back(item.key());
        failure = "there is no '" + shortened(step) + "'; " + nearest_name_hint(step, known);
        return nullptr;
    }
    const bool is_index = !step.empty() && step.size() < 9 && step.find_first_not_of("0123456789") == std::string::npos;
    if (value.is_array() && is_index && std::stoul(step) < value.size()) return &value[std::stoul(step)];
    failure = value.is_array() ? "there is no item '" + shortened(step) + "' in a list of " + std::to_string(value.size()) +
                                     ", counted from 0"
                               : "nothing is inside a single value: '" + shortened(step) + "'";
    return nullptr;
}

double number_at(const ResultJson& result, const std::string& path, std::string& failure) {
    const ResultJson* value = &result;
    for (const std::string& step : steps_of(path))
        if (value) value = step_into(*value, step, failure);
    if (value && value->is_number()) return value->get<double>();
    if (value) failure = "this is no number";
    failure = "result.json, " + path + ": " + failure;
    return std::numeric_limits<double>::quiet_NaN();
}

VerifyRow row_of(const Expectation& expected, const Result& result, const ResultJson& json) {
    std::string failure = result.status == "ok" ? "" : "the analysis failed: " + result.message;
    const double value =
        failure.empty() ? number_at(json, expected.quantity, failure) : std::numeric_limits<double>::quiet_NaN();
    std::string what = expected.source.empty() ? expected.quantity : expected.quantity + " (" + expected.source + ")";
    std::replace_if(
        what.begin(), what.end(), [](unsigned char c) { return c < ' '; }, ' ');  // a row is a line
    VerifyRow row = compared({what, {}, expected.value, expected.tolerance, expected.value == 0 ? 1.0 : 0.0}, value);
    row.unknowns = result.unknowns + result.multipliers;
    row.failure = failure;
    return row;
}

/// What cannot be read may have some: verify_scene says what is wrong with it.
bool has_expectations(const fs::path& file) {
    try {
        return find_member(read_json(file.string()).root, "expect") != nullptr;
    } catch (const InputError&) { return true; }
}

VerifyRow row_of_unreadable(const std::string& file, const InputError& error) {
    VerifyRow row;
    row.name = file;
    row.quantity = "expect";
    row.value = row.reference = row.relative_error = std::numeric_limits<double>::quiet_NaN();
    const std::size_t n = error.problems().size();
    row.failure = one_line(error.problems().front()) + (n > 1 ? " (and " + std::to_string(n - 1) + " more)" : "");
    return row;
}

}  // namespace

std::vector<VerifyRow> compared_with_expectations(const Scene& scene, const Result& result) {
    std::vector<VerifyRow> rows;
    if (scene.expect.empty()) return rows;
    const ResultJson json = ResultJson::parse(result_json(result));
    for (const Expectation& expected : scene.expect) rows.push_back(row_of(expected, result, json));
    for (VerifyRow& row : rows) row.name = scene.file;
    return rows;
}

std::vector<VerifyRow> compared_with_cases(const Scene& scene, const std::vector<CaseResult>& cases) {
    std::vector<VerifyRow> rows;
    for (std::size_t k = 0; k < cases.size(); ++k)
        for (VerifyRow& row : compared_with_expectations(scene_of_case(scene, scene.cases[k]), cases[k].result)) {
            row.quantity = cases[k].name + ": " + row.quantity;
            rows.push_back(std::move(row));
        }
    return rows;
}

std::vector<VerifyRow> verify_scene(const std::string& file) {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<VerifyRow> rows;
    try {
        const Scene scene = read_scene(file);
        if (scene.cases.empty())
            rows = compared_with_expectations(scene, analyze(scene, {}));
        else
            rows = compared_with_cases(scene, analyze_cases(scene, {}));
    } catch (const InputError& error) { rows = {row_of_unreadable(file, error)}; }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    for (VerifyRow& row : rows) row.seconds = seconds;
    return rows;
}

std::vector<std::string> scenes_with_expectations(const std::string& path) {
    std::vector<std::string> scenes;
    if (!fs::is_directory(path)) {
        if (has_expectations(path)) scenes.push_back(path);
    } else {
        for (const fs::path& file : files_below(path, [](const fs::path&) { return false; }).files)
            if (file.extension() == ".json" && has_expectations(file)) scenes.push_back(file.string());
    }
    if (scenes.empty())
        throw InputError(path, "no scene here has 'expect'", "abut help expect says how to state known answers");
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

}  // namespace abut
