// SPDX-License-Identifier: GPL-3.0-or-later
// What can be wrong with a spline.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/curves/spline_shape.hpp"
#include "tests/geometry/curves/spline_samples.hpp"

namespace spline_fault_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;

TEST(SplineShape, BezierFaults) {
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1}, {2, 0}}, {}), "");
    EXPECT_EQ(bezier_fault({{0, 0}}, {}), "it has 1 points, possible are 2 to 9");
    EXPECT_EQ(bezier_fault(std::vector<Vec2>(10, {1, 1}), {}), "it has 10 points, possible are 2 to 9");
    EXPECT_EQ(bezier_fault({{0, 0}, {inf, 1}, {2, 0}}, {}), "points[1] is not finite");
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1}, {2, 0}}, {1, 2}), "it has 2 weights for 3 points");
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1}, {2, 0}}, {1, 0, 1}), "weights[1] is 0, weights must be positive");
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1}, {2, 0}}, {1, 1, -2}), "weights[2] is -2, weights must be positive");
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1}, {2, 0}}, {1, std::nan(""), 1}), "weights[1] is not finite");
    EXPECT_EQ(bezier_fault({{4, 3}, {4, 3}, {4, 3}}, {}), "all its points are equal");
}

TEST(SplineShape, CuspsAreFaults) {
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1}, {0, 1}, {1, 0}}, {}), "it has a cusp at parameter 0.5, cut it there");
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1.1}, {0, 1}, {1, 0}}, {}), "");
    EXPECT_EQ(bezier_fault({{0, 0}, {2, 0}, {0, 0}}, {}), "it has a cusp at parameter 0.5, cut it there");  // there and back
    EXPECT_EQ(bezier_fault({{0, 0}, {2, 3}, {0, 0}}, {1, 3, 1}), "it has a cusp at parameter 0.5, cut it there");
    // (t - 1/3)^3 in both directions: stands still and goes on
    std::vector<Vec2> line;
    for (const double y : {-1.0 / 27, 2.0 / 27, -4.0 / 27, 8.0 / 27}) line.push_back({y, 2 * y});
    EXPECT_EQ(bezier_fault(line, {}), "it has a cusp at parameter 0.333333, cut it there");
    // a span's inner cusp is found at its knot parameter, wherever the curve is turned to
    for (int k = 0; k < 40; ++k) {
        const double c = std::cos(k), s = std::sin(k);
        Nurbs nurbs = with_interior_knots(3, {0.5, 0.5, 0.5}, {{-2, 1}, {-1, 0}, {-1, -1}, {0, 0}, {1, 1}, {0, 1}, {1, 0}});
        for (Vec2& p : nurbs.points) p = Similarity{c, s, {3, 1}, 1, false}(p);
        EXPECT_EQ(spline_fault(nurbs), "it has a cusp at parameter 0.75, cut it there") << k;
    }
}

TEST(SplineShape, NurbsFaults) {
    const std::vector<Vec2> four{{0, 0}, {1, 1}, {2, 0}, {3, 1}};
    const auto fault = [](int degree, std::vector<double> knots, std::vector<Vec2> points, std::vector<double> weights = {}) {
        return spline_fault({degree, std::move(knots), std::move(points), std::move(weights)});
    };
    EXPECT_EQ(fault(3, {0, 0, 0, 0, 1, 1, 1, 1}, four), "");
    EXPECT_EQ(fault(0, {0, 1}, four), "its degree is 0, possible are 1 to 8");
    EXPECT_EQ(fault(9, {0, 1}, four), "its degree is 9, possible are 1 to 8");
    EXPECT_EQ(fault(3, {0, 0, 0, 0, 1, 1, 1}, four), "it has 7 knots, 4 points of degree 3 need 8");
    EXPECT_EQ(fault(4, {0, 0, 0, 0, 1, 1, 1, 1}, four), "it has 4 points, degree 4 needs at least 5");
    EXPECT_EQ(fault(2, {0, 0, 0, -1, 1, 1, 1}, four), "knots[3] is -1, less than the one before it (0)");
    EXPECT_EQ(fault(2, {0, 0, 0, std::nan(""), 1, 1, 1}, four), "knots[3] is not finite");
    EXPECT_EQ(fault(2, {0, 0, 0, 0, 1, 1, 1}, four), "knot 0 stands there 4 times, degree 2 allows 3");
    EXPECT_EQ(fault(2, {0, 1, 2, 2, 2, 3, 4}, four), "its parameter range is empty: knots[2] and knots[4] are both 2");
    EXPECT_EQ(fault(3, {0, 0, 0, 0, 1, 1, 1, 1}, four, {1, 1, 1}), "it has 3 weights for 4 points");
    EXPECT_EQ(fault(3, {0, 0, 0, 0, 1, 1, 1, 1}, four, {1, 1, -1, 1}), "weights[2] is -1, weights must be positive");
    EXPECT_EQ(fault(2, {0, 0, 0, 0.5, 1, 1, 1}, {{1, 1}, {1, 1}, {1, 1}, {1, 1}}), "all its points are equal");
    EXPECT_EQ(fault(1, {0, 0, 1, 1}, {{0, 0}, {std::nan(""), 0}}), "points[1] is not finite");
    // knots a rounding apart are one knot
    EXPECT_EQ(fault(2, {0, 0, 0, 1, 1, std::nextafter(1, 2), std::nextafter(1, 2)}, four),
              "knot 1 stands there 4 times, degree 2 allows 3");
}

}  // namespace

}  // namespace spline_fault_test
