// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curve.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace {

using namespace abut::geometry;
constexpr double pi = std::numbers::pi;

/// Segments and arcs of both directions: short, longer than half a turn, full, with ends on and off the quarter turns.
std::vector<Curve> curves() {
    return {Segment{{1, 2}, {4, -2}},   Segment{{0, 0}, {0, 3}},       Segment{{5, 1}, {-2, 1}},
            Arc{{1, -2}, 1.5, 0.3, 1},  Arc{{1, -2}, 1.5, 0.3, -1},    Arc{{0, 0}, 2, -1, 5},
            Arc{{0, 0}, 2, 7, -4.5},    Arc{{3, 1}, 0.5, 0, pi / 2},   Arc{{3, 1}, 0.5, pi / 2, pi},
            Arc{{-1, 1}, 1, 0, 2 * pi}, Arc{{-1, 1}, 1, -2.5, -2 * pi}};
}

std::vector<double> parameters() {
    return {0, 0.1, 0.25, 0.5, 0.77, 1};
}

void expect_near(const Vec2& a, const Vec2& b, double tolerance) {
    EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " against " << b.transpose();
}

double distance(const Curve& curve, const Vec2& p, double t) {
    return (point(curve, t) - p).norm();
}

TEST(Curve, PointsInClosedForm) {
    const Curve segment = Segment{{1, 2}, {4, -2}};
    expect_near(point(segment, 0.25), {1.75, 1}, 0);
    EXPECT_EQ(point(segment, 1), Vec2(4, -2));
    const Curve arc = Arc{{1, -2}, 2, pi / 6, pi / 3};
    expect_near(point(arc, 0), {1 + std::sqrt(3.0), -1}, 1e-15);
    expect_near(point(arc, 0.5), {2, -2 + std::sqrt(3.0)}, 1e-15);
    expect_near(point(arc, 1), {1, 0}, 1e-15);
}

/// A segment ends bit for bit where it was told to: neighbours share the vertex.
TEST(Curve, SegmentsEndExactly) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1e3, 1e3);
    for (int k = 0; k < 200; ++k) {
        const Segment s{{any(random), any(random)}, {any(random), any(random)}};
        EXPECT_EQ(point(s, 0), s.from);
        EXPECT_EQ(point(s, 1), s.to);
    }
}

TEST(Curve, DerivativeAgainstDifferences) {
    const double h = 1e-5;  // central: h^2 / 6 of the third derivative (250 at most), and rounding over h: 1e-16 * 5 / h
    for (const Curve& curve : curves())
        for (double t : parameters())
            expect_near(derivative(curve, t), (point(curve, t + h) - point(curve, t - h)) / (2 * h), 5e-9);
}

TEST(Curve, TangentNormalAndCurvatureAgainstDifferences) {
    const double h = 1e-5;
    for (const Curve& curve : curves())
        for (double t : parameters()) {
            const Vec2 d = derivative(curve, t);
            const Vec2 tangent = unit_tangent(curve, t), normal = outward_normal(curve, t);
            expect_near(tangent * d.norm(), d, 1e-14);
            EXPECT_NEAR(tangent.norm(), 1, 1e-15);
            EXPECT_NEAR(cross(normal, tangent), 1, 1e-15);
            const Vec2 turn = (unit_tangent(curve, t + h) - unit_tangent(curve, t - h)) / (2 * h * d.norm());
            expect_near(turn, curvature(curve, t) * left_of(tangent), 1e-8);
        }
}

TEST(Curve, CurvatureIsPositiveToTheLeft) {
    EXPECT_EQ(curvature(Segment{{0, 0}, {1, 2}}, 0.5), 0);
    EXPECT_EQ(curvature(Arc{{0, 0}, 4, 1, 2}, 0.5), 0.25);
    EXPECT_EQ(curvature(Arc{{0, 0}, 4, 1, -2}, 0.5), -0.25);
}

TEST(Curve, LengthAgainstChords) {
    const int n = 2000;  // chords of an arc fall short by (angle / n)^2 / 24: 4e-7 of 2 pi
    for (const Curve& curve : curves()) {
        double chords = 0;
        for (int i = 0; i < n; ++i) chords += (point(curve, (i + 1.0) / n) - point(curve, i * 1.0 / n)).norm();
        EXPECT_NEAR(length(curve), chords, 1e-6 * chords);
    }
}

