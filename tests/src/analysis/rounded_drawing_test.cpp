// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that a drawing's rounding inclines to the loads by a little.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/verification/scene_answers.hpp"

namespace abut::rounded_drawing_test {
namespace {

/// A plate on three fixed rollers, its underside drawn from -rise to rise over its length of 90; 100 N straight down, and
/// `sideways` along.
Result on_rollers(double rise, double sideways) {
    std::string parts = R"({"name": "plate", "material": "m", "geometry": {"polygon": [[-45, )" + test::number(-rise) +
                        "], [45, " + test::number(rise) + "], [45, 20], [-45, 20]]}}";
    std::string supports;
    for (int k = 0; k < 3; ++k) {
        const std::string name = "r" + std::to_string(k);
        parts += R"(, {"name": ")" + name + R"(", "material": "m", "geometry": {"circle": {"center": [)" +
                 std::to_string(25 * (k - 1)) + R"(, -10], "radius": 10}}})";
        supports += (k == 0 ? "" : ", ") + (R"({"part": ")" + name + R"(", "rigid": {"translation": [0, 0], "rotation": 0}})");
    }
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [)" + parts +
                        R"(], "supports": [)" + supports +
                        R"(], "contacts": {"overlap": "press_fit"}, "accuracy": {"level": "draft"},
                        "loads": [{"on": "plate/e2", "force": [)" +
                        test::number(sideways) + ", -100]}]}");
}

TEST(RoundedDrawing, ALittleTiltOfAFaceIsNoPush) {
    for (double rise : {0.0, 1e-6, -1e-5}) {
        const Result r = on_rollers(rise, 0);
        EXPECT_EQ(r.status, "ok") << rise << ": " << r.message;
    }
}

TEST(RoundedDrawing, APushIsOneHoweverSmall) {
    const Result r = on_rollers(0, 1e-3);
    EXPECT_EQ(r.status, "failed");
    EXPECT_NE(r.message.find("plate slides along"), std::string::npos) << r.message;
}

/// A disc of radius 10 that 1000 N press into a V of two flanks at right angles, drawn `deep` into both.
Result in_a_v(double deep, const std::string& contacts) {
    return test::answer(
        R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "v", "material": "m", "geometry": {"polygon": [[-30, -20], [30, -20], [30, 30], [0, 0], [-30, 30]]}},
        {"name": "d", "material": "m", "geometry": {"circle": {"center": [0, )" +
        test::number((10 - deep) * std::sqrt(2.0)) +
        R"(], "radius": 10}}}], "supports": [{"on": "v/e0", "fix": ["x", "y"]}], "accuracy": {"level": "draft"},
        "contacts": )" +
        contacts + R"(, "loads": [{"part": "d", "force": [0, -1000]}]})");
}

bool tells_overlap(const Result& r) {
    return std::any_of(r.warnings.begin(), r.warnings.end(), [](const std::string& w) {
        return w.find("no more than a drawing is precise to") != std::string::npos && w.find("v and d") != std::string::npos;
    });
}

/// Coordinates of four decimals make such overlaps. Hertz: the pressure is that of faces that touch.
TEST(RoundedDrawing, AnOverlapWithinThePrecisionOfDrawingsIsTouching) {
    const Result exact = in_a_v(0, "{}");
    ASSERT_EQ(exact.status, "ok") << exact.message;
    const double force = 1000 / std::sqrt(2.0), elastic = 210000 / (2 * (1 - 0.3 * 0.3));
    // the disc and the flanks are finite: Hertz to the draft's accuracy
    EXPECT_NEAR(exact.contacts.at(0).max_pressure.value, std::sqrt(force * elastic / (std::numbers::pi * 10)),
                0.1 * exact.contacts.at(0).max_pressure.value);
    for (double deep : {5e-5, 3e-4}) {
        SCOPED_TRACE(deep);
        const Result r = in_a_v(deep, "{}");
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_TRUE(tells_overlap(r));
        for (std::size_t k = 0; k < 2; ++k) {
            const double given = exact.contacts.at(k).max_pressure.value;
            EXPECT_NEAR(r.contacts.at(k).max_pressure.value, given, 0.001 * given);
            EXPECT_NEAR(r.contacts.at(k).force.norm(), force, 1e-6 * force);
        }
    }
    EXPECT_FALSE(tells_overlap(exact));
    EXPECT_THROW(in_a_v(2e-3, "{}"), InputError);
}

/// Three discs of radius 5 side by side in the corner of a tray, pressed into it by 100 N along the row and 20 N each
/// down, the whole turned by an angle and moved, all coordinates with three decimals.
Result in_a_turned_tray(double degrees, double radius) {
    const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
    const auto at = [&](double x, double y) {
        const auto rounded = [](double v) { return test::number(std::round(1e3 * v) / 1e3); };
        return "[" + rounded(c * x - s * y + 3.217) + ", " + rounded(s * x + c * y + 1.431) + "]";
    };
    const auto along = [&](double x, double y) {
        return "[" + test::number(c * x - s * y) + ", " + test::number(s * x + c * y) + "]";
    };
    std::string parts = R"({"name": "tray", "material": "m", "geometry": {"polygon": [)" + at(-5, -5) + ", " + at(40, -5) +
                        ", " + at(40, 0) + ", " + at(0, 0) + ", " + at(0, 20) + ", " + at(-5, 20) + "]}}",
                loads;
    for (int k = 0; k < 3; ++k) {
        const std::string name = "d" + std::to_string(k);
        parts += R"(, {"name": ")" + name + R"(", "material": "m", "geometry": {"circle": {"center": )" + at(5 + 10 * k, 5) +
                 R"(, "radius": )" + test::number(radius) + "}}}";
        loads += (k == 0 ? "" : ", ") + (R"({"part": ")" + name + R"(", "force": )" + along(k == 2 ? -100 : 0, -20) + "}");
    }
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [)" + parts +
                        R"(], "supports": [{"on": "tray/e0", "fix": ["x", "y"]}], "accuracy": {"level": "draft"}, "loads": [)" +
                        loads + "]}");
}

/// Rounding to the last digit makes overlaps of up to one and a half of it; what is drawn deeper, or by a radius, is a fit.
TEST(RoundedDrawing, AnOverlapThatTheDigitsExplainIsTouching) {
    for (const double degrees : {0.0, 17.0, 40.0, 71.3}) {
        SCOPED_TRACE(degrees);
        const Result r = in_a_turned_tray(degrees, 5);
        ASSERT_EQ(r.status, "ok") << r.message;
        int of_row = 0, of_weights = 0;
        for (const ContactResult& contact : r.contacts) {
            of_row += std::abs(contact.force.norm() - 100) < 0.1;
            of_weights += std::abs(contact.force.norm() - 20) < 0.1;
        }
        EXPECT_EQ(of_row, 3);
        EXPECT_EQ(of_weights, 3);
    }
    EXPECT_THROW(in_a_turned_tray(17, 5.005), InputError);
}

/// Whatever the digits of its place are.
TEST(RoundedDrawing, ThePressFitOfAShaftIsNoTouch) {
    for (const char* center : {"[40, 40]", "[40.25, 40]", "[40.253, 40.17]"}) {
        SCOPED_TRACE(center);
        const std::string circle = std::string(R"({"circle": {"center": )") + center + R"(, "radius": )";
        EXPECT_THROW(
            test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "hub", "material": "m", "geometry": {"difference": [
                {"rectangle": {"min": [0, 0], "max": [80, 80]}, "name": "b"}, )" +
                         circle + R"(25}}]}}, {"name": "shaft", "material": "m", "geometry": )" + circle + R"(25.012}}}],
            "supports": [{"on": "hub/b/bottom", "fix": ["x", "y"]}], "loads": [{"part": "shaft", "force": [0, -100]}]})"),
            InputError);
    }
}

TEST(RoundedDrawing, OverlapsArePressedApartOrLeftWhereTheSceneSaysSo) {
    const Result fit = in_a_v(3e-4, R"({"overlap": "press_fit"})"), left = in_a_v(3e-4, R"({"overlap": "ignore"})");
    for (const Result* r : {&fit, &left}) {
        ASSERT_EQ(r->status, "ok") << r->message;
        EXPECT_LT(r->parts.at(1).max_displacement.value, 0.05);  // faces that touch have nowhere to go
        EXPECT_FALSE(tells_overlap(*r));
        for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(r->contacts.at(k).force.norm(), 1000 / std::sqrt(2.0), 1e-3);
    }
}

}  // namespace
}  // namespace abut::rounded_drawing_test
