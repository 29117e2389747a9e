// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/scene_answers.hpp"

#include <algorithm>
#include <cstdio>

#include "src/scene/read_scene.hpp"

namespace abut::test {

Result answer(const std::string& json) {
    return analyze(read_scene_text(json, "scene.json"), {});
}

std::vector<Result> answer_of_cases(const std::string& json) {
    const Scene scene = read_scene_text(json, "scene.json");
    if (scene.cases.empty()) return {analyze(scene, {})};
    std::vector<Result> results;
    for (CaseResult& c : analyze_cases(scene, {})) results.push_back(std::move(c.result));
    return results;
}

Result answer_file(const std::string& path) {
    return analyze(read_scene(std::string(ABUT_SOURCE_DIR) + "/" + path), {});
}

bool warns(const std::vector<std::string>& warnings, const std::string& words) {
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

std::string number(double v) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", v);
    return text;
}

std::string pair_text(double x, double y) {
    return "[" + number(x) + ", " + number(y) + "]";
}

}  // namespace abut::test
