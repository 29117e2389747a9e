// SPDX-License-Identifier: GPL-3.0-or-later
// Where splines are cut into curves, and what their ends are.
#include <gtest/gtest.h>

#include <vector>

#include "geometry/curves/spline_shape.hpp"
#include "tests/geometry/curves/spline_samples.hpp"

namespace spline_corners_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;

TEST(SplineShape, CutAtCornersOnly) {
    // the legs at the double knot: straight on, almost (1e-9), a corner, straight back
    const auto pieces = [](const Vec2& after) {
        return nurbs_curves(with_interior_knots(2, {0.25, 0.25}, {{0, 1}, {-1, 0}, {0, 0}, after, {2, 2}}));
    };
    EXPECT_EQ(pieces({1, 0}).size(), 1u);
    EXPECT_EQ(pieces({3, 0}).size(), 1u);
    EXPECT_EQ(pieces({1, 1e-16}).size(), 1u);
    EXPECT_EQ(pieces({1, 1e-9}).size(), 2u);
    EXPECT_EQ(pieces({1, 1}).size(), 2u);
    EXPECT_EQ(pieces({-0.5, 0}).size(), 2u);
    EXPECT_EQ(shape_of(pieces({1, 0})[0]).breaks, (std::vector<double>{0, 0.25, 1}));
    EXPECT_EQ(shape_of(pieces({1, 1})[0]).breaks, (std::vector<double>{0, 1}));
}

TEST(SplineShape, FullMultiplicityLeavesAGap) {
    std::vector<Vec2> points{{0, 0}, {1, 1}, {2, 0}, {2.5, 0}, {3, 1}, {4, 0}};
    std::vector<Curve> curves = nurbs_curves(with_interior_knots(2, {0.5, 0.5, 0.5}, points));
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(point(curves[0], 1), points[2]);
    EXPECT_EQ(point(curves[1], 0), points[3]);
    points[3] = points[2];
    curves = nurbs_curves(with_interior_knots(2, {0.5, 0.5, 0.5}, points));
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(point(curves[0], 1), point(curves[1], 0));
    points[4] = {3, -1};  // straight on: the gap has closed and nothing is left to cut at
    EXPECT_EQ(nurbs_curves(with_interior_knots(2, {0.5, 0.5, 0.5}, points)).size(), 1u);
}

TEST(SplineShape, CutWhereItStandsStill) {
    // three equal points of a quadratic with simple knots: a span without length between two that stop there
    const Nurbs nurbs = with_interior_knots(2, {0.25, 0.5, 0.75}, {{0, 0}, {1, 1}, {1, 1}, {1, 1}, {2, 0}, {3, 0}});
    ASSERT_EQ(spline_fault(nurbs), "");
    const std::vector<Curve> curves = nurbs_curves(nurbs);
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(point(curves[0], 1), Vec2(1, 1));
    EXPECT_EQ(point(curves[1], 0), Vec2(1, 1));
    EXPECT_EQ(shape_of(curves[0]).breaks.size(), 2u);
    EXPECT_EQ(shape_of(curves[1]).breaks.size(), 3u);
}

TEST(SplineShape, PointsWithoutLengthBehindAGapJoinNothing) {
    // a gap, three equal points, then a span that begins there
    const Nurbs nurbs =
        with_interior_knots(2, {0.25, 0.25, 0.25, 0.5, 0.5}, {{0, 0}, {1, 1}, {2, 0}, {5, 5}, {5, 5}, {5, 5}, {6, 6}, {7, 5}});
    ASSERT_EQ(spline_fault(nurbs), "");
    const std::vector<Curve> curves = nurbs_curves(nurbs);
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(point(curves[0], 1), Vec2(2, 0));
    EXPECT_EQ(point(curves[1], 0), Vec2(5, 5));
}

/// Handles drawn in (control points on the ends) leave tangents that are limits: towards the first point that differs.
TEST(SplineShape, TangentsAtEndsThatStandStill) {
    for (const double noise : {0.0, 1e-16}) {
        const Curve curve = bezier_curve({{1, 2}, {1, 2 + noise}, {3, 3}, {5, 2 - noise}, {5, 2}}, {});
        const auto begin = evaluate(shape_of(curve), 0), end = evaluate(shape_of(curve), 1);
        EXPECT_LE((begin[1].normalized() - Vec2(2, 1).normalized()).norm(), 1e-14) << noise;
        EXPECT_LE((end[1].normalized() - Vec2(2, -1).normalized()).norm(), 1e-14) << noise;
        EXPECT_LT(begin[1].norm(), 1e-13);
        EXPECT_EQ(begin[0], Vec2(1, 2));
        EXPECT_EQ(end[0], Vec2(5, 2));
    }
    const Curve thrice = bezier_curve({{0, 0}, {0, 0}, {0, 0}, {3, 4}}, {1, 2, 3, 4});
    EXPECT_LE((evaluate(shape_of(thrice), 0)[1].normalized() - Vec2(0.6, 0.8)).norm(), 1e-14);
}

TEST(SplineShape, DegreeOneIsSegments) {
    const std::vector<Vec2> corners{{0, 0}, {1, 0}, {2, 0}, {2, 3}};
    const std::vector<Curve> plain = nurbs_curves(with_interior_knots(1, {0.3, 0.6}, corners));
    ASSERT_EQ(plain.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_TRUE(std::holds_alternative<Segment>(plain[i]));
        EXPECT_EQ(std::get<Segment>(plain[i]).from, corners[i]);
        EXPECT_EQ(std::get<Segment>(plain[i]).to, corners[i + 1]);
    }
    Nurbs weighted = with_interior_knots(1, {0.3, 0.6}, corners);
    weighted.weights = {1, 2, 1, 3};
    const std::vector<Curve> rational = nurbs_curves(weighted);
    ASSERT_EQ(rational.size(), 3u);
    for (const Curve& curve : rational) EXPECT_TRUE(std::holds_alternative<Spline>(curve));
    EXPECT_LE((evaluate(shape_of(rational[0]), 0.5)[0] - Vec2(2.0 / 3, 0)).norm(), 1e-15);
    weighted.weights = {2, 2, 2, 2};
    EXPECT_TRUE(std::holds_alternative<Segment>(nurbs_curves(weighted)[0]));
    EXPECT_TRUE(std::holds_alternative<Segment>(bezier_curve({{0, 0}, {1, 2}}, {3, 3})));
    EXPECT_TRUE(std::holds_alternative<Spline>(bezier_curve({{0, 0}, {1, 2}}, {3, 4})));
}

}  // namespace

}  // namespace spline_corners_test
