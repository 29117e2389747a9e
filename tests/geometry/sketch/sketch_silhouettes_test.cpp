// SPDX-License-Identifier: GPL-3.0-or-later
// The outline around everything in a block as one part.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::sketch_silhouettes_test {
namespace {

/// A head of 8 x 3 on a shank of 4 x 10, with a thread's lines that cross its tip, and an axis that stands out.
Entities screw(const Vec2& at) {
    const auto line = [&](double x1, double y1, double x2, double y2, const std::string& name) {
        return drawn_line(at + Vec2(x1, y1), at + Vec2(x2, y2), name);
    };
    return {line(-4, 0, 4, 0, "h0"),        line(4, 0, 4, 3, "h1"),      line(4, 3, -4, 3, "h2"),
            line(-4, 3, -4, 0, "h3"),       line(2, 0, 2, -9, "s0"),     line(2, -9, 1, -10, "s1"),
            line(1, -10, -1, -10, "s2"),    line(-1, -10, -2, -9, "s3"), line(-2, -9, -2, 0, "s4"),
            line(-2, -9, 2, -9, "e"),       line(-2, -1, 2, -1, "f"),    line(1.5, -1, 1.5, -9.5, "t"),
            line(-1.5, -1, -1.5, -9.5, "u")};
}
constexpr double screw_area = 24 + 39;

/// Each set of entities as an insertion of the block, on layer `layer`.
Drawing inserted(const std::string& block, const std::vector<Entities>& sets) {
    Entities all;
    Drawing drawing;
    for (std::size_t k = 0; k < sets.size(); ++k) {
        drawing.insertions.push_back({block, -1});
        for (SketchEntity entity : sets[k]) {
            entity.block = block;
            entity.insertion = static_cast<int>(k);
            if (sets.size() > 1) entity.instance = block + "#" + std::to_string(k);
            all.push_back(entity);
        }
    }
    const std::vector<Insertion> insertions = drawing.insertions;
    drawing = drawing_of(all);
    drawing.insertions = insertions;
    return drawing;
}

SketchParts outlined(const Drawing& drawing, const std::vector<std::string>& blocks, PartsBy way = PartsBy::automatic) {
    SketchOptions options;
    options.block_outline = blocks;
    options.parts_by = way;
    return parts_of(drawing, options);
}

int n_told(const std::vector<SketchProblem>& told, const std::string& what) {
    return static_cast<int>(
        std::count_if(told.begin(), told.end(), [&](const SketchProblem& one) { return says(one.what, what); }));
}

TEST(SketchSilhouettes, TheOutlineAroundABlockIsOnePart) {
    const Drawing drawing = inserted("M4", {screw({100, 50})});
    const SketchParts without = parts_of(drawing, {});
    ASSERT_FALSE(without.problems.empty());
    EXPECT_TRUE(says(without.problems[0].hint, "--block-outline M4 (in a scene \"block_outline\": [\"M4\"])"))
        << without.problems[0].hint;

    const SketchParts sketch = outlined(drawing, {"m?"});
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_NEAR(area(sketch.parts[0]), screw_area, 1e-9);
    expect_sound(sketch.parts[0]);
    EXPECT_EQ(n_told(sketch.warnings,
                     "of block M4 the outline around everything is taken for a part: 1 in 1 insertion; 4 of its lines and arcs "
                     "are left out"),
              1);
    EXPECT_EQ(n_told(sketch.warnings, "stand out"), 0);
}

TEST(SketchSilhouettes, EachInsertionIsAPartOfItsOwn) {
    for (const PartsBy way : {PartsBy::automatic, PartsBy::layer, PartsBy::block, PartsBy::loop, PartsBy::color}) {
        const SketchParts sketch = outlined(inserted("M4", {screw({0, 0}), screw({20, 0}), screw({40, 1})}), {"*"}, way);
        EXPECT_TRUE(sketch.problems.empty());
        ASSERT_EQ(sketch.parts.size(), 3u);
        for (const Part& part : sketch.parts) EXPECT_NEAR(area(part), screw_area, 1e-9);
        EXPECT_EQ(n_told(sketch.warnings, "a part: 3 in 3 insertions; 12 of its lines"), 1);
    }
}

TEST(SketchSilhouettes, NestedBlocksAreOneWhateverLayersTheyAreOn) {
    Drawing drawing = inserted("BOLT", {screw({0, 0})});
    drawing.insertions.push_back({"WASHER", 0});
    for (SketchEntity ring : drawn_rectangle({-5, -1}, {5, 0}, "w", "THIN")) {
        ring.block = "BOLT/WASHER";
        ring.insertion = 1;
        drawing.entities.push_back(ring);
    }
    const SketchParts all = outlined(drawing, {"BOLT"});
    ASSERT_EQ(all.parts.size(), 1u);
    EXPECT_NEAR(area(all.parts[0]), screw_area + 6, 1e-9);
    EXPECT_EQ(all.parts[0].name, "0");
}

TEST(SketchSilhouettes, WhatOverlapsIsOneOutline) {
    const double pi = std::numbers::pi;
    const Drawing drawing = inserted("RIVET", {drawn_rectangle({-2, -10}, {2, 0}, "s") +
                                               Entities{drawn_circle({0, 0}, 4, "head"), drawn_circle({0, 0}, 1, "mark")}});
    const SketchParts sketch = outlined(drawing, {"RIVET"});
    ASSERT_EQ(sketch.parts.size(), 1u);
    const double in_disc = 2 * std::sqrt(12.0) + 16 * std::asin(0.5);  // of the shank: the integral of sqrt(16 - x^2)
    EXPECT_NEAR(area(sketch.parts[0]), 16 * pi + 40 - in_disc, 1e-9);
    EXPECT_EQ(count_holes(sketch.parts[0]), 0);
}

TEST(SketchSilhouettes, WhatStandsOutIsTold) {
    const SketchParts sketch =
        outlined(inserted("M4", {screw({0, 0}) + Entities{drawn_line({0, -12}, {0, 5}, "axis")}}), {"M4"});
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_NEAR(area(sketch.parts[0]), screw_area, 1e-9);
    EXPECT_EQ(n_told(sketch.warnings, "1 line or arc of block M4 stand out of its outline, and are cut off there"), 1);
}

TEST(SketchSilhouettes, FaultsAreOneLineEach) {
    const SketchParts unknown = outlined(inserted("M4", {screw({0, 0})}), {"M4", "M5*"});
    ASSERT_EQ(unknown.problems.size(), 1u);
    EXPECT_EQ(unknown.problems[0].what, "no block that is inserted is called 'M5*'");
    EXPECT_EQ(unknown.problems[0].hint, "it inserts M4");
    const SketchParts open = outlined(inserted("AXIS", {{drawn_line({0, 0}, {1, 0}, "a")}}), {"AXIS"});
    EXPECT_EQ(n_told(open.problems, "block AXIS holds no closed outline"), 1);
    Entities gap = screw({0, 0});
    gap[2] = drawn_line({4, 3}, {-3.9, 3}, "h2");  // the head is open by a tenth
    EXPECT_EQ(n_told(outlined(inserted("M4", {gap}), {"M4"}).problems, "0.1 apart"), 1);
}

TEST(SketchSilhouettes, FarFromTheOrigin) {
    const SketchParts sketch = outlined(inserted("M4", {screw({1e6, -3e6})}), {"M4"});
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_NEAR(area(sketch.parts[0]), screw_area, 1e-6);
    EXPECT_NEAR(sketch.warnings[0].at.x(), 1e6, 10);
}

}  // namespace
}  // namespace abut::geometry::sketch_silhouettes_test
