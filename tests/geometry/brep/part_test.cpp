// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/curves/spline_shape.hpp"

namespace part_test {

namespace {

using namespace abut::geometry;
constexpr double pi = std::numbers::pi;

void add_loop(Part& part, const std::vector<Curve>& curves) {
    part.loops.emplace_back();
    for (const Curve& curve : curves) {
        part.loops.back().edges.push_back(static_cast<int>(part.edges.size()));
        part.edges.push_back({curve, "", ""});
    }
}

std::vector<Curve> closed(const std::vector<Vec2>& points) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < points.size(); ++i) curves.push_back(Segment{points[i], points[(i + 1) % points.size()]});
    return curves;
}

Part one_loop(const std::vector<Curve>& curves) {
    Part part;
    add_loop(part, curves);
    return part;
}

/// A part, its properties by elementary formulas, and whether a point is inside.
struct Sample {
    std::string name;
    Part part;
    double area, perimeter;
    Vec2 centroid;
    int n_holes;
    std::function<bool(const Vec2&)> inside;
};

bool in_disc(const Vec2& p, const Vec2& center, double r) {
    return (p - center).norm() < r;
}
bool in_box(const Vec2& p, double x0, double y0, double x1, double y1) {
    return p.x() > x0 && p.x() < x1 && p.y() > y0 && p.y() < y1;
}

Sample angle_section() {
    return {"angle section",
            one_loop(closed({{0, 0}, {2, 0}, {2, 0.5}, {0.5, 0.5}, {0.5, 1.5}, {0, 1.5}})),
            1.5,
            7,
            {(1.0 * 1 + 0.5 * 0.25) / 1.5, (1.0 * 0.25 + 0.5 * 1) / 1.5},
            0,
            [](const Vec2& p) { return in_box(p, 0, 0, 2, 0.5) || in_box(p, 0, 0, 0.5, 1.5); }};
}

Sample disc(double seam) {
    return {"disc", one_loop({Arc{{1, 2}, 1.5, seam, 2 * pi}}),           2.25 * pi, 3 * pi, {1, 2},
            0,      [](const Vec2& p) {
                return in_disc(p, {1, 2}, 1.5); }};
}

Sample half_disc() {
    return {"half disc", one_loop({Arc{{0, 0}, 1, 0, pi}, Segment{{-1, 0}, {1, 0}}}),     pi / 2, pi + 2, {0, 4 / (3 * pi)},
            0,           [](const Vec2& p) { return p.y() > 0 && in_disc(p, {0, 0}, 1); }};
}

/// The circle's part within a corner is missing: an arc that runs clockwise.
Sample notched_square() {
    const double rest = 1 - pi / 16;
    // the quarter disc's centroid is 4 r / (3 pi) from both its sides
    const double c = (0.5 - pi / 16 * (1 - 4 * 0.5 / (3 * pi))) / rest;
    return {"notched square",
            one_loop({Segment{{0, 0}, {1, 0}}, Segment{{1, 0}, {1, 0.5}}, Arc{{1, 1}, 0.5, -pi / 2, -pi / 2},
                      Segment{{0.5, 1}, {0, 1}}, Segment{{0, 1}, {0, 0}}}),
            rest,
            3 + pi / 4,
            {c, c},
            0,
            [](const Vec2& p) {
                return in_box(p, 0, 0, 1, 1) && !in_disc(p, {1, 1}, 0.5);
            }};
}

