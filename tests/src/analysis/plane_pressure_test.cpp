// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/plane_pressure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace abut::plane_pressure_test {
namespace {

constexpr double a = 0.3, middle = 2, force = 7;

/// By the trapezoidal rule over the angle, exact for sines.
double integral(const PlaneStretch& stretch) {
    constexpr int n = 200;
    double sum = 0;
    for (int i = 1; i < n; ++i) {
        const double t = std::numbers::pi * i / n;
        sum += pressure_at(stretch, stretch.middle + stretch.half_width * std::cos(t)) * std::sin(t);
    }
    return sum * stretch.half_width * std::numbers::pi / n;
}

}  // namespace

TEST(PlanePressure, OfParabolasIsHertz) {
    const auto stretch = plane_stretch([](double x) { return x / 40; }, middle, a, force);
    ASSERT_TRUE(stretch);
    const double p0 = 2 * force / (std::numbers::pi * a);
    for (double u : {-0.99, -0.5, 0.0, 0.3, 0.8, 0.999})
        EXPECT_NEAR(pressure_at(*stretch, middle + u * a), p0 * std::sqrt(1 - u * u), 1e-12 * p0) << u;
    EXPECT_EQ(pressure_at(*stretch, middle + 1.01 * a), 0);
    EXPECT_EQ(pressure_at(*stretch, middle - 1.01 * a), 0);
}

/// A gap that grows with x^4 [Galin1953]: p is in proportion to (a^2 / 2 + x^2) sqrt(a^2 - x^2).
TEST(PlanePressure, OfQuartics) {
    const auto stretch = plane_stretch([](double x) { return x * x * x; }, middle, a, force);
    ASSERT_TRUE(stretch);
    const double at_middle = pressure_at(*stretch, middle);
    for (double u : {-0.9, 0.2, 0.7})
        EXPECT_NEAR(pressure_at(*stretch, middle + u * a), at_middle * (1 + 2 * u * u) * std::sqrt(1 - u * u),
                    1e-12 * at_middle);
    EXPECT_NEAR(integral(*stretch), force, 1e-3 * force);
}

TEST(PlanePressure, CarriesTheForce) {
    const auto stretch = plane_stretch([](double x) { return std::sinh(3 * x); }, middle, a, force);
    ASSERT_TRUE(stretch);
    EXPECT_NEAR(integral(*stretch), force, 1e-3 * force);
}

TEST(PlanePressure, OfWedgesJointsAndUnknownGapsIsUnknown) {
    EXPECT_FALSE(plane_stretch([](double) { return 0.1; }, middle, a, force));
    EXPECT_FALSE(plane_stretch([](double x) { return std::max(0.0, x - 0.5 * a); }, middle, a, force));
    EXPECT_FALSE(plane_stretch([](double x) { return -x; }, middle, a, force));
    EXPECT_FALSE(plane_stretch([](double) { return std::nullopt; }, middle, a, force));
}

}  // namespace abut::plane_pressure_test
