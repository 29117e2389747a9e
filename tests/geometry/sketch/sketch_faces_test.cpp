// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines that share edges.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::sketch_faces_test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(SketchFaces, AnEdgeDrawnOnceBoundsTwoParts) {
    // a post on a base whose top is drawn in one piece; the post has no bottom of its own
    const Entities drawing = drawn_rectangle({0, 0}, {40, 10}, "a") + Entities{drawn_line({10, 10}, {10, 30}, "b0"),
                                                                               drawn_line({10, 30}, {20, 30}, "b1"),
                                                                               drawn_line({20, 30}, {20, 10}, "b2")};
    const SketchParts sketch = parts_by(drawing, PartsBy::loop);
    EXPECT_TRUE(sketch.problems.empty());
    EXPECT_EQ(sorted_areas(sketch), (std::vector<double>{200, 400}));
    for (const Part& part : sketch.parts) expect_sound(part);
    const Part& base = sketch.parts[0];
    ASSERT_EQ(base.edges.size(), 6u);  // its top in three pieces, along the top's own direction, from x = 40 to x = 0
    for (const Edge& edge : base.edges) {
        if (edge.source != "a2") continue;
        const double begin = 40 - std::max(point(edge.curve, 0).x(), point(edge.curve, 1).x());
        EXPECT_EQ(edge.source_begin, begin);
        EXPECT_EQ(edge.name, begin == 0 ? "a2#0" : begin == 20 ? "a2#1" : "a2#2");
        EXPECT_TRUE(edge.along_source);
    }
    const Part& post = sketch.parts[1];
    const auto bottom = std::find_if(post.edges.begin(), post.edges.end(), [](const Edge& e) { return e.source == "a2"; });
    ASSERT_NE(bottom, post.edges.end());
    EXPECT_EQ(bottom->name, "a2");
    EXPECT_EQ(bottom->source_begin, 20);
    EXPECT_FALSE(bottom->along_source);
    EXPECT_TRUE(std::any_of(sketch.repairs.begin(), sketch.repairs.end(),
                            [](const Repair& r) { return says(r.what, "LINE a2 cut where b0 ends on it"); }));
    EXPECT_TRUE(std::any_of(sketch.warnings.begin(), sketch.warnings.end(), [](const SketchProblem& w) {
        return says(w.what, "share lines that are drawn once; areas on both sides are taken as parts: r1, r2");
    }));
}

TEST(SketchFaces, AnEdgeDrawnTwiceBoundsTwoParts) {
    const SketchParts sketch =
        parts_by(drawn_rectangle({0, 0}, {10, 10}, "a") + drawn_rectangle({10, 0}, {25, 10}, "b"), PartsBy::loop);
    EXPECT_TRUE(sketch.problems.empty());
    EXPECT_EQ(sorted_areas(sketch), (std::vector<double>{100, 150}));
    for (const Part& part : sketch.parts) expect_sound(part);
}

TEST(SketchFaces, AFrameOfBarsHasAnOpening) {
    const Entities bars = drawn_rectangle({0, 0}, {30, 5}, "a") + drawn_rectangle({0, 25}, {30, 30}, "b") +
                          drawn_rectangle({0, 5}, {5, 25}, "c") + drawn_rectangle({25, 5}, {30, 25}, "d");
    const SketchParts frame = parts_by(bars, PartsBy::loop);
    EXPECT_TRUE(frame.problems.empty());
    EXPECT_EQ(sorted_areas(frame), (std::vector<double>{100, 100, 150, 150}));
    // a pin and a bored pin inside the opening
    const SketchParts filled = parts_by(
        bars + Entities{drawn_circle({10, 10}, 2, "p"), drawn_circle({18, 18}, 3, "q"), drawn_circle({18, 18}, 1, "r")},
        PartsBy::loop);
    ASSERT_EQ(filled.parts.size(), 6u);
    EXPECT_NEAR(total_area(filled), 500 + 4 * pi + 8 * pi, 1e-9);
}

TEST(SketchFaces, ADividedOutlineInAPlateIsAHoleWithPartsInIt) {
    // a bush of two halves, its joint drawn once
    const Entities drawing = drawn_rectangle({-20, -20}, {20, 20}, "a") +
                             Entities{drawn_circle({0, 0}, 10, "c"), drawn_line({-10, 0}, {10, 0}, "d")};
    const SketchParts sketch = parts_by(drawing, PartsBy::loop);
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.parts.size(), 3u);
    EXPECT_NEAR(area(sketch.parts[0]), 1600 - 100 * pi, 1e-9);
    EXPECT_EQ(count_holes(sketch.parts[0]), 1);
    EXPECT_NEAR(area(sketch.parts[1]), 50 * pi, 1e-9);
    EXPECT_NEAR(area(sketch.parts[2]), 50 * pi, 1e-9);
    for (const Part& part : sketch.parts) expect_sound(part);
}

