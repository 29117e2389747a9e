// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/curve_moments.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/curves/spline_shape.hpp"
#include "tests/geometry/curves/sample_curves.hpp"

namespace curve_moments_test {

namespace {

using namespace abut::geometry;
using test::nurbs_circle;
constexpr double pi = std::numbers::pi;

void expect_moments(const Moments& m, double area, const Vec2& first, double tolerance) {
    EXPECT_NEAR(m.area, area, tolerance);
    EXPECT_LE((m.first - first).norm(), tolerance) << m.first.transpose() << " against " << first.transpose();
}

/// One of each kind and then some.
std::vector<Curve> curves() {
    const Curve many = nurbs_curves({3,
                                     {0, 0, 0, 0, 0.17, 0.31, 0.68, 1, 1, 1, 1},
                                     {{0, 0}, {1, 1.5}, {2, 0}, {3, 2}, {2, 3}, {0.5, 2.5}, {0, 4}},
                                     {1, 1.5, 1, 0.7, 1, 2, 1}})[0];
    return {Segment{{1, 2}, {4, -2}},
            Arc{{1, -2}, 1.5, 0.3, 5},
            Arc{{1, -2}, 1.5, 0.3, -0.4},
            EllipticArc{{0, 1}, {1.2, 0.9}, {-0.3, 0.4}, 0.7, -4},
            EllipticArc{{-1, 0}, {0.6, 0.8}, {0.4, -0.3}, 2, 5},
            EllipticArc{{0, 0}, {1.5, 0.5}, {-5e-4, 15e-4}, 0.4, 2 * pi},
            bezier_curve({{0, 0}, {1, 2}, {2, -1.5}, {3, 1}}, {}),
            bezier_curve({{0, 0}, {1, 2}, {3, 1.5}}, {1, 0.01, 2}),
            bezier_curve({{0, 0}, {1, 1}, {2, -0.5}, {3, 1}, {3.5, 2}, {3, 3}, {2, 2.5}, {1, 3}, {0, 2}}, {}),
            many,
            Spline{std::get<Spline>(many).shape, 0.93, 0.08},
            nurbs_circle({1, 2}, 1.5)};
}

/// Shoelace over many chords; the rest falls with the square of their number (Richardson).
Moments by_chords(const Curve& curve, double t0, double t1, const Vec2& o, int n) {
    Moments sum;
    const auto triangle = [&](const Vec2& a, const Vec2& b) {
        sum.area += cross(a, b) / 2;
        sum.first += cross(a, b) / 6 * (a + b);
    };
    for (int i = 0; i < n; ++i)
        triangle(point(curve, t0 + (t1 - t0) * i / n) - o, point(curve, t0 + (t1 - t0) * (i + 1) / n) - o);
    triangle(point(curve, t1) - o, point(curve, t0) - o);
    return sum;
}

TEST(Bulge, HalfDiscs) {
    // centroid 4 r / (3 pi) from the diameter
    expect_moments(bulge(Arc{{1, 2}, 3, 0, pi}, 0, 1, {1, 2}), 4.5 * pi, {0, 18}, 4e-14);
    expect_moments(bulge(Arc{{1, 2}, 3, 0, -pi}, 0, 1, {1, 2}), -4.5 * pi, {0, 18}, 4e-14);
    expect_moments(bulge(EllipticArc{{1, 2}, {3, 0}, {0, 0.5}, 0, pi}, 0, 1, {1, 2}), 0.75 * pi, {0, 0.5}, 1e-14);
    expect_moments(bulge(nurbs_circle({1, 2}, 3), 0, 0.5, {1, 2}), 4.5 * pi, {0, 18}, 4e-14);
}

TEST(Bulge, WholeEllipsesAndCircles) {
    const EllipticArc ellipse{{0, 0}, {1, 0}, {0, 0.5}, 0.3, 2 * pi};  // x^2 + 4 y^2 = 1
    expect_moments(bulge(ellipse, 0, 1, {0, 0}), pi / 2, {0, 0}, 1e-15);
    expect_moments(bulge(reversed(ellipse), 0, 1, {1, 0}), -pi / 2, {pi / 2, 0}, 2e-15);
    expect_moments(bulge(nurbs_circle({0, 0}, 1), 0, 1, {0, 0}), pi, {0, 0}, 4e-15);
    expect_moments(bulge(reversed(nurbs_circle({0, 0}, 1)), 0, 1, {0, 1}), -pi, {0, pi}, 1e-14);
    const Curve mirrored = transformed(ellipse, Similarity{0.6, 0.8, {5, 1}, 2, true});
    expect_moments(bulge(mirrored, 0, 1, {5, 1}), -2 * pi, {0, 0}, 1e-14);
}

/// (0,0) (1,2) (2,-1.5) (3,1): x = 3 t, y a cubic, integrated by hand over t; and a parabola's segment: 2/3 of its box.
TEST(Bulge, BezierCurvesInRationals) {
    // bulge = integral of y dx below the chord: chord's 1.5 less 3 (0 + 2 - 1.5 + 1)/4
    EXPECT_NEAR(bulge(bezier_curve({{0, 0}, {1, 2}, {2, -1.5}, {3, 1}}, {}), 0, 1, {0, 0}).area, 1.5 - 3 * 1.5 / 4, 1e-15);
    const Curve parabola = bezier_curve({{-1, 0}, {0, -4}, {1, 0}}, {});  // y = 2 x^2 - 2
    expect_moments(bulge(parabola, 0, 1, {0, 0}), 8.0 / 3, {0, -32.0 / 15}, 2e-15);
    expect_moments(bulge(parabola, 0, 1, {1, 1}), 8.0 / 3, {-8.0 / 3, -32.0 / 15 - 8.0 / 3}, 4e-15);
    expect_moments(bulge(reversed(parabola), 0, 1, {0, 0}), -8.0 / 3, {0, 32.0 / 15}, 2e-15);
}

TEST(Bulge, AgainstChords) {
    const int n = 1000;
    const Vec2 o(0.5, -1);
    for (const Curve& curve : curves())
        for (const auto& [t0, t1] : {std::pair(0.0, 1.0), std::pair(0.13, 0.71)}) {
            const Moments coarse = by_chords(curve, t0, t1, o, n), fine = by_chords(curve, t0, t1, o, 2 * n);
            const Moments m = bulge(curve, t0, t1, o);
            // chords' error of fourth order is left, and where they straddle a knot of third: 1e-9 of it
            EXPECT_NEAR(m.area, (4 * fine.area - coarse.area) / 3, 4e-8) << kind_name(curve);
            EXPECT_LE((m.first - (4 * fine.first - coarse.first) / 3).norm(), 1e-7) << kind_name(curve);
        }
}

/// Bulges of the portions and the polygon of their chords: the bulge of the whole.
TEST(Bulge, PortionsAddUp) {
    std::mt19937 random(31);
    std::uniform_real_distribution<double> unit(0, 1);
    const Vec2 o(-3, 5);
    for (const Curve& curve : curves())
        for (int k = 0; k < 20; ++k) {
            std::vector<double> cuts{0, unit(random), unit(random), unit(random), 1};
            std::sort(cuts.begin(), cuts.end());
            Moments sum;
            for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
                const Vec2 a = point(curve, 0) - o, b = point(curve, cuts[i]) - o, c = point(curve, cuts[i + 1]) - o;
                const Moments m = bulge(curve, cuts[i], cuts[i + 1], o);
                const double triangle = cross(b - a, c - a) / 2;
                sum.area += m.area + triangle;
                sum.first += m.first + triangle / 3 * (a + b + c);
            }
            const Moments whole = bulge(curve, 0, 1, o);
            expect_moments(whole, sum.area, sum.first, 4e-13);
        }
}

/// Of thin circular segments, all digits: 2/3 chord x sagitta, centroid 2/5 of the sagitta above the chord, with the next
/// terms.
TEST(Bulge, ThinSegmentsKeepTheirDigits) {
    for (double h : {0.4, 0.1, 1e-2, 1e-4, 1e-8}) {
        const double r = 2, h2 = h * h, h3 = h2 * h;
        // the series of h - sin h cos h; the next term is 4096 r^2 h^13 / 13!
        const double area = r * r * h3 * (2.0 / 3 - h2 * (2.0 / 15 - h2 * (4.0 / 315 - h2 * (2.0 / 2835 - h2 * 4.0 / 155925))));
        const Curve arc = Arc{{0, 0}, r, pi / 2 - h, 2 * h};
        const Vec2 chord_middle = 0.5 * (point(arc, 0) + point(arc, 1));
        const Moments m = bulge(arc, 0, 1, chord_middle);
        EXPECT_NEAR(m.area, area, 3e-6 * std::pow(h, 13) + 2e-15 * area);
        const double height = m.first.y() / m.area, sagitta = 2 * r * std::pow(std::sin(h / 2), 2);
        EXPECT_NEAR(height / sagitta, 0.4, 0.01 * h2 + 1e-14);
        EXPECT_NEAR(bulge(EllipticArc{{0, 0}, {r, 0}, {0, r}, pi / 2 - h, 2 * h}, 0, 1, chord_middle).area, area,
                    3e-6 * std::pow(h, 13) + 2e-15 * area);
    }
}

/// The series and the closed form meet.
TEST(Bulge, SeriesMeetClosedForm) {
    const Curve arc = Arc{{0, 0}, 1, 0, 2};
    const double below = 0.5 - 1e-12, above = 0.5 + 1e-12;
    const Moments a = bulge(arc, 0, below, {0, 0}), b = bulge(arc, 0, above, {0, 0});
    EXPECT_NEAR(a.area, b.area, 4e-12);
    EXPECT_LE((a.first - b.first).norm(), 4e-12);
}

TEST(BulgeChecks, NoticeAFault) {
    EXPECT_NONFATAL_FAILURE(expect_moments({1, {0, 0}}, 1 + 2e-14, {0, 0}, 1e-14), "exceeds");
    EXPECT_NONFATAL_FAILURE(expect_moments({1, {0, 2e-14}}, 1, {0, 0}, 1e-14), "against");
}

}  // namespace

}  // namespace curve_moments_test
