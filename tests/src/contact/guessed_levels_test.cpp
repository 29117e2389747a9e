// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings whose parts lie above each other, and those whose parts are drawn into each other by mistake.
#include "src/contact/guessed_levels.hpp"

#include <gtest/gtest.h>

#include "src/contact/candidates.hpp"
#include "src/contact/detect.hpp"
#include "src/scene/part_levels.hpp"
#include "src/scene/read_sketch.hpp"
#include "tests/geometry/dxf/dxf_text.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::guessed_levels_test {
namespace {

using geometry::dxf_circle;
using geometry::dxf_rectangle;

/// A bar with eyes of this radius.
std::string bar(const std::string& layer, double x0, double x1, double eye, double y = 0) {
    return dxf_rectangle(layer, layer, x0 - 10, y - 10, x1 + 10, y + 10) + dxf_circle(layer + "8", layer, x0, y, eye) +
           dxf_circle(layer + "9", layer, x1, y, eye);
}

std::string ring(const std::string& layer, double x, double inner, double outer) {
    return dxf_circle(layer + "0", layer, x, 0, outer) + dxf_circle(layer + "1", layer, x, 0, inner);
}

Scene drawing(const std::string& entities) {
    const TemporaryFolder folder;
    return read_sketch(folder.write("d.dxf", geometry::dxf_file(entities)), {}).scene;
}

std::string guessed(const std::string& entities) {
    Scene scene = drawing(entities);
    const std::size_t n_warnings = scene.warnings.size();
    take_guessed_levels(scene);
    EXPECT_EQ(levels_text(scene).empty(), scene.warnings.size() == n_warnings);
    EXPECT_EQ(scene.imports[0].warnings.size() - scene.warnings.size(),
              drawing(entities).imports[0].warnings.size() - n_warnings);
    if (!levels_text(scene).empty()) { EXPECT_NO_THROW(find_candidates(scene, 1)); }
    return levels_text(scene);
}

const std::string lap = bar("A", 0, 50, 4) + bar("B", 50, 100, 4) + dxf_circle("P", "PIN", 50, 0, 4);

}  // namespace

TEST(GuessedLevels, LinksThatAPinJoins) {
    EXPECT_EQ(guessed(lap), "A 1; B 2; PIN 1, 2");
    Scene scene = drawing(lap);
    take_guessed_levels(scene);
    EXPECT_EQ(detect_contacts(scene, std::nullopt).pairs.size(), 2u);
    EXPECT_NE(scene.warnings.back().find(
                  "A, B overlap in the plan, and parts that fit holes of two of them join them (PIN): taken as lying above "
                  "each other, levels A 1; B 2; PIN 1, 2"),
              std::string::npos)
        << scene.warnings.back();
}

TEST(GuessedLevels, TellingChangesNothing) {
    Scene scene = drawing(lap);
    tell_guessed_levels(scene);
    EXPECT_EQ(levels_text(scene), "");
    EXPECT_NE(scene.warnings.back().find("they look as if they lay above each other"), std::string::npos);
    EXPECT_THROW(find_candidates(scene, 1), InputError);
}

TEST(GuessedLevels, APinThatNobodyDrew) {
    const std::string bars = bar("A", 0, 50, 4) + bar("B", 50, 100, 4);
    EXPECT_EQ(guessed(bars), "A 1; B 2");
    Scene scene = drawing(bars);
    take_guessed_levels(scene);
    EXPECT_NE(scene.warnings.back().find(
                  R"("parts": [{"name": "pin", "material": "steel", "level": [1, 2], "geometry": {"circle": {"center": )"
                  R"([50, 0], "radius": 4}}}])"),
              std::string::npos)
        << scene.warnings.back();
    EXPECT_EQ(guessed(bar("A", 0, 50, 4) + bar("B", 50, 100, 4.5)), "");
}

