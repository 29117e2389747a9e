// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/curve_meetings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/csg/overlap.hpp"
#include "geometry/curves/arc_spline.hpp"
#include "geometry/curves/spline_shape.hpp"
#include "tests/geometry/curves/sample_curves.hpp"

namespace abut::geometry::curve_meetings_test {
namespace {

constexpr double pi = std::numbers::pi;
/// Rounding of Newton's last step on curves of size 1 to 10.
constexpr double exact = 1e-12;

using test::ellipse;
using test::nurbs_circle;
using test::of_one_edge;

/// Places farther apart than the tolerance.
std::vector<Vec2> distinct(const std::vector<Vec2>& points, double tolerance) {
    std::vector<Vec2> kept;
    for (const Vec2& p : points)
        if (std::none_of(kept.begin(), kept.end(), [&](const Vec2& q) { return (p - q).norm() <= tolerance; }))
            kept.push_back(p);
    return kept;
}

double nearest(const std::vector<Vec2>& points, const Vec2& p) {
    double best = 1e300;
    for (const Vec2& q : points) best = std::min(best, (p - q).norm());
    return best;
}

double off(const Curve& curve, const Vec2& p) {
    return (point(curve, closest_parameter(curve, p)) - p).norm();
}

TEST(Meetings, TwoEllipsesCrossAtFourKnownPoints) {
    const auto points = meeting_points(ellipse({0, 0}, 2, 1), ellipse({0, 0}, 1, 2), 1e-9);
    const double c = 2 / std::sqrt(5.0);
    EXPECT_EQ(distinct(points, 1e-9).size(), 4u);
    for (const double x : {-c, c})
        for (const double y : {-c, c}) EXPECT_LE(nearest(points, {x, y}), exact);
}

TEST(Meetings, LinesAndEllipsesAgainstTheQuadratic) {
    std::mt19937 random(3);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    int crossing = 0;
    for (int k = 0; k < 200; ++k) {
        const EllipticArc e = ellipse({uniform(-1, 1), uniform(-1, 1)}, uniform(0.2, 3), uniform(0.2, 3), uniform(-3, 3));
        const Vec2 p(uniform(-3, 3), uniform(-3, 3)), angle(uniform(-pi, pi), 0);
        const Vec2 u(std::cos(angle.x()), std::sin(angle.x()));
        const Segment line{p - 20 * u, p + 20 * u};
        // in the frame where the ellipse is the unit circle
        const auto map = [&](const Vec2& v) { return Vec2(v.dot(e.a) / e.a.squaredNorm(), v.dot(e.b) / e.b.squaredNorm()); };
        const Vec2 q = map(p - e.center), v = map(u);
        const double A = v.squaredNorm(), B = q.dot(v), C = q.squaredNorm() - 1, root = B * B - A * C;
        const auto points = meeting_points(line, e, 1e-10);
        if (root < 0) {
            EXPECT_TRUE(points.empty()) << k;
            continue;
        }
        ++crossing;
        EXPECT_EQ(distinct(points, 1e-9).size(), 2u) << k;
        const double conditioning = 1 + 1 / std::sqrt(root);
        for (const double side : {-1.0, 1.0})
            EXPECT_LE(nearest(points, p + (-B + side * std::sqrt(root)) / A * u), exact * conditioning) << k;
    }
    EXPECT_GT(crossing, 80);
}

TEST(Meetings, TouchingPointsOfEllipses) {
    for (int k = 0; k < 50; ++k) {
        const EllipticArc e = ellipse({0.3, -0.2}, 2, 0.7, 0.4);
        const double t = (k + 0.3) / 50;
        const Vec2 p = point(e, t), u = unit_tangent(e, t), n = right_of(u);
        for (const double gap : {0.0, 1e-10, -1e-10}) {
            const Segment line{p + gap * n - 3 * u, p + gap * n + 2 * u};
            const auto points = meeting_points(e, line, 1e-9);
            ASSERT_FALSE(points.empty()) << k;
            EXPECT_LE(nearest(points, p), 1e-9) << k;  // the touching point itself, not one beside it
            for (const Vec2& q : points) EXPECT_LE(std::max(off(e, q), off(line, q)), 1e-9 * (1 + 1e-6));
        }
        EXPECT_TRUE(meeting_points(e, Segment{p + 2e-9 * n - u, p + 2e-9 * n + u}, 1e-9).empty());
    }
}

TEST(Meetings, ALensThinnerThanTheArcsHasTwoCorners) {
    // the line y = 1 - h cuts the ellipse x^2/4 + y^2 = 1 at x = +-2 sqrt(2h - h^2)
    for (const double h : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9}) {
        const auto points = meeting_points(ellipse({0, 0}, 2, 1), Segment{{-3, 1 - h}, {3, 1 - h}}, 1e-13);
        const double x = 2 * std::sqrt(2 * h - h * h);
        EXPECT_EQ(distinct(points, 1e-6).size(), 2u) << h;
        for (const double side : {-x, x}) EXPECT_LE(nearest(points, {side, 1 - h}), 1e-15 / std::sqrt(h)) << h;
    }
}

TEST(Meetings, SharedStretchesGiveTheirEnds) {
    const EllipticArc whole = ellipse({1, 2}, 3, 1, 0.2);
    const Curve first = trimmed(whole, 0.1, 0.6), second = trimmed(whole, 0.4, 0.9);
    for (const Curve& other : {second, reversed(second)}) {
        const auto points = meeting_points(first, other, 1e-10);
        EXPECT_LE(nearest(points, point(whole, 0.4)), exact);
        EXPECT_LE(nearest(points, point(whole, 0.6)), exact);
        EXPECT_EQ(distinct(points, 1e-9).size(), 2u);
    }
    EXPECT_EQ(distinct(meeting_points(whole, reversed(whole), 1e-10), 1e-9).size(), 1u);  // the seam
}

TEST(Meetings, NurbsCirclesMeetWhereTrueCirclesDo) {
    const Curve nurbs = nurbs_circle({1, 1}, 2);
    const Arc circle{{1, 1}, 2, 0, 2 * pi};
    for (const Curve& other : {Curve(Arc{{3, 2}, 1.5, 0.3, 2 * pi}), Curve(Segment{{-3, 0}, {4, 2}}),
                               Curve(ellipse({2, 2}, 2, 1)), nurbs_circle({3, 2}, 1.5)}) {
        const auto expected = distinct(meeting_points(circle, other, 1e-10), 1e-9),
                   found = distinct(meeting_points(nurbs, other, 1e-10), 1e-9);
        EXPECT_EQ(found.size(), expected.size());
        EXPECT_EQ(expected.size(), 2u);
        for (const Vec2& p : expected) EXPECT_LE(nearest(found, p), exact);
    }
}

/// Crossings of two polylines at angles above 20 degrees: there the curves cross as well.
std::vector<Vec2> crossings_of_chords(const Curve& a, const Curve& b, int n) {
    std::vector<Vec2> found, pa, pb;
    for (int i = 0; i <= n; ++i) {
        pa.push_back(point(a, static_cast<double>(i) / n));
        pb.push_back(point(b, static_cast<double>(i) / n));
    }
    for (std::size_t i = 0; i + 1 < pa.size(); ++i)
        for (std::size_t k = 0; k + 1 < pb.size(); ++k) {
            const Vec2 u = pa[i + 1] - pa[i], v = pb[k + 1] - pb[k], d = pb[k] - pa[i];
            const double det = cross(u, v), s = cross(d, v) / det, t = cross(d, u) / det;
            if (std::abs(det) < std::sin(pi / 9) * u.norm() * v.norm()) continue;
            if (s >= 0 && s <= 1 && t >= 0 && t <= 1) found.push_back(pa[i] + s * u);
        }
    return found;
}

void expect_all_crossings(int n_cases, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1), weight(0.3, 3);
    const auto spline = [&](int n, bool rational) {
        std::vector<Vec2> points;
        std::vector<double> weights;
        for (int i = 0; i < n; ++i) points.emplace_back(coordinate(random), coordinate(random));
        for (int i = 0; i < n && rational; ++i) weights.push_back(weight(random));
        return bezier_curve(points, weights);
    };
    int n_found = 0;
    for (int k = 0; k < n_cases; ++k) {
        const Curve a = spline(3 + k % 4, k % 2 == 0);
        const Curve b = k % 3 == 0 ? Curve(ellipse({coordinate(random), coordinate(random)}, 0.8, 0.5, coordinate(random)))
                                   : spline(4, k % 5 == 0);
        const auto points = meeting_points(a, b, 1e-10);
        for (const Vec2& p : points) EXPECT_LE(std::max(off(a, p), off(b, p)), 1e-10 * (1 + 1e-6)) << k;
        constexpr int n = 200;
        const double chord = std::pow(length(a) / n, 2) + std::pow(length(b) / n, 2);
        for (const Vec2& p : crossings_of_chords(a, b, n)) {
            ++n_found;
            EXPECT_LE(nearest(points, p), 4 * std::sqrt(chord)) << k;  // mean chords: the longest are a few times that
        }
        if (::testing::Test::HasFailure()) FAIL() << "case " << k;
    }
    EXPECT_GT(n_found, n_cases / 2);
}

