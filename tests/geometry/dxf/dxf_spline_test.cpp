// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/curves/spline_shape.hpp"
#include "geometry/curves/spline_through.hpp"
#include "tests/geometry/dxf/dxf_text.hpp"

namespace abut::geometry::dxf_spline_test {
namespace {

constexpr double pi = std::numbers::pi;

using Points = std::vector<Vec2>;

std::string codes(int code, const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text += dxf_groups({{code, value}});
    return text;
}

std::string points_text(int x_code, const Points& points) {
    std::string text;
    for (const Vec2& p : points) text += dxf_groups({{x_code, p.x()}, {x_code + 10, p.y()}});
    return text;
}

std::string spline(int flags, int degree, const std::string& numbers) {
    return dxf_record("SPLINE", "2F", "A", {}) + "70\n" + std::to_string(flags) + "\n71\n" + std::to_string(degree) + "\n" +
           numbers;
}

Drawing read_spline(int flags, int degree, const std::string& numbers) {
    return read_drawing(dxf_file(spline(flags, degree, numbers)));
}

void expect_near(const Vec2& a, const Vec2& b, double tolerance = 1e-12) {
    EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " | " << b.transpose();
}

TEST(DxfSpline, ReadsRationalSplines) {
    const double w = std::sqrt(0.5);
    const Drawing drawing =
        read_spline(8, 2, codes(40, {0, 0, 0, 1, 1, 1}) + codes(41, {1, w, 1}) + points_text(10, {{2, 0}, {2, 2}, {0, 2}}));
    ASSERT_EQ(drawing.entities.size(), 1u);
    EXPECT_EQ(drawing.entities[0].name, "h2F");
    EXPECT_EQ(drawing.entities[0].kind, "SPLINE");
    for (double t = 0; t <= 1; t += 0.125) EXPECT_NEAR(point(drawing.entities[0].curve, t).norm(), 2, 1e-14);
    EXPECT_EQ(drawing.counts.at("SPLINE").used, 1);
}

TEST(DxfSpline, CutsAtCorners) {
    const Drawing drawing =
        read_spline(8, 2, codes(40, {0, 0, 0, 1, 1, 2, 2, 2}) + points_text(10, {{0, 0}, {1, 0}, {2, 1}, {2, 3}, {0, 3}}));
    ASSERT_EQ(drawing.entities.size(), 2u);
    EXPECT_EQ(drawing.entities[0].name, "h2F.0");
    EXPECT_EQ(drawing.entities[1].name, "h2F.1");
    expect_near(point(drawing.entities[0].curve, 1), {2, 1});
    expect_near(point(drawing.entities[1].curve, 0), {2, 1});
}

TEST(DxfSpline, TurnsDegreeOneIntoLines) {
    const Drawing drawing = read_spline(8, 1, codes(40, {0, 0, 1, 2, 2}) + points_text(10, {{0, 0}, {1, 0}, {1, 1}}));
    ASSERT_EQ(drawing.entities.size(), 2u);
    for (const SketchEntity& entity : drawing.entities) EXPECT_EQ(kind_name(entity.curve), "line");
    expect_near(point(drawing.entities[1].curve, 1), {1, 1});
}

TEST(DxfSpline, CompletesClosedSplines) {
    const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, wrapped{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}};
    const std::string knots = codes(40, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    const Drawing whole = read_spline(11, 3, knots + points_text(10, wrapped));
    const Drawing without_points = read_spline(11, 3, knots + points_text(10, square));
    const Drawing without_knots = read_spline(3, 3, points_text(10, square));
    ASSERT_EQ(whole.entities.size(), 1u);
    for (const Drawing* other : {&without_points, &without_knots}) {
        ASSERT_EQ(other->entities.size(), 1u);
        for (double t = 0; t <= 1; t += 0.0625)
            expect_near(point(other->entities[0].curve, t), point(whole.entities[0].curve, t), 1e-14);
    }
    expect_near(point(whole.entities[0].curve, 0), point(whole.entities[0].curve, 1));
    const Drawing open = read_spline(8, 3, points_text(10, square));  // no knots: clamped at the ends
    expect_near(point(open.entities.at(0).curve, 0), {0, 0});
    expect_near(point(open.entities.at(0).curve, 1), {0, 4});
}

TEST(DxfSpline, RefusesNumbersThatMakeNoSpline) {
    const std::string points = points_text(10, {{0, 0}, {1, 2}, {2, 0}, {3, 1}}), knots = codes(40, {0, 0, 0, 0, 1, 1, 1, 1});
    ASSERT_TRUE(read_spline(8, 3, knots + points).problems.empty());
    const std::vector<std::pair<std::string, std::string>> bad{
        {spline(8, 3, ""), "neither control points nor fit points"},
        {spline(8, 3, points + codes(40, {0, 0, 0, 1, 1, 1})), "knots"},
        {spline(8, 3, points + codes(40, {0, 0, 0, 1, 0, 1, 1, 1})), "less than the one before"},
        {spline(8, 3, points + knots + codes(41, {1, 1})), "weights"},
        {spline(8, 3, points + knots + codes(41, {1, 1, -1, 1})), "positive"},
        {spline(8, 90, points + knots), "degree"},
        {spline(8, -2000000000, points + knots), "degree"},
        {spline(8, 3, knots + "10\n1\n10\n2\n20\n0\n"), "lack coordinates"},
        {spline(8, 3, knots + points + "20\n0\n"), "lack coordinates"},
        {spline(8, 3, knots + points + "10\n1\n"), "lack coordinates"},
        {spline(8, 3, codes(40, {0, 0, 0, 0, 1, 1, 1}) + "40\nnan\n" + points), "'nan'"},
        {spline(1, 3, points_text(11, {{0, 0}, {1, 1}, {0, 0}})), "fewer than three"},
        {spline(1, 3, points_text(11, {{20, 0}, {30, 10}, {20 + 4e-15, 0}})), "fewer than three"},
        {spline(8, 3, points_text(11, {{0, 0}, {1e13, 1}})), "sensible"}};
    for (const auto& [record, what] : bad) {
        const Drawing drawing = read_drawing(dxf_file(record));
        EXPECT_TRUE(drawing.entities.empty());
        ASSERT_EQ(drawing.problems.size(), 1u) << what;
        EXPECT_NE(drawing.problems[0].what.find(what), std::string::npos) << drawing.problems[0].what;
        EXPECT_EQ(drawing.problems[0].entity, "h2F");
    }
}

TEST(DxfSpline, SplinesOfOnePointHaveNoLength) {
    for (const std::string& numbers :
         {points_text(11, {{1, 2}, {1, 2}}), codes(40, {0, 0, 1, 1}) + points_text(10, {{1, 2}, {1, 2}})}) {
        const Drawing drawing = read_spline(8, 1, numbers);
        ASSERT_EQ(drawing.entities.size(), 1u);
        EXPECT_EQ(length(drawing.entities[0].curve), 0);
        expect_near(point(drawing.entities[0].curve, 0), {1, 2});
    }
}

const Points wave{{0, 0}, {1, 2}, {3, 2.5}, {4, 0}, {4.5, -1}, {8, 1}};

/// Distance of the point from the curve.
double distance(const Curve& curve, const Vec2& p) {
    return (point(curve, closest_parameter(curve, p)) - p).norm();
}

TEST(DxfSpline, PassesThroughFitPoints) {
    const Drawing drawing = read_spline(8, 3, points_text(11, wave));
    ASSERT_EQ(drawing.entities.size(), 1u);  // smooth: in one piece
    const Curve& curve = drawing.entities[0].curve;
    for (const Vec2& p : wave) EXPECT_LE(distance(curve, p), 1e-12);
    EXPECT_GT(distance(curve, {1, 2.1}), 0.01);  // the check can fail
    const double size = 8;
    for (const double end : {0.0, 1.0}) EXPECT_LE(std::abs(curvature(curve, end)) * size, 1e-11);
    EXPECT_GT(std::abs(curvature(curve, 0.5)) * size, 0.1);
}

TEST(DxfSpline, KeepsGivenTangents) {
    const Curve curve =
        read_spline(8, 3, points_text(11, wave) + dxf_groups({{12, 0}, {22, -3}, {13, 1e-3}, {23, 0}})).entities.at(0).curve;
    expect_near(unit_tangent(curve, 0), {0, -1});
    expect_near(unit_tangent(curve, 1), {1, 0});
    for (const Vec2& p : wave) EXPECT_LE(distance(curve, p), 1e-12);
    const Curve natural = read_spline(8, 3, points_text(11, wave) + dxf_groups({{12, 0}, {22, 0}})).entities.at(0).curve;
    EXPECT_LE(std::abs(curvature(natural, 0)), 1e-11);  // a tangent of no length is none
}

TEST(DxfSpline, CurvatureIsContinuousAtFitPoints) {
    for (const bool closed : {false, true}) {
        const Nurbs nurbs = spline_through({wave, closed, {}, {}});
        for (std::size_t k = 3; k < nurbs.points.size(); k += 3) {  // Bezier points around each fit point
            const bool is_seam = k + 1 == nurbs.points.size();
            if (is_seam && !closed) break;
            const std::size_t i = k / 3, n = nurbs.points.size();
            const auto at = [&](std::size_t j) { return nurbs.points[j < n ? j : j - n + 1]; };
            const double h1 = nurbs.knots[3 * i + 1] - nurbs.knots[3 * i - 2];
            const double h2 = is_seam ? nurbs.knots[4] : nurbs.knots[3 * i + 4] - nurbs.knots[3 * i + 1];
            const Vec2 before = (at(k) - 2 * at(k - 1) + at(k - 2)) / (h1 * h1),
                       after = (at(k) - 2 * at(k + 1) + at(k + 2)) / (h2 * h2);
            expect_near((at(k) - at(k - 1)) / h1, (at(k + 1) - at(k)) / h2);
            expect_near(before, after);
        }
    }
}

/// The largest distance from the unit circle of the closed spline through n points of it.
double circle_error(int n) {
    Points points;
    for (int i = 0; i < n; ++i) points.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n));
    points.push_back(points.front() + Vec2(4e-16, 4e-16));  // as CAD writes closed splines, rounded twice
    const Curve curve = read_spline(1, 3, points_text(11, points)).entities.at(0).curve;
    double error = 0;
    for (int i = 0; i <= 50 * n; ++i) error = std::max(error, std::abs(point(curve, i / (50.0 * n)).norm() - 1));
    return error;
}

TEST(DxfSpline, ClosedSplinesConvergeToACircle) {
    for (int n = 16; n <= 64; n *= 2) EXPECT_NEAR(std::log2(circle_error(n) / circle_error(2 * n)), 4, 0.15) << n;
}

}  // namespace
}  // namespace abut::geometry::dxf_spline_test