TEST(Curve, LengthInClosedForm) {
    EXPECT_EQ(length(Segment{{1, 2}, {4, -2}}), 5);
    EXPECT_NEAR(length(Arc{{0, 0}, 3, 1, -2 * pi}), 6 * pi, 1e-14);
    for (const Curve& curve : curves()) {
        EXPECT_NEAR(length(curve, 0.25, 0.75), length(curve) / 2, 1e-15 * length(curve));
        EXPECT_EQ(length(curve, 0.75, 0.25), -length(curve, 0.25, 0.75));
        EXPECT_NEAR(length(curve, 0, 0.3) + length(curve, 0.3, 1), length(curve), 1e-15 * length(curve));
    }
}

/// The box holds every point, and each of its sides has one.
TEST(Curve, BoundingBoxIsTight) {
    const int n = 2000;  // the side's point is missed by at most half a step: radius / 2 (pi / n)^2 below it
    for (const Curve& curve : curves()) {
        Box2 sampled;
        for (int i = 0; i <= n; ++i) sampled.extend(point(curve, i * 1.0 / n));
        const Box2 box = bounding_box(curve);
        expect_near(box.min, sampled.min, 4e-6);
        expect_near(box.max, sampled.max, 4e-6);
        EXPECT_TRUE((box.min.array() <= sampled.min.array() + 1e-15).all());
        EXPECT_TRUE((box.max.array() >= sampled.max.array() - 1e-15).all());
    }
}

TEST(Curve, BoundingBoxOfACircleIsExact) {
    const Box2 box = bounding_box(Arc{{1, 2}, 0.75, 0.3, 2 * pi});
    EXPECT_EQ(box.min, Vec2(0.25, 1.25));
    EXPECT_EQ(box.max, Vec2(1.75, 2.75));
}

/// No sampled point is closer.
TEST(Curve, ClosestParameterAgainstSearch) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-4, 4);
    for (const Curve& curve : curves())
        for (int k = 0; k < 100; ++k) {
            const Vec2 p(any(random), any(random));
            const double t = closest_parameter(curve, p);
            ASSERT_GE(t, 0);
            ASSERT_LE(t, 1);
            double least = 1e300;
            for (int i = 0; i <= 400; ++i) least = std::min(least, distance(curve, p, i / 400.0));
            EXPECT_LE(distance(curve, p, t), least + 1e-14);
        }
}

TEST(Curve, ClosestParameterOfItsOwnPoints) {
    for (const Curve& curve : curves())
        for (double t : {0.1, 0.25, 0.5, 0.77}) EXPECT_NEAR(closest_parameter(curve, point(curve, t)), t, 1e-14);
}

TEST(Curve, ClosestParameterWhereSeveralAreEquallyClose) {
    EXPECT_EQ(closest_parameter(Arc{{1, 1}, 2, 0.3, 1.5}, {1, 1}), 0);  // the centre
    EXPECT_EQ(closest_parameter(Arc{{0, 0}, 1, 0, pi}, {0, -1}), 0);    // both ends
    EXPECT_EQ(closest_parameter(Arc{{0, 0}, 1, pi, pi}, {0, 1}), 0);
    EXPECT_EQ(closest_parameter(Arc{{0, 0}, 1, 0, 2 * pi}, {3, 0}), 0);  // the seam
    EXPECT_EQ(closest_parameter(Arc{{0, 0}, 1, 0, -2 * pi}, {3, 0}), 0);
}

TEST(Curve, ClosestParameterBeyondTheEnds) {
    EXPECT_EQ(closest_parameter(Segment{{0, 0}, {1, 0}}, {-3, 5}), 0);
    EXPECT_EQ(closest_parameter(Segment{{0, 0}, {1, 0}}, {3, 5}), 1);
    const Curve quarter = Arc{{0, 0}, 1, 0, pi / 2};
    EXPECT_EQ(closest_parameter(quarter, {0.5, -3}), 0);
    EXPECT_EQ(closest_parameter(quarter, {-3, 0.5}), 1);
}

