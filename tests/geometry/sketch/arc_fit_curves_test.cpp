// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/arc_fit_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "geometry/curves/arc_spline.hpp"

namespace abut::geometry::arc_fit_curves_test {
namespace {

constexpr double pi = std::numbers::pi;
using Points = std::vector<Vec2>;

std::vector<FacetCurve> curves_of(const Points& points, double tolerance = 1e-6) {
    return curves_through_facets(points, fit_lines_and_arcs(points, true, tolerance), tolerance);
}

/// Involute of a circle of radius 20, unwound from u0 to u1, in n facets.
Vec2 involute(double u) {
    return 20 * Vec2(std::cos(u) + u * std::sin(u), std::sin(u) - u * std::cos(u));
}

/// A plate with one involute side.
Points plate_with_flank(double u0, double u1, int n) {
    Points points;
    for (int k = 0; k <= n; ++k) points.push_back(involute(u0 + (u1 - u0) * k / n));
    points.push_back({-30, points.back().y()});
    points.push_back({-30, points.front().y()});
    return points;
}

Points ellipse(double a, double b, int n, double start = 0.1) {
    Points points;
    for (int k = 0; k < n; ++k) points.push_back({a * std::cos(start + 2 * pi * k / n), b * std::sin(start + 2 * pi * k / n)});
    return points;
}

double distance(const Vec2& p, const std::function<Vec2(double)>& curve, double t0, double t1) {
    double least = 1e300;
    constexpr int n = 1500;
    for (int k = 0; k < n; ++k) {
        const Segment chord{curve(t0 + (t1 - t0) * k / n), curve(t0 + (t1 - t0) * (k + 1) / n)};
        least = std::min(least, (point(chord, closest_parameter(chord, p)) - p).norm());
    }
    return least;
}

double largest_distance(const FacetCurve& found, const std::function<Vec2(double)>& curve, double t0, double t1) {
    double largest = 0;
    for (const Curve& arc : found.arcs)
        for (int k = 0; k <= 3; ++k) largest = std::max(largest, distance(point(arc, k / 3.0), curve, t0, t1));
    return largest;
}

/// Joined end to end, tangential, turning one way, through all vertices within the residual.
void expect_smooth(const FacetCurve& found, const Points& points) {
    ASSERT_FALSE(found.arcs.empty());
    const auto at = [&](int k) { return points[static_cast<std::size_t>(k) % points.size()]; };
    EXPECT_LE((point(found.arcs.front(), 0) - at(found.first)).norm(), 1e-10);
    EXPECT_LE((point(found.arcs.back(), 1) - at(found.last)).norm(), 1e-10);
    double turn = 0;
    for (std::size_t k = 0; k < found.arcs.size(); ++k) {
        if (const Arc* arc = std::get_if<Arc>(&found.arcs[k])) {
            EXPECT_GE(arc->sweep * turn, 0) << "turns back";
            turn = arc->sweep;
        }
        if (k == 0) continue;
        const Curve &before = found.arcs[k - 1], &after = found.arcs[k];
        EXPECT_LE((point(before, 1) - point(after, 0)).norm(), 1e-10);
        EXPECT_LE(std::abs(cross(unit_tangent(before, 1), unit_tangent(after, 0))), most_arc_kink) << "a kink";
    }
    double worst = 0;
    for (int k = found.first; k <= found.first + found.n_facets; ++k) {
        double least = 1e300;
        for (const Curve& arc : found.arcs) least = std::min(least, (point(arc, closest_parameter(arc, at(k))) - at(k)).norm());
        worst = std::max(worst, least);
    }
    EXPECT_LE(worst, found.residual + 1e-10);
    EXPECT_LE(found.residual, std::max(1e-10, vertex_share * found.sagitta));
}

TEST(FacetCurves, FollowTheInvoluteAndNotItsChords) {
    for (int n : {6, 9, 14, 30}) {
        const Points points = plate_with_flank(0.4, 0.9, n);
        const auto found = curves_of(points);
        ASSERT_EQ(found.size(), 1u) << n;
        expect_smooth(found[0], points);
        EXPECT_EQ(found[0].first, 0);
        EXPECT_EQ(found[0].n_facets, n);
        const double chords = (involute(0.65 + 0.25 / n) - involute(0.65 - 0.25 / n)).norm() * 0.5 / n / 8;
        EXPECT_NEAR(found[0].sagitta, chords, 0.6 * chords);
        EXPECT_LE(largest_distance(found[0], involute, 0.4, 0.9), 0.1 * found[0].sagitta) << n;
    }
}

TEST(FacetCurves, AnEllipseIsClosedAllAround) {
    for (int n : {80, 120})
        for (double b : {10.0, 18.0}) {
            const Points points = ellipse(20, b, n);
            const auto found = curves_of(points, 1e-7);
            ASSERT_EQ(found.size(), 1u) << n << " " << b;
            expect_smooth(found[0], points);
            EXPECT_EQ(found[0].n_facets, n);
            EXPECT_EQ(found[0].first, found[0].last);
            const Curve &end = found[0].arcs.back(), &begin = found[0].arcs.front();
            EXPECT_LE(std::abs(cross(unit_tangent(end, 1), unit_tangent(begin, 0))), most_arc_kink);
            const auto curve = [b](double t) { return Vec2(20 * std::cos(t), b * std::sin(t)); };
            EXPECT_LE(largest_distance(found[0], curve, 0, 2 * pi), 0.1 * found[0].sagitta);
        }
}

TEST(FacetCurves, PolygonsStay) {
    for (int n = 3; n <= 23; ++n) EXPECT_TRUE(curves_of(ellipse(10, 10, n)).empty()) << n;
    EXPECT_TRUE(curves_of({{0, 0}, {9, 0}, {10, 1}, {10, 10}, {0, 10}}).empty()) << "a chamfer";
    // sides of 10 and 1 in turn, 32 of them: no curve has such curvatures
    Points cut_corners;
    Vec2 p(0, 0);
    for (int k = 0; k < 32; ++k) {
        cut_corners.push_back(p);
        const double turn = 2 * pi * (k / 2) / 16 + (k % 2 == 0 ? 0 : 0.15);
        p += (k % 2 == 0 ? 10.0 : 1.0) * Vec2(std::cos(turn), std::sin(turn));
    }
    EXPECT_TRUE(curves_of(cut_corners).empty());
    // three facets are too few to tell
    EXPECT_TRUE(curves_of(plate_with_flank(0.4, 0.9, 3)).empty());
}

/// Facets far finer than the tolerance: arcs within it would be farther from the curve than the facets are.
TEST(FacetCurves, FineFacetsAreFollowedAsWell) {
    for (double tolerance : {1e-3, 1e-2}) {
        const Points points = plate_with_flank(0.4, 0.9, 100);
        const auto found = curves_of(points, tolerance);
        ASSERT_EQ(found.size(), 1u);
        expect_smooth(found[0], points);
        EXPECT_EQ(found[0].n_facets, 100);
        EXPECT_LT(found[0].sagitta, 0.1 * tolerance);
        EXPECT_LE(largest_distance(found[0], involute, 0.4, 0.9), 0.5 * found[0].sagitta);
        EXPECT_LT(found[0].arcs.size(), 40u) << "not one for each facet";
    }
}

/// Pieces of an ellipse lie near circles. Whoever touches it at a vertex does still.
TEST(FacetCurves, PiecesThatAreNearlyArcsJoinTheirCurve) {
    const Points points = ellipse(10, 9.4, 48);
    const double tolerance = 1e-3;
    const auto pieces = fit_lines_and_arcs(points, true, tolerance);
    EXPECT_TRUE(std::any_of(pieces.begin(), pieces.end(), [](const FittedPiece& p) { return p.residual > 0; }));
    const auto found = curves_through_facets(points, pieces, tolerance);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].n_facets, 48);
    EXPECT_LE(found[0].residual, 1e-12);
    // two true arcs, tangential, whose curvatures are near each other, stay what they are
    Points oval;
    for (int k = 0; k <= 12; ++k) oval.push_back(10 * Vec2(std::cos(0.1 * k), std::sin(0.1 * k)));
    const Vec2 center = oval.back() * (1 - 1.4);
    for (int k = 1; k <= 12; ++k) oval.push_back(center + 14 * Vec2(std::cos(1.2 + 0.07 * k), std::sin(1.2 + 0.07 * k)));
    oval.push_back({-20, -20});
    for (Vec2& p : oval) p = p.cast<float>().cast<double>();
    EXPECT_TRUE(curves_of(oval, 1e-4).empty());
}

