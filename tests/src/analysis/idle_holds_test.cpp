// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/idle_holds.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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

bool is_noted(const Result& r) {
    return std::any_of(r.notes.begin(), r.notes.end(), [](const std::string& note) {
        return note == "under these loads only contacts that carry nothing hold: block slides along (0, 1)";
    });
}

}  // namespace

TEST(IdleHolds, ABlockBetweenFloorAndLidThatCarryNothingIsNoted) {
    const Result r = in_groove(0.02, "");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_TRUE(is_noted(r));
}

TEST(IdleHolds, WhatIsPressedOnItsFloorIsHeld) {
    const Result r = in_groove(0.02, R"(, {"on": "block/top", "force": [0, -50]})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_FALSE(is_noted(r));
}

}  // namespace abut::idle_holds_test
