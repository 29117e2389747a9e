// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion/placement.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "src/scene/read_scene.hpp"

namespace abut::placement_test {
namespace {

constexpr double pi = std::numbers::pi;

void expect_near(const Vec2& a, const Vec2& b, double tolerance = 1e-12) {
    EXPECT_NEAR((a - b).norm(), 0, tolerance) << a.transpose() << " and " << b.transpose();
}

TEST(Placement, TurnsThenMoves) {
    const Placement p{pi / 2, {1, 2}};
    expect_near(p.of({3, 0}), {1, 5});
    expect_near(p.turned({3, 0}), {0, 3});
}

TEST(Placement, TurnsByRightAnglesExactly) {
    const double quarter = pi / 2;
    const Vec2 x(3, 0.1);
    EXPECT_EQ((Placement{quarter, {0, 0}}.turned(x)), Vec2(-0.1, 3));
    EXPECT_EQ((Placement{-quarter, {0, 0}}.turned(x)), Vec2(0.1, -3));
    EXPECT_EQ((Placement{6 * quarter, {0, 0}}.turned(x)), Vec2(-3, -0.1));
    EXPECT_NE((Placement{quarter * (1 + 1e-12), {0, 0}}.turned(x)), Vec2(-0.1, 3));
}

TEST(Placement, AScrewKeepsWhatItTurnsAbout) {
    // a point 2 to the right of the pole goes up
    const Placement p = along_screw({2, 0}, {0, 2 * 0.7}, 0.7);
    expect_near(p.of({0, 0}), {0, 0});
    expect_near(p.of({2, 0}), {2 * std::cos(0.7), 2 * std::sin(0.7)});
    expect_near(along_screw({5, -3}, {1, 2}, 0).of({7, 7}), {8, 9});
    expect_near(along_screw({5, -3}, {1, 2}, 1e-9).of({7, 7}), {8, 9}, 2e-8);
}

TEST(Placement, OneAfterTheOther) {
    const Placement first = about_center({1, 1}, {2, -1}, 0.4), then = about_center({-3, 2}, {0, 5}, -1.3);
    const Placement both = followed_by(first, then);
    for (const Vec2& x : {Vec2(0, 0), Vec2(4, -2)}) expect_near(both.of(x), then.of(first.of(x)));
    EXPECT_NEAR(both.angle, -0.9, 1e-15);
}

TEST(Placement, LosesDigitsThatAreRounding) {
    const Placement p = without_rounding(about_center({1, 2}, {1e-9, -8}, 1e-12), {1, 2}, 10);
    EXPECT_EQ(p.angle, 0);
    expect_near(p.of({1, 2}) - Vec2(1, 2), {0, -8}, 0);
}

const std::string scene_text = R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}},
    "parts": [{"name": "base", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [10, 4]}}},
              {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [0, 5], "max": [2, 7]}}}],
    "supports": [{"on": "base/bottom", "fix": ["x", "y"]}, {"part": "block", "at": [[1, 6]], "fix": ["x"]}],
    "loads": [{"on": "block/top", "force": [0, -1], "at": [2, 7]}],
    "accuracy": {"grids": {"block": {"cells": [4, 4], "angle": 10}}},
    "output": {"probes": [{"part": "block", "at": [2, 7]}, {"part": "base", "at": [2, 3]}]}})";

TEST(Placement, TakesAlongWhatBelongsToThePart) {
    const Scene drawn = read_scene_text(scene_text, "s.json");
    const Placement p = about_center({1, 6}, {0.5, -1}, pi / 2);
    const Scene there = placed(drawn, resolve_conditions(drawn), {{}, p});
    expect_near(there.output.probes.at(0).at, p.of({2, 7}));
    expect_near(there.output.probes.at(1).at, {2, 3}, 0);
    expect_near(there.supports.at(1).at.at(0), {1.5, 5});
    expect_near(*there.loads.at(0).at, p.of({2, 7}));
    EXPECT_NEAR(there.accuracy.grids.at("block").angle, 100 * pi / 180, 1e-12);
    expect_near(centroid(there.parts.at(1).part), {1.5, 5});
    EXPECT_EQ(centroid(there.parts.at(0).part), centroid(drawn.parts.at(0).part));
    EXPECT_EQ(there.parts.at(1).part.edges.at(0).name, drawn.parts.at(1).part.edges.at(0).name);
}

TEST(Placement, IsForEveryPartOfTheSceneThatConditionsAreOf) {
    const Scene drawn = read_scene_text(scene_text, "s.json");
    EXPECT_THROW(placed(drawn, resolve_conditions(drawn), {{}}), std::logic_error);
    EXPECT_THROW(placed(drawn, {}, {{}, {}}), std::logic_error);
}

TEST(Placement, SaysWhyPartsAreNotFollowed) {
    Scene scene = read_scene_text(scene_text, "s.json");
    const ResolvedConditions conditions = resolve_conditions(scene);
    EXPECT_EQ(why_not_followed(scene, conditions), "");
    scene.follows_motion = false;
    EXPECT_NE(why_not_followed(scene, conditions).find("off"), std::string::npos);
    scene.follows_motion = true;
    scene.loads.at(0).value[1] = parse_expression_with_unit("-x", {}, true).value;
    EXPECT_NE(why_not_followed(scene, conditions).find("expressions"), std::string::npos);
}

}  // namespace
}  // namespace abut::placement_test
