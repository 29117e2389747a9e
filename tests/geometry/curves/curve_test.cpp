// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/curve.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/curves/spline_shape.hpp"

namespace curve_test {

namespace {

using namespace abut::geometry;
constexpr double pi = std::numbers::pi;

/// Segments and arcs of both directions: short, longer than half a turn, full, with ends on and off the quarter turns.
std::vector<Curve> lines_and_circles() {
    return {Segment{{1, 2}, {4, -2}},   Segment{{0, 0}, {0, 3}},       Segment{{5, 1}, {-2, 1}},
            Arc{{1, -2}, 1.5, 0.3, 1},  Arc{{1, -2}, 1.5, 0.3, -1},    Arc{{0, 0}, 2, -1, 5},
            Arc{{0, 0}, 2, 7, -4.5},    Arc{{3, 1}, 0.5, 0, pi / 2},   Arc{{3, 1}, 0.5, pi / 2, pi},
            Arc{{-1, 1}, 1, 0, 2 * pi}, Arc{{-1, 1}, 1, -2.5, -2 * pi}};
}

/// Upright, turned, mirrored, flat; portions and full turns of both directions.
std::vector<Curve> ellipses() {
    return {
        EllipticArc{{1, -2}, {1.5, 0}, {0, 0.5}, 0.3, 1},    EllipticArc{{0, 1}, {1.2, 0.9}, {-0.3, 0.4}, 0.7, -4},
        EllipticArc{{0, 0}, {1, 0}, {0, 0.5}, 0, 2 * pi},    EllipticArc{{2, 1}, {0.8, -0.6}, {0.36, 0.48}, -1, 2 * pi},
        EllipticArc{{-1, 0}, {0.6, 0.8}, {0.4, -0.3}, 2, 5}, EllipticArc{{0, 0}, {1.5, 0.5}, {-0.005, 0.015}, 0.4, -2 * pi}};
}

Curve nurbs_circle() {
    const double w = std::sqrt(0.5);
    return nurbs_curves({2,
                         {0, 0, 0, 1.2, 1.2, 2.2, 2.2, 3, 3, 4, 4, 4},
                         {{2, 1}, {2, 3}, {0, 3}, {-2, 3}, {-2, 1}, {-2, -1}, {0, -1}, {2, -1}, {2, 1}},
                         {1, w, 1, w, 1, w, 1, w, 1}})[0];
}

/// With inflections, rational, of many spans, of the highest degree, closed, and portions of both directions.
std::vector<Curve> splines() {
    const Curve wave = bezier_curve({{0, 0}, {1, 2}, {2, -1.5}, {3, 1}}, {});
    const Curve rational = bezier_curve({{0, 0}, {1, 2}, {3, 1.5}}, {1, 0.4, 2});
    const Curve high = bezier_curve({{0, 0}, {1, 1}, {2, -0.5}, {3, 1}, {3.5, 2}, {3, 3}, {2, 2.5}, {1, 3}, {0, 2}},
                                    {1, 2, 1, 1.5, 1, 2, 1, 1, 1});
    const Curve many = nurbs_curves({3,
                                     {0, 0, 0, 0, 0.17, 0.31, 0.68, 1, 1, 1, 1},
                                     {{0, 0}, {1, 1.5}, {2, 0}, {3, 2}, {2, 3}, {0.5, 2.5}, {0, 4}},
                                     {1, 1.5, 1, 0.7, 1, 2, 1}})[0];
    const auto& shape = std::get<Spline>(many).shape;
    return {wave, rational, high, many, Spline{shape, 0.93, 0.08}, Spline{shape, 0.2, 0.3}, nurbs_circle()};
}

std::vector<Curve> curves() {
    std::vector<Curve> all = lines_and_circles();
    for (const std::vector<Curve>& more : {ellipses(), splines()}) all.insert(all.end(), more.begin(), more.end());
    return all;
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

/// By five points: h^4 / 30 of the fifth derivative (up to 1e8: rational splines), and rounding over h.
template <class F>
Vec2 difference(F f, double t) {
    const double h = 1e-4;
    return (8 * (f(t + h) - f(t - h)) - (f(t + 2 * h) - f(t - 2 * h))) / (12 * h);
}
constexpr double difference_error = 2e-8;

TEST(Curve, DerivativesAgainstDifferences) {
    for (const Curve& curve : curves())
        for (double t : parameters()) {
            expect_near(derivative(curve, t), difference([&](double x) { return point(curve, x); }, t), difference_error);
            const Vec2 dd = difference([&](double x) { return derivative(curve, x); }, t);
            expect_near(second_derivative(curve, t), dd, 50 * difference_error);
        }
}

TEST(Curve, TangentNormalAndCurvatureAgainstDifferences) {
    for (const Curve& curve : curves())
        for (double t : parameters()) {
            const Vec2 d = derivative(curve, t);
            const Vec2 tangent = unit_tangent(curve, t), normal = outward_normal(curve, t);
            expect_near(tangent * d.norm(), d, 1e-14);
            EXPECT_NEAR(tangent.norm(), 1, 1e-15);
            EXPECT_NEAR(cross(normal, tangent), 1, 1e-15);
            const Vec2 turn = difference([&](double x) { return derivative(curve, x); }, t);
            EXPECT_NEAR(cross(tangent, turn), curvature(curve, t) * d.squaredNorm(), 50 * difference_error);
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
    // Gauss-Kummer and adaptive quadrature in 50 digits agree
    EXPECT_NEAR(length(EllipticArc{{0, 0}, {1, 0}, {0, 0.5}, 0.3, 2 * pi}), 4.844224110273838, 1e-14);
    EXPECT_NEAR(length(EllipticArc{{1, 1}, {0.6, 0.8}, {-4e-4, 3e-4}, 0.3, -2 * pi}), 4.0000042435987808, 4e-15);
    EXPECT_NEAR(length(nurbs_circle()), 4 * pi, 2e-14);
    for (const Curve& curve : lines_and_circles())
        EXPECT_NEAR(length(curve, 0.25, 0.75), length(curve) / 2, 1e-15 * length(curve));
}

TEST(Curve, LengthAdds) {
    for (const Curve& curve : curves()) {
        EXPECT_EQ(length(curve, 0.75, 0.25), -length(curve, 0.25, 0.75));
        for (double t : {1e-9, 0.05, 0.3, 0.9})
            EXPECT_NEAR(length(curve, 0, t) + length(curve, t, 1), length(curve), 4e-15 * length(curve));
    }
}

/// Where the speed is small, as at the tips of a flat ellipse, a rounding of the length is much of the parameter.
TEST(Curve, ParameterAtLengthInvertsLength) {
    for (const Curve& curve : curves()) {
        const double total = length(curve);
        for (int i = 0; i <= 50; ++i) {
            const double t = i / 50.0, found = parameter_at_length(curve, length(curve, 0, t));
            EXPECT_NEAR(found, t, 1e-15 + 1e-14 * total / derivative(curve, t).norm());
        }
        EXPECT_EQ(parameter_at_length(curve, 0), 0);
        EXPECT_EQ(parameter_at_length(curve, -1), 0);
        EXPECT_EQ(parameter_at_length(curve, total), 1);
        EXPECT_EQ(parameter_at_length(curve, 2 * total), 1);
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

/// The nearest of the samples, and golden sections around it: no derivative, no structure.
double searched_distance(const Curve& curve, const Vec2& p, int n) {
    int best = 0;
    for (int i = 1; i <= n; ++i)
        if (distance(curve, p, i * 1.0 / n) < distance(curve, p, best * 1.0 / n)) best = i;
    double lo = std::max(best - 1, 0) * 1.0 / n, hi = std::min(best + 1, n) * 1.0 / n;
    const double golden = 0.5 * (std::sqrt(5.0) - 1);
    while (hi - lo > 1e-8) {
        const double a = hi - golden * (hi - lo), b = lo + golden * (hi - lo);
        if (distance(curve, p, a) < distance(curve, p, b)) {
            hi = b;
        } else {
            lo = a;
        }
    }
    return std::min({distance(curve, p, lo), distance(curve, p, hi), distance(curve, p, best * 1.0 / n)});
}

/// Near, far, on the evolute (where the distance is flat to the third order), and close to it.
std::vector<Vec2> points_about(const Curve& curve, std::mt19937& random, int n) {
    std::uniform_real_distribution<double> unit(0, 1);
    const Box2 box = bounding_box(curve);
    const double size = box.diagonal();
    std::vector<Vec2> points;
    for (int k = 0; k < n; ++k) {
        const double t = unit(random), bend = curvature(curve, t);
        const Vec2 at = point(curve, t), normal = outward_normal(curve, t);
        points.push_back(box.center() + size * Vec2(unit(random) - 0.5, unit(random) - 0.5));
        points.push_back(box.center() + 1e3 * size * Vec2(unit(random) - 0.5, unit(random) - 0.5));
        points.push_back(at + 1e-6 * size * (unit(random) - 0.5) * normal);
        if (std::abs(bend) * size < 1e-3) continue;
        points.push_back(at - normal / bend);
        points.push_back(at - normal / bend * (1 + 1e-6 * (unit(random) - 0.5)));
    }
    return points;
}

void expect_closest(const Curve& curve, const Vec2& p, int n_samples) {
    const double t = closest_parameter(curve, p), d = distance(curve, p, t);
    ASSERT_GE(t, 0);
    ASSERT_LE(t, 1);
    EXPECT_LE(d, searched_distance(curve, p, n_samples) + 2e-15 * (p.norm() + bounding_box(curve).diagonal() + d))
        << kind_name(curve) << " from " << p.transpose() << " at " << t;
}

void sweep_closest(int n) {
    std::mt19937 random(5);
    for (const Curve& curve : curves())
        for (const Vec2& p : points_about(curve, random, n)) expect_closest(curve, p, 400);
}

TEST(Curve, ClosestParameterAgainstSearch) {
    sweep_closest(20);
}

TEST(LongCurve, ClosestParameterAgainstSearch) {
    sweep_closest(1000);
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
    EXPECT_EQ(closest_parameter(nurbs_circle(), {0, 1}), 0);
    EXPECT_EQ(closest_parameter(reversed(nurbs_circle()), {0, 1}), 0);
    EXPECT_EQ(closest_parameter(nurbs_circle(), {3, 1}), 0);
    const EllipticArc ellipse{{0, 0}, {1, 0}, {0, 0.5}, 0, 2 * pi};
    EXPECT_NEAR(closest_parameter(ellipse, {0, 0}), 0.25, 1e-15);  // both ends of the minor axis
    EXPECT_NEAR(closest_parameter(reversed(ellipse), {0, 0}), 0.25, 1e-15);
    EXPECT_EQ(closest_parameter(ellipse, {2, 0}), 0);       // the seam
    EXPECT_LT(closest_parameter(ellipse, {0.3, 0}), 0.25);  // on the major axis, within the evolute
    EXPECT_EQ(closest_parameter(ellipse, {0.9, 0}), 0);     // and outside
    const Curve hill = bezier_curve({{-1, 0}, {0, 2}, {1, 0}}, {});
    EXPECT_LT(closest_parameter(hill, {0, -3}), 1e-15);
    EXPECT_LT(closest_parameter(hill, {0, 0}), 0.5);
    EXPECT_NEAR(closest_parameter(hill, {0, 3}), 0.5, 1e-15);
}

/// Circles but for 1e-9, 1e-12 and 1e-15 of them, from their centre: the distance is the same everywhere within that.
TEST(Curve, ClosestParameterFromTheCentreOfNearCircles) {
    for (double flattening : {1e-9, 1e-12, 1e-15, 0.0}) {
        const Curve ellipse = EllipticArc{{1, 2}, {0.6, 0.8}, {-0.8 * (1 - flattening), 0.6 * (1 - flattening)}, 0.4, 5};
        for (const Vec2& p : {Vec2(1, 2), Vec2(1 + 1e-13, 2), Vec2(1, 2 - 1e-9)})
            for (const Curve& curve : {ellipse, transformed(ellipse, 0.8, 0.6, {5, 5})}) expect_closest(curve, p, 400);
    }
    expect_closest(nurbs_circle(), {1e-13, 1}, 400);
    expect_closest(nurbs_circle(), {-1e-9, 1 + 1e-9}, 400);
}

/// From the tips' centres of curvature outwards along the axis, by aspect ratios up to 1000: the nearest point is the tip.
TEST(Curve, ClosestParameterAtTheTipsOfFlatEllipses) {
    for (double b : {0.5, 0.1, 1e-2, 1e-3}) {
        const Curve ellipse = EllipticArc{{0, 0}, {1, 0}, {0, b}, -1, 5};
        for (double x : {1 - b * b, 1 - 0.5 * b * b, 1.0, 1 + b, 3.0}) {
            const double t = closest_parameter(ellipse, {x, 0});
            EXPECT_LE(distance(ellipse, {x, 0}, t), std::abs(1 - x) + 4e-15);
            if (x > 1 - b * b) { EXPECT_NEAR(t, 0.2, 1e-12 / (b * b)); }
        }
    }
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
            EXPECT_NEAR(std::min(std::abs(d.x()), std::abs(d.y())), 0, 1e-13);  // a rounding of t at the flat ellipse's tips
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

/// Against sampling: between neighbouring samples on two sides of the line there is one crossing, and no other.
TEST(Curve, CrossingsAgainstSampling) {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> unit(-0.1, 1.1);
    const int n = 1000;
    for (const Curve& curve : curves())
        for (int k = 0; k < 20; ++k) {
            const int axis = k % 2;
            const Box2 box = bounding_box(curve);
            const double c = box.min[axis] + unit(random) * box.size()[axis];
            const std::vector<double> found = crossings(curve, axis, c);
            std::size_t at = 0;
            for (int i = 0; i < n; ++i) {
                const bool before = point(curve, i * 1.0 / n)[axis] < c, after = point(curve, (i + 1.0) / n)[axis] < c;
                if (before == after) continue;
                ASSERT_LT(at, found.size());
                EXPECT_GE(found[at], i * 1.0 / n - 1e-15);
                EXPECT_LE(found[at], (i + 1.0) / n + 1e-15);
                EXPECT_NEAR(point(curve, found[at])[axis], c, 4e-15 * (1 + std::abs(c)));
                ++at;
            }
            // two crossings between neighbouring samples: next to an extremum
            for (; at + 1 < found.size(); at += 2) EXPECT_LT(found[at + 1] - found[at], 1.0 / n);
            EXPECT_EQ(at, found.size());
        }
}

/// At the extrema themselves the line touches; curves along the line have no crossings.
TEST(Curve, CrossingsWhereTheLineTouches) {
    for (const Curve& curve : {Curve(EllipticArc{{1, 2}, {2, 0}, {0, 0.5}, 0.3, 5}), Curve(Arc{{1, 2}, 0.5, 0.3, 5})}) {
        EXPECT_EQ(crossings(curve, 1, 2.5).size(), 1u);
        EXPECT_EQ(crossings(curve, 1, 1.5).size(), 1u);
        EXPECT_EQ(crossings(curve, 1, 2.5 + 1e-12).size(), 0u);
        EXPECT_EQ(crossings(curve, 1, 2.5 - 1e-12).size(), 2u);
    }
    EXPECT_TRUE(crossings(Segment{{0, 1}, {2, 1}}, 1, 1).empty());
    EXPECT_EQ(crossings(Segment{{0, 1}, {2, 1}}, 0, 2), std::vector<double>{1});
}

/// Not less than the sum over many steps; exact for circles and ellipses, little more for splines.
TEST(Curve, TurningAgainstSteps) {
    const int n = 2000;
    for (const Curve& curve : curves())
        for (const auto& [t0, t1] : {std::pair(0.0, 1.0), std::pair(0.15, 0.8), std::pair(0.4, 0.45)}) {
            double sum = 0;
            for (int i = 0; i < n; ++i) {
                const Vec2 u = derivative(curve, t0 + (t1 - t0) * i / n), v = derivative(curve, t0 + (t1 - t0) * (i + 1) / n);
                sum += std::abs(std::atan2(cross(u, v), u.dot(v)));
            }
            const double turn = turning(curve, t0, t1);
            EXPECT_GE(turn, sum - 1e-12);
            EXPECT_LE(turn, std::holds_alternative<Spline>(curve) ? 1.1 * sum : sum + 1e-12);
        }
}

TEST(Curve, NumberOfAxisExtrema) {
    EXPECT_EQ(axis_extrema(EllipticArc{{0, 0}, {1, 0}, {0, 2}, 0, 2 * pi}).size(), 3u);
    EXPECT_EQ(axis_extrema(EllipticArc{{0, 0}, {0.6, 0.8}, {-0.4, 0.3}, 0, 2 * pi}).size(), 4u);
    EXPECT_EQ(axis_extrema(nurbs_circle()).size(), 3u);
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
            const double bend = curvature(curve, 1 - t);
            EXPECT_NEAR(curvature(reversed(curve), t), -bend, 1e-12 * std::abs(bend));
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
    for (const Similarity& map : {Similarity{std::cos(2.2), std::sin(2.2), {10, -3}}, Similarity{1, 0, {0, 0}, 2.5, false},
                                  Similarity{1, 0, {1, 2}, 1, true}, Similarity{0.6, -0.8, {-1, 2}, 0.4, true}})
        for (const Curve& curve : curves()) {
            const Curve moved = transformed(curve, map);
            EXPECT_EQ(kind_name(moved), kind_name(curve));
            EXPECT_NEAR(length(moved), map.scale * length(curve), 2e-14 * length(moved));
            for (double t : parameters()) {
                expect_near(point(moved, t), map(point(curve, t)), 2e-14);
                expect_near(derivative(moved, t), map.turned(derivative(curve, t)), 1e-13);
                EXPECT_NEAR(curvature(moved, t) * map.scale, (map.mirror ? -1 : 1) * curvature(curve, t),
                            1e-11 * (1 + std::abs(curvature(curve, t))));
            }
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

}  // namespace curve_test