/// Vertices off their circle by more than its sagitta, as rounding in files leaves them: the arc through all is the better one.
TEST(FacetCurves, RoundedVerticesOfArcsStayArcs) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int trial = 0; trial < 100; ++trial) {
        Points points{{-20, -20}, {0, -10}};
        constexpr int n = 60;
        for (int k = 1; k < n; ++k)
            points.push_back(10 * Vec2(std::sin(pi * k / n), -std::cos(pi * k / n)) + 1e-2 * Vec2(unit(random), unit(random)));
        points.push_back({0, 10});
        points.push_back({-20, 20});
        for (const FacetCurve& found : curves_of(points, 2e-2)) EXPECT_LE(found.n_facets, 8) << trial;
    }
}

/// A line that meets the curve tangentially, or nearly so, is no facet of it; and the curve begins as the line ends.
TEST(FacetCurves, LinesBesideCurvesStayLines) {
    for (double length : {3.0, 10.0, 40.0}) {
        Points points{involute(0.5) - length * Vec2(std::cos(0.5), std::sin(0.5))};
        for (int k = 0; k <= 12; ++k) points.push_back(involute(0.5 + 0.04 * k));
        points.push_back({-60, 60});
        points.push_back({-60, points[0].y()});
        const auto found = curves_of(points);
        ASSERT_EQ(found.size(), 1u) << length;
        EXPECT_EQ(found[0].first, 1);
        EXPECT_EQ(found[0].n_facets, 12);
        EXPECT_LE(std::abs(cross(unit_tangent(found[0].arcs.front(), 0), Vec2(std::cos(0.5), std::sin(0.5)))), most_arc_kink);
    }
}

