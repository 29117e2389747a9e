// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that supports lead far, and what friction takes along with them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/verification/scene_answers.hpp"

namespace abut::led_with_friction_test {
namespace {

std::string block(const std::string& name, double x0, double y0, double x1, double y1) {
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": {"rectangle": {"min": )" + test::pair_text(x0, y0) +
           R"(, "max": )" + test::pair_text(x1, y1) + "}}}";
}
std::string weight(const std::string& part, double force) {
    return R"({"part": ")" + part + R"(", "force": [0, )" + test::number(-force) + "]}";
}

Result led(const std::string& parts, const std::string& supports, const std::string& loads, double friction) {
    return test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2.1e5, "nu": 0.3}}, "parts": [)" + parts +
                        R"(], "supports": [)" + supports + R"(], "loads": [)" + loads + R"(], "contacts": {"friction": )" +
                        test::number(friction) + R"(}, "accuracy": {"level": "draft"}})");
}

double along(const Result& r, std::size_t part) {
    return r.parts.at(part).placement.value_or(PartResult::Moved{}).translation.x();
}

/// A cart carries what lies on it, however far it is led, and pushes a loaded row along; all but the first lies on the floor.
TEST(LedWithFriction, ACartCarriesAndPushes) {
    for (const double way : {60.0, 200.0}) {
        SCOPED_TRACE(way);
        const Result r =
            led(block("floor", -100, -30, 400, 0) + ", " + block("cart", 0, 0, 60, 30) + ", " + block("top", 10, 30, 50, 50) +
                    ", " + block("row", 90, 0, 130, 25) + ", " + block("cap", 95, 25, 125, 40),
                R"({"on": "floor/bottom", "fix": ["x", "y"]}, {"part": "cart", "rigid": {"translation": [)" +
                    test::number(way) + ", null]}}",
                weight("cart", 40) + ", " + weight("top", 10) + ", " + weight("row", 30) + ", " + weight("cap", 8), 0.3);
        ASSERT_EQ(r.status, "ok") << r.message;
        for (const std::size_t i : {1U, 2U}) EXPECT_NEAR(along(r, i), way, 0.1);
        for (const std::size_t i : {3U, 4U}) EXPECT_NEAR(along(r, i), way - 30, 0.1);
        EXPECT_NEAR(r.reactions.at(1).force.x(), 0.3 * 88, 1e-3);
    }
}

/// A belt takes a block as far as a stop, and slides on below it.
TEST(LedWithFriction, ABeltTakesABlockToItsStop) {
    const Result r =
        led(block("belt", -200, -20, 200, 0) + ", " + block("block", -20, 0, 20, 40) + ", " + block("stop", 70, 5, 90, 40),
            R"({"on": "stop/right", "fix": ["x", "y"]},
                            {"part": "belt", "rigid": {"translation": [120, 0], "rotation": 0}})",
            weight("block", 100), 0.25);
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_NEAR(along(r, 1), 50, 0.01);
    const Vec2 belt = r.reactions.at(1).force;
    EXPECT_NEAR(belt.x(), 0.25 * belt.y(), 1e-3) << "it slides";
    EXPECT_FALSE(std::any_of(r.reasons.begin(), r.reasons.end(), [](const Reason& reason) {
        return reason.text.find("is not at its limit") != std::string::npos;
    }));
}

/// A wheel that is turned rolls along the floor by its arc, but for what is left of its way: a thousandth of its size.
TEST(LedWithFriction, AWheelThatIsTurnedRolls) {
    for (const double degrees : {30.0, 170.0}) {
        SCOPED_TRACE(degrees);
        const double arc = 25 * degrees * std::numbers::pi / 180;
        const Result r =
            led(block("floor", -200, -30, 200, 0) +
                    R"(, {"name": "wheel", "material": "m", "geometry": {"circle": {"center": [0, 25], "radius": 25}}})",
                R"({"on": "floor/bottom", "fix": ["x", "y"]}, {"part": "wheel", "rigid": {"translation": [null, null],
                                "rotation": )" +
                    test::number(-degrees) + "}}",
                weight("wheel", 100), 0.4);
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_NEAR(along(r, 1), arc, 1e-3 * 50 * std::sqrt(2) + 0.002 * arc);
        EXPECT_NEAR(r.reactions.at(0).force.x(), 0, 1e-3);
    }
}

