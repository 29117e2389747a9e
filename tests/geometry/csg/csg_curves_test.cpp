// SPDX-License-Identifier: GPL-3.0-or-later
// Booleans of ellipses and splines: areas against closed forms, ends against the true curves.
#include <cmath>

#include "geometry/curves/curve_moments.hpp"
#include "tests/geometry/csg/csg_nodes.hpp"

namespace csg_curves_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::csg_nodes;

/// Points of the result that come from `source` lie on it to rounding.
void expect_on(const Part& part, const std::string& source, const Curve& curve) {
    const double size = bounding_box(part).diagonal();
    int n = 0;
    for (const Edge& e : part.edges) {
        if (e.source != source) continue;
        for (int i = 0; i <= 20; ++i, ++n) {
            const Vec2 p = point(e.curve, i / 20.0);
            EXPECT_LE((point(curve, closest_parameter(curve, p)) - p).norm(), 1e-12 * size)
                << source << " at " << p.transpose();
        }
    }
    EXPECT_GT(n, 0) << source;
}

Curve curve_of(const CsgNode& primitive) {
    return good(primitive).edges.front().curve;
}

/// Area of the ellipse's part within `depth` of the end of its first half axis.
double cap(double a, double b, double depth) {
    const double angle = 2 * std::asin(std::sqrt(depth / (2 * a)));
    return a * b * (angle - std::sin(angle) * std::cos(angle));
}

/// Area of the ellipse's sector from its first axis to the polar angle.
double sector(double a, double b, double angle) {
    return a * b / 2 * std::atan2(a * std::sin(angle), b * std::cos(angle));
}

}  // namespace

TEST(CsgCurves, EllipseAlone) {
    const Part part = good(ellipse(1, 2, 4, 0.5, 90, "pin"));
    EXPECT_NEAR(area(part), 2 * pi, 1e-13 * 2 * pi);
    ASSERT_EQ(names(part), Names{"pin/ellipse"});
    expect_same_point(point(part.edges[0].curve, 0), {1, 6}, 0);
    expect_same_point(point(part.edges[0].curve, 0.25), {0.5, 2}, 1e-15);
    EXPECT_EQ(kind_name(curve_of(ellipse(0, 0, 2, 2, 30))), "arc");
    EXPECT_NE(problem_of(ellipse(0, 0, 1, -1)).find("not positive"), std::string::npos);
    EXPECT_NE(problem_of(ellipse(0, 0, 1, std::nan(""))).find("not finite"), std::string::npos);
}

TEST(CsgCurves, EllipseCutByALineAtAnyHeight) {
    const double a = 3, b = 1.25;
    for (int i = 0; i < 60; ++i) {
        const double h = a * i / 60.0;
        const Part part = good(common({ellipse(0, 0, a, b), half_plane(h, 0, -1, 0)}));
        EXPECT_NEAR(area(part), cap(a, b, a - h), 1e-13 * pi * a * b) << h;
        EXPECT_EQ(names(part), (Names{"ellipse", "line"}));
        const double y = b * std::sqrt(1 - h * h / (a * a));
        expect_same_point(point(edge(part, "line").curve, 0), {h, y}, 1e-12 * 2 * a);
        expect_same_point(point(edge(part, "line").curve, 1), {h, -y}, 1e-12 * 2 * a);
        expect_on(part, "ellipse", curve_of(ellipse(0, 0, a, b)));
    }
}

TEST(CsgCurves, CapsOfAnEllipseDownToTheMergeLength) {
    // The chord comes ever closer to the end of the ellipse: in the end the coarsest arcs alone cannot tell.
    const double a = 3, b = 1.25;
    for (double depth = 1e-2; depth > 1e-7; depth /= 3) {
        const Part part = good(less({ellipse(0, 0, a, b), half_plane(a - depth, 0, -1, 0)}));
        EXPECT_NEAR(area(part), pi * a * b - cap(a, b, depth), 1e-14 * pi * a * b) << depth;
        EXPECT_EQ(part.edges.size(), 2u);
        EXPECT_NEAR(length(edge(part, "line").curve), 2 * b / a * std::sqrt(depth * (2 * a - depth)), 1e-8) << depth;
    }
}

