// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that are pressed and lie anywhere between walls that they do not touch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/verification/scene_answers.hpp"

namespace abut::loose_motions_test {
namespace {

std::string turned(double x, double y, double degrees) {
    const double c = std::cos(degrees * 3.141592653589793 / 180), s = std::sin(degrees * 3.141592653589793 / 180);
    return test::pair_text(c * x - s * y, s * x + c * y);
}

std::string box(double x0, double y0, double x1, double y1, double degrees) {
    return R"({"polygon": [)" + turned(x0, y0, degrees) + ", " + turned(x1, y0, degrees) + ", " + turned(x1, y1, degrees) +
           ", " + turned(x0, y1, degrees) + "]}";
}

/// A soft block on a floor between two walls 0.03 away, pressed down; the left wall is led towards it. All turned.
Result block_between_walls(double degrees, double led, double push = 0) {
    const auto part = [](const std::string& name, const std::string& material, const std::string& shape) {
        return R"({"name": ")" + name + R"(", "material": ")" + material + R"(", "geometry": )" + shape + "}";
    };
    const auto hold = [&](const std::string& name, double x) {
        return R"({"part": ")" + name + R"(", "rigid": {"translation": )" + turned(x, 0, degrees) + R"(, "rotation": 0}})";
    };
    return test::answer(
        R"({"abut": 1, "materials": {"hard": {"E": 2e5, "nu": 0.3}, "soft": {"E": 20000, "nu": 0.3}}, "parts": [)" +
        part("floor", "hard", box(-20, -5, 20, 0, degrees)) + ", " + part("left", "hard", box(-14, 1, -10.03, 9, degrees)) +
        ", " + part("right", "hard", box(10.03, 1, 14, 9, degrees)) + ", " +
        part("block", "soft", box(-10, 0, 10, 8, degrees)) + R"(], "supports": [)" + hold("floor", 0) + ", " +
        hold("left", led) + ", " + hold("right", 0) + R"(], "loads": [{"part": "block", "force": )" +
        turned(push, -20, degrees) + R"(}],
                        "output": {"probes": [{"part": "block", "at": )" +
        turned(0, 4, degrees) + "}]}}");
}

double along(const Result& r, double degrees) {
    const double a = degrees * 3.141592653589793 / 180;
    return std::cos(a) * r.probes.at(0).displacement.x() + std::sin(a) * r.probes.at(0).displacement.y();
}

bool is_told(const Result& r) {
    return std::any_of(r.warnings.begin(), r.warnings.end(), [](const std::string& w) {
        return w.find("nothing holds a motion that no load drives") != std::string::npos &&
               w.find("block") != std::string::npos;
    });
}

TEST(LooseMotions, ABlockBetweenWallsStaysInTheMiddleAndSaysSo) {
    for (const double degrees : {0.0, 17.0, 73.0}) {
        const Result r = block_between_walls(degrees, 0);
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_NEAR(along(r, degrees), 0, 1e-6) << degrees;
        EXPECT_TRUE(is_told(r)) << degrees;
    }
}

TEST(LooseMotions, AWallThatComesNearerMovesItNoFartherThanItHasTo) {
    for (const double degrees : {0.0, 17.0}) {
        const Result r = block_between_walls(degrees, 0.05);
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_NEAR(along(r, degrees), 0.02, 1e-3) << degrees;
    }
}

TEST(LooseMotions, WhatALoadPushesAgainstAWallIsHeld) {
    const Result r = block_between_walls(0, 0, 5);
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_NEAR(along(r, 0), 0.03, 1e-3);
    EXPECT_FALSE(is_told(r));
}

}  // namespace
}  // namespace abut::loose_motions_test
