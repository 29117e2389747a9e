// SPDX-License-Identifier: GPL-3.0-or-later
// Arc lengths of splines.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/curves/spline_shape.hpp"
#include "tests/geometry/curves/spline_samples.hpp"

namespace spline_length_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;
using std::numbers::pi;

/// y = x^2 from x0 to x1: x/2 sqrt(1 + 4x^2) + asinh(2x)/4.
double parabola_length(double x0, double x1) {
    const auto primitive = [](double x) { return 0.5 * x * std::sqrt(1 + 4 * x * x) + 0.25 * std::asinh(2 * x); };
    return primitive(x1) - primitive(x0);
}

TEST(SplineShape, LengthOfTheParabola) {
    const Curve curve = bezier_curve({{-1, 1}, {1, -3}, {3, 9}}, {});
    const SplineShape& shape = shape_of(curve);
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j)
            EXPECT_NEAR(length(shape, i / 20.0, j / 20.0), parabola_length(-1 + i / 5.0, -1 + j / 5.0),
                        1e-14 * shape.arc_length[1]);
}

TEST(SplineShape, LengthOfCircularArcs) {
    const Curve curve = nurbs_curves(circle()).front();
    const SplineShape& shape = shape_of(curve);
    const auto angle = [&](double u) {
        const Vec2 x = evaluate(shape, u)[0];
        const double a = std::atan2(x.y(), x.x());
        return a < 0 || u == 1 ? a + 2 * pi : a;
    };
    for (int i = 0; i <= 30; ++i)
        for (int j = 0; j <= 30; ++j) {
            const double u = i / 30.0, v = j / 30.0;
            EXPECT_NEAR(length(shape, u, v), (v == 1 ? 2 * pi : angle(v)) - (u == 1 ? 2 * pi : angle(u)), 2e-14)
                << u << " " << v;
        }
}

/// The sum is that of its parts, and chords extrapolated twice (error of the sixth order) give the same on smooth spans.
TEST(SplineShape, LengthOfRandomSplines) {
    RandomSplines random(8);
    for (int trial = 0; trial < 24; ++trial) {
        const Curve curve = nurbs_curves(random(2 + trial % 7, trial % 2 == 0, false, trial % 3 == 0)).front();
        const SplineShape& shape = shape_of(curve);
        const double total = length(shape, 0, 1);
        EXPECT_NEAR(total, length_by_chords(shape, 1000), 1e-9 * total) << trial;
        for (int k = 0; k < 10; ++k) {
            const double u = random.unit(), v = random.unit();
            EXPECT_NEAR(length(shape, 0, u) + length(shape, u, v) + length(shape, v, 1), total, 4e-14 * total) << trial;
            EXPECT_EQ(length(shape, u, v), -length(shape, v, u));
        }
    }
}

}  // namespace

}  // namespace spline_length_test
