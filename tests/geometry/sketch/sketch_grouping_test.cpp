// SPDX-License-Identifier: GPL-3.0-or-later
// What belongs to one part, and what parts and edges are called.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::sketch_grouping_test {
namespace {

using Names = std::vector<std::string>;
constexpr double pi = std::numbers::pi;

Entities in_block(Entities entities, const std::string& block, const std::string& instance = "") {
    for (SketchEntity& entity : entities) {
        entity.block = block;
        entity.instance = instance;
    }
    return entities;
}

Entities coloured(Entities entities, int color) {
    for (SketchEntity& entity : entities) entity.color = color;
    return entities;
}

Entities moved(Entities entities, const Vec2& by) {
    for (SketchEntity& entity : entities) entity.curve = transformed(entity.curve, 1, 0, by);
    return entities;
}

const Entities square = drawn_rectangle({0, 0}, {10, 10}, "s", "A");
const Entities disc{drawn_circle({20, 5}, 5, "c", "B")};

TEST(SketchGrouping, ByLayerWhereSeveralHoldOutlines) {
    const SketchParts sketch = parts_by(square + disc, PartsBy::automatic);
    EXPECT_EQ(sketch.parts_by, PartsBy::layer);
    EXPECT_EQ(sketch.why, "2 layers hold closed outlines");
    EXPECT_EQ(part_names(sketch), (Names{"A", "B"}));
    EXPECT_EQ(sketch.layers, (Names{"A", "B"}));
}

TEST(SketchGrouping, ByLoopWhereOneLayerHoldsAllOutlines) {
    Entities all = square + disc + moved(square, {30, 0});
    for (SketchEntity& entity : all) entity.layer = "A";
    all.back().layer = "B";  // a side of the last square: by itself no outline
    const SketchParts sketch = parts_by(all, PartsBy::automatic);
    EXPECT_EQ(sketch.parts_by, PartsBy::loop);
    EXPECT_EQ(sketch.why, "layer A alone holds closed outlines");
    EXPECT_EQ(part_names(sketch), (Names{"A#0", "A#1", "A#2"}));
    EXPECT_TRUE(sketch.problems.empty());
}

TEST(SketchGrouping, ByLoopWhereLayersCloseOnlyTogether) {
    Entities post = drawn_rectangle({2, 10}, {8, 30}, "p", "B");
    post.erase(post.begin());  // it stands on the square, whose side it shares
    const SketchParts sketch = parts_by(square + post + Entities{drawn_circle({5, 20}, 1, "h", "B")}, PartsBy::automatic);
    EXPECT_EQ(sketch.parts_by, PartsBy::loop);
    EXPECT_EQ(sketch.why, "2 layers hold closed outlines, but not all close without what is on other layers");
    EXPECT_EQ(part_names(sketch), (Names{"A", "B"}));
    EXPECT_GT(parts_by(square + post, PartsBy::layer).open_length, 0);
}

TEST(SketchGrouping, ByLoopWhereALayerOnlyHoldsHoles) {
    const Entities bore{drawn_circle({5, 5}, 2, "c", "INNER")};
    const SketchParts sketch = parts_by(square + bore, PartsBy::automatic);
    EXPECT_EQ(sketch.parts_by, PartsBy::loop);
    EXPECT_EQ(part_names(sketch), (Names{"A"}));
    EXPECT_NEAR(total_area(sketch), 100 - 4 * pi, 1e-12);
    EXPECT_TRUE(std::any_of(sketch.warnings.begin(), sketch.warnings.end(), [](const SketchProblem& w) {
        return says(w.what, "outlines on layer INNER lie in the material of what is on layer A, and are taken as its holes");
    }));
    // a pin in a hole lies in no material, and what covers a hole is drawn in front of it
    for (const double radius : {2.0, 1.9, 3.0}) {
        const SketchParts pin = parts_by(
            square + Entities{drawn_circle({5, 5}, 2, "h", "A"), drawn_circle({5, 5}, radius, "p", "PIN")}, PartsBy::automatic);
        EXPECT_EQ(pin.parts_by, PartsBy::layer) << radius;
        EXPECT_EQ(part_names(pin), (Names{"A", "PIN"})) << radius;
    }
}

bool warns(const SketchParts& sketch, const std::string& piece) {
    return std::any_of(sketch.warnings.begin(), sketch.warnings.end(),
                       [&](const SketchProblem& w) { return says(w.what, piece); });
}

/// A post on the square, whose side it shares: layers do not close by themselves, and separate the parts all the same.
Entities square_with_post() {
    Entities post = drawn_rectangle({2, 10}, {8, 30}, "p", "B");
    post.erase(post.begin());
    return square + post;
}

TEST(SketchGrouping, APinOnALayerOfItsOwnIsAPartWhereLayersSeparateParts) {
    const Entities pin{drawn_circle({5, 20}, 1, "c", "PIN")};
    const SketchParts sketch = parts_by(square_with_post() + pin, PartsBy::automatic);
    EXPECT_EQ(sketch.parts_by, PartsBy::loop);
    EXPECT_EQ(part_names(sketch), (Names{"A", "B", "PIN"}));
    EXPECT_NEAR(total_area(sketch), 100 + 120, 1e-9);
    EXPECT_TRUE(
        warns(sketch, "outlines on layer PIN lie in the material of what is on layer B, and are taken as parts that fit"));
    // a layer of holes holds none, nor is a ring around what another layer has in its hole one, nor where outlines are the
    // parts
    Drawing with_holes = drawing_of(square_with_post() + Entities{drawn_circle({5, 20}, 1, "c", "BOHRUNG")});
    with_holes.hole_layers = {"BOHRUNG"};
    const SketchParts bored = parts_of(with_holes, {});
    EXPECT_EQ(part_names(bored), (Names{"A", "B"}));
    EXPECT_NEAR(total_area(bored), 100 + 120 - pi, 1e-9);
    EXPECT_FALSE(warns(bored, "BOHRUNG"));
    const SketchParts screwed =
        parts_by(square_with_post() + Entities{drawn_circle({5, 20}, 2, "c", "X"), drawn_circle({5, 20}, 1.5, "s", "SCREW")},
                 PartsBy::automatic);
    EXPECT_EQ(part_names(screwed), (Names{"A", "B", "SCREW"}));
    EXPECT_EQ(part_names(parts_by(square_with_post() + pin, PartsBy::loop)), (Names{"A", "B"}));
    // where it is in a block, or on a layer of one part alone, it is a hole, and that is told
    const SketchParts hole =
        parts_by(square + in_block(Entities{drawn_circle({5, 5}, 2, "c", "A")}, "PIN"), PartsBy::automatic);
    EXPECT_EQ(part_names(hole), (Names{"A"}));
    EXPECT_TRUE(warns(hole, "outlines of block PIN lie in the material of what is of no block, and are taken as its holes"));
}

TEST(SketchGrouping, WhatIsDrawnOnTwoLayersIsAPartOnEither) {
    const Entities fits{drawn_circle({5, 20}, 2, "h", "B"), drawn_circle({5, 20}, 2, "b0", "BUSH"),
                        drawn_circle({5, 20}, 1, "b1", "BUSH"), drawn_circle({5, 20}, 1, "p", "PIN")};
    const SketchParts sketch = parts_by(square_with_post() + fits, PartsBy::automatic);
    EXPECT_EQ(sketch.parts_by, PartsBy::loop);
    EXPECT_EQ(part_names(sketch), (Names{"A", "B", "BUSH", "PIN"}));
    EXPECT_EQ(sketch.layers, (Names{"A", "B", "BUSH", "PIN"}));
    EXPECT_NEAR(area(sketch.parts[2]), 3 * pi, 1e-9);
    EXPECT_FALSE(warns(sketch, "lie in the material"));
}

/// Everything once more on a layer of contours: the layer that is one part's alone names it. Pins that are alike are named
/// alike.
TEST(SketchGrouping, WhatIsDrawnOnTwoLayersHasTheNameThatTellsMore) {
    const Entities other = drawn_rectangle({30, 0}, {40, 10}, "t", "B");
    Entities again = square + other;
    for (SketchEntity& e : again) {
        e.layer = "KONTUR";
        e.name += "k";
    }
    EXPECT_EQ(part_names(parts_by(again + square + other, PartsBy::loop)), (Names{"A", "B"}));
    Entities pins;
    for (const double x : {3.0, 7.0})
        pins = pins + Entities{drawn_circle({x, 5}, 1, "h", "A"), drawn_circle({x, 5}, 1, "p", "PIN")};
    EXPECT_EQ(part_names(parts_by(square + other + pins, PartsBy::loop)), (Names{"A", "B", "PIN#0", "PIN#1"}));
}

TEST(SketchGrouping, PartsThatAreDrawnThroughOthersStayParts) {
    // a pin without a bore to hold it: with a third part it is an assembly, and the overlap is for the user to see
    const Entities pin{drawn_circle({5, 5}, 2, "p", "PIN")};
    const SketchParts assembly = parts_by(square + disc + pin, PartsBy::automatic);
    EXPECT_EQ(assembly.parts_by, PartsBy::layer);
    EXPECT_EQ(part_names(assembly), (Names{"A", "B", "PIN"}));
    // bodies of a mesh are parts in any case
    const SketchParts bodies = parts_by(in_block(square, "A") + in_block(pin, "PIN"), PartsBy::automatic);
    EXPECT_EQ(bodies.parts_by, PartsBy::layer);
    EXPECT_EQ(part_names(bodies), (Names{"A", "PIN"}));
}

TEST(SketchGrouping, ByBlockWhereEverythingLiesInBlocks) {
    const Entities all = in_block(square, "ASSY/PLATE") + in_block(moved(square, {30, 0}), "ASSY/BAR");
    const SketchParts sketch = parts_by(all, PartsBy::automatic);
    EXPECT_EQ(sketch.parts_by, PartsBy::block);
    EXPECT_EQ(sketch.why, "layer A alone holds closed outlines, and everything lies in several blocks");
    EXPECT_EQ(part_names(sketch), (Names{"PLATE", "BAR"}));
    EXPECT_EQ(sketch.layers, (Names{"PLATE", "BAR"}));
    // all in one block is no way to tell parts apart
    EXPECT_EQ(parts_by(in_block(square, "ASSY"), PartsBy::automatic).parts_by, PartsBy::loop);
    // nor are blocks that are the holes of another
    const SketchParts bored =
        parts_by(in_block(square, "PLATE") + in_block(Entities{drawn_circle({5, 5}, 2, "c", "A")}, "HOLE"), PartsBy::automatic);
    EXPECT_EQ(bored.parts_by, PartsBy::loop);
    EXPECT_TRUE(says(bored.why, "all others lie in the material of one")) << bored.why;
}

TEST(SketchGrouping, BlocksAreToldApartAtTheOutermostDifference) {
    // a pin with a chamfer drawn as a block of its own belongs together
    const Entities all = in_block(Entities{drawn_circle({0, 0}, 5, "c")}, "ASSY/PIN") +
                         in_block(Entities{drawn_circle({0, 0}, 4, "d")}, "ASSY/PIN/CHAMFER") +
                         in_block(drawn_rectangle({10, 0}, {20, 5}, "r"), "ASSY/BASE");
    const SketchParts sketch = parts_by(all, PartsBy::block);
    EXPECT_EQ(part_names(sketch), (Names{"PIN", "BASE"}));
    EXPECT_EQ(count_holes(sketch.parts[0]), 1);
}

TEST(SketchGrouping, EveryInsertionOfABlockIsAPart) {
    const Entities all = in_block(square, "PIN", "PIN#0") + in_block(moved(square, {10, 0}), "PIN", "PIN#1") +
                         in_block(moved(square, {50, 0}), "BASE");
    const SketchParts by_block = parts_by(all, PartsBy::block);
    EXPECT_EQ(part_names(by_block), (Names{"PIN#0", "PIN#1", "BASE"}));
    // the two touch along a side: never joined, never duplicates of each other
    EXPECT_TRUE(by_block.repairs.empty());
    const SketchParts by_layer = parts_by(all, PartsBy::layer);
    EXPECT_EQ(part_names(by_layer), (Names{"PIN#0:A", "PIN#1:A", "A"}));
    EXPECT_EQ(by_layer.layers, (Names{"A", "A", "A"}));
    EXPECT_TRUE(by_layer.repairs.empty());
    EXPECT_TRUE(by_layer.problems.empty());
    for (const SketchParts* sketch : {&by_block, &by_layer})
        for (const Part& part : sketch->parts) EXPECT_EQ(part.edges[0].name, "s0");
}

TEST(SketchGrouping, HolesFromInsertionsAreNamedAfterThem) {
    const Entities hole = in_block({drawn_circle({2, 5}, 1, "c", "A")}, "HOLE", "HOLE#0"),
                   other = in_block({drawn_circle({7, 5}, 1, "c", "A")}, "HOLE", "HOLE#1");
    const SketchParts sketch = parts_by(square + hole + other, PartsBy::layer);
    ASSERT_EQ(part_names(sketch), (Names{"A"}));
    EXPECT_EQ(count_holes(sketch.parts[0]), 2);
    EXPECT_EQ(sketch.parts[0].edges[4].name, "HOLE#0:c");
    EXPECT_EQ(sketch.parts[0].edges[5].name, "HOLE#1:c");
}

TEST(SketchGrouping, InsertionsThatDoNotCloseBelongTogether) {
    // half an outline, and its mirror image
    Entities half{drawn_line({0, 0}, {5, 0}, "a"), drawn_line({5, 0}, {5, 8}, "b"), drawn_line({5, 8}, {0, 8}, "c")},
        mirrored = half;
    Similarity mirror;
    mirror.mirror = true;
    for (SketchEntity& entity : mirrored) entity.curve = transformed(entity.curve, mirror);
    const SketchParts sketch =
        parts_by(in_block(half, "HALF", "HALF#0") + in_block(mirrored, "HALF", "HALF#1"), PartsBy::layer);
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_EQ(area(sketch.parts[0]), 80);
    expect_sound(sketch.parts[0]);  // two edges of each handle, but of different names
    EXPECT_EQ(sketch.parts[0].name, "HALF#0:0");
}

TEST(SketchGrouping, ByColour) {
    const SketchParts sketch =
        parts_by(coloured(drawn_rectangle({0, 0}, {10, 10}, "a"), 3) + coloured(drawn_rectangle({10, 0}, {20, 10}, "b"), 5),
                 PartsBy::color);
    EXPECT_EQ(part_names(sketch), (Names{"color3", "color5"}));
    EXPECT_TRUE(sketch.repairs.empty());  // the shared side is drawn once for each
}

TEST(SketchGrouping, PartsOfOneNameAreNumberedInTheFilesOrder) {
    Entities all = moved(square, {50, 0}) + square;
    for (std::size_t k = 4; k < 8; ++k) all[k].name = "t" + std::to_string(k);
    all.push_back(drawn_circle({100, 0}, 1, "u", "A#0"));  // a layer that is called as a numbered part would be
    const SketchParts sketch = parts_by(all, PartsBy::layer);
    EXPECT_EQ(part_names(sketch), (Names{"A#1", "A#2", "A#0"}));
    EXPECT_EQ(sketch.parts[0].edges[0].name, "s0");
}

TEST(SketchGrouping, SaysWhenItWasAskedFor) {
    for (const PartsBy way : {PartsBy::layer, PartsBy::block, PartsBy::loop, PartsBy::color}) {
        const SketchParts sketch = parts_by(square, way);
        EXPECT_EQ(sketch.parts_by, way);
        EXPECT_EQ(sketch.why, "asked for");
        EXPECT_EQ(sketch.parts.size(), 1u);
    }
}

/// A sheet's border with a title block in its corner, which shares edges with it, about some parts.
Entities in_a_sheet(const Entities& parts) {
    return drawn_rectangle({-50, -50}, {250, 160}, "s", "SHEET") + drawn_rectangle({150, -50}, {250, -20}, "t", "SHEET") +
           parts;
}

TEST(SketchGrouping, AnAssemblyInAFrameIsNoPatternOfHoles) {
    const Entities touching = drawn_rectangle({0, 0}, {40, 20}, "p", "P") + drawn_rectangle({40, 0}, {90, 20}, "q", "Q");
    const Entities nested = Entities{drawn_circle({0, 0}, 20, "r0", "ring"), drawn_circle({0, 0}, 10.1, "r1", "ring"),
                                     drawn_circle({0, 0}, 10, "p0", "pin")};
    const Entities holes = drawn_rectangle({0, 0}, {40, 20}, "p", "P") + drawn_rectangle({60, 0}, {90, 20}, "q", "Q");
    for (const Entities& parts : {touching, nested}) {
        const SketchParts sketch = parts_by(in_a_sheet(parts), PartsBy::automatic);
        EXPECT_EQ(sketch.parts_by, PartsBy::layer);
        EXPECT_TRUE(says(sketch.why, "frame of a sheet")) << sketch.why;
        EXPECT_TRUE(sketch.problems.empty());
    }
    for (const char* name : {"P", "Q"})
        EXPECT_NE(part_called(parts_by(in_a_sheet(touching), PartsBy::automatic), name), nullptr);
    for (const char* name : {"ring", "pin"})
        EXPECT_NE(part_called(parts_by(in_a_sheet(nested), PartsBy::automatic), name), nullptr);
    const SketchParts plate = parts_by(in_a_sheet(holes), PartsBy::automatic);
    EXPECT_EQ(plate.parts_by, PartsBy::loop);
    EXPECT_EQ(part_called(plate, "P"), nullptr);
}

TEST(SketchGrouping, LinesOfOtherLayersDoNotCutAPart) {
    // A hidden edge, or a bend, on a layer of its own: it bounds nothing but halves of the part.
    const Entities plate = drawn_rectangle({0, 0}, {100, 50}, "p", "PLATE");
    const SketchParts bent = parts_by(plate + Entities{drawn_line({30, 0}, {30, 50}, "b", "BEND")}, PartsBy::automatic);
    EXPECT_EQ(part_names(bent), std::vector<std::string>{"PLATE"});
    EXPECT_TRUE(bent.problems.empty());
    ASSERT_EQ(bent.warnings.size(), 1u);
    EXPECT_TRUE(says(bent.warnings[0].what, "LINE on layer BEND bounds nothing")) << bent.warnings[0].what;
    // On the part's own layer it divides it, and with an area of its own it is a second part.
    const SketchParts divided = parts_by(plate + Entities{drawn_line({30, 0}, {30, 50}, "b", "PLATE")}, PartsBy::automatic);
    EXPECT_EQ(sorted_areas(divided), (std::vector<double>{1500, 3500}));
    const Entities lid{drawn_line({100, 0}, {120, 0}, "l0", "LID"), drawn_line({120, 0}, {120, 50}, "l1", "LID"),
                       drawn_line({120, 50}, {100, 50}, "l2", "LID")};
    const SketchParts shared = parts_by(plate + lid, PartsBy::automatic);
    EXPECT_EQ(sorted_areas(shared), (std::vector<double>{1000, 5000}));
    EXPECT_TRUE(shared.problems.empty());
}

TEST(SketchGrouping, LoneLinesAreSetAsideAndTold) {
    // Centre lines as continuous lines on the part's layer.
    Entities entities = drawn_rectangle({0, 0}, {100, 50}, "p") + Entities{drawn_circle({50, 25}, 10, "c")} +
                        Entities{drawn_line({35, 25}, {65, 25}, "x"), drawn_line({50, 10}, {50, 40}, "y")};
    const SketchParts sketch = parts_by(entities, PartsBy::automatic);
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_EQ(sketch.parts[0].loops.size(), 2u);
    ASSERT_EQ(sketch.warnings.size(), 1u);
    EXPECT_TRUE(says(sketch.warnings[0].what, "(joined to nothing, the longest 30 long) and were set aside: x, y"))
        << sketch.warnings[0].what;
    EXPECT_EQ(sketch.warnings[0].at, Vec2(50, 25));
    // Ends that something nearly continues are a gap.
    entities = drawn_rectangle({0, 0}, {100, 50}, "p");
    entities[1] = drawn_line({100, 0.1}, {100, 49.9}, "p1");
    const SketchParts gaps = parts_by(entities, PartsBy::automatic);
    ASSERT_EQ(gaps.problems.size(), 2u);
    for (const SketchProblem& problem : gaps.problems) EXPECT_TRUE(says(problem.what, "0.1 apart")) << problem.what;
}

}  // namespace
}  // namespace abut::geometry::sketch_grouping_test
