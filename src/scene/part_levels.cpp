// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/part_levels.hpp"

#include <algorithm>
#include <limits>

namespace abut {

bool have_common_level(const Levels& a, const Levels& b) {
    return a.empty() || b.empty() ||
           std::any_of(a.begin(), a.end(), [&](int level) { return std::binary_search(b.begin(), b.end(), level); });
}

std::optional<Levels> read_levels(SceneReading& reading, const JsonValue& value) {
    const std::size_t before = reading.problems.size();
    Levels levels;
    const auto read_one = [&](const JsonValue& item) {
        const std::optional<int> level = read_integer(reading, item, 1, std::numeric_limits<int>::max());
        if (!level) return;
        if (std::find(levels.begin(), levels.end(), *level) != levels.end())
            report_problem(reading, item, "level " + std::to_string(*level) + " is listed twice", "take it away once");
        levels.push_back(*level);
    };
    if (value.kind != JsonValue::Kind::array)
        read_one(value);
    else if (check_list(reading, value, 1, "levels"))
        for (const JsonValue& item : value.items) read_one(item);
    if (reading.problems.size() > before) return std::nullopt;
    std::sort(levels.begin(), levels.end());
    return levels;
}

std::string levels_text(const Levels& levels) {
    std::string text;
    for (const int level : levels) text += (text.empty() ? "" : ", ") + std::to_string(level);
    return text.empty() ? "all" : text;
}

std::string levels_text(const Scene& scene) {
    std::string text;
    for (const ScenePart& part : scene.parts)
        if (!part.level.empty()) text += (text.empty() ? "" : "; ") + part.name + " " + levels_text(part.level);
    return text;
}

}  // namespace abut
