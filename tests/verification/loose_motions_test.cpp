// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that are pressed and lie anywhere between walls that they do not touch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

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

bool is_told(const Result& r, const std::string& part = "block") {
    return std::any_of(r.warnings.begin(), r.warnings.end(), [&](const std::string& w) {
        return w.find("nothing holds a motion that no load drives") != std::string::npos && w.find(part) != std::string::npos;
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

/// A slider in a channel, a roller in its groove, and a plunger on that which a post beside it holds: what the walls bear is
/// rounding, and holds nothing.
TEST(LooseMotions, WallsThatBearNothingButRoundingHoldNothing) {
    constexpr double top = 16.881449618829485;  // of the roller, which lies on both sides of the groove
    std::vector<double> moved;
    for (const double degrees : {0.0, 17.0}) {
        const auto polygon = [&](const std::string& name, const std::string& material, const std::vector<Vec2>& corners) {
            std::string text = R"({"name": ")" + name + R"(", "material": ")" + material + R"(", "geometry": {"polygon": [)";
            for (std::size_t k = 0; k < corners.size(); ++k)
                text += (k > 0 ? ", " : "") + turned(corners[k].x(), corners[k].y(), degrees);
            return text + "]}}";
        };
        const Result r = test::answer(
            R"({"abut": 1, "thickness": 10, "materials": {"steel": {"E": 210000, "nu": 0.3}, "pom": {"E": 2800, "nu": 0.37}},
            "parts": [)" +
            polygon("base", "steel",
                    {{-30, -10}, {30, -10}, {30, 16}, {12.04, 16}, {12.04, 0}, {-12.04, 0}, {-12.04, 16}, {-30, 16}}) +
            ", " + polygon("slider", "pom", {{-12, 0}, {12, 0}, {12, 12}, {5, 12}, {0, 7.5}, {-5, 12}, {-12, 12}}) +
            R"(, {"name": "roller", "material": "steel", "geometry": {"circle": {"center": )" + turned(0, top - 4, degrees) +
            R"(, "radius": 4}}}, )" + polygon("plunger", "steel", {{-6, top}, {6, top}, {6, top + 14}, {-6, top + 14}}) + ", " +
            polygon("post", "steel", {{6.03, top + 2}, {14, top + 2}, {14, top + 12}, {6.03, top + 12}}) +
            R"(], "supports": [{"on": "base/e0", "fix": ["x", "y"]},
                {"part": "post", "rigid": {"translation": [0, 0], "rotation": 0}}, {"part": "plunger", "rigid": {"rotation": 0}}],
            "loads": [{"part": "plunger", "force": )" +
            turned(30, -1500, degrees) + "}]}");
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_TRUE(is_told(r, "slider")) << degrees;
        moved.push_back(r.parts.at(1).max_displacement.value);
    }
    EXPECT_NEAR(moved[0], moved[1], 0.005 * moved[0]);
}

/// A block in a pocket that closes its gaps only when it is warm, with friction: it sticks where it was until then, in the
/// middle, wherever its grid begins.
TEST(LooseMotions, WhatGrowsUntilItTouchesSticksWhereItWasUntilThen) {
    constexpr double growth = 2.3e-5 * 30 * 10, gap = 0.95 * growth;  // at each end
    for (const double degrees : {0.0, 17.0, 73.0}) {
        const auto at = [&](double x, double y) { return turned(x, y, degrees); };
        const Result r = test::answer(
            R"({"abut": 1, "thickness": 10, "materials": {"steel": {"E": 210000, "nu": 0.3},
                "alu": {"E": 70000, "nu": 0.33, "expansion": 2.3e-5}}, "parts": [
                {"name": "box", "material": "steel", "geometry": {"difference": [)" +
            box(-40, -30, 40, 30, degrees) + ", " + box(-10 - gap, -5.02, 10 + gap, 5.02, degrees) +
            R"(]}}, {"name": "block", "material": "alu", "geometry": )" + box(-10, -5, 10, 5, degrees) +
            R"(}], "supports": [{"on": "box/0/*", "fix": ["x", "y"]}], "loads": [{"part": "block", "temperature": 30}],
                "contacts": {"friction": 0.3}, "output": {"probes": [{"part": "block", "at": )" +
            at(0, 0) + R"(}, {"part": "block", "at": )" + at(9, 4.5) + "}]}}");
        ASSERT_EQ(r.status, "ok") << r.message;
        const double a = degrees * 3.141592653589793 / 180;
        const Vec2 middle = r.probes.at(0).displacement, corner = r.probes.at(1).displacement;
        EXPECT_LT(middle.norm(), 0.01 * growth) << degrees;
        EXPECT_NEAR(-std::sin(a) * corner.x() + std::cos(a) * corner.y(), 0.45 * growth, 0.01 * growth) << degrees;
    }
}

/// Two blocks side by side on a slope, pressed straight against it: what rounding of their coordinates leaves along it drives
/// nothing.
TEST(LooseMotions, RoundingOfASlopeDrivesNothing) {
    for (const double degrees : {7.0, 30.0, 47.0, 61.0})
        for (const double digits : {1e7, 1e8, 1e9}) {
            const auto at = [&](double x, double y) {
                const double a = degrees * 3.141592653589793 / 180, c = std::cos(a), s = std::sin(a);
                return test::pair_text(std::round((c * x - s * y) * digits) / digits,
                                       std::round((s * x + c * y) * digits) / digits);
            };
            const auto block = [&](const char* name, double x0, double y0, double x1, double y1) {
                return R"({"name": ")" + std::string(name) + R"(", "material": "m", "geometry": {"polygon": [)" + at(x0, y0) +
                       ", " + at(x1, y0) + ", " + at(x1, y1) + ", " + at(x0, y1) + "]}}";
            };
            const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [)" +
                                          block("A", 0, 0, 100, 20) + ", " + block("B", 10.3, 20, 54.7, 45) + ", " +
                                          block("C", 54.7, 20, 76.1, 45) +
                                          R"(], "supports": [{"on": "A/e0", "fix": ["x", "y"]}],
                "loads": [{"on": ["B/e2", "C/e2"], "pressure": 5}]})");
            ASSERT_EQ(r.status, "ok") << degrees << " " << digits << r.message;
            EXPECT_NEAR(r.contacts.at(0).force.norm(), 5 * 44.4, 1e-4) << degrees << " " << digits;
            EXPECT_TRUE(is_told(r, "B") || is_told(r, "C")) << degrees << " " << digits;
        }
}

/// A pin in a bore, off its middle, that grows until it fills it: what touches first gives way, and nothing slips until all
/// round it is pressed.
TEST(LooseMotions, WhatTouchesFirstGivesWayWithoutFriction) {
    const auto pin = [](double beside, const char* more) {
        return test::answer_of_cases(
            R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 210000, "nu": 0.3, "expansion": 1.2e-5}},
            "parts": [{"name": "hub", "material": "m", "geometry": {"difference": [
                {"rectangle": {"min": [-30, -30], "max": [30, 30]}, "name": "o"}, {"circle": {"center": [0, 0], "radius": 10.01}}]}},
                {"name": "pin", "material": "m", "geometry": {"circle": {"center": )" +
            test::pair_text(beside, 0) + R"(, "radius": 10}}}],
            "supports": [{"on": "hub/o/*", "fix": ["x", "y"]}], "contacts": {"friction": 0.3},
            "loads": [{"part": "pin", "temperature": 200, "name": "heat"}])" +
            more + "}");
    };
    const double middle = pin(0, "").front().contacts.at(0).max_pressure.value;
    EXPECT_GT(middle, 100);
    for (const char* more :
         {"", R"(, "steps": [{"name": "a", "loads": {"heat": 0.3}}, {"name": "b", "loads": {"heat": 1}}])"}) {
        const std::vector<Result> all = pin(0.004, more);
        for (const Result& r : all) ASSERT_EQ(r.status, "ok") << r.message;
        if (all.size() > 1) { EXPECT_EQ(all[0].contacts.at(0).max_pressure.value, 0); }
        EXPECT_NEAR(all.back().contacts.at(0).max_pressure.value, middle, 0.02 * middle) << more;
    }
}

/// With three decimals the slope is inclined to the load by more than rounding: the block slides, and it is said by how little.
TEST(LooseMotions, AFewDigitsMayDriveAPartAndThatIsSaid) {
    const auto at = [](double x, double y) {
        const double a = 17 * 3.141592653589793 / 180, c = std::cos(a), s = std::sin(a);
        return test::pair_text(std::round((c * x - s * y) * 1e3) / 1e3, std::round((s * x + c * y) * 1e3) / 1e3);
    };
    const auto block = [&](const char* name, double x0, double y0, double x1, double y1) {
        return R"({"name": ")" + std::string(name) + R"(", "material": "m", "geometry": {"polygon": [)" + at(x0, y0) + ", " +
               at(x1, y0) + ", " + at(x1, y1) + ", " + at(x0, y1) + "]}}";
    };
    const auto pressed = [&](const char* more) {
        return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [)" +
                            block("A", 0, 0, 100, 20) + ", " + block("B", 17.3, 20, 61.7, 50) +
                            R"(], "supports": [{"on": "A/e0", "fix": ["x", "y"]}], "loads": [{"on": "B/e2", "pressure": 5}])" +
                            more + "}");
    };
    const Result slides = pressed("");
    EXPECT_NE(slides.status, "ok");
    EXPECT_NE(slides.message.find("of the largest load"), std::string::npos) << slides.message;
    EXPECT_EQ(pressed(R"(, "contacts": {"friction": 0.1})").status, "ok");
}

}  // namespace
}  // namespace abut::loose_motions_test
