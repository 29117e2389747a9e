// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines that turn one way only.
#include "geometry/sketch/sketch_winding.hpp"

#include <random>

#include "geometry/csg/exact_outline.hpp"
#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::sketch_winding_test {
namespace {

constexpr double pi = std::numbers::pi;

Part loop_of(const std::vector<Curve>& curves) {
    Part part;
    part.loops.emplace_back();
    for (const Curve& curve : curves) {
        part.loops[0].edges.push_back(static_cast<int>(part.edges.size()));
        part.edges.push_back({curve, {}, {}, true, 0.0});
    }
    return part;
}

Part polygon(const std::vector<Vec2>& corners) {
    std::vector<Curve> sides;
    for (std::size_t k = 0; k < corners.size(); ++k) sides.push_back(Segment{corners[k], corners[(k + 1) % corners.size()]});
    return loop_of(sides);
}

TEST(SketchWinding, ConvexOutlinesAreKnown) {
    EXPECT_TRUE(is_convex(polygon({{0, 0}, {4, 0}, {4, 3}, {0, 3}})));
    EXPECT_TRUE(is_convex(polygon({{0, 0}, {2, 0}, {4, 0}, {4, 3}, {0, 3}})));  // a joint along a side
    EXPECT_TRUE(is_convex(loop_of({Arc{{1, 2}, 3, 0.5, 2 * pi}})));
    EXPECT_TRUE(is_convex(loop_of({EllipticArc{{0, 0}, {2, 1}, {-0.1, 0.2}, 0, 2 * pi}})));
    EXPECT_TRUE(is_convex(
        loop_of({Segment{{0, 0}, {4, 0}}, Arc{{4, 1}, 1, -pi / 2, pi}, Segment{{4, 2}, {0, 2}}, Arc{{0, 1}, 1, pi / 2, pi}})));
}

TEST(SketchWinding, AllElseIsNot) {
    EXPECT_FALSE(is_convex(polygon({{0, 0}, {0, 3}, {4, 3}, {4, 0}})));            // clockwise
    EXPECT_FALSE(is_convex(polygon({{0, 0}, {4, 0}, {4, 3}, {2, 2.9}, {0, 3}})));  // a notch
    EXPECT_FALSE(is_convex(polygon({{0, 0}, {4, 3}, {4, 0}, {0, 3}})));            // crossed
    std::vector<Vec2> star;
    for (int k = 0; k < 5; ++k) star.emplace_back(std::cos(4 * pi * k / 5), std::sin(4 * pi * k / 5));
    EXPECT_FALSE(is_convex(polygon(star)));                                      // left all along, twice around
    EXPECT_FALSE(is_convex(polygon({{0, 0}, {4, 0}, {4, 1e-12}, {0, 1e-12}})));  // a sliver
    EXPECT_FALSE(is_convex(loop_of({Segment{{0, 0}, {4, 0}}, Segment{{4.1, 0}, {4, 3}}, Segment{{4, 3}, {0, 0}}})));  // open
    EXPECT_FALSE(is_convex(loop_of({Arc{{0, 0}, 1, 0, -2 * pi}})));
}

/// What is convex is right in exact arithmetic, too, and every convex hull is.
TEST(SketchWinding, AgreesWithExactArithmetic) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    int n_convex = 0;
    for (int k = 0; k < 300; ++k) {
        std::vector<Vec2> corners(static_cast<std::size_t>(3 + k % 3));
        for (Vec2& p : corners) p = {coordinate(random), coordinate(random)};
        const Part part = polygon(corners);
        if (!is_convex(part)) continue;
        ++n_convex;
        EXPECT_FALSE(exact_fault(part));
    }
    EXPECT_GT(n_convex, 50);
}

}  // namespace
}  // namespace abut::geometry::sketch_winding_test
