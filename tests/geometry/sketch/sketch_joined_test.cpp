// SPDX-License-Identifier: GPL-3.0-or-later
// Hatches tell part from part: alike on both sides of a line they are one.
#include <gtest/gtest.h>

#include <numbers>

#include "geometry/sketch/sketch_hatches.hpp"
#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::sketch_joined_test {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<Curve> rectangle_of(const Vec2& min, const Vec2& max) {
    const Vec2 right(max.x(), min.y()), left(min.x(), max.y());
    return {Segment{min, right}, Segment{right, max}, Segment{max, left}, Segment{left, min}};
}

Hatch hatch_of(const std::vector<Curve>& loop, const HatchLook& look) {
    Hatch hatch;
    hatch.loops = {loop};
    hatch.look = look;
    hatch.name = "hatch";
    return hatch;
}

const HatchLook plain{"ANSI31", 0, 1, "H", 7}, turned{"ANSI31", 90, 1, "H", 7};

/// Two squares of 10 with a line between them.
Entities divided() {
    return drawn_rectangle({0, 0}, {20, 10}, "p") + Entities{drawn_line({10, 0}, {10, 10}, "middle")};
}

SketchParts parts_with(const Entities& entities, std::vector<Hatch> hatches, const SketchOptions& options = {}) {
    Drawing drawing = drawing_of(entities);
    drawing.hatches = std::move(hatches);
    return parts_of(drawing, options);
}

SketchParts hatched(const HatchLook& left, const HatchLook& right, const Entities& entities = divided(),
                    const SketchOptions& options = {}) {
    return parts_with(
        entities, {hatch_of(rectangle_of({0, 0}, {10, 10}), left), hatch_of(rectangle_of({10, 0}, {20, 10}), right)}, options);
}

int n_told(const SketchParts& sketch, const std::string& what) {
    return static_cast<int>(std::count_if(sketch.warnings.begin(), sketch.warnings.end(),
                                          [&](const SketchProblem& warning) { return says(warning.what, what); }));
}

TEST(SketchJoined, HatchedAlikeIsOnePart) {
    const SketchParts one = hatched(plain, plain);
    ASSERT_EQ(one.parts.size(), 1u);
    EXPECT_EQ(area(one.parts[0]), 200);
    EXPECT_EQ(one.parts[0].edges.size(), 6u);  // long sides keep the joints
    expect_sound(one.parts[0]);
    EXPECT_EQ(n_told(one, "hatched alike (ANSI31) are taken as drawn on one part, not as its outline: r1, r2"), 1);
    ASSERT_EQ(one.regions.size(), 2u);
    for (const SketchRegion& region : one.regions) {
        EXPECT_EQ(region.part, one.parts[0].name);
        EXPECT_TRUE(region.is_doubtful);
    }
}

TEST(SketchJoined, WhatLooksDifferentIsTwoParts) {
    for (const HatchLook& other : {turned, HatchLook{"ANSI37", 0, 1, "H", 7}, HatchLook{"ANSI31", 0, 2, "H", 7},
                                   HatchLook{"ANSI31", 0, 1, "K", 7}, HatchLook{"ANSI31", 0, 1, "H", 3}}) {
        const SketchParts two = hatched(plain, other);
        EXPECT_EQ(sorted_areas(two), (std::vector<double>{100, 100}));
        EXPECT_TRUE(two.warnings.empty());
    }
}

TEST(SketchJoined, WhatHasNoHatchBesideOthersThatHaveOneIsTold) {
    const auto beside = [](const Entities& entities) {
        return parts_with(entities, {hatch_of(rectangle_of({0, 0}, {10, 10}), plain)});
    };
    const SketchParts sketch = beside(divided());
    EXPECT_EQ(sorted_areas(sketch), (std::vector<double>{100, 100}));  // a shaft is drawn so, and so is a bore
    EXPECT_EQ(n_told(sketch, "without a hatch, beside others that have one, are taken as parts: r2"), 1);
    const Entities apart = drawn_rectangle({0, 0}, {10, 10}, "a") + drawn_rectangle({10, 0}, {20, 10}, "b");
    EXPECT_EQ(n_told(beside(apart), "without a hatch"), 0) << "outlines of their own are parts";
}

