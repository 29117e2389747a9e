// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of curved edges that face a way by chance.
#include "src/plan/stray_selections.hpp"

#include <gtest/gtest.h>

#include "src/scene/read_scene.hpp"

namespace abut::stray_selections_test {
namespace {

std::vector<std::string> strays_of(const std::string& geometry, const std::string& on) {
    return stray_selections(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0.3}}, "parts": [
        {"name": "p", "material": "m", "geometry": )" +
                                                geometry + R"(}], "supports": [{"on": )" + on + R"(, "fix": ["x", "y"]}]})",
                                            "s.json"));
}

const std::string plate = R"({"rectangle": {"min": [-20, -30], "max": [20, 30]}})",
                  hole = R"({"name": "h", "circle": {"center": [0, 10], "radius": 8}})",
                  holed = R"({"difference": [)" + plate + ", " + hole + "]}",
                  rounded = R"({"slot": {"from": [-10, 0], "to": [10, 0], "radius": 6}})";

/// The top of a hole faces down.
TEST(StraySelections, PiecesOfHolesAreNamed) {
    const std::vector<std::string> strays = strays_of(holed, R"({"part": "p", "facing": [0, -1]})");
    ASSERT_EQ(strays.size(), 1u);
    EXPECT_NE(strays[0].find("/supports/0/on: p/h/circle faces"), std::string::npos) << strays[0];
}

TEST(StraySelections, SidesOfSlotsAreNamed) {
    const std::string slotted =
        R"({"difference": [)" + plate + R"(, {"name": "s", "slot": {"from": [-10, 0], "to": [10, 0], "radius": 3}}]})";
    const std::vector<std::string> strays = strays_of(slotted, R"({"part": "p", "facing": [0, -1]})");
    ASSERT_EQ(strays.size(), 1u);
    EXPECT_NE(strays[0].find("p/s/"), std::string::npos) << strays[0];
    EXPECT_EQ(strays[0].find("bottom"), std::string::npos) << strays[0];
    EXPECT_TRUE(strays_of(slotted, R"({"part": "p", "facing": [0.6, 0.8]})").empty());
}

TEST(StraySelections, WhatAdjoinsIsMeant) {
    EXPECT_TRUE(strays_of(rounded, R"({"part": "p", "facing": [0, -1]})").empty());
}

TEST(StraySelections, ACurveAloneIsMeant) {
    EXPECT_TRUE(strays_of(hole, R"({"part": "p", "facing": [0, -1]})").empty());
    EXPECT_TRUE(strays_of(holed, R"({"part": "p", "facing": [0.6, -0.8]})").empty());
}

TEST(StraySelections, ACornerIsNearToTwoEdges) {
    const std::vector<std::string> strays = strays_of(plate, R"({"part": "p", "near": [20, -30]})");
    ASSERT_EQ(strays.size(), 1u);
    EXPECT_NE(strays[0].find("p/bottom is selected, and p/right is as near to this place"), std::string::npos) << strays[0];
    EXPECT_TRUE(strays_of(plate, R"({"part": "p", "near": [20, -29.9]})").empty());
    EXPECT_TRUE(strays_of(holed, R"({"part": "p", "near": [0, 10]})").empty()) << "a circle's middle";
}

TEST(StraySelections, OtherSelectorsTakeWhatTheySay) {
    EXPECT_TRUE(strays_of(holed, R"(["p/bottom", {"part": "p", "box": [[-3, 0], [3, 40]]}])").empty());
}

}  // namespace
}  // namespace abut::stray_selections_test
