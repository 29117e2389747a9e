// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/drawn_touches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/verification/scene_answers.hpp"

namespace abut::drawn_touches_test {
namespace {

/// A bar on the tips of two wedges; degrees: half the angle of a tip.
Result on_wedges(double degrees) {
    const double half = 15 * std::tan(degrees * std::numbers::pi / 180);
    const auto wedge = [&](const char* name, double x) {
        return std::string(R"(, {"name": ")") + name + R"(", "material": "m", "geometry": {"polygon": [)" +
               test::pair_text(x, 0) + ", " + test::pair_text(x - half, -15) + ", " + test::pair_text(x + half, -15) + "]}}";
    };
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "bar", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [100, 10]}}})" +
                        wedge("left", 10) + wedge("right", 90) + R"(],
        "supports": [{"on": ["left/e1", "right/e1"], "fix": ["x", "y"]},
                     {"part": "bar", "rigid": {"translation": [0, null]}}],
        "loads": [{"on": "bar/top", "force": [0, -500]}], "accuracy": {"level": "draft"}})");
}

}  // namespace

TEST(DrawnTouches, ABarOnBladesFailsByTheirNames) {
    const Result sharp = on_wedges(20);
    EXPECT_EQ(sharp.status, "failed");
    EXPECT_NE(sharp.message.find("bar slides along (0, -1)"), std::string::npos) << sharp.message;
    EXPECT_NE(sharp.message.find("round those of bar and left at (10, 0); bar and right at (90, 0)"), std::string::npos)
        << sharp.message;
    const Result blunt = on_wedges(40);
    ASSERT_EQ(blunt.status, "ok") << blunt.message;
    double pressed = 0;  // both faces of a tip have a share
    for (const ContactResult& c : blunt.contacts) pressed += std::abs(c.force.y());
    EXPECT_NEAR(pressed, 500, 1e-6);
}

/// A bar on two blocks and a blade between them.
TEST(DrawnTouches, ABarThatBendsIntoABladeIsNoAnswer) {
    const auto block = [](const char* name, const char* polygon) {
        return std::string(R"(, {"name": ")") + name + R"(", "material": "m", "geometry": {"polygon": )" + polygon + "}}";
    };
    const auto answer = [&](const char* load) {
        return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "bar", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [200, 10]}}})" +
                            block("left", "[[0, 0], [0, -20], [20, -20], [20, 0]]") +
                            block("blade", "[[100, 0], [90, -20], [110, -20]]") +
                            block("right", "[[180, 0], [180, -20], [200, -20], [200, 0]]") + R"(],
            "supports": [{"on": ["left/e1", "right/e1", "blade/e1"], "fix": ["x", "y"]},
                         {"part": "bar", "rigid": {"translation": [0, null]}}],
            "loads": [{"on": "bar/top", "force": )" +
                            load + R"(}], "accuracy": {"level": "draft"}})");
    };
    const auto says = [](const Result& r) {
        return std::any_of(r.reasons.begin(), r.reasons.end(), [](const auto& reason) {
            return reason.text.find("bar and blade go into each other by ") != std::string::npos;
        });
    };
    EXPECT_TRUE(says(answer("[0, -500]")));
    EXPECT_FALSE(says(answer("[0, 0]")));
}

}  // namespace abut::drawn_touches_test
