// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/arc_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry::arc_fit_test {
namespace {

constexpr double pi = std::numbers::pi;
using Points = std::vector<Vec2>;

Points on_arc(const Vec2& center, double radius, double from, double sweep, int n_facets) {
    Points points;
    for (int k = 0; k <= n_facets; ++k) {
        const double angle = from + sweep * k / n_facets;
        points.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

Points circle(double radius, int n) {
    Points points = on_arc({3, -2}, radius, 0.3, 2 * pi, n);
    points.pop_back();
    return points;
}

const Arc& arc_of(const FittedPiece& piece) {
    return std::get<Arc>(piece.curve);
}

/// Every piece begins where the one before ended, at its first point, and all points lie on theirs within the tolerance.
void expect_consistent(const std::vector<FittedPiece>& pieces, const Points& points, bool closed, double tolerance) {
    ASSERT_FALSE(pieces.empty());
    const int n = static_cast<int>(points.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const FittedPiece& piece = pieces[k];
        const auto at = [&](int i) { return points[static_cast<std::size_t>(i % n)]; };
        EXPECT_LE((point(piece.curve, 0) - at(piece.first)).norm(), 1e-12 * 100);
        EXPECT_LE((point(piece.curve, 1) - at(piece.last)).norm(), 1e-12 * 100);
        if (k + 1 < pieces.size() || closed) { EXPECT_EQ(piece.last, pieces[(k + 1) % pieces.size()].first); }
        double worst = 0;
        for (int i = piece.first; i != piece.last; i = (i + 1) % n)
            worst = std::max(worst, (point(piece.curve, closest_parameter(piece.curve, at(i))) - at(i)).norm());
        EXPECT_LE(worst, piece.residual + 1e-12);
        EXPECT_LE(piece.residual, tolerance);
    }
    if (closed) return;
    EXPECT_EQ(pieces.front().first, 0);
    EXPECT_EQ(pieces.back().last, n - 1);
}

TEST(ArcFit, CirclesAreFullArcs) {
    for (const int n : {24, 30, 64, 360, 5000})
        for (const double radius : {0.5, 10.0}) {
            const auto pieces = fit_lines_and_arcs(circle(radius, n), true, 1e-3);
            ASSERT_EQ(pieces.size(), 1u) << n;
            EXPECT_EQ(pieces[0].first, 0);
            EXPECT_EQ(pieces[0].last, 0);
            const Arc& arc = arc_of(pieces[0]);
            EXPECT_EQ(arc.sweep, 2 * pi);
            EXPECT_NEAR(arc.radius, radius, 1e-12);
            EXPECT_LE((arc.center - Vec2(3, -2)).norm(), 1e-12);
            EXPECT_LE(pieces[0].residual, 1e-12);
        }
    Points clockwise = circle(10, 64);
    std::reverse(clockwise.begin(), clockwise.end());
    EXPECT_EQ(arc_of(fit_lines_and_arcs(clockwise, true, 1e-3)[0]).sweep, -2 * pi);
}

TEST(ArcFit, PolygonsStayPolygons) {
    for (const int n : {3, 4, 6, 8, 12, 16, 23})
        EXPECT_EQ(fit_lines_and_arcs(circle(10, n), true, 1e-3).size(), static_cast<std::size_t>(n));
    EXPECT_EQ(fit_lines_and_arcs(circle(10, 24), true, 1e-3).size(), 1u);  // a facet turns by 0.262, below the limit of 0.27
    // a chamfered and a coarsely rounded corner
    const auto chamfer = fit_lines_and_arcs({{0, 0}, {9, 0}, {10, 1}, {10, 10}}, false, 1e-3);
    EXPECT_EQ(chamfer.size(), 3u);
    Points rounded{{0, 0}};
    for (const Vec2& p : on_arc({9, 1}, 1, -pi / 2, pi / 2, 4)) rounded.push_back(p);
    rounded.push_back({10, 10});
    EXPECT_EQ(fit_lines_and_arcs(rounded, false, 1e-3).size(), 6u);
}

TEST(ArcFit, FindsWhereLinesAndArcsMeet) {
    // a rounded rectangle: lines in several pieces, fillets of different size and fineness; begun anywhere on it
    Points outline;
    const auto add = [&](const Points& points) { outline.insert(outline.end(), points.begin(), points.end()); };
    add({{2, 0}, {10, 0}, {25, 0}});
    add(on_arc({27, 3}, 3, -pi / 2, pi / 2, 8));
    add({{30, 8}});
    add(on_arc({25, 15}, 5, 0, pi / 2, 40));
    add({{14, 20}, {13, 20}});
    add(on_arc({1, 19}, 1, pi / 2, pi / 2, 12));
    add(on_arc({2, 2}, 2, pi, pi / 2, 16));
    outline.pop_back();  // where it began
    for (std::size_t shift = 0; shift < outline.size(); ++shift) {
        Points turned = outline;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(shift), turned.end());
        const auto pieces = fit_lines_and_arcs(turned, true, 1e-3);
        expect_consistent(pieces, turned, true, 1e-3);
        ASSERT_EQ(pieces.size(), 8u) << shift;
        std::vector<double> radii;
        for (const FittedPiece& piece : pieces)
            if (const auto* arc = std::get_if<Arc>(&piece.curve)) {
                radii.push_back(arc->radius);
                EXPECT_NEAR(arc->sweep, pi / 2, 1e-9);
                EXPECT_LE(piece.residual, 1e-12);  // nothing of the lines was taken in, near as it is
            }
        std::sort(radii.begin(), radii.end());
        ASSERT_EQ(radii.size(), 4u);
        for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(radii[k], (std::vector<double>{1, 2, 3, 5})[k], 1e-9);
    }
}

TEST(ArcFit, CornersAreNotRoundedOff) {
    // a lens of two arcs, begun in the middle of one
    const double half = std::acos(0.5);
    Points lens = on_arc({0, -5}, 10, pi / 2 - half, 2 * half, 40);
    lens.pop_back();
    for (const Vec2& p : on_arc({0, 5}, 10, -pi / 2 - half, 2 * half, 40)) lens.push_back(p);
    lens.pop_back();
    std::rotate(lens.begin(), lens.begin() + 17, lens.end());
    const auto pieces = fit_lines_and_arcs(lens, true, 1e-3);
    ASSERT_EQ(pieces.size(), 2u);
    for (const FittedPiece& piece : pieces) EXPECT_NEAR(arc_of(piece).radius, 10, 1e-9);
    expect_consistent(pieces, lens, true, 1e-3);
}

TEST(ArcFit, LinesAreLines) {
    Points points;
    for (int k = 0; k <= 50; ++k) points.push_back(Vec2(0.1 * k * k, 0.05 * k * k + 1e-5 * std::sin(7.0 * k)));
    const auto pieces = fit_lines_and_arcs(points, false, 1e-4);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<Segment>(pieces[0].curve));
    expect_consistent(pieces, points, false, 1e-4);
    // there and back is not one line
    EXPECT_EQ(fit_lines_and_arcs({{0, 0}, {10, 0}, {4, 0}}, false, 1e-4).size(), 2u);
}

TEST(ArcFit, NoiseWithinTheToleranceIsTolerated) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 100; ++trial) {
        const double radius = 1 + static_cast<double>(random() % 50), tolerance = 1e-3;
        const double sweep = 0.5 + 5 * std::generate_canonical<double, 53>(random);
        const int n = static_cast<int>(sweep / 0.2) + 10 + static_cast<int>(random() % 100);
        Points points = on_arc({1, 2}, radius, 6 * std::generate_canonical<double, 53>(random), sweep, n);
        const double facet = radius * sweep / n, sagitta = facet * facet / (8 * radius);
        // Facets do not turn back; where they stand off by the tolerance, their points must be nearer to tell the arc.
        const double noise = std::min({0.3 * tolerance, 0.01 * facet, sagitta > 0.5 * tolerance ? 0.05 * sagitta : tolerance});
        for (Vec2& p : points)
            p += noise *
                 Vec2(std::generate_canonical<double, 53>(random) - 0.5, std::generate_canonical<double, 53>(random) - 0.5);
        const auto pieces = fit_lines_and_arcs(points, false, tolerance);
        expect_consistent(pieces, points, false, tolerance);
        ASSERT_EQ(pieces.size(), 1u) << trial;
        // Ends off by the noise turn the bisector: a centre of an arc of small sweep moves by noise / (1 - cos(sweep / 2)).
        EXPECT_NEAR(arc_of(pieces[0]).radius, radius, 5 * noise / (1 - std::cos(sweep / 2)));
    }
}

