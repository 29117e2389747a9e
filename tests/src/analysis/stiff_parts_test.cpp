// SPDX-License-Identifier: GPL-3.0-or-later
// Forces that are small differences: stops that parts nearly miss.
#include "src/analysis/stiff_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/verification/scene_answers.hpp"

namespace abut::stiff_parts_test {
namespace {

/// A cantilever over a round stop, which it reaches with the last two hundredths of its way.
Result nearly_missed(double friction, const std::string& accuracy) {
    return test::answer(R"({"abut": 1, "analysis": "plane_stress", "thickness": 8,
        "materials": {"steel": {"E": 205000, "nu": 0.29}}, "parts": [
        {"name": "arm", "material": "steel", "geometry": {"rectangle": {"min": [0, 0], "max": [60, 5]}}},
        {"name": "stop", "material": "steel", "geometry": {"circle": {"center": [56, -6.262], "radius": 6}}}],
        "supports": [{"on": "arm/left", "fix": ["x", "y"]}, {"part": "stop", "rigid": {"translation": [0, 0], "rotation": 0}}],
        "loads": [{"on": "arm/right", "force": [0, -70]}], "contacts": {"friction": )" +
                        test::number(friction) + R"(}, "accuracy": )" + accuracy + "}");
}

/// With cells at the clamp's corners that follow the stress there.
Result exact(double friction) {
    std::string places;
    for (const char* corner : {"[0, 0]", "[0, 5]"})
        for (const char* radius : {"0.5", "0.05", "0.005", "0.0005"})
            places += (places.empty() ? "" : ", ") + (R"({"near": )" + std::string(corner) + R"(, "radius": )" + radius +
                                                      R"(, "cell_size": )" + radius + "e-1}");
    return nearly_missed(friction, R"({"level": "fine", "refine": [)" + places + "]}");
}

void is_known_as_well_as_it_says(double friction) {
    const Result truth = exact(friction);
    ASSERT_EQ(truth.status, "ok") << truth.message;
    const double force = truth.contacts.at(0).force.norm();
    ASSERT_GT(force, 0);
    EXPECT_LT(force, 0.05 * 70);
    for (const char* level : {"draft", "standard"}) {
        const Result r = nearly_missed(friction, R"({"level": ")" + std::string(level) + R"("})");
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_TRUE(r.accuracy.reached) << level << r.accuracy.why;
        const ContactResult& c = r.contacts.at(0);
        const double off = std::abs(c.force.norm() / force - 1);
        EXPECT_LT(off, 2 * c.errors.value().force) << level;
        EXPECT_LT(off, r.accuracy.target) << level;
    }
}

TEST(StiffParts, AForceThatIsASmallDifferenceIsKnownAsWellAsItSays) {
    is_known_as_well_as_it_says(0);
}

TEST(StiffParts, SoIsOneWithFriction) {
    is_known_as_well_as_it_says(0.2);
}

/// The corner of a leaf that just reaches another one: a force of half a thousandth decides how far that moves.
TEST(StiffParts, WhatACornerThatIsNearlyMissedMovesIsKnownAsWellAsItSays) {
    const auto leaves = [](const std::string& level) {
        return test::answer(R"({"abut": 1, "analysis": "plane_stress", "thickness": 10,
            "materials": {"steel": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "lower", "material": "steel", "geometry": {"rectangle": {"min": [0, 0], "max": [60, 2]}}},
            {"name": "upper", "material": "steel", "geometry": {"rectangle": {"min": [0, 2.904], "max": [49.827, 4.904]}}},
            {"name": "tip", "material": "steel", "geometry": {"circle": {"center": [25, 7.904], "radius": 3}}}],
            "supports": [{"on": ["lower/left", "upper/left"], "fix": ["x", "y"]}, {"part": "tip", "rigid": {"rotation": 0}}],
            "loads": [{"part": "tip", "force": [0, -98.281]}],
            "accuracy": {"level": ")" +
                            level + R"("}})");
    };
    const Result truth = leaves("fine");
    ASSERT_EQ(truth.status, "ok") << truth.message;
    for (const char* level : {"draft", "standard"}) {
        const Result r = leaves(level);
        ASSERT_EQ(r.status, "ok") << r.message;
        ASSERT_TRUE(r.contacts.at(0).errors) << level;
        const double moves = truth.parts.at(0).max_displacement.value;
        EXPECT_LT(std::abs(r.parts.at(0).max_displacement.value - moves), r.parts[0].max_displacement_error.value_or(0) * moves)
            << level;
    }
}

/// Where statics gives the force, corners that make the parts too stiff do not change it.
TEST(StiffParts, AForceThatStaticsGivesMissesNothing) {
    const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [
        {"name": "shelf", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [60, 5]}}},
        {"name": "roller", "material": "m", "geometry": {"circle": {"center": [50, 11], "radius": 6}}}],
        "supports": [{"on": "shelf/left", "fix": ["x", "y"]}, {"part": "roller", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"part": "roller", "force": [0, -20]}], "accuracy": {"level": "draft"}})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_NEAR(r.contacts.at(0).force.norm(), 20, 1e-6);
    EXPECT_LT(r.contacts.at(0).errors.value().force, 1e-3);
    EXPECT_TRUE(r.accuracy.reached) << r.accuracy.why;
}

}  // namespace
}  // namespace abut::stiff_parts_test