TEST(Meetings, RandomSplinesAgainstChords) {
    expect_all_crossings(150, 8);
}
TEST(LongMeetings, RandomSplinesAgainstChords) {
    expect_all_crossings(10000, 9);
}

TEST(Meetings, OrderOfTheCurvesDoesNotMatter) {
    std::mt19937 random(21);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    for (int k = 0; k < 60; ++k) {
        std::vector<Vec2> points;
        for (int i = 0; i < 5; ++i) points.emplace_back(coordinate(random), coordinate(random));
        const Curve a = bezier_curve(points, {}), b = ellipse({coordinate(random), coordinate(random)}, 0.9, 0.4, k);
        const auto there = meeting_points(a, b, 1e-10), back = meeting_points(b, a, 1e-10);
        EXPECT_EQ(distinct(there, 1e-8).size(), distinct(back, 1e-8).size()) << k;
        for (const Vec2& p : there) EXPECT_LE(nearest(back, p), 1e-9) << k;
    }
}

/// Area common to two regions given as level sets, by a fine sum over columns whose ends are exact.
TEST(Overlaps, EllipsesAndNurbsCirclesAgainstClosedForms) {
    // x^2/4 + y^2 <= 1 and x^2 + y^2/4 <= 1: 8 (a b / 2) atan(b/a)
    const auto crossed = overlap(of_one_edge(ellipse({0, 0}, 2, 1)), of_one_edge(ellipse({0, 0}, 1, 2)), 1e-10);
    EXPECT_NEAR(crossed.area, 8 * std::atan(0.5), 1e-11);
    // one inside the other, and one that is the other
    EXPECT_NEAR(overlap(of_one_edge(ellipse({0, 0}, 2, 1)), of_one_edge(ellipse({0.1, 0}, 1, 0.5)), 1e-10).area, pi / 2, 1e-11);
    EXPECT_NEAR(overlap(of_one_edge(ellipse({0, 0}, 2, 1)), of_one_edge(ellipse({0, 0}, 2, 1, 0, 1.0)), 1e-10).area, 2 * pi,
                1e-8);
    EXPECT_EQ(overlap(of_one_edge(ellipse({0, 0}, 2, 1)), of_one_edge(ellipse({4, 0}, 2, 1)), 1e-10).area, 0);  // touching
    // two circles of radius r at distance d
    const double r = 2, d = 1.3, lens = 2 * r * r * std::acos(d / (2 * r)) - d / 2 * std::sqrt(4 * r * r - d * d);
    const Vec2 moved(d * std::cos(0.4), d * std::sin(0.4));
    EXPECT_NEAR(overlap(of_one_edge(nurbs_circle({0, 0}, r)), of_one_edge(nurbs_circle(moved, r)), 1e-10).area, lens, 1e-11);
    EXPECT_NEAR(overlap(of_one_edge(nurbs_circle({0, 0}, r)), of_one_edge(Arc{moved, r, 0, 2 * pi}), 1e-10).area, lens, 1e-11);
}

}  // namespace
}  // namespace abut::geometry::curve_meetings_test