TEST(SketchFaces, ARectangleAlongTheSideOfALargerOneIsANotch) {
    // by the same rule that makes it a hole when it is clear of the side
    for (const double shift : {0.0, 1.0}) {
        const SketchParts sketch = parts_by(
            drawn_rectangle({0, 0}, {30, 20}, "a") + drawn_rectangle({10, 5 + shift}, {20, 20 - (shift > 0 ? 1 : 0)}, "b"),
            PartsBy::loop);
        EXPECT_TRUE(sketch.problems.empty());
        ASSERT_EQ(sketch.parts.size(), 1u);
        EXPECT_NEAR(area(sketch.parts[0]), 600 - (shift > 0 ? 130 : 150), 1e-9);
        EXPECT_EQ(count_holes(sketch.parts[0]), shift > 0 ? 1 : 0);
        expect_sound(sketch.parts[0]);
    }
}

TEST(SketchFaces, APinThatShareAnArcWithItsHoleIsAPart) {
    // a hole and a pin with a flat: the rest of the pin's circle is the hole's
    const double x = std::sqrt(75.0);
    const double a = std::asin(0.5);
    const Entities drawing = drawn_rectangle({-20, -20}, {20, 20}, "a") +
                             Entities{drawn_circle({0, 0}, 10, "c"), drawn(Arc{{0, 0}, 10, pi - a, pi + 2 * a}, "p"),
                                      drawn_line({x, 5}, {-x, 5}, "q")};
    const double segment = 100 * (pi / 3) - 5 * x;  // cut off by the flat
    const SketchParts sketch = parts_by(drawing, PartsBy::loop);
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.parts.size(), 2u);
    EXPECT_NEAR(area(sketch.parts[0]), 1600 - 100 * pi, 1e-9);
    EXPECT_NEAR(area(sketch.parts[1]), 100 * pi - segment, 1e-9);
    for (const Part& part : sketch.parts) expect_sound(part, 1e-11);
}

TEST(SketchFaces, TangentCurvesAreSortedByCurvature) {
    // three arcs and a line leave one point along one tangent; all end on a wall
    const auto fan = [](double radius,
                        const std::string& name) {  // from the origin, up, to the left or the right, as far as x = 4
        const double turn = std::acos(1 - 4 / std::abs(radius));
        return radius > 0 ? drawn(Arc{{radius, 0}, radius, pi, -turn}, name) : drawn(Arc{{radius, 0}, -radius, 0, turn}, name);
    };
    Entities drawing{fan(5, "r5"), fan(8, "r8"), fan(20, "r20")};
    const auto end_of = [&](int k) { return point(drawing[static_cast<std::size_t>(k)].curve, 1); };
    drawing.push_back(drawn_line({0, 0}, {0, 20}, "up"));
    drawing.push_back(drawn_line({0, 20}, end_of(2), "w0"));
    drawing.push_back(drawn_line(end_of(2), end_of(1), "w1"));
    drawing.push_back(drawn_line(end_of(1), end_of(0), "w2"));
    std::mt19937 random(5);
    for (int trial = 0; trial < 20; ++trial) {
        Entities turned = drawing;
        shuffle_and_turn(turned, random);
        const double angle = 0.3 * trial;
        for (SketchEntity& entity : turned) entity.curve = transformed(entity.curve, std::cos(angle), std::sin(angle), {3, 1});
        const SketchParts sketch = parts_by(turned, PartsBy::loop);
        EXPECT_TRUE(sketch.problems.empty());
        ASSERT_EQ(sketch.parts.size(), 3u);
        for (const Part& part : sketch.parts) expect_sound(part, 1e-11);
        // each lies between two neighbours: no part is bounded by the outer two
        for (const Part& part : sketch.parts) EXPECT_EQ(part.edges.size(), 3u);
    }
}

TEST(SketchFaces, OutlinesThatTouchInOnePointAreParted) {
    const SketchParts corners =
        parts_by(drawn_rectangle({0, 0}, {10, 10}, "a") + drawn_rectangle({10, 10}, {20, 20}, "b"), PartsBy::loop);
    EXPECT_TRUE(corners.problems.empty());
    EXPECT_EQ(sorted_areas(corners), (std::vector<double>{100, 100}));
    // a hole that touches the outline with a corner
    const SketchParts hole = parts_by(
        drawn_polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, "a") + drawn_polygon({{0, 0}, {5, 2}, {2, 5}}, "b"), PartsBy::loop);
    EXPECT_TRUE(hole.problems.empty());
    ASSERT_EQ(hole.parts.size(), 1u);
    EXPECT_NEAR(area(hole.parts[0]), 100 - 10.5, 1e-12);
}

