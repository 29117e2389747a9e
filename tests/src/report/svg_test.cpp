// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/svg.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <sstream>

#include "geometry/curves/spline_shape.hpp"
#include "tests/src/results/synthetic_result.hpp"

namespace abut::svg_test {
namespace {

Box2 box(const Vec2& min, const Vec2& max) {
    Box2 b;
    b.extend(min);
    b.extend(max);
    return b;
}

TEST(Svg, ViewFitsWideModelsToTheWidthAndTurnsYDown) {
    const View view = fit_view(box({10, -5}, {170, 10}), 1000, 500, 20);
    EXPECT_NEAR(view(Vec2(10, 0)).x(), 20, 1e-9);
    EXPECT_NEAR(view(Vec2(170, 0)).x(), 980, 1e-9);
    EXPECT_NEAR(view(Vec2(0, 10)).y(), 20, 1e-9);
    EXPECT_NEAR(view(Vec2(0, -5)).y(), view.height - 20, 1e-9);
    EXPECT_NEAR(view.height, 15 * 6 + 40, 1e-9);
}

TEST(Svg, ViewFitsHighModelsToTheHeightAndCentresThem) {
    const View view = fit_view(box({0, 0}, {1, 100}), 600, 440, 20);
    EXPECT_NEAR(view.height, 440, 1e-9);
    EXPECT_NEAR(view(Vec2(0.5, 0)).x(), 300, 1e-9);
}

TEST(Svg, ViewOfNothingAndOfAPointIsFinite) {
    for (const Box2& b : {Box2{}, box({3, 4}, {3, 4})}) {
        const View view = fit_view(b, 600, 400, 20);
        EXPECT_TRUE(std::isfinite(view.height) && view.height > 0 && view(Vec2(3, 4)).allFinite());
    }
}

TEST(Svg, PathOfAPartHasOneClosedSubpathPerLoop) {
    geometry::Part part = synthetic::rectangle("p", {0, 0}, {10, 5});
    const View view = fit_view(geometry::bounding_box(part), 120, 100, 10);
    EXPECT_EQ(path_data(part, view), "M10 60L110 60L110 10L10 10L10 60Z");
    synthetic::add_hole(part, {5, 2}, 1);
    const std::string path = path_data(part, view);
    EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
    EXPECT_EQ(std::count(path.begin(), path.end(), 'Z'), 2);
}

TEST(Svg, ArcsStayArcsAndTurnTheRightWay) {
    View view;  // scale 1, y down
    const geometry::Curve quarter = geometry::Arc{{0, 0}, 10, 0, std::numbers::pi / 2};
    EXPECT_EQ(path_data(quarter, 0, 1, view), "M10 0A10 10 0 0 0 0 -10");  // counter-clockwise: sweep flag 0
    EXPECT_EQ(path_data(geometry::reversed(quarter), 0, 1, view), "M0 -10A10 10 0 0 1 10 0");
    const std::string half = path_data(geometry::Curve(geometry::Arc{{0, 0}, 10, 0, 2 * std::numbers::pi}), 0, 0.5, view);
    EXPECT_EQ(half.substr(half.size() - 5), "-10 0") << half;
}

TEST(Svg, FullCircleIsDrawnInPiecesBelowAHalfTurn) {
    View view;
    const std::string path = path_data(geometry::Curve(geometry::Arc{{0, 0}, 1, 0.3, 2 * std::numbers::pi}), 0, 1, view);
    EXPECT_GE(std::count(path.begin(), path.end(), 'A'), 3);
}

/// The points of path data at the ends of its commands, with the last five numbers of an "A" as they stand.
std::vector<Vec2> path_points(const std::string& path) {
    std::vector<Vec2> points;
    std::istringstream text(path);
    for (char command = 0; text >> command;) {
        double skipped = 0;
        for (int k = 0; k < (command == 'A' ? 5 : 0); ++k) text >> skipped;
        Vec2 p;
        text >> p.x() >> p.y();
        points.push_back(p);
    }
    return points;
}

TEST(Svg, EllipsesAreArcsWithRotationAndSense) {
    View view;  // scale 1, y down
    const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
    const geometry::EllipticArc quarter{{0, 0}, {20 * c, 20 * s}, {-10 * s, 10 * c}, 0, std::numbers::pi / 2};
    EXPECT_EQ(path_data(geometry::Curve(quarter), 0, 1, view), "M17.32 -10A20 10 -30 0 0 -5 -8.66");
    geometry::EllipticArc mirrored = quarter;
    mirrored.b = -mirrored.b;
    EXPECT_EQ(path_data(geometry::Curve(mirrored), 0, 1, view), "M17.32 -10A20 10 -30 0 1 5 8.66");
    geometry::EllipticArc full = quarter;
    full.sweep = 2 * std::numbers::pi;
    const std::string path = path_data(geometry::Curve(full), 0, 1, view);
    EXPECT_GE(std::count(path.begin(), path.end(), 'A'), 3);
}

TEST(Svg, SplinesAreDrawnAsArcsThroughTheirPoints) {
    const View view = fit_view(box({0, 0}, {4, 3}), 1000, 800, 20);
    const geometry::Curve spline = geometry::bezier_curve({{0, 0}, {1, 4}, {3, 4}, {4, 0}}, {});
    for (const auto& [t0, t1] : {std::pair(0.0, 1.0), std::pair(0.25, 0.75)}) {
        const std::vector<Vec2> points = path_points(path_data(spline, t0, t1, view));
        ASSERT_GT(points.size(), 5u);
        EXPECT_NEAR((points.front() - view(geometry::point(spline, t0))).norm(), 0, 0.01);
        EXPECT_NEAR((points.back() - view(geometry::point(spline, t1))).norm(), 0, 0.01);
        for (const Vec2& p : points) {
            const Vec2 model((p.x() - view.offset.x()) / view.scale, (view.offset.y() - p.y()) / view.scale);
            const Vec2 closest = geometry::point(spline, geometry::closest_parameter(spline, model));
            EXPECT_LT((closest - model).norm() * view.scale, 0.06);
        }
    }
}

TEST(Svg, TicksCoverTheRangeAtNiceSteps) {
    const std::vector<std::pair<double, double>> ranges{{0, 1},     {-3.3, 7.1},    {1e-9, 3e-9},
                                                        {0, 132.4}, {1e6, 1e6 + 3}, {-5, -1}};
    for (const auto& [low, high] : ranges)
        for (int n : {3, 5, 8}) {
            const std::vector<double> ticks = nice_ticks(low, high, n);
            ASSERT_GE(ticks.size(), 2u);
            const double step = ticks[1] - ticks[0];
            EXPECT_LE(ticks.front(), low + 1e-6 * step);
            EXPECT_GE(ticks.back(), high - 1e-6 * step);
            EXPECT_GT(ticks[1], low) << "a tick too many below";
            EXPECT_LT(ticks[ticks.size() - 2], high) << "a tick too many above";
            const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-6));
            EXPECT_TRUE(std::abs(mantissa - 1) < 1e-5 || std::abs(mantissa - 2) < 1e-5 || std::abs(mantissa - 5) < 1e-5)
                << step;
            EXPECT_LE(std::abs(static_cast<double>(ticks.size()) - n), 0.5 * n + 2) << low << " " << high << " " << n;
        }
}

