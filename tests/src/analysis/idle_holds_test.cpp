// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/idle_holds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/verification/scene_answers.hpp"

namespace abut::idle_holds_test {
namespace {

/// A block pressed against the left side of a groove by 100, with a lid so far above it.
Result in_groove(double above, const std::string& more_loads) {
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "groove", "material": "m", "geometry": {"polygon":
            [[-20, -10], [30, -10], [30, 20], [10.01, 20], [10.01, 0], [0, 0], [0, 20], [-20, 20]]}},
        {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [0, 0.02], "max": [10, 12]}}},
        {"name": "lid", "material": "m", "geometry": {"rectangle": {"min": [-20, 20], "max": [30, 30]}}},
        {"name": "peg", "material": "m", "geometry": {"rectangle": {"min": [4, )" +
                        test::number(12 + above) + R"(], "max": [6, 20]}}}],
        "supports": [{"on": "groove/e0", "fix": ["x", "y"]}, {"on": "lid/top", "fix": ["x", "y"]},
                     {"part": "peg", "rigid": {"translation": [0, 0], "rotation": 0}}],
        "loads": [{"on": "block/right", "force": [-100, 0]})" +
                        more_loads + R"(], "accuracy": {"level": "draft"}})");
}

bool has(const std::vector<std::string>& texts, const std::string& words) {
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return text.find(words) != std::string::npos; });
}

bool is_noted(const Result& r) {
    return has(r.notes, "under these loads only contacts that carry nothing hold");
}

}  // namespace

/// It may be anywhere between them: that is told as a motion which nothing holds.
TEST(IdleHolds, ABlockBetweenFloorAndLidThatCarryNothingIsToldOnce) {
    const Result r = in_groove(0.02, "");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_TRUE(has(r.warnings, "nothing holds a motion that no load drives (the answer of least motion is given): block"));
    EXPECT_FALSE(is_noted(r));
}

/// An oval pin in an oval hole, turned until it touches: where it does it is round, and turns on as long as other places stay
/// open.
TEST(IdleHolds, APinThatTurnsAboutTheMiddleOfItsOnlyContactIsNoted) {
    const Result r = test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "plate", "material": "m", "geometry": {"difference": [{"rectangle": {"min": [-30, -30], "max": [30, 30]}, "name": "o"},
            {"ellipse": {"center": [0, 0], "radii": [10, 7], "angle": 20}}]}},
        {"name": "pin", "material": "m", "geometry": {"ellipse": {"center": [0, 0], "radii": [9.723, 6.70887], "angle": 20}}}],
        "supports": [{"on": "plate/o/bottom", "fix": ["x", "y"]}],
        "loads": [{"part": "pin", "moment": 14459.104}, {"part": "pin", "force": [0, -1672.467]}], "accuracy": {"level": "draft"}})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_TRUE(is_noted(r));
}

TEST(IdleHolds, WhatIsPressedOnItsFloorIsHeld) {
    const Result r = in_groove(0.02, R"(, {"on": "block/top", "force": [0, -50]})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_FALSE(is_noted(r));
}

}  // namespace abut::idle_holds_test
