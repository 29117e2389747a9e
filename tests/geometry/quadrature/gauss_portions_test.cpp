// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/gauss_portions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/curves/gauss.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace gauss_portions_test {

namespace {

using namespace abut::geometry;
constexpr double pi = std::numbers::pi;

/// A quarter of the unit circle as a rational curve, the first and last weight times `low`: the same points, reached unevenly.
Curve uneven_quarter(double low) {
    return bezier_curve({{1, 0}, {1, 1}, {0, 1}}, {low * low, low * std::sqrt(0.5), 1});
}

TEST(GaussPortions, WeightsOfAnyRatioAreHalvedUntilTheRuleHolds) {
    for (int digits = 0; digits <= 6; ++digits) {
        const Curve curve = uneven_quarter(std::pow(10.0, -digits));
        std::vector<GaussPortion> portions;
        append_area_portions(portions, curve, 0, 1, 2, {1, 1});
        double sum = 0, t = 0;
        int n_points = 0;
        for (const GaussPortion& portion : portions) {
            EXPECT_EQ(portion.t0, t);
            t = portion.t1;
            n_points += portion.n;
            const GaussRule& rule = gauss_rule(portion.n);
            for (std::size_t i = 0; i < rule.points.size(); ++i) {
                const double at = portion.t0 + rule.points[i] * (portion.t1 - portion.t0);
                const Vec2 p = point(curve, at);
                sum += rule.weights[i] * (portion.t1 - portion.t0) * derivative(curve, at).y() * std::pow(p.x(), 5) *
                       std::pow(p.y(), 4) / 5;
            }
        }
        EXPECT_EQ(t, 1);
        // the integral of sin^4 cos^6 over a quarter turn is 3 pi / 512
        EXPECT_NEAR(sum, 3 * pi / 512 / 5, 1e-15) << digits;
        EXPECT_LT(n_points, 60 + 300 * digits);
    }
}

/// Not more than the degree of the integrand asks for, and less on short portions.
TEST(GaussPortions, PolynomialsTakeTheirExactCountAtMost) {
    for (int n = 2; n <= max_spline_degree; ++n) {
        std::vector<Vec2> points;
        for (int i = 0; i <= n; ++i) points.emplace_back(i, std::sin(2.0 * i));
        const Curve curve = bezier_curve(points, {});
        for (int degree = 1; degree <= 4; ++degree) {
            std::vector<GaussPortion> portions;
            append_area_portions(portions, curve, 0, 1, degree, {1, 1});
            ASSERT_EQ(portions.size(), 1u);
            EXPECT_LE(portions[0].n, n * (2 * degree + 1));
            append_area_portions(portions, curve, 0.5, 0.501, degree, {1, 1});
            EXPECT_LE(portions[1].n, portions[0].n);
        }
        std::vector<GaussPortion> portions;
        append_area_portions(portions, curve, 0.5, 0.501, 4, {1, 1});
        EXPECT_LT(portions[0].n, 20);  // 9 times 8 for the whole of degree 8
    }
}

}  // namespace

}  // namespace gauss_portions_test
