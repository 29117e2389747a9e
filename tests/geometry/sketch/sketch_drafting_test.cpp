// SPDX-License-Identifier: GPL-3.0-or-later
// What of a drawing is its sheet, and what explains it.
#include <gtest/gtest.h>

#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::sketch_drafting_test {
namespace {

const Entities blocks = drawn_rectangle({0, 0}, {40, 20}, "a") + drawn_rectangle({0, 20}, {40, 40}, "b");

SketchParts parts_with(const Entities& entities, std::vector<DrawnText> texts = {}, SketchOptions options = {}) {
    Drawing drawing = drawing_of(entities);
    drawing.texts = std::move(texts);
    options.parts_by = PartsBy::loop;
    return parts_of(drawing, options);
}

bool tells(const SketchParts& sketch, const std::string& what) {
    return std::any_of(sketch.warnings.begin(), sketch.warnings.end(),
                       [&](const SketchProblem& warning) { return says(warning.what, what); });
}

TEST(SketchDrafting, FramesAreSetAside) {
    const Entities frame = drawn_rectangle({-50, -50}, {150, 150}, "f");
    const SketchParts single = parts_with(frame + blocks);
    EXPECT_EQ(sorted_areas(single), (std::vector<double>{800, 800}));
    EXPECT_TRUE(tells(single, "4 entities, the first on layer 0, set aside as frame of a sheet: f0, f1, f2, f3"));
    const SketchParts twofold = parts_with(frame + drawn_rectangle({-40, -40}, {140, 140}, "g") + blocks);
    EXPECT_EQ(sorted_areas(twofold), (std::vector<double>{800, 800}));
    SketchOptions kept;
    kept.keep_drafting = true;
    EXPECT_EQ(parts_with(frame + drawn_rectangle({-40, -40}, {140, 140}, "g") + blocks, {}, kept).parts.size(), 3u);
}

TEST(SketchDrafting, APlateWithWindowsStaysAPlate) {
    const Entities plate = drawn_rectangle({0, 0}, {100, 60}, "p") + drawn_rectangle({10, 10}, {40, 50}, "v") +
                           drawn_rectangle({60, 10}, {90, 50}, "w");
    const SketchParts sketch = parts_with(plate);
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_EQ(count_holes(sketch.parts[0]), 2);
    EXPECT_TRUE(sketch.warnings.empty());
    // windows with next to nothing between them may be parts that nearly touch
    const SketchParts near = parts_with(drawn_rectangle({0, 0}, {100, 60}, "p") + drawn_rectangle({10, 10}, {49.9, 50}, "v") +
                                        drawn_rectangle({50.1, 10}, {90, 50}, "w"));
    EXPECT_EQ(near.parts.size(), 1u);
    EXPECT_TRUE(tells(near, "it may be the frame of a sheet"));
}

TEST(SketchDrafting, AWallIsNoMargin) {
    // 1 of 400 is less than any sheet has
    const SketchParts box = parts_with(drawn_rectangle({0, 0}, {400, 300}, "f") + drawn_rectangle({1, 1}, {399, 299}, "g") +
                                       drawn_rectangle({20, 20}, {60, 40}, "a") + drawn_rectangle({20, 100}, {60, 140}, "b"));
    EXPECT_EQ(sorted_areas(box), (std::vector<double>{800, 120000 - 398 * 298.0, 1600}));
    EXPECT_FALSE(tells(box, "frame of a sheet"));
}

TEST(SketchDrafting, TitleBlocksGoWithTheirContent) {
    Entities sheet = drawn_rectangle({-100, -100}, {197, 110}, "f") + drawn_rectangle({-80, -90}, {187, 100}, "g") + blocks;
    for (const double y : {-80.0, -70.0}) sheet.push_back(drawn_line({87, y}, {187, y}, "row"));
    for (const double x : {87.0, 137.0}) sheet.push_back(drawn_line({x, -90}, {x, -70}, "column"));  // one crosses a row
    sheet.push_back(drawn_circle({150, -85}, 2, "symbol"));
    const SketchParts sketch = parts_with(sheet, {{"TITLE", {90, -88}, 3}, {"1:1", {140, -78}, 3}});
    EXPECT_TRUE(sketch.problems.empty());
    EXPECT_EQ(sorted_areas(sketch), (std::vector<double>{800, 800}));
    EXPECT_TRUE(tells(sketch, "set aside as content of the sheet"));
}

TEST(SketchDrafting, BalloonsGoWithTheirLeaders) {
    const Entities balloon{drawn_line({10, 10}, {-26.8, 37.6}, "leader"), drawn_circle({-30, 40}, 4, "balloon"),
                           drawn_circle({10, 10}, 0.5, "dot")};
    for (const bool has_text : {true, false}) {
        const SketchParts sketch =
            parts_with(blocks + balloon, has_text ? std::vector<DrawnText>{{"1", {-31, 38}, 3}} : std::vector<DrawnText>{});
        EXPECT_EQ(sorted_areas(sketch), (std::vector<double>{800, 800})) << has_text;
        EXPECT_TRUE(tells(sketch, "1 entity on layer 0, set aside as balloon: balloon"));
        EXPECT_TRUE(tells(sketch, "1 entity on layer 0, set aside as leader or arrow: leader"));
        EXPECT_TRUE(tells(sketch, "1 entity on layer 0, set aside as dot of a leader: dot"));
    }
    // a roller on a flat is none, whatever is written on it
    const SketchParts roller = parts_with(blocks + Entities{drawn_circle({20, 45}, 5, "roller")}, {{"A", {19, 44}, 3}});
    EXPECT_EQ(roller.parts.size(), 3u);
}

TEST(SketchDrafting, ADiscWithItsNumberIsADisc) {
    EXPECT_EQ(parts_with({drawn_circle({0, 0}, 10, "disc")}, {{"1", {-1, -1}, 3}}).parts.size(), 1u);
    // a roller just above its rail
    for (const double gap : {0.02, 0.4}) {
        const SketchParts sketch =
            parts_with(blocks + Entities{drawn_circle({20, 45 + gap}, 5, "roller")}, {{"1", {19, 44}, 3}});
        EXPECT_EQ(sketch.parts.size(), 3u) << gap;
    }
}

/// Boxes with parts in them: with a note, with the proportions of paper, with walls as wide as margins.
TEST(SketchDrafting, WhatPartsRestOnOrFitIntoIsNoFrame) {
    const auto box = [](double wall) {
        return drawn_rectangle({0, 0}, {120, 85}, "o") + drawn_rectangle({wall, wall}, {120 - wall, 85 - wall}, "i");
    };
    const std::vector<DrawnText> note{{"S355", {60, 40}, 3}};
    const Entities rollers{drawn_circle({30, 14}, 10, "r"), drawn_circle({80, 14}, 10, "s")};
    EXPECT_EQ(parts_with(box(4) + rollers, note).parts.size(), 3u);
    EXPECT_EQ(parts_with(box(4) + drawn_rectangle({4.5, 20}, {115.5, 60}, "slider"), note).parts.size(), 2u);
    EXPECT_EQ(
        parts_with(box(4) + drawn_rectangle({20, 20}, {60, 60}, "a") + drawn_rectangle({70, 20}, {90, 60}, "b")).parts.size(),
        3u)
        << "nothing is written on it";
    // a tube on a plate, with a roller in it
    EXPECT_EQ(parts_with(box(4) + drawn_rectangle({-20, -20}, {140, 0}, "base") + Entities{rollers[0]}, note).parts.size(), 3u);
}

TEST(SketchDrafting, APlateWithANoteIsNoSheet) {
    const std::vector<DrawnText> note{{"t = 10", {10, 5}, 3}};
    const Entities holes{drawn_circle({50, 50}, 10, "h"), drawn_circle({150, 50}, 10, "k")};
    const SketchParts plate = parts_with(drawn_rectangle({0, 0}, {297, 210}, "p") + holes, note);
    ASSERT_EQ(plate.parts.size(), 1u);
    EXPECT_EQ(count_holes(plate.parts[0]), 2);
    EXPECT_TRUE(tells(plate, "it has the proportions of paper, and a text in it, so it may be the frame of a sheet"));
    // a window on the plate's own layer, and a slider in it on another; all on one layer is what a sheet shows
    for (const std::string layer : {"SLIDER", "PLATE"}) {
        const SketchParts sketch =
            parts_with(drawn_rectangle({0, 0}, {297, 210}, "p", "PLATE") + drawn_rectangle({50, 50}, {100, 80}, "w", "PLATE") +
                           drawn_rectangle({60, 55}, {90, 75}, "s", layer),
                       note);
        ASSERT_EQ(sketch.parts.size(), layer == "SLIDER" ? 2u : 1u);
        EXPECT_NEAR(sorted_areas(sketch)[0], layer == "SLIDER" ? 600 : 900, 1e-9);
    }
}

/// A block stands in a small window of a plate, on whose layer the window is: they share a line as parts on a sheet do.
TEST(SketchDrafting, ABlockInAWindowStandsInAPlate) {
    const auto drawn = [](const std::string& layer) {
        return parts_with(drawn_rectangle({0, 0}, {100, 60}, "p", layer) + drawn_rectangle({40, 20}, {60, 40}, "w", "PLATE") +
                          drawn_rectangle({45, 20}, {55, 30}, "b", "BLOCK"));
    };
    EXPECT_EQ(sorted_areas(drawn("PLATE")), (std::vector<double>{100, 6000 - 400}));
    EXPECT_TRUE(tells(drawn("PLATE"), "is taken as a plate; outlines in it share lines, as parts that touch do, so it may be"));
    EXPECT_TRUE(tells(drawn("FRAME"), "set aside as frame of a sheet"));
}

TEST(SketchDrafting, PartsOnTheirLayersAreNoTable) {
    for (const bool are_named : {true, false}) {
        const std::string upper = are_named ? "UPPER" : "LOWER";
        const SketchParts sketch =
            parts_with(drawn_rectangle({0, 0}, {40, 20}, "a", "LOWER") + drawn_rectangle({0, 20}, {40, 40}, "b", upper),
                       {{"LOWER", {10, 10}, 3}, {"UPPER", {10, 30}, 3}});
        EXPECT_EQ(sketch.parts.size(), are_named ? 2u : 0u);
    }
}

TEST(SketchDrafting, OutlinesThatNearlyCloseAreFaults) {
    Entities square = drawn_rectangle({0, 0}, {100, 100}, "a");
    square[3] = drawn_line({0, 100}, {0, 3.9}, "a3");  // of 396 less than 1 %
    const SketchParts nearly = parts_with(square + drawn_rectangle({200, 0}, {240, 20}, "b"));
    ASSERT_EQ(nearly.problems.size(), 1u);
    EXPECT_TRUE(says(nearly.problems[0].what, "3.9 apart"));
    SketchOptions open;
    open.leave_open = true;
    const SketchParts left = parts_with(square + drawn_rectangle({200, 0}, {240, 20}, "b"), {}, open);
    EXPECT_TRUE(left.problems.empty());
    EXPECT_EQ(left.parts.size(), 1u);
    EXPECT_NEAR(left.open_length, 396.1, 1e-9);
    square[3] = drawn_line({0, 100}, {0, 4.1}, "a3");
    EXPECT_TRUE(parts_with(square + drawn_rectangle({200, 0}, {240, 20}, "b")).problems.empty());
}

/// Nearer to each other than ends are joined at, but no repetition: a larger tolerance would not help.
/// A text beside a corner of an outline that does not close makes no leader of it.
TEST(SketchDrafting, AnOpenOutlineBesideATextIsNoLeader) {
    const Entities open{drawn_line({0, 0}, {40, 0}, "a"), drawn_line({40, 0}, {40, 20}, "b"),
                        drawn_line({40, 20}, {0, 20}, "c"), drawn_line({0, 20}, {0, 0.05}, "d")};
    const SketchParts sketch = parts_with(open, {{"BASE", {38, 18}, 4}});
    EXPECT_FALSE(tells(sketch, "leader"));
    ASSERT_EQ(sketch.problems.size(), 1u);
    EXPECT_TRUE(says(sketch.problems[0].what, "open outline on layer 0: the ends of a, d are 0.05 apart"))
        << sketch.problems[0].what;
}

TEST(SketchDrafting, LinesBesideEachOtherAreNoGapToClose) {
    const Entities base = drawn_polygon({{-30, -20}, {30, -19.999712345}, {30, 0}, {-30, 0}}, "a");
    const SketchParts sketch =
        parts_with(base + Entities{drawn_line({-10, -20}, {5, -20}, "b")} + drawn_rectangle({50, 0}, {90, 20}, "c"));
    ASSERT_EQ(sketch.problems.size(), 1u);
    EXPECT_TRUE(says(sketch.problems[0].what, "open outline"));
    EXPECT_TRUE(says(sketch.problems[0].hint, "remove the one that is drawn twice")) << sketch.problems[0].hint;
}

}  // namespace
}  // namespace abut::geometry::sketch_drafting_test