TEST(ArcFit, RandomPolylinesStayWithinTheTolerance) {
    std::mt19937 random(11);
    for (int trial = 0; trial < 200; ++trial) {
        Points points{{0, 0}};
        double direction = 0;
        const int n = 2 + static_cast<int>(random() % 60);
        for (int k = 0; k < n; ++k) {  // bends of all kinds, smooth stretches among them
            if (random() % 8 == 0) direction += 2 * std::generate_canonical<double, 53>(random) - 1;
            direction += random() % 2 == 0 ? 0.1 : 0.0;
            points.push_back(points.back() +
                             (0.1 + static_cast<double>(random() % 3)) * Vec2(std::cos(direction), std::sin(direction)));
        }
        for (const bool closed : {false, true})
            expect_consistent(fit_lines_and_arcs(points, closed, 1e-2), points, closed, 1e-2);
    }
}

TEST(ArcFit, TakesTimeInProportion) {
    // 200 000 points: one circle, and as many corners
    EXPECT_EQ(fit_lines_and_arcs(circle(1000, 200000), true, 1e-6).size(), 1u);
    Points zigzag;
    for (int k = 0; k < 200000; ++k) zigzag.push_back(Vec2(k, k % 2));
    EXPECT_EQ(fit_lines_and_arcs(zigzag, false, 1e-6).size(), 199999u);
}

