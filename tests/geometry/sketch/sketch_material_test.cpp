// SPDX-License-Identifier: GPL-3.0-or-later
// Which areas are material: outlines drawn twice, clearances, hatches, what the user says.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::sketch_material_test {
namespace {

constexpr double pi = std::numbers::pi;
const Entities plate = drawn_rectangle({-40, -30}, {40, 30}, "p");

bool tells(const SketchParts& sketch, const std::string& what) {
    return std::any_of(sketch.warnings.begin(), sketch.warnings.end(),
                       [&](const SketchProblem& warning) { return says(warning.what, what); });
}

Hatch hatch_of(const std::vector<Vec2>& corners) {
    Hatch hatch;
    hatch.loops.emplace_back();
    for (std::size_t k = 0; k < corners.size(); ++k)
        hatch.loops[0].push_back(Segment{corners[k], corners[(k + 1) % corners.size()]});
    return hatch;
}

TEST(SketchMaterial, DrawnTwiceThereIsMaterialOnBothSides) {
    const Entities twice{drawn_circle({0, 0}, 15, "a"), drawn_circle({0, 0}, 10, "b"), drawn_circle({0, 0}, 15, "c"),
                         drawn_circle({0, 0}, 10, "d")};
    const SketchParts bush = parts_by(plate + twice, PartsBy::loop);
    ASSERT_EQ(bush.parts.size(), 3u);
    EXPECT_NEAR(area(bush.parts[0]), 4800 - 225 * pi, 1e-9);
    EXPECT_NEAR(area(bush.parts[1]), 125 * pi, 1e-9);
    EXPECT_NEAR(area(bush.parts[2]), 100 * pi, 1e-9);
    EXPECT_TRUE(tells(bush, "2 lines or arcs that lie on others"));
    // a layer is one part: there it is a slip; so it is where all is drawn twice
    EXPECT_EQ(parts_by(plate + twice, PartsBy::layer).parts.size(), 2u);
    EXPECT_EQ(parts_by(plate + plate + twice, PartsBy::loop).parts.size(), 2u);
}

TEST(SketchMaterial, WhatFloatsInAHoleIsTold) {
    const SketchParts once =
        parts_by(plate + Entities{drawn_circle({0, 0}, 15, "a"), drawn_circle({0, 0}, 10, "b")}, PartsBy::loop);
    EXPECT_EQ(once.parts.size(), 2u);
    EXPECT_TRUE(tells(once, "touch nothing are taken as parts with air around them"));
    const SketchParts pin =
        parts_by(plate + Entities{drawn_circle({0, 0}, 15, "a"), drawn_circle({0, 0}, 14.9, "b")}, PartsBy::loop);
    EXPECT_EQ(pin.parts.size(), 2u);
    EXPECT_TRUE(pin.warnings.empty());
}

TEST(SketchMaterial, AnOutlineThatMayBeDrawnTwiceIsTold) {
    const auto ring = [](double wall) {
        return parts_by({drawn_circle({0, 0}, 15, "a"), drawn_circle({0, 0}, 15 - wall, "b")}, PartsBy::loop);
    };
    EXPECT_TRUE(tells(ring(0.01), "is hollow, its wall only 0.01 thick: its outline may be drawn twice"));
    EXPECT_TRUE(ring(0.1).warnings.empty());
    EXPECT_FALSE(ring(0.0001).problems.empty());
}

TEST(SketchMaterial, ABushIsAroundAPinWithClearance) {
    const Entities rings{drawn_circle({0, 0}, 15, "a"), drawn_circle({0, 0}, 10, "b"), drawn_circle({0, 0}, 9.95, "c")};
    const SketchParts sketch = parts_by(plate + rings, PartsBy::loop);
    ASSERT_EQ(sketch.parts.size(), 3u);
    EXPECT_NEAR(area(sketch.parts[1]), 125 * pi, 1e-9);
    EXPECT_NEAR(area(sketch.parts[2]), 9.95 * 9.95 * pi, 1e-9);
    EXPECT_TRUE(tells(sketch, "taken as a bush"));
    // a tube by itself stays one, however thin
    EXPECT_NEAR(total_area(parts_by({rings[1], rings[2]}, PartsBy::loop)), (100 - 9.95 * 9.95) * pi, 1e-9);
}

/// Two plates with a hole between them, and a bolt through it: of the clearance nobody drew the outline.
Entities bolted() {
    return drawn_rectangle({-40, 0}, {-6.75, 16}, "a") + drawn_rectangle({-40, 16}, {-6.75, 32}, "b") +
           drawn_polygon({{-6, 32}, {-9, 32}, {-9, 40}, {9, 40}, {9, 32}, {6, 32}, {6, -10}, {-9, -10}, {-9, 0}, {-6, 0}},
                         "bolt");
}

TEST(SketchMaterial, ClearancesAreEmpty) {
    const SketchParts sketch = parts_by(bolted(), PartsBy::loop);
    EXPECT_EQ(sorted_areas(sketch).size(), 3u);
    EXPECT_TRUE(tells(sketch, "areas on layer 0 that other outlines enclose are taken as empty: r"));
    const auto doubtful =
        std::find_if(sketch.regions.begin(), sketch.regions.end(), [](const SketchRegion& r) { return r.part.empty(); });
    ASSERT_NE(doubtful, sketch.regions.end());
    EXPECT_TRUE(doubtful->is_doubtful);

    Drawing drawing = drawing_of(bolted());
    SketchOptions options;
    options.parts_by = PartsBy::loop;
    options.regions[doubtful->name] = "SLEEVE";
    const SketchParts chosen = parts_of(drawing, options);
    EXPECT_EQ(chosen.parts.size(), 4u);
    EXPECT_NE(part_called(chosen, "SLEEVE"), nullptr);
    EXPECT_FALSE(tells(chosen, "taken as empty"));

    drawing.hatches.push_back(hatch_of({{-6.75, 0}, {-6, 0}, {-6, 32}, {-6.75, 32}}));
    EXPECT_EQ(parts_of(drawing, {}).parts.size(), 4u);
}

TEST(SketchMaterial, WithinOneHatchALineIsAnEdge) {
    Drawing drawing = drawing_of(plate + Entities{drawn_circle({0, 0}, 5, "c")});
    drawing.hatches.push_back(hatch_of({{-40, -30}, {40, -30}, {40, 30}, {-40, 30}}));
    const SketchParts sketch = parts_of(drawing, {});
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_EQ(area(sketch.parts[0]), 4800);
    EXPECT_TRUE(tells(sketch, "are taken as drawn on one part, not as its outline: r1, r2"));
}

TEST(SketchMaterial, WhereThinThingsAreMadeAStripIsOne) {
    const Entities walls = drawn_rectangle({-20, -20}, {20, 20}, "o") + drawn_rectangle({-19.95, -19.95}, {19.95, 19.95}, "i") +
                           Entities{drawn_circle({-8, 0}, 3, "a"), drawn_circle({-8, 0}, 2.9, "b"),
                                    drawn_circle({8, 0}, 3, "c"), drawn_circle({8, 0}, 2.9, "d")};
    const SketchParts sketch = parts_by(walls, PartsBy::loop);
    ASSERT_EQ(sketch.parts.size(), 3u);
    EXPECT_NEAR(area(sketch.parts[0]), 1600 - 39.9 * 39.9, 1e-9);
    EXPECT_NEAR(area(sketch.parts[1]), 0.59 * pi, 1e-9);
    EXPECT_NEAR(area(sketch.parts[2]), 0.59 * pi, 1e-9);
}

TEST(SketchMaterial, AScrewIsDrawnOverItsPlates) {
    const SketchParts sketch = parts_by(drawn_rectangle({0, 0}, {60, 3}, "a") + drawn_rectangle({0, -30}, {60, 0}, "b") +
                                            drawn_polygon({{26, 3}, {34, 3}, {32, 0}, {32, -18}, {28, -18}, {28, 0}}, "screw"),
                                        PartsBy::loop);
    EXPECT_TRUE(sketch.problems.empty());
    EXPECT_EQ(sorted_areas(sketch), (std::vector<double>{90, 180, 1800}));
    EXPECT_TRUE(tells(sketch, "both are taken as parts that overlap"));
}

}  // namespace
}  // namespace abut::geometry::sketch_material_test