TEST(SketchFaces, WhatBoundsNothingIsReported) {
    const SketchParts sketch = parts_by(drawn_rectangle({0, 0}, {10, 10}, "a") + drawn_rectangle({20, 0}, {30, 10}, "b") +
                                            Entities{drawn_line({10, 5}, {20, 5}, "c")},
                                        PartsBy::loop);
    EXPECT_TRUE(sketch.problems.empty());
    EXPECT_EQ(sorted_areas(sketch), (std::vector<double>{100, 100}));
    ASSERT_EQ(sketch.warnings.size(), 1u);
    EXPECT_TRUE(says(sketch.warnings[0].what, "LINE on layer 0 bounds nothing (joining outlines, 10 long)"))
        << sketch.warnings[0].what;
    EXPECT_EQ(sketch.warnings[0].at, Vec2(15, 5));
}

// ---- random subdivisions ----

struct Cell {
    Vec2 min, max;
    double area() const { return (max - min).prod(); }
};

/// A rectangle cut by lines from side to side, again and again; the lines that were cut along.
struct Subdivision {
    std::vector<Cell> cells;
    Entities cuts;
};

Subdivision subdivided(std::mt19937& random, int n_cuts) {
    Subdivision result{{{{0, 0}, {100, 60}}}, {}};
    for (int cut = 0; cut < n_cuts; ++cut) {
        Cell& cell = result.cells[random() % result.cells.size()];
        const int axis = (cell.max - cell.min).x() > (cell.max - cell.min).y() ? 0 : 1;
        if ((cell.max - cell.min)[axis] < 1) continue;
        const double at =
            cell.min[axis] + (cell.max - cell.min)[axis] * (0.25 + 0.5 * std::generate_canonical<double, 53>(random));
        Cell other = cell;
        cell.max[axis] = other.min[axis] = at;
        Vec2 from = other.min, to = other.max;
        to[axis] = at;
        result.cuts.push_back(drawn_line(from, to, "cut" + std::to_string(cut)));
        result.cells.push_back(other);
    }
    return result;
}

void place(Entities& entities, std::mt19937& random) {
    const double angle = 2 * pi * std::generate_canonical<double, 53>(random);
    const double far = std::pow(10.0, static_cast<double>(random() % 7));
    for (SketchEntity& entity : entities)
        entity.curve = transformed(entity.curve, std::cos(angle), std::sin(angle), {far, -3 * far});
}

void expect_cells(const SketchParts& sketch, const Subdivision& expected, const std::string& what) {
    EXPECT_TRUE(sketch.problems.empty()) << what << ": " << sketch.problems.front().what;
    std::vector<double> areas;
    for (const Cell& cell : expected.cells) areas.push_back(cell.area());
    std::sort(areas.begin(), areas.end());
    const std::vector<double> found = sorted_areas(sketch);
    ASSERT_EQ(found.size(), areas.size()) << what;
    // Coordinates up to 3e6 are rounded to 5e-10, ends are joined as they are found: times the cell's perimeter.
    for (std::size_t k = 0; k < areas.size(); ++k) EXPECT_NEAR(found[k], areas[k], 1e-6) << what;
    for (const Part& part : sketch.parts) expect_sound(part, 1e-7);
}

void check_subdivisions(int n_cases, unsigned seed) {
    std::mt19937 random(seed);
    for (int trial = 0; trial < n_cases; ++trial) {
        const Subdivision subdivision = subdivided(random, 2 + static_cast<int>(random() % 14));
        Entities once = drawn_rectangle({0, 0}, {100, 60}, "frame") + subdivision.cuts, each;
        for (std::size_t k = 0; k < subdivision.cells.size(); ++k)
            each = each + drawn_rectangle(subdivision.cells[k].min, subdivision.cells[k].max, "c" + std::to_string(k) + "s");
        for (Entities* entities : {&once, &each}) {
            shuffle_and_turn(*entities, random);
            place(*entities, random);
        }
        const std::string what = "case " + std::to_string(trial);
        expect_cells(parts_by(once, PartsBy::loop), subdivision, what + ", every line once");
        expect_cells(parts_by(each, PartsBy::loop), subdivision, what + ", every cell by itself");
        if (testing::Test::HasFailure()) return;
    }
}

TEST(SketchFaces, LinesThatCrossAreNamedWhereTheyDo) {
    const SketchParts sketch = parts_by(
        drawn_rectangle({0, 0}, {10, 6}, "s") + Entities{drawn_line({3, 0}, {3, 6}, "up"), drawn_line({0, 2}, {10, 4}, "over")},
        PartsBy::loop);
    ASSERT_EQ(sketch.problems.size(), 1u);
    EXPECT_TRUE(says(sketch.problems[0].what, "lines that share areas on layer 0 cross each other, up and over"))
        << sketch.problems[0].what;
    EXPECT_LT((sketch.problems[0].at - Vec2(3, 2.6)).norm(), 1e-9);
}

TEST(SketchFaces, FindsTheCellsOfSubdivisions) {
    check_subdivisions(150, 1);
}

TEST(LongSketchFaces, FindsTheCellsOfSubdivisions) {
    check_subdivisions(10000, 2);
}

}  // namespace
}  // namespace abut::geometry::sketch_faces_test
