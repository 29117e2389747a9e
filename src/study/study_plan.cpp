// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/study_plan.hpp"

#include <algorithm>
#include <cmath>

#include "src/plan/dissertation_limits.hpp"
#include "src/scene/dissertation_method.hpp"

namespace abut {

namespace {

constexpr double reference_refinement = 0.7;  ///< of the smallest size

/// Time over unknowns, where it is not known: a little steeper than the factorisations measured (1.1 to 1.2).
constexpr double assumed_exponent = 1.25;

using Kind = StudySetting::Kind;

bool is_family_mate(const StudySetting& a, const StudySetting& b) {
    return a.kind == b.kind && a.degree == b.degree && a.basis == b.basis && a.threads == b.threads;
}

/// There is nothing that a level could change.
bool gives_grids(const Accuracy& accuracy) {
    return accuracy.method == "dissertation" ||
           ((accuracy.cell_size || !accuracy.grids.empty()) && !accuracy.adapt.value_or(false));
}

StudySetting level_setting(const Accuracy& accuracy, const char* level) {
    if (accuracy.method == "dissertation") return {Kind::level, level, accuracy.degree, basis_of_dissertation, 1};
    return {Kind::level, level, accuracy.degree, accuracy.basis == "auto" ? "web" : accuracy.basis, 1};
}

}  // namespace

std::vector<StudySetting> level_settings(const Scene& scene) {
    std::vector<StudySetting> settings;
    const std::vector<const char*> levels =
        gives_grids(scene.accuracy) ? std::vector{level_as_given} : std::vector{"standard", "draft", "fine"};
    for (const char* level : levels) settings.push_back(level_setting(scene.accuracy, level));
    return settings;
}

std::vector<StudySetting> threaded_settings(const Scene& scene, int threads) {
    if (threads < 2) return {};
    std::vector<StudySetting> settings = level_settings(scene);
    for (StudySetting& setting : settings) setting.threads = threads;
    return settings;
}

std::vector<StudySetting> grid_settings(const Scene& scene, const StudyOptions& options) {
    std::vector<StudySetting> settings;
    Scene by_dissertation = scene;
    take_dissertation_method(by_dissertation);
    std::vector<Problem> against;
    append_dissertation_problems(by_dissertation, against);
    for (double size : options.sizes) {
        if (against.empty()) settings.push_back({Kind::graded, "", 2, basis_of_dissertation, size});
        if (is_by_dissertation(scene)) continue;
        for (const char* basis : {"web", "normalized"})
            for (int degree : options.degrees) settings.push_back({Kind::graded, "", degree, basis, size});
        settings.push_back({Kind::uniform, "", 2, "web", size});
    }
    return settings;
}

StudySetting reference_setting(const Scene& scene, const StudyOptions& options) {
    if (!gives_grids(scene.accuracy)) return level_setting(scene.accuracy, level_reference);
    if (is_by_dissertation(scene))
        return {Kind::graded, "", 2, basis_of_dissertation, reference_refinement * options.sizes.back()};
    return {Kind::graded, "", 2, "web", reference_refinement * options.sizes.back()};
}

std::optional<double> predicted_seconds(const std::vector<StudyRun>& runs, const StudySetting& setting) {
    std::optional<double> seconds;
    double size = 0;
    for (const StudyRun& run : runs) {
        if (!is_family_mate(run.setting, setting) || run.status != StudyRun::Status::ok) continue;
        if (run.setting.size <= setting.size || (seconds && run.setting.size >= size)) continue;
        size = run.setting.size;
        seconds = run.seconds * std::pow(size / setting.size, 2 * assumed_exponent);
    }
    return seconds;
}

double equal_cell_size(const Scene& scene, const std::vector<StudyGrid>& grids) {
    double area = 0, cells = 0;
    for (const ScenePart& p : scene.parts) {
        const auto grid = std::find_if(grids.begin(), grids.end(), [&](const StudyGrid& g) { return g.part == p.name; });
        if (grid == grids.end()) continue;
        const auto size = bounding_box(p.part).size();
        area += size.x() * size.y();
        cells += grid->n_cells;
    }
    return std::sqrt(area / cells);
}

}  // namespace abut
