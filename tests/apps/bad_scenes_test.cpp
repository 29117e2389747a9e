// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says about scenes that are wrong, and about one that cannot be solved.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "tests/apps/command_line.hpp"

namespace {

using namespace abut_tests;

struct BadScene {
    std::string name;
    std::string scene;
    std::vector<std::string> words;  ///< that one line must hold: where, what, what to do
};

void PrintTo(const BadScene& bad, std::ostream* stream) {
    *stream << bad.name;
}

class BadScenes : public CommandLine, public ::testing::WithParamInterface<BadScene> {};

TEST_P(BadScenes, AreRefusedWithOneLineThatSaysWhereWhatAndWhatToDo) {
    write("scene.json", GetParam().scene);
    const Outcome run = abut({"analyze", "scene.json"});
    expect_refused(run, 1);
    expect_words(joined(run.errors), {"abut: scene.json:"});
    expect_words(joined(run.errors), GetParam().words);
    EXPECT_FALSE(fs::exists(folder_ / "out/result.json"));
}

SceneText with(std::string SceneText::*member, const std::string& text) {
    SceneText scene;
    scene.*member = text;
    return scene;
}

const char* const open_square =
    R"({"loops": [[{"line": {"from": [0, 0], "to": [10, 0]}}, {"line": {"from": [10, 0], "to": [10, 10]}},
      {"line": {"from": [10, 10], "to": [0, 10]}}, {"line": {"from": [0, 10], "to": [0, 1]}}]]})";

std::vector<BadScene> bad_scenes() {
    using S = SceneText;
    return {
        {"bad_json", "{\n  \"abut\": 1,\n  \"title\" \"no colon\"\n}\n", {"scene.json:3", "':'"}},
        {"empty_file", "", {"scene.json:1"}},
        {"unknown_key", with(&S::more, ",\n  \"titel\": \"Block\"").text(), {"scene.json:9 /titel", "did you mean 'title'"}},
        {"missing_material", with(&S::used_material, "stel").text(), {"/parts/0/material", "stel", "steel"}},
        {"unknown_part",
         with(&S::supports, R"([{"on": "blok/bottom", "fix": ["x", "y"]}])").text(),
         {"/supports/0/on", "blok", "block"}},
        {"empty_selection",
         with(&S::supports, R"([{"on": "block/floor", "fix": ["x", "y"]}])").text(),
         {"/supports/0/on", "floor", "bottom"}},
        {"open_loop", with(&S::geometry, open_square).text(), {"/parts/0/geometry", "e3", "e0", "1"}},
        {"negative_radius",
         with(&S::geometry, R"({"circle": {"center": [0, 0], "radius": -5}})").text(),
         {"/parts/0/geometry/circle/radius", "greater than 0"}},
        {"poisson", with(&S::material, R"({"E": 210000, "nu": 0.7})").text(), {"/materials/steel/nu", "0.5"}},
        {"unknown_format", with(&S::more, R"(, "output": {"formats": ["pdf"]})").text(), {"/output/formats/0", "pdf", "png"}},
        {"friction_below_zero",
         with(&S::more, R"(, "contacts": {"friction": -0.2})").text(),
         {"/contacts/friction", "not negative", "rough"}},
    };
}

INSTANTIATE_TEST_SUITE_P(CommandLine, BadScenes, ::testing::ValuesIn(bad_scenes()),
                         [](const ::testing::TestParamInfo<BadScene>& test) { return test.param.name; });

TEST_F(CommandLine, AllProblemsOfASceneAreListedAtOnce) {
    SceneText scene;
    scene.used_material = "brass";
    scene.material = R"({"E": -1, "nu": 0.7})";
    write("scene.json", scene.text());
    const Outcome run = abut({"analyze", "scene.json"});
    expect_refused(run, 3);
    EXPECT_TRUE(any_line_has(run.errors, {"brass"}));
    EXPECT_TRUE(any_line_has(run.errors, {"/materials/steel/E"}));
    EXPECT_TRUE(any_line_has(run.errors, {"/materials/steel/nu"}));
}

/// A block that is pushed sideways and held upwards only.
TEST_F(CommandLine, AMechanismFailsWithStatus1AndNamesPartAndMotion) {
    SceneText scene;
    scene.supports = R"([{"on": "block/bottom", "fix": ["y"]}])";
    scene.loads = R"([{"on": "block/left", "pressure": 1}])";
    write("scene.json", scene.text());
    const Outcome run = abut({"analyze", "scene.json"});
    EXPECT_EQ(run.status, 1);
    ASSERT_EQ(run.errors.size(), 1U) << joined(run.errors);
    expect_words(run.errors[0], {"abut: scene.json: ", "block slides along (1, 0)"});
    // What is known is written all the same.
    expect_words(read(folder_ / "out/result.json"), {"\"status\": \"failed\"", "\"message\""});
    EXPECT_TRUE(fs::exists(folder_ / "out/report.html"));
}

}  // namespace
