// SPDX-License-Identifier: GPL-3.0-or-later
// What two parts have in common, against the Boolean of the trees that they come from. On the lattice of random trees edges and
// corners coincide often; where the trees are turned they coincide but for rounding.
#include "geometry/csg/overlap.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "geometry/csg/common_boundary.hpp"
#include "tests/geometry/csg/csg_nodes.hpp"
#include "tests/geometry/csg/random_csg_scene.hpp"

namespace abut::geometry::overlap_test {
namespace {

using namespace csg_nodes;

/// Of the size: below it two parts touch.
constexpr double touching = 1e-9;
/// Of the size squared: where arcs touch tangentially, rounding decides on the root of it along them.
constexpr double area_error = 1.5e-8;

/// How many of the pairs have something in common.
int expect_areas_of_booleans(unsigned first_seed, unsigned n, Leaves leaves) {
    int n_common = 0;
    for (unsigned seed = first_seed; seed < first_seed + n; ++seed) {
        std::mt19937 random(seed);
        int name = 0;
        CsgNode a = random_tree(random, leaves, name), b = random_tree(random, leaves, name);
        if (seed % 2)
            for (CsgNode* node : {&a, &b}) *node = turned(std::move(*node), 17.3, {3.25, -1});
        const CsgResult first = evaluate(a), second = evaluate(b);
        if (!first.problems.empty() || !second.problems.empty()) continue;
        const CsgResult both = evaluate(common({a, b}));
        const double expected = both.problems.empty() ? area(both.part) : 0;
        Box2 box = bounding_box(first.part);
        box.extend(bounding_box(second.part).min);
        box.extend(bounding_box(second.part).max);
        const double size = box.diagonal();
        const Overlap found = overlap(first.part, second.part, touching * size);
        EXPECT_NEAR(found.area, expected, area_error * size * size) << "seed " << seed << "\n" << tree_text(common({a, b}));
        EXPECT_EQ(found.area > 0, found.depth > 0) << "seed " << seed;
        n_common += expected > 0;
    }
    return n_common;
}

TEST(ExactOverlap, AreasAreThoseOfBooleans) {
    EXPECT_GT(expect_areas_of_booleans(1, 1000, Leaves::lines_and_circles), 150);
    EXPECT_GT(expect_areas_of_booleans(1, 200, Leaves::all), 30);
}

TEST(LongExactOverlap, AreasAreThoseOfBooleans) {
    EXPECT_GT(expect_areas_of_booleans(5001, 10000, Leaves::lines_and_circles), 1500);
    EXPECT_GT(expect_areas_of_booleans(5001, 2000, Leaves::all), 300);
}

TEST(ExactOverlap, OfAnyDepthIsFound) {
    const auto block = [](double x0, double x1) { return evaluate(rectangle(x0, 0, x1, 1)).part; };
    for (const double depth : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
        const Overlap found = overlap(block(0, 1), block(1 - depth, 2), 0);
        EXPECT_NEAR(found.depth, depth, 2e-16) << depth;
        EXPECT_NEAR(found.area, depth, 1e-15) << depth;
        EXPECT_EQ(overlap(block(0, 1), block(1 - depth, 2), 1.1 * depth).area, 0) << depth;
    }
    EXPECT_EQ(overlap(block(0, 1), block(1, 2), 0).area, 0) << "they touch";
}

TEST(ExactOverlap, LoopsAreOverlapsOfTheirOwn) {
    for (const double turn : {0.0, 17.0}) {
        const auto base = evaluate(place(rectangle(0, 0, 40, 5), turn, {1, 2})).part;
        const auto stool =
            evaluate(place(join({rectangle(2, 4.5, 8, 8), rectangle(30, 4.8, 36, 8), rectangle(2, 7, 36, 12)}), turn, {1, 2}))
                .part;
        std::vector<Overlap> feet = overlaps(base, stool, 1e-9);
        ASSERT_EQ(feet.size(), 2u) << turn;
        if (feet[0].depth < feet[1].depth) std::swap(feet[0], feet[1]);
        EXPECT_NEAR(feet[0].depth, 0.5, 1e-9) << turn;
        EXPECT_NEAR(feet[0].area, 3, 1e-9) << turn;
        EXPECT_NEAR(feet[1].depth, 0.2, 1e-9) << turn;
        EXPECT_NEAR(feet[1].area, 1.2, 1e-9) << turn;
        const Overlap whole = overlap(base, stool, 1e-9), both = geometry::joined(feet);
        EXPECT_EQ(both.depth, whole.depth) << turn;
        EXPECT_NEAR(both.area, whole.area, 1e-9) << turn;
        EXPECT_EQ(both.edge1, whole.edge1) << turn;
    }
    const auto plate = evaluate(rectangle(-3, -3, 3, 3)).part, disc = evaluate(circle(0.1, 0.2, 1)).part;
    EXPECT_EQ(overlaps(plate, disc, 1e-9).size(), 1u);
    EXPECT_TRUE(overlaps(plate, evaluate(rectangle(3, -3, 5, 3)).part, 1e-9).empty());
}

TEST(ExactOverlap, ThePinOfItsHoleHasNothingInCommonWithIt) {
    const auto plate = evaluate(less({rectangle(-3, -3, 3, 3), circle(0.1, 0.2, 1)})).part;
    EXPECT_TRUE(common_boundary(plate, evaluate(rectangle(-3, -5, 3, -3)).part, 0).empty()) << "beside it";
    for (const double angle : {0.0, 17.0, 90.0}) {
        const auto pin = evaluate(place(circle(0, 0, 1), angle, {0.1, 0.2})).part;
        EXPECT_EQ(overlap(plate, pin, 1e-12).area, 0) << angle;
        const auto thick = evaluate(place(circle(0, 0, 1 + 1e-10), angle, {0.1, 0.2})).part;
        EXPECT_NEAR(overlap(plate, thick, 1e-12).area, 2 * std::numbers::pi * 1e-10, 1e-15) << angle;
        EXPECT_NEAR(overlap(plate, thick, 1e-12).depth, 1e-10, 1e-15) << angle;
    }
}

}  // namespace
}  // namespace abut::geometry::overlap_test
