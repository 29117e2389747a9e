// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that friction does not hold: they slide, roll, tip and carry others to where it does.
#include "src/motion/friction_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/scene_answers.hpp"

namespace abut::friction_steps_test {
namespace {

/// A block whose centre of gravity lies beside the one that it stands on tips, and leans on that in the end, which friction
/// keeps where it is.
TEST(StepsWithFriction, WhatTipsLeavesWhatFrictionHolds) {
    const Result r = test::answer(R"({"abut": 1, "thickness": 100, "materials": {"m": {"E": 2.1e5, "nu": 0.3}}, "parts": [
        {"name": "floor", "material": "m", "geometry": {"rectangle": {"min": [-300, -50], "max": [400, 0]}}},
        {"name": "low", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [100, 60]}}},
        {"name": "up", "material": "m", "geometry": {"rectangle": {"min": [-125, 60], "max": [73, 120]}}}],
        "supports": [{"on": "floor/bottom", "fix": ["x", "y"]}],
        "loads": [{"part": "low", "force": [0, -46]}, {"part": "up", "force": [0, -92]}],
        "contacts": {"friction": 0.6}})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_LT(r.parts.at(1).placement.value_or(PartResult::Moved{}).translation.norm(), 1e-3);
    EXPECT_GT(r.parts.at(2).placement.value().rotation, 0.3);
}

constexpr const char* channel = R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2.1e5, "nu": 0.3}}, "parts": [
    {"name": "channel", "material": "m", "geometry": {"place": {"of": {"polygon":
        [[0, -30], [300, -30], [300, 0], [30, 0], [30, 60], [0, 60]]}, "rotate": ANGLE}}}, PARTS],
    "supports": [{"on": "channel/e0", "fix": ["x", "y"]}], "loads": [LOADS], "contacts": {"friction": FRICTION},
    "accuracy": {"level": "draft"}})";

/// Parts on the floor of a channel, which a wall ends 30 along it, all turned.
Result in_channel(double degrees, const std::string& parts, const std::string& loads, double friction) {
    std::string text = channel;
    const auto put = [&](const std::string& what, const std::string& value) {
        text.replace(text.find(what), what.size(), value);
    };
    put("PARTS", parts);
    put("LOADS", loads);
    put("ANGLE", test::number(degrees));
    put("FRICTION", test::number(friction));
    return test::answer(text);
}

/// A disc rolls down a slope that it would not slide down, however many times it turns on its way.
TEST(StepsWithFriction, ADiscRollsToTheWall) {
    const Result r = in_channel(
        10, R"({"name": "disc", "material": "m", "geometry": {"place": {"of": {"circle": {"center": [150, 15], "radius": 15}},
            "rotate": 10}}})",
        R"({"part": "disc", "force": [0, -5]})", 0.5);
    ASSERT_EQ(r.status, "ok") << r.message;
    const PartResult::Moved& moved = r.parts.at(1).placement.value();
    EXPECT_NEAR(moved.translation.norm(), 105, 0.1);
    EXPECT_NEAR(moved.rotation, 105.0 / 15, 0.1);
    EXPECT_TRUE(r.accuracy.reached) << r.accuracy.why;
}

std::string block(const std::string& name, double x0, double y0, double x1, double y1) {
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": {"rectangle": {"min": )" + test::pair_text(x0, y0) +
           R"(, "max": )" + test::pair_text(x1, y1) + "}}}";
}

/// What lies on a block that is pushed along goes with it, held by friction, and not on to the wall, however hard the block is
/// pushed.
TEST(StepsWithFriction, WhatLiesOnABlockIsCarriedAlong) {
    for (const double push : {6.0, 60.0}) {
        const Result r = in_channel(
            0, block("low", 150, 0, 200, 20) + ", " + block("up", 160, 20, 190, 30),
            R"({"part": "low", "force": [)" + test::number(-push) + R"(, -10]}, {"part": "up", "force": [0, -2]})", 0.3);
        ASSERT_EQ(r.status, "ok") << r.message;
        for (const std::size_t i : {1U, 2U}) EXPECT_NEAR(r.parts.at(i).placement.value().translation.x(), -120, 1e-3);
        EXPECT_NEAR(r.parts[2].placement->translation.y(), 0, 1e-3);
    }
}

/// A wedge pushed against a block stops there, wherever it is drawn: to lift the block takes more than twice as much.
TEST(StepsWithFriction, AWedgeStopsWhereFrictionHoldsIt) {
    for (const double away : {5.0, 20.0}) {
        const double rise = std::tan(10 * std::numbers::pi / 180);
        const std::string wedge = R"({"name": "wedge", "material": "m", "geometry": {"polygon": [)" + test::pair_text(away, 0) +
                                  ", " + test::pair_text(away + 60, 0) + ", " + test::pair_text(away + 60, 60 * rise) + "]}}",
                          above = R"({"name": "block", "material": "m", "geometry": {"polygon": [[-40, 0], [0, 0], )" +
                                  test::pair_text(20, 20 * rise) + ", [20, 40], [-40, 40]]}}";
        const Result r = test::answer(
            R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2.1e5, "nu": 0.3}}, "parts": [{"name": "floor",
            "material": "m", "geometry": {"polygon": [[-60, -30], [150, -30], [150, 0], [-40, 0], [-40, 80], [-60, 80]]}}, )" +
            above + ", " + wedge + R"(], "supports": [{"on": "floor/e0", "fix": ["x", "y"]}], "loads": [
            {"part": "wedge", "force": [-2, -0.2]}, {"part": "block", "force": [0, -10]}], "contacts": {"friction": 0.3},
            "accuracy": {"level": "draft"}})");
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_NEAR(r.parts.at(2).placement.value().translation.x(), -away, 0.1);
        EXPECT_LT(std::abs(r.parts.at(1).placement.value_or(PartResult::Moved{}).rotation), 1e-4);
    }
}

}  // namespace
}  // namespace abut::friction_steps_test
