// SPDX-License-Identifier: GPL-3.0-or-later
// Where a coordinate of a spline is stationary.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/curves/spline_shape.hpp"
#include "tests/geometry/curves/spline_samples.hpp"

namespace spline_stationary_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;

/// Signs of the derivative where it can be told from zero; steps of a dense sampling.
struct SignChanges {
    std::vector<double> from, to;
};
SignChanges sign_changes(const SplineShape& shape, int axis, int n) {
    SignChanges found;
    double last = 0, last_sign = 0;
    for (int k = 0; k <= n; ++k) {
        const double u = static_cast<double>(k) / n, d = evaluate(shape, u)[1][axis];
        if (std::abs(d) < 1e-11) continue;
        const double s = std::copysign(1, d);
        if (s == -last_sign) {
            found.from.push_back(last);
            found.to.push_back(u);
        }
        last = u;
        last_sign = s;
    }
    return found;
}

/// Each change of sign between two samples has its parameter there, each parameter is stationary, and between two of them the
/// sign is one.
void check_stationary(const SplineShape& shape, int axis, int n, const std::string& which) {
    const std::vector<double> found = stationary_parameters(shape, axis);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end())) << which;
    const SignChanges changes = sign_changes(shape, axis, n);
    for (std::size_t i = 0; i < changes.from.size(); ++i) {
        const auto at = std::lower_bound(found.begin(), found.end(), changes.from[i] - 1e-14);
        EXPECT_TRUE(at != found.end() && *at <= changes.to[i] + 1e-14) << which << " lost one after " << changes.from[i];
    }
    for (const double u : found) {
        const auto [x, d, dd] = evaluate(shape, u);
        EXPECT_LE(std::abs(d[axis]), 1e-14 * (d.norm() + dd.norm()) * 16) << which << " at " << u;
        EXPECT_TRUE(u > 0 && u < 1);
    }
}

int n_checked_splines(unsigned seed, int trials) {
    RandomSplines random(seed);
    int n_curves = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const Nurbs nurbs = random(2 + trial % 7, trial % 2 == 0, trial % 3 == 0, trial % 5 < 3);
        if (!spline_fault(nurbs).empty()) continue;
        for (const Curve& curve : nurbs_curves(nurbs)) {
            const auto* spline = std::get_if<Spline>(&curve);
            if (!spline) continue;
            ++n_curves;
            for (const int axis : {0, 1}) check_stationary(*spline->shape, axis, 200, std::to_string(trial));
        }
    }
    return n_curves;
}

TEST(SplineShape, StationaryParametersOfRandomSplines) {
    EXPECT_GT(n_checked_splines(9, 1000), 1000);
}

TEST(LongSplineShape, StationaryParametersOfRandomSplines) {
    EXPECT_GT(n_checked_splines(10, 10000), 10000);
}

TEST(SplineShape, StationaryParametersInClosedForm) {
    // y = x^2 over -1..3
    EXPECT_EQ(stationary_parameters(shape_of(bezier_curve({{-1, 1}, {1, -3}, {3, 9}}, {})), 1), std::vector<double>{0.25});
    EXPECT_TRUE(stationary_parameters(shape_of(bezier_curve({{-1, 1}, {1, -3}, {3, 9}}, {})), 0).empty());
    // y = T_4, the Chebyshev polynomial, on x = 2u - 1: extrema at x = -+ sqrt(1/2) and 0
    const Curve chebyshev = bezier_curve({{-1, 1}, {-0.5, -7}, {0, 11 + 2.0 / 3}, {0.5, -7}, {1, 1}}, {});
    const std::vector<double> found = stationary_parameters(shape_of(chebyshev), 1);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_NEAR(found[0], 0.5 - std::sqrt(0.125), 4e-16);
    EXPECT_NEAR(found[1], 0.5, 4e-16);
    EXPECT_NEAR(found[2], 0.5 + std::sqrt(0.125), 4e-16);
}

TEST(SplineShape, ConstantCoordinatesHaveNoStationaryParameters) {
    const std::vector<Vec2> points{{0, 7}, {1, 7}, {3, 7}, {4, 7}};
    EXPECT_TRUE(stationary_parameters(shape_of(bezier_curve(points, {})), 1).empty());
    EXPECT_TRUE(stationary_parameters(shape_of(bezier_curve(points, {1, 2, 3, 4})), 1).empty());
    // turned to a line of any direction and back: constant but for rounding
    for (int k = 1; k < 30; ++k) {
        const double c = std::cos(k), s = std::sin(k);
        const SplineShape turned = transformed(shape_of(bezier_curve(points, {1, 2, 3, 4})), {c, s, {5, -9}, 1, false});
        const SplineShape back = transformed(turned, {c, -s, {-5, 9}, 1, false});
        EXPECT_TRUE(stationary_parameters(back, 1).empty()) << k;
    }
    // straight, then bent: the break is where it ceases to be constant
    const Curve bent = nurbs_curves(with_interior_knots(2, {0.5}, {{0, 0}, {1, 0}, {2, 0}, {3, 1}})).front();
    EXPECT_EQ(stationary_parameters(shape_of(bent), 1), std::vector<double>{0.5});
}

/// A quarter turn with tangents along the axes at its ends has none inside, wherever it stands.
TEST(SplineShape, TangentsAtTheEndsAreNotInside) {
    const double w = std::sqrt(0.5);
    for (int k = 0; k < 200; ++k) {
        const Vec2 at(0.1 * k - 7.3, std::sqrt(static_cast<double>(k)));
        const Curve quarter = bezier_curve({at + Vec2(1, 0), at + Vec2(1, 1), at + Vec2(0, 1)}, {1, w, 1});
        for (const int axis : {0, 1}) EXPECT_TRUE(stationary_parameters(shape_of(quarter), axis).empty()) << k;
    }
}

}  // namespace

}  // namespace spline_stationary_test