TEST(Svg, TicksOfOneValueAndOfNonsense) {
    EXPECT_GE(nice_ticks(5, 5, 4).size(), 2u);
    EXPECT_GE(nice_ticks(0, 0, 4).size(), 2u);
    EXPECT_GE(nice_ticks(0, std::numeric_limits<double>::infinity(), 4).size(), 2u);
}

/// Relative luminance of "#rrggbb", with the weights of Rec. 709 without its gamma.
double lightness(const std::string& color) {
    const auto channel = [&](std::size_t at) { return std::stoi(color.substr(at, 2), nullptr, 16) / 255.0; };
    return 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
}

TEST(Svg, ColorMapGetsLighterAllTheWay) {
    for (int i = 0; i < 50; ++i) EXPECT_LT(lightness(map_color(i / 50.0)), lightness(map_color((i + 1) / 50.0))) << i;
    EXPECT_EQ(map_color(-1), map_color(0));
    EXPECT_EQ(map_color(2), map_color(1));
    EXPECT_EQ(map_color(std::numeric_limits<double>::quiet_NaN()), map_color(0));
}

TEST(Svg, PartColorsDifferAndAreLightEnoughForBlackText) {
    std::set<std::string> seen;
    for (int i = 0; i < 12; ++i) {
        EXPECT_TRUE(seen.insert(part_color(i)).second) << i;
        EXPECT_GT(lightness(part_color(i)), 0.6) << i;
    }
    EXPECT_EQ(part_color(12), part_color(0));
}

}  // namespace
}  // namespace abut::svg_test
