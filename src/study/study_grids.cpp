// SPDX-License-Identifier: GPL-3.0-or-later
// The scene at a setting: levels, grids of other cell sizes, equal cells.
#include <algorithm>
#include <cmath>

#include "src/scene/accuracy_goal.hpp"
#include "src/scene/dissertation_method.hpp"
#include "src/study/study_measure.hpp"

namespace abut {

namespace {

/// Everything that the scene itself says of its grids is taken away.
void forget_grids(Accuracy& accuracy) {
    accuracy.target.reset();
    accuracy.cell_size.reset();
    accuracy.refine.clear();
    accuracy.grids.clear();
    accuracy.adapt.reset();
}

GridOptions resized(const StudyGrid& grid, double size) {
    GridOptions options;
    options.x = resized_lines(grid.x, size);
    options.y = resized_lines(grid.y, size);
    options.angle = grid.angle;
    for (const PartResult::Halved& h : grid.halved) options.refine.push_back({h.low, h.high, h.levels});
    options.where = "/accuracy/grids/" + grid.part;
    return options;
}

}  // namespace

std::vector<double> resized_lines(const std::vector<double>& lines, double size) {
    const auto n = static_cast<double>(lines.size() - 1);
    const int cells = std::max(1, static_cast<int>(std::lround(n / size)));
    std::vector<double> resized{lines.front()};
    for (int k = 1; k < cells; ++k) {
        const double place = n * k / cells;  // among the old lines, counted from 0
        const auto i = static_cast<std::size_t>(place);
        const double t = place - static_cast<double>(i);
        resized.push_back(t == 0 ? lines[i] : (1 - t) * lines[i] + t * lines[i + 1]);
    }
    resized.push_back(lines.back());
    return resized;
}

Scene scene_at(Scene scene, const StudyTask& task) {
    const StudySetting& setting = task.setting;
    Accuracy& accuracy = scene.accuracy;
    if (setting.kind == StudySetting::Kind::level) {
        if (setting.level == level_as_given) return scene;
        accuracy.target.reset();
        accuracy.level = setting.level;
        if (setting.level == level_reference) {
            accuracy.level = "fine";
            accuracy.target = target_of(accuracy) / 5;
        }
        return scene;
    }
    forget_grids(accuracy);
    accuracy.degree = setting.degree;
    if (setting.basis == basis_of_dissertation)
        take_dissertation_method(scene);
    else
        accuracy.basis = setting.basis;
    if (setting.kind == StudySetting::Kind::uniform) {
        accuracy.cell_size = setting.size * task.equal_size;
        return scene;
    }
    for (const StudyGrid& grid : *task.grids) {
        GridOptions& options = accuracy.grids.emplace(grid.part, resized(grid, setting.size)).first->second;
        if (setting.basis == basis_of_dissertation) options.refine.clear();  // it has tensor grids only
    }
    return scene;
}

}  // namespace abut