Sample plate_with_holes() {
    Part part = one_loop(closed({{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}));
    add_loop(part, {Arc{{-0.5, 0}, 0.25, pi, -pi}, Arc{{-0.5, 0}, 0.25, 0, -pi}});
    add_loop(part, closed({{0.75, 0}, {0.5, -0.25}, {0.25, 0}, {0.5, 0.25}}));
    const double rest = 2 - pi / 16 - 0.125;
    return {"plate with holes",
            part,
            rest,
            6 + pi / 2 + std::sqrt(2.0),
            {(0.5 * pi / 16 - 0.5 * 0.125) / rest, 0},
            2,
            [](const Vec2& p) {
                return in_box(p, -1, -0.5, 1, 0.5) && !in_disc(p, {-0.5, 0}, 0.25) &&
                       std::abs(p.x() - 0.5) + std::abs(p.y()) > 0.25;
            }};
}

Sample two_regions() {
    Part part = one_loop(closed({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    add_loop(part, closed({{3, 0}, {4, 0}, {4, 1}, {3, 1}}));
    return {
        "two regions", part, 2, 8, {2, 0.5}, 0, [](const Vec2& p) {
                return in_box(p, 0, 0, 1, 1) || in_box(p, 3, 0, 4, 1); }};
}

std::vector<Sample> samples() {
    return {angle_section(), disc(0), disc(0.3), disc(-pi), half_disc(), notched_square(), plate_with_holes(), two_regions()};
}

Vec2 moved(const Vec2& p, double c, double s, const Vec2& d) {
    return Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y()) + d;
}

double distance_to_boundary(const Part& part, const Vec2& p) {
    double least = 1e300;
    for (const Edge& e : part.edges) least = std::min(least, (point(e.curve, closest_parameter(e.curve, p)) - p).norm());
    return least;
}

/// How many of the points are judged wrongly; those closer than 1e-12 to the boundary may go either way.
int misjudged(const Sample& sample, const std::vector<Vec2>& points) {
    return static_cast<int>(std::count_if(points.begin(), points.end(), [&](const Vec2& p) {
        return contains(sample.part, p) != sample.inside(p) && distance_to_boundary(sample.part, p) > 1e-12;
    }));
}

TEST(Part, AreaPerimeterCentroidHoles) {
    for (const Sample& s : samples()) {
        SCOPED_TRACE(s.name);
        EXPECT_NEAR(area(s.part), s.area, 1e-15 * 10);
        EXPECT_NEAR(perimeter(s.part), s.perimeter, 1e-14);
        EXPECT_LT((centroid(s.part) - s.centroid).norm(), 1e-14);
        EXPECT_EQ(count_holes(s.part), s.n_holes);
    }
}

/// Taken about the part's own box: a kilometre away costs the digits of the coordinates (1e6 * 1e-16, over all edges) and no
/// more.
TEST(Part, PropertiesAfterAMove) {
    const double c = std::cos(0.7), s = std::sin(0.7);
    for (double away : {0.0, 10.0, 1e6}) {
        const Vec2 d(away, -away);
        const double tolerance = 1e-14 + 1e-15 * away;
        for (const Sample& sample : samples()) {
            SCOPED_TRACE(sample.name);
            const Part part = transformed(sample.part, c, s, d);
            EXPECT_NEAR(area(part), sample.area, tolerance);
            EXPECT_NEAR(perimeter(part), sample.perimeter, tolerance);
            EXPECT_LT((centroid(part) - moved(sample.centroid, c, s, d)).norm(), tolerance);
            EXPECT_EQ(count_holes(part), sample.n_holes);
        }
    }
}

TEST(Part, SecondMomentsAreThoseOfRectanglesAndRings) {
    const auto expect = [](const Part& part, const Vec2& about, double xx, double yy, double xy) {
        const Eigen::Matrix2d m = second_moments(part, about);
        EXPECT_NEAR(m(0, 0), xx, 1e-13 * (xx + yy));
        EXPECT_NEAR(m(1, 1), yy, 1e-13 * (xx + yy));
        EXPECT_NEAR(m(0, 1), xy, 1e-13 * (xx + yy));
    };
    const Part plate = one_loop(closed({{1, 2}, {5, 2}, {5, 3}, {1, 3}}));
    expect(plate, {3, 2.5}, 64.0 / 12, 4.0 / 12, 0);
    expect(plate, {0, 0}, 64.0 / 12 + 4 * 9, 4.0 / 12 + 4 * 6.25, 4 * 3 * 2.5);
    Part ring = one_loop({Arc{{1, 2}, 2, 0, 2 * pi}});
    add_loop(ring, {Arc{{1, 2}, 1, 0, -2 * pi}});
    expect(ring, {1, 2}, pi / 4 * (16 - 1), pi / 4 * (16 - 1), 0);
    // a straight side may be drawn as a spline whose speed changes at a knot anywhere
    std::vector<Curve> sides = closed({{0, 0}, {4, 0}, {4, 1}, {0, 1}});
    sides[2] = nurbs_curves({2, {0, 0, 0, 0.03, 1, 1, 1}, {{4, 1}, {3.9, 1}, {0.5, 1}, {0, 1}}, {}}).at(0);
    expect(one_loop(sides), {2, 0.5}, 64.0 / 12, 4.0 / 12, 0);
}

TEST(Part, NothingHasNoArea) {
    EXPECT_EQ(area(Part{}), 0);
    EXPECT_TRUE(bounding_box(Part{}).empty());
}

TEST(Part, BoundingBoxAndMergeLength) {
    const Box2 box = bounding_box(disc(0.3).part);
    EXPECT_EQ(box.min, Vec2(-0.5, 0.5));
    EXPECT_EQ(box.max, Vec2(2.5, 3.5));
    EXPECT_DOUBLE_EQ(merge_length(disc(0.3).part), 1e-9 * 3 * std::sqrt(2.0));
}

TEST(Part, ContainsRandomPoints) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-2, 5);
    std::vector<Vec2> points;
    for (int k = 0; k < 1000; ++k) points.emplace_back(any(random), any(random));
    for (const Sample& s : samples()) EXPECT_EQ(misjudged(s, points), 0) << s.name;
}

/// The ray from a point meets vertices, seams and horizontal tangents where the point is as high as they are, to the last bit.
TEST(Part, ContainsPointsAtTheHeightsOfVerticesSeamsAndExtrema) {
    for (const Sample& s : samples()) {
        std::vector<double> heights, places;
        for (const Edge& e : s.part.edges) {
            std::vector<double> special = axis_extrema(e.curve);
            special.insert(special.end(), {0, 1});
            for (double t : special)
                for (double to : {-9.0, 9.0}) {
                    const Vec2 p = point(e.curve, t);
                    heights.insert(heights.end(), {p.y(), std::nextafter(p.y(), to), std::round(8 * p.y()) / 8});
                    places.insert(places.end(), {p.x() + 1e-3, p.x() - 1e-3, p.x() + 0.37, p.x() - 0.37});
                }
            if (const auto* arc = std::get_if<Arc>(&e.curve))
                heights.insert(heights.end(), {arc->center.y(), arc->center.y() + arc->radius, arc->center.y() - arc->radius});
        }
        std::vector<Vec2> points;
        for (double y : heights)
            for (double x : places) points.emplace_back(x, y);
        ASSERT_GT(points.size(), 50u);
        EXPECT_EQ(misjudged(s, points), 0) << s.name;
    }
}

TEST(Part, ContainsAfterQuarterTurnsAndAnyTurn) {
    std::mt19937 random(13);
    std::uniform_real_distribution<double> any(-2, 5);
    const Vec2 d(0.25, -1);
    for (const Sample& original : samples())
        for (const Vec2& turn : {Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1), Vec2(0.6, 0.8)}) {
            Sample sample = original;
            sample.part = transformed(original.part, turn.x(), turn.y(), d);
            sample.inside = [&](const Vec2& p) { return original.inside(moved(p - d, turn.x(), -turn.y(), {0, 0})); };
            std::vector<Vec2> points;
            for (int k = 0; k < 200; ++k) points.push_back(moved({any(random), any(random)}, turn.x(), turn.y(), d));
            for (const Edge& e : sample.part.edges)
                for (double dx : {-0.3, -0.01, 0.01, 0.3}) points.push_back(point(e.curve, 0) + Vec2(dx, 0));
            EXPECT_EQ(misjudged(sample, points), 0) << sample.name;
        }
}

/// Counted in the source's own direction, whichever way the part's boundary runs.
TEST(Part, ArcLengthAlongTheSource) {
    Edge edge{Arc{{0, 0}, 2, 0, pi}, "circle#0", "circle"};
    EXPECT_NEAR(edge_arc_length(edge, 0), 0, 1e-15);
    EXPECT_NEAR(edge_arc_length(edge, 0.25), pi / 2, 1e-15);
    edge.along_source = false;
    EXPECT_NEAR(edge_arc_length(edge, 1), 0, 1e-15);
    EXPECT_NEAR(edge_arc_length(edge, 0.25), 1.5 * pi, 1e-15);
}

TEST(PartChecks, NoticeAFault) {
    Sample s = disc(0);
    s.inside = [](const Vec2& p) { return in_disc(p, {1, 2}, 1.51); };
    EXPECT_EQ(misjudged(s, {{2.505, 2}, {1, 2}}), 1);
}

}  // namespace

}  // namespace part_test