TEST(GuessedLevels, AChainNeedsTwo) {
    std::string chain;
    for (int k = 0; k < 4; ++k) chain += bar(std::string(1, static_cast<char>('A' + k)), 50 * k, 50 * k + 50, 4);
    for (int k = 0; k < 5; ++k) chain += dxf_circle("P" + std::to_string(k), "PIN" + std::to_string(k), 50 * k, 0, 4);
    EXPECT_EQ(guessed(chain), "A 1; B 2; C 1; D 2; PIN1 1, 2; PIN2 1, 2; PIN3 1, 2");  // PIN0, PIN4 join nothing: all levels
}

TEST(GuessedLevels, BushesAndRollersOfARollerChain) {
    const std::string link =
        bar("INNER", 0, 50, 5) + bar("OUTER", 50, 100, 4) + ring("BUSH", 50, 4, 5) + dxf_circle("P", "PIN", 50, 0, 4);
    EXPECT_EQ(guessed(link), "INNER 1; OUTER 2; BUSH 1; PIN 1, 2");
    EXPECT_EQ(guessed(link + ring("ROLLER", 50, 5, 8)), "INNER 1; OUTER 2; BUSH 1, 3; PIN 1, 2, 3; ROLLER 3");
}

TEST(GuessedLevels, ThreePlatesThatAllOverlapNeedThree) {
    EXPECT_EQ(guessed(lap + bar("C", 50, 120, 4)), "A 1; B 2; PIN 1, 2, 3; C 3");
}

TEST(GuessedLevels, APlateOverAPinIsOnNoneOfThePinsLevels) {
    EXPECT_EQ(guessed(lap + dxf_rectangle("C", "COVER", 44, -30, 57, 30)), "A 1; B 2; PIN 1, 2; COVER 3");
}

TEST(GuessedLevels, WhatIsDrawnIntoEachOtherStaysSo) {
    for (const std::string& entities :
         {dxf_rectangle("A", "A", 0, 0, 50, 20) + dxf_rectangle("B", "B", 40, 10, 90, 30),   // no pin
          dxf_rectangle("A", "A", 0, 0, 50, 20) + dxf_circle("B", "ROLLER", 25, 29.99, 10),  // 0.01 into a flat
          dxf_rectangle("A", "A", 0, 0, 50, 20) + dxf_rectangle("B", "B", 0, 20, 50, 40) + dxf_circle("C", "DOWEL", 25, 20, 4),
          bar("A", 0, 50, 4) + dxf_circle("P", "PIN", 50, 0, 4.01),  // a press fit
          bar("A", 0, 50, 4) + dxf_circle("P", "PIN", 50, 0, 4) + dxf_rectangle("B", "B", 45, 9, 90, 30)}) {
        EXPECT_EQ(guessed(entities), "");
    }
}

TEST(GuessedLevels, ContactsThatTheGuessLosesAreTold) {
    // a stop that stands on both bars of the lap: it overlaps none, and meets both
    Scene beside = drawing(lap + dxf_rectangle("S", "STOP", 40, 10, 60, 20));
    take_guessed_levels(beside);
    EXPECT_EQ(levels_text(beside), "A 1; B 2; PIN 1, 2");
    EXPECT_EQ(detect_contacts(beside, std::nullopt).pairs.size(), 4u);
    // a post on the first bar, and a bracket on the second that leans against it
    const std::string post = dxf_rectangle("D", "POST", 0, 0, 30, 60);
    std::string bracket;
    const std::vector<std::array<double, 2>> corners{{70, 0}, {90, 0}, {90, 60}, {30, 60}, {30, 40}, {70, 40}};
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto &from = corners[k], &to = corners[(k + 1) % corners.size()];
        bracket += geometry::dxf_line("E" + std::to_string(k), "BRACKET", from[0], from[1], to[0], to[1]);
    }
    Scene lost = drawing(lap + post + bracket);
    take_guessed_levels(lost);
    EXPECT_EQ(levels_text(lost), "A 1; B 2; PIN 1, 2; POST 2; BRACKET 1");
    EXPECT_NE(lost.warnings.back().find(
                  "POST and BRACKET come close to each other, but have none of these levels in common: no contact"),
              std::string::npos)
        << lost.warnings.back();
}

}  // namespace abut::guessed_levels_test