/// What is pushed over an edge falls, and lies where it falls, held by no friction that it would have to come to.
TEST(LedWithFriction, WhatIsPushedOverAnEdgeFalls) {
    const Result r = led(block("floor", -200, -130, 0, 0) + ", " + block("ground", -200, -160, 200, -130) + ", " +
                             block("pusher", -70, 5, -50, 25) + ", " + block("box", -45, 0, -5, 30),
                         R"({"on": "floor/bottom", "fix": ["x", "y"]}, {"on": "ground/bottom", "fix": ["x", "y"]},
                            {"part": "pusher", "rigid": {"translation": [70, 0], "rotation": 0}})",
                         weight("box", 50), 0.3);
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_LT(r.parts.at(3).placement.value().translation.y(), -100);
    EXPECT_TRUE(std::any_of(r.reasons.begin(), r.reasons.end(),
                            [](const Reason& reason) { return reason.text.find("box turns by") != std::string::npos; }));
    EXPECT_FALSE(std::any_of(r.reasons.begin(), r.reasons.end(), [](const Reason& reason) {
        return reason.text.find("is not at its limit") != std::string::npos;
    }));
}

/// A sledge that may turn, and is led a thousand times farther than it is strained: where it sticks as it begins would tilt it
/// on its edge, from where it creeps back for long.
TEST(LedWithFriction, ASledgeIsNotTiltedByWhereItSticks) {
    for (const double way : {0.1, 1.0, 12.0, 25.0}) {
        SCOPED_TRACE(way);
        const Result r = led(block("table", -60, -50, 60, -20) + ", " + block("sledge", -60, -20, 60, 0) + ", " +
                                 block("load", -20, 0, 20, 40) + ", " + block("lid", -15, 40, 15, 60),
                             R"({"on": "table/bottom", "fix": ["x", "y"]}, {"part": "sledge", "rigid": {"translation": [)" +
                                 test::number(way) + ", null]}}",
                             weight("sledge", 5) + ", " + weight("load", 100) + ", " + weight("lid", 20), 0.3);
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_NEAR(r.reactions.at(1).force.x(), 0.3 * 125, 1e-3);
        EXPECT_NEAR(r.reactions.at(0).force.y(), 125, 1e-6);
    }
}

/// So do the steps of a scene, which all are where the first takes the parts.
TEST(LedWithFriction, StepsBeginWhereTheFirstOneLeads) {
    const std::vector<Result> steps = test::answer_of_cases(
        R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2.1e5, "nu": 0.3}}, "parts": [)" +
        block("floor", -100, -30, 200, 0) + ", " + block("cart", 0, 0, 60, 30) + ", " + block("top", 10, 30, 50, 50) +
        R"(], "supports": [{"on": "floor/bottom", "fix": ["x", "y"]},
            {"part": "cart", "rigid": {"translation": [60, null], "rotation": 0}}],
        "loads": [{"part": "cart", "force": [0, -40], "name": "weight"}, {"part": "top", "force": [0, -10], "name": "weight"},
            {"part": "top", "force": [2, 0], "name": "side"}],
        "steps": [{"name": "led", "loads": {"weight": 1}}, {"name": "pushed", "loads": {"weight": 1, "side": 1}}],
        "contacts": {"friction": 0.3}, "accuracy": {"level": "draft"}})");
    ASSERT_EQ(steps.size(), 2U);
    for (const Result& step : steps) {
        ASSERT_EQ(step.status, "ok") << step.message;
        for (const std::size_t i : {1U, 2U}) EXPECT_NEAR(along(step, i), 60, 0.1);
        EXPECT_FALSE(std::any_of(step.reasons.begin(), step.reasons.end(), [](const Reason& reason) {
            return reason.text.find("is not at its limit") != std::string::npos;
        }));
    }
    EXPECT_NEAR(steps[0].reactions.at(1).force.x(), 0.3 * 50, 1e-3);
}

}  // namespace
}  // namespace abut::led_with_friction_test
