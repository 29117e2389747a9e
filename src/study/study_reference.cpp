// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/study_reference.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "src/scene/read_materials.hpp"
#include "src/scene/scene_fields.hpp"
#include "src/verification/verify.hpp"

namespace abut {

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Text alone does not say which files an import means.
bool is_same_scene(const std::string& path, const Scene& scene, const fs::path& other) {
    std::error_code error;
    if (fs::equivalent(path, other, error)) return true;
    return scene.imports.empty() && fs::is_regular_file(other, error) && text_of(path) == text_of(other);
}

std::map<std::string, double> parameters_of(const std::string& path) {
    JsonDocument document = read_json(path);
    SceneReading reading{document.file, std::move(document.root), {}, {}, {}};
    if (const JsonValue* parameters = find_member(reading.root, "parameters")) read_parameters(reading, *parameters);
    return reading.parameters;
}

bool has_values(const std::map<std::string, double>& parameters, const std::map<std::string, double>& wanted) {
    for (const auto& [name, value] : wanted) {
        const auto found = parameters.find(name);
        if (found == parameters.end() || found->second != value) return false;
    }
    return true;
}

bool is_solved_by(const VerifyProblem& problem, const Scene& scene) {
    if (problem.runs.size() != 1 || problem.expects_failure || problem.quantities.empty()) return false;
    const VerifyRun& run = problem.runs.front();
    return !run.penalty && run.analysis.value_or(scene.analysis) == scene.analysis;
}

}  // namespace

const VerifyProblem* known_problem(const std::string& scene_path, const Scene& scene, const std::string& data_folder) {
    if (data_folder.empty()) return nullptr;
    const std::map<std::string, double> parameters = parameters_of(scene_path);
    for (const VerifyProblem& problem : verify_problems())
        if (is_solved_by(problem, scene) && has_values(parameters, problem.runs.front().parameters) &&
            is_same_scene(scene_path, scene, fs::path(data_folder) / problem.runs.front().scene))
            return &problem;
    return nullptr;
}

}  // namespace abut