TEST(CsgCurves, EllipseLessTheSameTurned) {
    const double a = 2, b = 1;
    for (double degrees : {90.0, 60.0, 37.0, 5.0, 0.5}) {
        const double half = degrees * pi / 360;  // where the two cross, and every quarter turn from there
        const double shared = 4 * (sector(a, b, half + pi / 2) - sector(a, b, half));
        const CsgNode e = ellipse(0.3, 0.4, a, b), turned = ellipse(0.3, 0.4, a, b, degrees);
        EXPECT_NEAR(area_of(common({e, turned})), shared, 1e-12 * shared);
        EXPECT_NEAR(area_of(join({e, turned})), 2 * pi * a * b - shared, 1e-12 * 2 * shared);
        const Part part = good(less({e, turned}));
        EXPECT_NEAR(area(part), pi * a * b - shared, 1e-12 * shared);
        EXPECT_EQ(part.loops.size(), 2u);
        expect_on(part, "0/ellipse", curve_of(e));
        expect_on(part, "1/ellipse", curve_of(turned));
    }
}

TEST(CsgCurves, NurbsCircleMeetsTrueCircle) {
    const double r = 2;
    for (int i = 1; i < 40; ++i) {
        const double d = 2 * r * i / 40.0;
        const double lens = 2 * r * r * std::acos(d / (2 * r)) - d / 2 * std::sqrt(4 * r * r - d * d);
        const CsgNode drawn = loop_of({nurbs_circle({0, 0}, r)}), round = circle(d, 0, r);
        EXPECT_NEAR(area_of(join({drawn, round})), 2 * pi * r * r - lens, 1e-12 * 30) << d;
        EXPECT_NEAR(area_of(common({drawn, round})), lens, 1e-12 * 30) << d;
        EXPECT_NEAR(area_of(less({round, drawn})), pi * r * r - lens, 1e-12 * 30) << d;
    }
}

TEST(CsgCurves, BlobLessSlot) {
    const Curve curve = blob({0.5, -0.25}, 3);
    const CsgNode drawn = loop_of({curve}), tool = slot(-5, -1, 4, 2, 0.6);
    const double whole = area_of(drawn), slotted = area_of(tool), shared = area_of(common({drawn, tool}));
    const Part part = good(less({drawn, tool}));
    EXPECT_NEAR(area(part), whole - shared, 1e-12 * whole);
    EXPECT_NEAR(area_of(join({drawn, tool})), whole + slotted - shared, 1e-12 * whole);
    EXPECT_NEAR(slotted, 2 * 0.6 * std::sqrt(90.0) + pi * 0.36, 1e-13 * slotted);
    expect_on(part, "e0", curve);
}

TEST(CsgCurves, CurvedPinsFillTheirHoles) {
    const CsgNode pins[] = {ellipse(0.3, 0.1, 2, 0.7, 20), loop_of({nurbs_circle({0.1, 0.2}, 1.3)}), loop_of({blob({0, 0}, 2)}),
                            slot(-1, 0.3, 2, 1.7, 0.77)};
    for (const CsgNode& pin : pins)
        for (double degrees : {0.0, 77.7}) {
            const CsgNode placed = place(pin, degrees, {0.3, 0.1});
            const CsgNode plate = less({rectangle(-9, -9, 9, 9), placed});
            EXPECT_NE(problem_of(common({plate, placed})).find("empty"), std::string::npos);
            EXPECT_NE(problem_of(less({placed, placed})).find("empty"), std::string::npos);
            EXPECT_EQ(good(join({plate, placed})).edges.size(), 4u);
            // turned there and back in two steps: the same curve but for rounding
            const CsgNode other = place(place(placed, 15), -15);
            EXPECT_EQ(good(join({plate, other})).edges.size(), 4u);
        }
}

TEST(CsgCurves, HalfEllipsesAndTheWholeAreTheSameCurve) {
    const EllipticArc upper{{1, 2}, {3, 0}, {0, 2}, 0.4, pi}, lower{{1, 2}, {3, 0}, {0, 2}, 0.4 + pi, pi};
    const CsgNode halves = loop_of({upper, lower}), whole = ellipse(1, 2, 3, 2);
    EXPECT_NE(problem_of(less({halves, whole})).find("empty"), std::string::npos);
    EXPECT_NE(problem_of(less({whole, halves})).find("empty"), std::string::npos);
    const CsgNode half = loop_of({upper, Segment{point(upper, 1), point(upper, 0)}});
    const Part rest = good(less({whole, half}));
    EXPECT_NEAR(area(rest), 3 * pi, 1e-12 * 20);
    EXPECT_EQ(names(rest), (Names{"ellipse", "e1"}));
}

