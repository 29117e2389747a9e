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