/// At the extrema a component of the derivative vanishes, and between them none does.
TEST(Curve, AxisExtremaBoundMonotonePieces) {
    for (const Curve& curve : curves()) {
        std::vector<double> ends = axis_extrema(curve);
        for (double t : ends) {
            const Vec2 d = unit_tangent(curve, t);
            EXPECT_NEAR(std::min(std::abs(d.x()), std::abs(d.y())), 0, 1e-14);
        }
        ends.insert(ends.begin(), 0);
        ends.push_back(1);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            ASSERT_LT(ends[i], ends[i + 1]);
            const Vec2 middle = derivative(curve, 0.5 * (ends[i] + ends[i + 1]));
            for (double s : {0.01, 0.2, 0.8, 0.99}) {
                const Vec2 d = derivative(curve, ends[i] + s * (ends[i + 1] - ends[i]));
                EXPECT_TRUE(d.x() * middle.x() > 0 || middle.x() == 0);
                EXPECT_TRUE(d.y() * middle.y() > 0 || middle.y() == 0);
            }
        }
    }
}

TEST(Curve, NumberOfAxisExtrema) {
    EXPECT_EQ(axis_extrema(Segment{{0, 0}, {1, 0}}).size(), 0u);
    EXPECT_EQ(axis_extrema(Arc{{0, 0}, 1, 0.1, 1}).size(), 0u);
    EXPECT_EQ(axis_extrema(Arc{{0, 0}, 1, 0.1, -1}).size(), 1u);
    EXPECT_EQ(axis_extrema(Arc{{0, 0}, 1, 0.1, 2 * pi}).size(), 4u);
    EXPECT_EQ(axis_extrema(Arc{{0, 0}, 1, 0, 2 * pi}).size(), 3u);  // the seam is one too, but an end
}

TEST(Curve, ReversedRunsBackwards) {
    for (const Curve& curve : curves())
        for (double t : parameters()) {
            expect_near(point(reversed(curve), t), point(curve, 1 - t), 4e-15);
            expect_near(derivative(reversed(curve), t), -derivative(curve, 1 - t), 2e-14);
            EXPECT_EQ(curvature(reversed(curve), t), -curvature(curve, 1 - t));
        }
}

TEST(Curve, TrimmedIsThePortion) {
    for (const Curve& curve : curves()) {
        const Curve portion = trimmed(curve, 0.2, 0.9);
        for (double t : parameters()) expect_near(point(portion, t), point(curve, 0.2 + 0.7 * t), 4e-15);
        EXPECT_NEAR(length(portion), length(curve, 0.2, 0.9), 4e-15 * length(curve));
        for (double t : parameters()) expect_near(point(trimmed(curve, 0, 1), t), point(curve, t), 4e-15);
    }
}

TEST(Curve, TransformedMovesItsPoints) {
    const double c = std::cos(2.2), s = std::sin(2.2);
    const Vec2 d(10, -3);
    for (const Curve& curve : curves())
        for (double t : parameters()) {
            const Vec2 p = point(curve, t), q = derivative(curve, t);
            const Curve moved = transformed(curve, c, s, d);
            expect_near(point(moved, t), Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y()) + d, 1e-14);
            expect_near(derivative(moved, t), {c * q.x() - s * q.y(), s * q.x() + c * q.y()}, 2e-14);
            EXPECT_NEAR(length(moved), length(curve), 1e-14 * length(curve));
        }
}

TEST(Vec2, RightAngles) {
    const Vec2 v(3, 1);
    EXPECT_EQ(left_of(v), Vec2(-1, 3));
    EXPECT_EQ(right_of(v), Vec2(1, -3));
    EXPECT_EQ(cross(v, left_of(v)), 10);
    EXPECT_EQ(cross(v, right_of(v)), -10);
}

TEST(Box2, EmptyUntilExtended) {
    Box2 box;
    EXPECT_TRUE(box.empty());
    EXPECT_EQ(box.diagonal(), 0);
    box.extend(Vec2(1, 2));
    EXPECT_FALSE(box.empty());
    EXPECT_EQ(box.diagonal(), 0);
    box.extend(Vec2(4, -2));
    EXPECT_EQ(box.diagonal(), 5);
    EXPECT_EQ(box.center(), Vec2(2.5, 0));
    EXPECT_FALSE(box.overlaps({{4.5, 0}, {5, 1}}, 0.25));
    EXPECT_TRUE(box.overlaps({{4.5, 0}, {5, 1}}, 0.5));
    EXPECT_TRUE(box.overlaps({{4, -2}, {5, -2}}, 0));
}

TEST(CurveChecks, NoticeAFault) {
    EXPECT_NONFATAL_FAILURE(expect_near({1, 2}, {1, 2 + 2e-14}, 1e-14), "against");
}

}  // namespace