TEST(CsgCurves, PiecesThroughTheSeamAreOneEdge) {
    const Part part = good(less({ellipse(0, 0, 2, 1), rectangle(-3, -3, 0.5, 3)}));
    EXPECT_EQ(names(part), (Names{"ellipse", "right"}));
    const EllipticArc& arc = std::get<EllipticArc>(edge(part, "ellipse").curve);
    EXPECT_GT(arc.start + arc.sweep, 2 * pi);
    EXPECT_TRUE(edge(part, "ellipse").along_source);
    EXPECT_NEAR(edge(part, "ellipse").source_begin, length(curve_of(ellipse(0, 0, 2, 1)), 0, arc.start / (2 * pi)), 1e-13 * 20);
    const Part drawn = good(less({loop_of({nurbs_circle({0, 0}, 2)}), rectangle(-3, -3, 0.5, 3)}));
    EXPECT_EQ(names(drawn), (Names{"e0#0", "e0#1", "right"}));  // closed splines are cut where they begin
    EXPECT_EQ(edge(drawn, "e0#0").source_begin, 0);
}

TEST(CsgCurves, WholeEllipseInAHole) {
    const Part part = good(less({rectangle(-5, -5, 5, 5), ellipse(0, 0, 2, 1, 30)}));
    const EllipticArc& hole = std::get<EllipticArc>(edge(part, "ellipse").curve);
    EXPECT_EQ(hole.start + hole.sweep, 0);
    EXPECT_FALSE(edge(part, "ellipse").along_source);
    EXPECT_EQ(edge(part, "ellipse").source_begin, 0);
    EXPECT_NEAR(area(part), 100 - 2 * pi, 1e-13 * 100);
}

TEST(CsgCurves, LineThroughAnInflectionPoint) {
    // y = x^3 above a line that touches it where it crosses: the crossing is a triple root, known to the cube root of a
    // rounding.
    const Curve cubic = bezier_curve({{-1, -1}, {-1.0 / 3, 1}, {1.0 / 3, -1}, {1, 1}}, {});
    for (double h : {0.0, 0.1, 0.3, 0.9})
        for (double degrees : {0.0, 20.0, 33.3}) {
            const CsgNode below =
                loop_of({reversed(cubic), Segment{{-1, -1}, {-1, -3}}, Segment{{-1, -3}, {1, -3}}, Segment{{1, -3}, {1, 1}}});
            const CsgNode tool = rectangle(-2, -4, 2, h * h * h);
            const Part part = good(less({place(below, degrees), place(tool, degrees)}));
            EXPECT_NEAR(area(part), 0.25 - h * h * h + 0.75 * std::pow(h, 4), 1e-13 * 10) << h << " " << degrees;
            EXPECT_EQ(names(part), (Names{"e0", "e3", "top"}));
        }
}

TEST(CsgCurves, OsculatingCircles) {
    // At an end of its axes the circle of curvature stays on one side, elsewhere it crosses.
    EXPECT_EQ(names(good(less({ellipse(0, 0, 2, 1), circle(1.5, 0, 0.5)}))), (Names{"ellipse", "circle"}));
    EXPECT_EQ(names(good(join({circle(0, -3, 4), ellipse(0, 0, 2, 1)}))), (Names{"circle"}));
    for (double u : {0.2, 0.7, 1.2}) {
        const Vec2 p(2 * std::cos(u), std::sin(u)), d(-2 * std::sin(u), std::cos(u));
        const double r = std::pow(d.norm(), 3) / 2;
        const Vec2 c = p + r * left_of(d).normalized();
        const CsgNode round = ellipse(0, 0, 2, 1), disc = circle(c.x(), c.y(), r);
        EXPECT_NEAR(area_of(join({round, disc})) + area_of(common({round, disc})), 2 * pi + pi * r * r, 1e-12 * 100) << u;
        EXPECT_EQ(names(good(join({round, disc}))), (Names{"ellipse", "circle"}));
    }
}

}  // namespace csg_curves_test
