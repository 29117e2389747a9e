// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that no load reaches are named: in the plan, the result, the table, the report.
#include "src/plan/left_out_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "src/analysis/analysis.hpp"
#include "src/report/report.hpp"
#include "tests/src/analysis/plate_scene.hpp"

namespace abut::left_out_parts_test {
namespace {

const std::string two_far =
    far_block + R"(, {"name": "peg", "material": "m", "geometry": {"rectangle": {"min": [200, 0], "max": [201, 1]}}})";

Effect plan_of(const Variation& v) {
    const Scene scene = scene_of(v);
    return left_out_effect(scene, resolve_conditions(scene));
}

TEST(LeftOutParts, ThePlanNamesThem) {
    using Names = std::vector<std::string>;
    EXPECT_FALSE(plan_of({}).on);
    EXPECT_FALSE(plan_of({.more_parts = next_block, .more_supports = hold_block}).on);  // touches the plate
    EXPECT_EQ(plan_of({.more_parts = two_far}).parts, (Names{"block", "peg"}));
    EXPECT_TRUE(plan_of({.more_parts = two_far}).on);
    EXPECT_EQ(plan_of({.more_parts = two_far, .more_loads = R"(, {"part": "peg", "force": [1, 0]})"}).parts, Names{"block"});
    EXPECT_FALSE(plan_of({.more_parts = two_far, .more_loads = R"(, {"gravity": [0, -1]})"}).on);
}

TEST(LeftOutParts, ThePlanSaysWhereItCannotKnow) {
    const Effect e = plan_of(
        {.more_parts = R"({"name": "block", "material": "m", "geometry": {"rectangle": {"min": [3.5, 0], "max": [5, 1]}}})"});
    EXPECT_FALSE(e.on);
    EXPECT_NE(e.why.find("not known"), std::string::npos) << e.why;
}

TEST(LeftOutParts, TheAnswerNamesThem) {
    Scene scene = scene_of({.more_parts = two_far});
    scene.accuracy.level = "draft";
    const Result result = analyze(scene, {});
    const std::string text =
        "parts block, peg are not analysed: they carry no load, and no face of them touches a part that does";
    EXPECT_EQ(std::count(result.warnings.begin(), result.warnings.end(), text), 1);
    EXPECT_NE(result_table(result).find("warning: " + text), std::string::npos);
    const auto parts = nlohmann::json::parse(result_json(result))["parts"];
    ASSERT_EQ(parts.size(), 3U);
    for (const auto& part : parts) EXPECT_EQ(part["solved"].get<bool>(), part["name"] == "plate");
    const std::string report = report_html(result);
    EXPECT_NE(report.find(text), std::string::npos);
    EXPECT_NE(report.find("not analysed: no load reaches it"), std::string::npos);
}

TEST(LeftOutParts, ASceneWithoutThemHasNoWordOfThem) {
    Scene scene = scene_of({});
    scene.accuracy.level = "draft";
    for (const std::string& warning : analyze(scene, {}).warnings) EXPECT_EQ(warning.find("not analysed"), std::string::npos);
    EXPECT_EQ(left_out_text({}), "");
    EXPECT_EQ(left_out_text({"a"}), "part a is not analysed: it carries no load, and no face of it touches a part that does");
}

}  // namespace
}  // namespace abut::left_out_parts_test
