// SPDX-License-Identifier: GPL-3.0-or-later
// Pins through plates that lie above each other, their circles drawn as often as people draw them.
#include "geometry/sketch/sketch_pins.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::sketch_pins_test {
namespace {

constexpr double pi = std::numbers::pi;

const Entities first = drawn_rectangle({0, 0}, {60, 20}, "a", "A"), second = drawn_rectangle({40, -20}, {60.5, 40}, "b", "B");
const Entities pin{drawn_circle({50, 10}, 5, "pin", "PIN")};
const double hole = 25 * pi;

Entities hole_on(const std::string& layer) {
    return {drawn_circle({50, 10}, 5, "hole" + layer, layer)};
}

int n_told(const SketchParts& sketch) {
    return static_cast<int>(std::count_if(sketch.warnings.begin(), sketch.warnings.end(), [](const SketchProblem& warning) {
        return says(warning.what, "as a pin through plates above each other");
    }));
}

}  // namespace

TEST(SketchPins, CirclesDrawnForEachPartAreTakenAsTheyAre) {
    const SketchParts sketch = parts_by(first + hole_on("A") + second + hole_on("B") + pin, PartsBy::layer);
    EXPECT_EQ(part_names(sketch), (std::vector<std::string>{"A", "B", "PIN"}));
    EXPECT_NEAR(total_area(sketch), 1200 - hole + 1230 - hole + hole, 1e-9);
    EXPECT_EQ(n_told(sketch), 0);
}

TEST(SketchPins, CirclesDrawnOnceOrTwiceAreHolesOfBothPlates) {
    for (const Entities& holes : {Entities{}, hole_on("A"), hole_on("B")}) {
        const SketchParts sketch = parts_by(first + second + pin + holes, PartsBy::automatic);
        EXPECT_EQ(sketch.parts_by, PartsBy::layer);
        EXPECT_TRUE(sketch.problems.empty());
        ASSERT_EQ(part_names(sketch), (std::vector<std::string>{"A", "B", "PIN"}));
        EXPECT_NEAR(area(*part_called(sketch, "A")), 1200 - hole, 1e-9);
        EXPECT_NEAR(area(*part_called(sketch, "B")), 1230 - hole, 1e-9);
        EXPECT_EQ(n_told(sketch), 1);
        for (const Part& part : sketch.parts) expect_sound(part);
        const bool is_own = holes.empty() || holes.front().layer == "B";
        EXPECT_EQ(part_called(sketch, "A")->edges.back().name, is_own ? "pin" : "holeA");
    }
    const SketchParts both = parts_by(first + second + pin, PartsBy::layer);
    EXPECT_TRUE(says(both.warnings.back().what,
                     "PIN lies in outlines that cross, as a pin through plates above each other: taken as one, with "
                     "a hole of its size in A and B"));
}

TEST(SketchPins, PlatesMayLieAcrossAtAnyAngle) {
    const Vec2 along{0.242, 0.9703}, across{0.9703, -0.242};
    const Entities slanted = drawn_polygon(
        {-8 * along - 9 * across, -8 * along + 9 * across, 50 * along + 9 * across, 50 * along - 9 * across}, "b", "B");
    const SketchParts sketch =
        parts_by(drawn_rectangle({-20, -40}, {80, 14}, "a", "A") + slanted + Entities{drawn_circle({0, 0}, 5, "pin", "PIN")},
                 PartsBy::layer);
    EXPECT_EQ(n_told(sketch), 1);
    for (const char* plate : {"A", "B"}) EXPECT_EQ(count_holes(*part_called(sketch, plate)), 1) << plate;
}

TEST(SketchPins, WhatLiesOnOnePlateStaysThere) {
    // neither a part beside the overlap, nor plates of which one lies on the other, nor plates side by side
    const Entities beside{drawn_circle({20, 10}, 5, "pin", "PIN")};
    EXPECT_EQ(n_told(parts_by(first + second + beside, PartsBy::layer)), 0);
    const Entities on_it = drawn_rectangle({35, 2}, {58, 18}, "c", "C");
    EXPECT_EQ(n_told(parts_by(first + on_it + pin, PartsBy::layer)), 0);
    const Entities below = drawn_rectangle({0, -20}, {60, 0}, "d", "D"), dowel{drawn_circle({30, 0}, 5, "dowel", "DOWEL")};
    EXPECT_EQ(n_told(parts_by(first + below + dowel, PartsBy::layer)), 0);
    // a cover over a pin that joins two plates as they are drawn
    const Entities cover = drawn_rectangle({43, -30}, {58, 50}, "e", "E");
    EXPECT_EQ(n_told(parts_by(first + hole_on("A") + second + hole_on("B") + pin + cover, PartsBy::layer)), 0);
    EXPECT_EQ(n_told(parts_by(first + hole_on("A") + second + pin + cover, PartsBy::layer)), 1);
    // what is on the plate's own layer is its hole already
    EXPECT_EQ(n_told(parts_by(first + hole_on("A") + second + hole_on("B"), PartsBy::layer)), 0);
}

TEST(SketchPins, EveryPartIsOfSomeGroup) {
    std::vector<Part> parts(2);
    std::vector<SketchProblem> warnings;
    EXPECT_THROW(cut_pins(parts, {"A"}, warnings), std::logic_error);
}

}  // namespace abut::geometry::sketch_pins_test
