// SPDX-License-Identifier: GPL-3.0-or-later
// Rules for portions of edges cut zones where the portions begin and end.
#include "src/contact/pair_rules.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "src/contact/candidates.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::pair_rules_test {
namespace {

Scene scene_with(const std::string& parts, const std::string& rules) {
    return read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0}}, "parts": [)" + parts +
                               R"(], "contacts": {"pairs": [)" + rules + "]}}",
                           "s.json");
}

const std::string two_blocks = R"(
    {"name": "a", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [10, 2]}}},
    {"name": "b", "material": "m", "geometry": {"rectangle": {"min": [0, 2], "max": [10, 4]}}})";

struct Stretch {
    double begin, length;
    int rule;
};

std::vector<Stretch> stretches_of(const Scene& scene) {
    std::vector<Stretch> stretches;
    for (const Candidate& c : find_candidates(scene, 1))
        stretches.push_back({c.zone.begin1, c.zone.end1 - c.zone.begin1, c.rule});
    return stretches;
}

}  // namespace

TEST(PairRules, PortionsOfEitherPartCutTheZone) {
    for (const char* rule : {R"({"between": [{"part": "a", "box": [[2, 1], [5, 3]]}, "b/bottom"], "friction": 0.3})",
                             R"({"between": ["a/top", {"part": "b", "box": [[2, 1], [5, 3]]}], "friction": 0.3})",
                             R"({"between": [{"part": "b", "box": [[2, 1], [8, 3]]}, {"part": "a", "box": [[-1, 1], [5, 3]]}],
                                "friction": 0.3})"}) {
        const auto found = stretches_of(scene_with(two_blocks, rule));  // along a/top, from x = 10
        ASSERT_EQ(found.size(), 3u) << rule;
        EXPECT_EQ(std::vector({found[0].rule, found[1].rule, found[2].rule}), (std::vector{-1, 0, -1})) << rule;
        EXPECT_NEAR(found[0].length, 5, 1e-9) << rule;
        EXPECT_NEAR(found[1].length, 3, 1e-9) << rule;
        EXPECT_NEAR(found[2].length, 2, 1e-9) << rule;
    }
}

TEST(PairRules, LaterRulesAreExceptionsWhereTheyAreFor) {
    const Scene scene = scene_with(two_blocks, R"({"between": ["a/top", "b/bottom"], "friction": 0.3},
        {"between": ["a/top", {"part": "b", "box": [[-1, 1], [4, 3]]}], "kind": "ignore"})");
    const auto found = stretches_of(scene);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].rule, 0);
    EXPECT_NEAR(found[0].length, 6, 1e-9);
    EXPECT_EQ(PairRules(scene).later_than(0), 1);
}

/// Where a closed zone begins is no end of a stretch.
TEST(PairRules, APortionOfACircleLeavesTheRestInOnePiece) {
    for (const char* way : {"[0, -1]", "[1, 0]", "[-0.3, 1]"}) {
        const Scene scene = scene_with(R"(
            {"name": "hole", "material": "m", "geometry": {"difference": [{"rectangle": {"min": [-9, -9], "max": [9, 9]}},
                {"circle": {"center": [0, 0], "radius": 5}}]}},
            {"name": "pin", "material": "m", "geometry": {"circle": {"center": [0, 0], "radius": 5}}})",
                                       R"({"between": ["hole/*", {"part": "pin", "facing": )" + std::string(way) +
                                           R"(, "within": 45}], "kind": "bonded"})");
        const auto found = stretches_of(scene);
        ASSERT_EQ(found.size(), 2u) << way;
        const auto& [bonded, rest] = found[0].rule == 0 ? std::tie(found[0], found[1]) : std::tie(found[1], found[0]);
        EXPECT_EQ(bonded.rule, 0);
        EXPECT_EQ(rest.rule, -1);
        EXPECT_NEAR(bonded.length, 2.5 * std::numbers::pi, 1e-6) << way;
        EXPECT_NEAR(rest.length, 7.5 * std::numbers::pi, 1e-6) << way;
    }
}

/// Two feet reach into their base: a rule that ignores the deeper one says nothing of the other.
TEST(PairRules, OverlapsAreIgnoredWhereTheRuleIsFor) {
    const std::string parts = R"({"name": "base", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [40, 5]}}},
        {"name": "stool", "material": "m", "geometry": {"polygon":
            [[2, 4.5], [8, 4.5], [8, 8], [30, 8], [30, 4.8], [36, 4.8], [36, 12], [2, 12]]}})";
    const auto refused = [&](const std::string& box) {
        try {
            find_candidates(
                scene_with(parts, R"({"between": [{"part": "base", "box": )" + box + R"(}, "stool/*"], "kind": "ignore"})"), 1);
        } catch (const InputError& error) { return error.problems().front().what; }
        return std::string();
    };
    EXPECT_NE(refused("[[0, 4], [15, 6]]").find("0.2"), std::string::npos) << refused("[[0, 4], [15, 6]]");
    EXPECT_NE(refused("[[20, 4], [40, 6]]").find("0.5"), std::string::npos) << refused("[[20, 4], [40, 6]]");
    EXPECT_EQ(refused("[[0, 4], [40, 6]]"), "");
}

}  // namespace abut::pair_rules_test