TEST(ArcFit, CurvesThatAreLinesOrArcs) {
    const double w = std::sqrt(0.5);
    const Curve quarter = bezier_curve({{10, 0}, {10, 10}, {0, 10}}, {1, w, 1});
    const auto arc = as_line_or_arc(quarter, 1e-9);
    ASSERT_TRUE(arc);
    EXPECT_LE((std::get<Arc>(*arc).center - Vec2(0, 0)).norm(), 1e-12);
    EXPECT_NEAR(std::get<Arc>(*arc).sweep, pi / 2, 1e-12);
    const auto line = as_line_or_arc(bezier_curve({{0, 0}, {1, 1}, {5, 5}, {6, 6}}, {}), 1e-9);
    ASSERT_TRUE(line);
    EXPECT_EQ(std::get<Segment>(*line).to, Vec2(6, 6));
    const auto all_around = as_line_or_arc(EllipticArc{{1, 2}, {0, 3}, {-3, 0}, 0.4, 2 * pi}, 1e-9);
    ASSERT_TRUE(all_around);
    EXPECT_EQ(std::get<Arc>(*all_around).sweep, 2 * pi);
    EXPECT_NEAR(std::get<Arc>(*all_around).radius, 3, 1e-12);
    const auto mirrored = as_line_or_arc(EllipticArc{{1, 2}, {3, 0}, {0, -3}, 0, 1}, 1e-9);
    ASSERT_TRUE(mirrored);
    EXPECT_NEAR(std::get<Arc>(*mirrored).sweep, -1, 1e-12);

    EXPECT_FALSE(as_line_or_arc(EllipticArc{{1, 2}, {3, 0}, {0, 2.99}, 0, 2}, 1e-4));
    EXPECT_FALSE(as_line_or_arc(bezier_curve({{10, 0}, {10, 10}, {0, 10}}, {1, 1, 1}), 1e-2));
    // the usual cubic for a quarter circle is off by 2.7e-4 of the radius, outwards; half of that from the circle between
    const double k = 0.5522847498;
    const Curve cubic = bezier_curve({{10, 0}, {10, 10 * k}, {10 * k, 10}, {0, 10}}, {});
    EXPECT_FALSE(as_line_or_arc(cubic, 1e-3));
    EXPECT_TRUE(as_line_or_arc(cubic, 2e-3));
    // a spline that turns back along its line is none
    EXPECT_FALSE(as_line_or_arc(bezier_curve({{0, 0}, {20, 0}, {-10, 0}, {10, 0}}, {}), 1e-6));
}

}  // namespace
}  // namespace abut::geometry::arc_fit_test
