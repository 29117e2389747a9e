// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/closest_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/curves/spline_shape.hpp"
#include "tests/geometry/curves/sample_curves.hpp"

namespace abut::geometry::closest_points_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double exact = 1e-13;

using test::ellipse;
using test::of_one_edge;

TEST(ClosestPointsGeneral, EllipseAndLineBySupport) {
    for (int k = 0; k < 60; ++k) {
        const double angle = 2 * pi * k / 60 + 0.01, h = 3 + 0.01 * k;
        const Vec2 n(std::cos(angle), std::sin(angle));
        const double support = std::hypot(2 * n.x(), 0.5 * n.y());  // of x^2/4 + 4 y^2 = 1
        const Segment line{h * n - 9 * left_of(n), h * n + 7 * left_of(n)};
        const ClosestPoints c = closest_points(ellipse({0, 0}, 2, 0.5), line);
        EXPECT_NEAR(c.distance, h - support, exact);
        EXPECT_NEAR((c.x1 - Vec2(4 * n.x(), 0.25 * n.y()) / support).norm(), 0, 1e-11);
        EXPECT_NEAR((c.x2 - c.x1).norm(), c.distance, exact);
        EXPECT_NEAR((point(line, c.t2) - c.x2).norm(), 0, exact);
    }
}

TEST(ClosestPointsGeneral, TouchingAndCrossingAreZero) {
    const EllipticArc e = ellipse({0, 0}, 2, 1);
    EXPECT_NEAR(closest_points(e, ellipse({4, 0}, 2, 1)).distance, 0, exact);
    EXPECT_NEAR(closest_points(e, ellipse({1, 0.4}, 2, 1)).distance, 0, exact);
    EXPECT_NEAR(closest_points(e, e).distance, 0, exact);
    const ClosestPoints gap = closest_points(e, ellipse({4 + 1e-9, 0}, 2, 1));
    EXPECT_NEAR(gap.distance, 1e-9, 1e-15);
    EXPECT_NEAR((gap.x1 - Vec2(2, 0)).norm(), 0, 1e-11);
}

/// Global minimum by samples of one curve: from above within rounding, from below by the samples' spacing.
void expect_global(int n_cases, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1), weight(0.3, 3);
    const auto spline = [&](int n, bool rational, const Vec2& shift) {
        std::vector<Vec2> points;
        std::vector<double> weights;
        for (int i = 0; i < n; ++i) points.emplace_back(shift + Vec2(coordinate(random), coordinate(random)));
        for (int i = 0; i < n && rational; ++i) weights.push_back(weight(random));
        return bezier_curve(points, weights);
    };
    int apart = 0;
    for (int k = 0; k < n_cases; ++k) {
        const Vec2 shift(1.5 + coordinate(random), 1.5 * coordinate(random));
        const Curve a = spline(3 + k % 4, k % 2 == 0, {0, 0});
        const Curve b = k % 3 == 0   ? Curve(ellipse(shift, 0.8, 0.3, coordinate(random)))
                        : k % 3 == 1 ? Curve(Arc{shift, 0.7, 3 * coordinate(random), 2})
                                     : spline(4, false, shift);
        const ClosestPoints c = closest_points(a, b);
        EXPECT_NEAR((point(a, c.t1) - point(b, c.t2)).norm(), c.distance, exact);
        constexpr int n = 200;
        double sampled = 1e300, spacing = 0;
        for (int j = 0; j <= n; ++j) {
            const Vec2 p = point(a, static_cast<double>(j) / n);
            sampled = std::min(sampled, (point(b, closest_parameter(b, p)) - p).norm());
            if (j > 0) spacing = std::max(spacing, length(a, static_cast<double>(j - 1) / n, static_cast<double>(j) / n));
        }
        EXPECT_LE(c.distance, sampled + exact) << k;
        EXPECT_GE(c.distance, sampled - spacing) << k;
        const ClosestPoints back = closest_points(b, a);
        EXPECT_NEAR(back.distance, c.distance, exact) << k;
        // where the curves do not meet, the line between them is normal to each, or ends at an end
        if (c.distance < 1e-3) continue;
        ++apart;
        const Vec2 u = (c.x2 - c.x1) / c.distance;
        if (c.t1 > 0 && c.t1 < 1) { EXPECT_NEAR(u.dot(unit_tangent(a, c.t1)), 0, 1e-9) << k; }
        if (c.t2 > 0 && c.t2 < 1) { EXPECT_NEAR(u.dot(unit_tangent(b, c.t2)), 0, 1e-9) << k; }
        if (::testing::Test::HasFailure()) FAIL() << "case " << k;
    }
    EXPECT_GT(apart, n_cases / 4);
}

TEST(ClosestPointsGeneral, RandomCurvesAgainstSamples) {
    expect_global(60, 4);
}
TEST(LongClosestPoints, RandomCurvesAgainstSamples) {
    expect_global(10000, 5);
}

TEST(ClosestPointsGeneral, PartsWithinALimit) {
    const Part a = of_one_edge(ellipse({0, 0}, 2, 1)), b = of_one_edge(ellipse({5, 0}, 2, 1));
    const auto near = closest_points(a, b, 1.5);
    ASSERT_TRUE(near);
    EXPECT_NEAR(near->distance, 1, exact);
    EXPECT_EQ(near->edge1, 0);
    EXPECT_FALSE(closest_points(a, b, 0.99));
}

}  // namespace
}  // namespace abut::geometry::closest_points_test