TEST(SketchJoined, HalfATurnLooksTheSame) {
    EXPECT_TRUE(look_alike(plain, {"ANSI31", 180, 1, "H", 7}));
    EXPECT_TRUE(look_alike({"ANSI31", -45, 1, "H", 7}, {"ANSI31", 135.0001, 1.0000001, "H", 7}));
    EXPECT_FALSE(look_alike({"ANSI31", -45, 1, "H", 7}, {"ANSI31", 45, 1, "H", 7}));
    const std::vector<Hatch> hatches{hatch_of({}, plain), hatch_of({}, turned), hatch_of({}, plain)};
    EXPECT_TRUE(look_alike(hatches, {0, 1}, {1, 2}));
    EXPECT_FALSE(look_alike(hatches, {0, 1}, {2}));  // crossed lines over one kind
    EXPECT_FALSE(look_alike(hatches, {}, {}));
}

TEST(SketchJoined, EachPartDrawnWholeIsTwoParts) {
    const SketchParts two =
        hatched(plain, plain, drawn_rectangle({0, 0}, {10, 10}, "a") + drawn_rectangle({10, 0}, {20, 10}, "b"));
    EXPECT_EQ(sorted_areas(two), (std::vector<double>{100, 100}));
    // unless everything is there twice
    const SketchParts one = hatched(plain, plain, divided() + divided());
    EXPECT_EQ(sorted_areas(one), (std::vector<double>{200}));
}

TEST(SketchJoined, OneHatchOverAHoleIsAnEdgeOnThePart) {
    const Entities plate =
        drawn_rectangle({-40, -30}, {40, 30}, "p") + Entities{drawn_circle({0, 0}, 9, "edge"), drawn_circle({0, 0}, 5, "hole")};
    Hatch hatch = hatch_of(rectangle_of({-40, -30}, {40, 30}), plain);
    hatch.loops.push_back({Arc{{0, 0}, 5, 0, 2 * pi}});
    const SketchParts sketch = parts_with(plate, {hatch});
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_NEAR(area(sketch.parts[0]), 4800 - 25 * pi, 1e-9);
    EXPECT_EQ(count_holes(sketch.parts[0]), 1);
    expect_sound(sketch.parts[0]);
}

/// A ring in four pieces around a square that is no material: joined, it has a hole.
TEST(SketchJoined, PiecesAroundAnOpeningAreARing) {
    Entities lines = drawn_rectangle({0, 0}, {30, 30}, "o") + drawn_rectangle({10, 10}, {20, 20}, "i");
    for (const auto& [from, to] : {std::pair(Vec2(0, 0), Vec2(10, 10)), std::pair(Vec2(30, 0), Vec2(20, 10)),
                                   std::pair(Vec2(30, 30), Vec2(20, 20)), std::pair(Vec2(0, 30), Vec2(10, 20))})
        lines.push_back(drawn_line(from, to, "cut" + std::to_string(lines.size())));
    Hatch ring = hatch_of(rectangle_of({0, 0}, {30, 30}), plain);
    ring.loops.push_back(rectangle_of({10, 10}, {20, 20}));
    SketchOptions open;
    open.regions["r5"] = "void";
    const SketchParts sketch = parts_with(lines, {ring}, open);
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_EQ(area(sketch.parts[0]), 800);
    EXPECT_EQ(count_holes(sketch.parts[0]), 1);
    expect_sound(sketch.parts[0]);
    EXPECT_EQ(n_told(sketch, "r1, r2, r3, r4"), 1);
    // in any order, and filled inside by another hatch: two parts
    std::mt19937 random(7);
    for (int k = 0; k < 10; ++k) {
        shuffle_and_turn(lines, random);
        const SketchParts filled = parts_with(lines, {ring, hatch_of(rectangle_of({10, 10}, {20, 20}), turned)});
        EXPECT_EQ(sorted_areas(filled), (std::vector<double>{100, 800}));
        for (const Part& part : filled.parts) expect_sound(part);
    }
}

