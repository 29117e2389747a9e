// SPDX-License-Identifier: GPL-3.0-or-later
// The key "level" of parts.
#include "src/scene/part_levels.hpp"

#include <gtest/gtest.h>

#include "src/scene/read_scene.hpp"
#include "tests/geometry/dxf/dxf_text.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::part_levels_test {
namespace {

const std::string head = R"({"abut": 1, "units": {"length": "mm", "force": "N"}, "parameters": {"top": 3}, )";

std::string block(const std::string& name, double x, const std::string& more) {
    return R"({"name": ")" + name + R"(", "material": "steel", )" + more + R"("geometry": {"rectangle": {"min": [)" +
           std::to_string(x) + ", 0], \"max\": [" + std::to_string(x + 2) + ", 1]}}}";
}

/// Two blocks that overlap, the second with this key.
std::string blocks(const std::string& level, const std::string& more = "") {
    return head + R"("parts": [)" + block("a", 0, R"("level": 1, )") + ", " +
           block("b", 1, level.empty() ? "" : "\"level\": " + level + ", ") + "]" + more + "}";
}

std::string problem_of(const std::string& scene) {
    try {
        read_scene_text(scene, "s.json");
    } catch (const InputError& error) {
        EXPECT_EQ(error.problems().size(), 1u) << error.what();
        return one_line(error.problems()[0]);
    }
    return "";
}

}  // namespace

TEST(PartLevels, OneLevelOrAListOfThem) {
    for (const auto& [text, levels] : {std::pair<std::string, Levels>{"", {}},
                                       {"2", {2}},
                                       {"[2]", {2}},
                                       {"[4, 1]", {1, 4}},
                                       {"\"top\"", {3}},
                                       {"[\"top+1\", 1]", {1, 4}},
                                       {"[2, 1.0]", {1, 2}}})
        EXPECT_EQ(read_scene_text(blocks(text), "s.json").parts[1].level, levels) << text;
}

TEST(PartLevels, WrongOnesAreOneProblemEach) {
    for (const auto& [text, problem] : std::vector<std::pair<std::string, std::string>>{
             {"0", "s.json:1 /parts/1/level: expected a whole number from 1 to 2147483647"},
             {"1.5", "s.json:1 /parts/1/level: expected a whole number from 1 to 2147483647"},
             {"-2", "s.json:1 /parts/1/level: expected a whole number from 1 to 2147483647"},
             {"1e30", "s.json:1 /parts/1/level: expected a whole number from 1 to 2147483647"},
             {"true", "s.json:1 /parts/1/level: expected a number"},
             {"{}", "s.json:1 /parts/1/level: expected a number"},
             {"\"upper\"", "s.json:1 /parts/1/level: "},
             {"[]", "s.json:1 /parts/1/level: this list of levels is empty; give at least 1"},
             {"[1, 0]", "s.json:1 /parts/1/level/1: expected a whole number from 1 to 2147483647"},
             {"[2, 1, 2]", "s.json:1 /parts/1/level/2: level 2 is listed twice; take it away once"},
             {"[[1]]", "s.json:1 /parts/1/level/0: expected a number"},
         })
        EXPECT_EQ(problem_of(blocks(text)).substr(0, problem.size()), problem) << text;
}

TEST(PartLevels, PartsAroundAnAxisHaveNone) {
    const std::string problem = problem_of(blocks("", R"(, "analysis": "axisymmetric")"));
    EXPECT_EQ(problem,
              "s.json:1 /parts/0/level: parts around an axis have no levels; their sections cannot lie above each other");
}

TEST(PartLevels, RulesForPartsThatCannotMeetAreAProblem) {
    const std::string rule = R"(, "contacts": {"pairs": [{"between": ["a/*", "b/*"], "kind": ")";
    EXPECT_EQ(problem_of(blocks("2", rule + R"(bonded"}]})")),
              "s.json:1 /contacts/pairs/0: these edges belong to parts that have no level in common: they cannot meet; give "
              "the parts a "
              "common \"level\", or take the rule away");
    EXPECT_EQ(problem_of(blocks("2", rule + R"(ignore"}]})")), "");
    EXPECT_EQ(problem_of(blocks("[1, 2]", rule + R"(bonded"}]})")), "");
    EXPECT_EQ(problem_of(blocks("2", R"(, "contacts": {"pairs": [{"between": ["*/left", "*/right"], "kind": "bonded"}]})")),
              "");
}

TEST(PartLevels, DrawingsGetThemByLayerAndByPart) {
    const TemporaryFolder folder;
    folder.write("d.dxf", geometry::dxf_file(geometry::dxf_rectangle("A", "PLATE", 0, 0, 4, 2) +
                                             geometry::dxf_rectangle("B", "PLATE", 6, 0, 9, 2) +
                                             geometry::dxf_rectangle("C", "LINK", 1, 1, 8, 3)));
    const Scene scene =
        read_scene(folder.write("s.json", head + R"("assembly": {"file": "d.dxf", "parts_by": "layer", "material": "steel",
        "parts": {"PLATE": {"level": 1}, "PLATE#1": {"level": [2, 1]}, "LINK": {"name": "link", "level": "top"}}}})"));
    ASSERT_EQ(scene.parts.size(), 3u);
    EXPECT_EQ(levels_text(scene), "PLATE#0 1; PLATE#1 1, 2; link 3");
}

TEST(PartLevels, WithoutAnyAPartMeetsAll) {
    EXPECT_TRUE(have_common_level({}, {}));
    EXPECT_TRUE(have_common_level({}, {7}));
    EXPECT_TRUE(have_common_level({1, 3}, {2, 3}));
    EXPECT_FALSE(have_common_level({1, 3}, {2, 4}));
    EXPECT_EQ(levels_text(Levels{}), "all");
}

}  // namespace abut::part_levels_test