TEST(FacetCurves, CornersBetweenCurvesStay) {
    // a lens of two parabolas, and one whose two halves meet at 0.2 rad
    Points points;
    for (int k = 0; k <= 20; ++k) points.push_back({-10.0 + k, 0.02 * std::pow(-10.0 + k, 2) + 0.1 * std::abs(-10.0 + k)});
    points.push_back({0, 30});
    const auto found = curves_of(points, 1e-7);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].last, 10);
    EXPECT_EQ(found[1].first, 10);
    const double kink = cross(unit_tangent(found[0].arcs.back(), 1), unit_tangent(found[1].arcs.front(), 0));
    EXPECT_NEAR(std::asin(kink), 2 * std::atan(0.1), 0.01);
}

TEST(FacetCurves, DoNotDependOnWhereThePointsBeginOrTheWayAround) {
    const Points points = plate_with_flank(0.4, 0.9, 11);
    const FacetCurve whole = curves_of(points).at(0);
    for (std::size_t shift = 1; shift < points.size(); ++shift) {
        Points turned = points;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(shift), turned.end());
        const auto found = curves_of(turned);
        ASSERT_EQ(found.size(), 1u) << shift;
        EXPECT_EQ(found[0].n_facets, whole.n_facets);
        EXPECT_EQ(found[0].arcs.size(), whole.arcs.size());
        EXPECT_NEAR(found[0].sagitta, whole.sagitta, 1e-12);
    }
    Points back(points.rbegin(), points.rend());
    const auto found = curves_of(back);
    ASSERT_EQ(found.size(), 1u);
    expect_smooth(found[0], back);
    EXPECT_NEAR(found[0].sagitta, whole.sagitta, 1e-9);
}

/// Vertices rounded to six digits: what is taken for a curve keeps to the rules, and to the points.
TEST(FacetCurves, RandomOutlinesKeepToTheirPoints) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    int n_found = 0;
    for (int trial = 0; trial < 150; ++trial) {
        Points points{{0, 0}};
        double direction = 0, step = 1, turn = 0.1;
        for (int k = 0; k < 60; ++k) {
            if (random() % 12 == 0) turn = 0.5 * (unit(random) - 0.5);
            step *= std::exp(0.3 * (unit(random) - 0.5));
            direction += turn * (0.8 + 0.4 * unit(random));
            const Vec2 next = points.back() + step * Vec2(std::cos(direction), std::sin(direction));
            points.push_back(1e-4 * (1e4 * next).array().round().matrix());
        }
        for (const FacetCurve& found : curves_of(points, 1e-4)) {
            expect_smooth(found, points);
            ++n_found;
        }
    }
    EXPECT_GT(n_found, 50);
}

TEST(FacetCurves, TakeTimeInProportion) {
    Points points = ellipse(2000, 1500, 50000);
    EXPECT_EQ(curves_through_facets(points, fit_lines_and_arcs(points, true, 1), 1).size(), 1u);
    std::vector<FittedPiece> lines;
    const int n = static_cast<int>(points.size());
    for (int k = 0; k < n; ++k)
        lines.push_back(
            {Segment{points[static_cast<std::size_t>(k)], points[static_cast<std::size_t>((k + 1) % n)]}, k, (k + 1) % n, 0});
    ASSERT_EQ(curves_through_facets(points, lines, 1e-9).size(), 1u);
}

}  // namespace
}  // namespace abut::geometry::arc_fit_curves_test
