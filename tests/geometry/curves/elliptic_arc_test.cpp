// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/elliptic_arc.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace elliptic_arc_test {

namespace {

using namespace abut::geometry;
constexpr double pi = std::numbers::pi;

TEST(EllipticArc, PointsAtQuarterTurnsAreExact) {
    const Vec2 c(0.3, -7), a(1.7, 0.2), b(-0.1, 0.85);
    const Vec2 at[] = {c + a, c + b, c - a, c - b};
    for (int from = -4; from <= 4; ++from)
        for (int sign : {1, -1})
            for (int k = 0; k <= 4; ++k) {
                const EllipticArc arc{c, a, b, from * pi / 2, sign * 2 * pi};
                EXPECT_EQ(evaluate(arc, k / 4.0)[0], at[((from + sign * k) % 4 + 4) % 4]) << from << " " << sign << " " << k;
            }
}

/// A hair beside a quarter turn is not one.
TEST(EllipticArc, PointsBesideQuarterTurnsAreNotSnapped) {
    const EllipticArc arc{{0, 0}, {1, 0}, {0, 1}, pi / 2, 1};
    EXPECT_EQ(evaluate(arc, 0)[0].x(), 0);
    EXPECT_NEAR(evaluate(arc, 1e-13)[0].x(), -1e-13, 1e-15);
}

/// The conjugate half diameters' own points, at the angles shifted by one and the same; axes at a right angle to rounding.
void expect_conjugate(const Vec2& p, const Vec2& q, double tolerance) {
    const Vec2 center(1, 2);
    const EllipticArc arc = from_conjugate(center, p, q, 0.4, 5);
    EXPECT_LE(std::abs(arc.a.dot(arc.b)), 4e-16 * arc.a.norm() * arc.b.norm());
    EXPECT_NEAR(cross(arc.a, arc.b), cross(p, q), 1e-15 * p.norm() * q.norm());
    EXPECT_EQ(arc.sweep, 5);
    for (int i = 0; i <= 20; ++i) {
        const double u = 0.4 + i / 20.0 * 5;
        const Vec2 expected = center + std::cos(u) * p + std::sin(u) * q;
        EXPECT_LE((evaluate(arc, i / 20.0)[0] - expected).norm(), tolerance * (p.norm() + q.norm()));
    }
}

TEST(EllipticArc, FromConjugateDiametersKeepsThePoints) {
    std::mt19937 random(23);
    std::uniform_real_distribution<double> any(-2, 2);
    for (int k = 0; k < 500; ++k) expect_conjugate({any(random), any(random)}, {any(random), any(random)}, 1e-14);
    for (double skew : {1e-3, 1e-6, 1e-9, -1e-9}) {  // nearly parallel, and nearly at a right angle
        expect_conjugate({1, 0.5}, {1, 0.5 + skew}, 1e-14);
        expect_conjugate({1, 0.5}, {2, 1 + skew}, 1e-14);
        expect_conjugate({1, 0}, {skew, 3}, 1e-14);
        expect_conjugate({1, 0}, {skew, 1}, 1e-14);
        expect_conjugate({0.6, 0.8}, {0.8, -0.6 + skew}, 1e-14);
    }
}

TEST(EllipticArc, FromConjugateLeavesAxesAlone) {
    const EllipticArc arc = from_conjugate({0, 0}, {0.5, 0}, {0, -2}, 0.1, -3);
    EXPECT_EQ(arc.a, Vec2(0.5, 0));
    EXPECT_EQ(arc.b, Vec2(0, -2));
    EXPECT_EQ(arc.start, 0.1);
}

/// The derivative's component vanishes there, and changes its sign nowhere else.
TEST(EllipticArc, StationaryParametersAreAllThereAre) {
    std::mt19937 random(29);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int k = 0; k < 300; ++k) {
        const double angle = 4 * any(random), aspect = std::pow(10, -1.5 * (1 + any(random)));
        const Vec2 a(std::cos(angle), std::sin(angle));
        const EllipticArc arc{{0, 0}, a, (k % 2 ? -aspect : aspect) * left_of(a), 7 * any(random), 2 * pi * any(random)};
        for (const int axis : {0, 1}) {
            std::vector<double> ends = stationary_parameters(arc, axis);
            const double extent = std::abs(arc.sweep) * std::hypot(arc.a[axis], arc.b[axis]);
            for (const double t : ends) EXPECT_NEAR(evaluate(arc, t)[1][axis], 0, 2e-14 * extent);
            ends.insert(ends.begin(), 0);
            ends.push_back(1);
            for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
                ASSERT_LT(ends[i], ends[i + 1]);
                const double sign = evaluate(arc, 0.5 * (ends[i] + ends[i + 1]))[1][axis];
                for (int j = 1; j < 20; ++j)
                    EXPECT_GT(sign * evaluate(arc, ends[i] + (ends[i + 1] - ends[i]) * j / 20)[1][axis], 0);
            }
        }
    }
}

/// An end at an extremum, but for rounding, is not one once more inside.
TEST(EllipticArc, EndsAreNoStationaryParameters) {
    const Vec2 a(0.6, 0.8), b(-0.4, 0.3);
    for (const int axis : {0, 1}) {
        const double root = std::atan2(b[axis], a[axis]);
        for (double nudge : {-4e-16, -1e-16, 0.0, 1e-16, 4e-16})
            for (int turns = -2; turns <= 2; ++turns) {
                const double start = root + turns * pi + nudge;
                EXPECT_EQ(stationary_parameters({{0, 0}, a, b, start, pi}, axis).size(), 0u);
                EXPECT_EQ(stationary_parameters({{0, 0}, a, b, start, -2 * pi}, axis).size(), 1u);
            }
    }
}

}  // namespace

}  // namespace elliptic_arc_test