TEST(SketchJoined, TheUserHasTheLastWord) {
    SketchOptions said;
    said.regions["r2"] = "part";
    EXPECT_EQ(hatched(plain, plain, divided(), said).parts.size(), 2u);
    said.regions["r2"] = "r1";
    const SketchParts joined = hatched(plain, turned, divided(), said);
    EXPECT_EQ(joined.parts.size(), 1u);
    EXPECT_EQ(n_told(joined, "hatched alike"), 0);
    EXPECT_EQ(parts_with(divided(), {}, said).parts.size(), 1u);
    said.regions = {{"r1", "PLATE"}, {"r2", "PLATE"}};
    const SketchParts named = parts_with(divided(), {}, said);
    EXPECT_EQ(part_names(named), (std::vector<std::string>{"PLATE"}));
    said.regions = {{"r1", "LEFT"}, {"r2", "RIGHT"}};
    EXPECT_EQ(part_names(hatched(plain, plain, divided(), said)), (std::vector<std::string>{"LEFT", "RIGHT"}));
}

TEST(SketchJoined, WhatIsApartStaysApartAndIsTold) {
    const Entities apart = drawn_rectangle({0, 0}, {10, 10}, "a") + drawn_rectangle({30, 0}, {40, 10}, "b");
    Hatch hatch = hatch_of(rectangle_of({0, 0}, {10, 10}), plain);
    hatch.loops.push_back(rectangle_of({30, 0}, {40, 10}));
    const SketchParts sketch = parts_with(apart, {hatch});
    EXPECT_EQ(sketch.parts.size(), 2u);
    EXPECT_EQ(n_told(sketch, "one hatch (ANSI31) covers areas"), 1);
    SketchOptions said;
    said.regions["r2"] = "r1";
    EXPECT_EQ(n_told(parts_with(apart, {}, said), "region r2 is to be one part with r1, but"), 1);
}

TEST(SketchJoined, LayersSeparateWhateverIsHatched) {
    const SketchParts sketch =
        parts_with(drawn_rectangle({0, 0}, {10, 10}, "a", "A") + drawn_rectangle({10, 0}, {20, 10}, "b", "B"),
                   {hatch_of(rectangle_of({0, 0}, {10, 10}), plain), hatch_of(rectangle_of({10, 0}, {20, 10}), plain)});
    EXPECT_EQ(part_names(sketch), (std::vector<std::string>{"A", "B"}));
}

TEST(SketchJoined, AHoleIsHatchedForThePinOfAnotherLayer) {
    for (const double radius : {4.99, 5.0, 5.01}) {
        Hatch hatch{{{Arc{{10, 10}, radius, 0, 2 * std::numbers::pi}}}, plain, {}};
        Entities lines = drawn_rectangle({0, 0}, {20, 20}, "a", "A") +
                         Entities{drawn_circle({10, 10}, 5, "h", "A"), drawn_circle({10, 10}, radius, "p", "B")};
        EXPECT_EQ(part_names(parts_with(lines, {hatch})), (std::vector<std::string>{"A", "B"})) << radius;
        // where no other layer has anything there, it is a part that the hole holds
        lines.pop_back();
        lines.push_back(drawn_circle({40, 10}, radius, "q", "B"));
        EXPECT_EQ(part_names(parts_with(lines, {hatch})), (std::vector<std::string>{"A#0", "A#1", "B"})) << radius;
    }
}

TEST(SketchJoined, AHatchOnAPartsLayerIsThatParts) {
    Entities lines = drawn_rectangle({0, 0}, {20, 20}, "a", "A") + Entities{drawn_circle({10, 10}, 5, "h", "A")} +
                     drawn_rectangle({-20, -20}, {40, 40}, "b", "B");
    const Hatch behind = hatch_of(rectangle_of({-20, -20}, {40, 40}), {"ANSI31", 0, 1, "B", 7});
    SketchOptions by_layer;
    by_layer.parts_by = PartsBy::layer;
    EXPECT_EQ(part_names(parts_with(lines, {behind}, by_layer)), (std::vector<std::string>{"A", "B"}));
    EXPECT_NEAR(area(parts_with(lines, {behind}, by_layer).parts[0]), 400 - 25 * pi, 1e-9);
}

}  // namespace
}  // namespace abut::geometry::sketch_joined_test
