// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/csg.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/geometry/csg/csg_nodes.hpp"

namespace csg_test {

namespace {
using namespace abut::geometry;
using namespace abut::geometry::csg_nodes;
}  // namespace

TEST(Csg, PrimitivesAloneKeepTheirEdges) {
    const Part r = good(rectangle(1, 2, 4, 4));
    EXPECT_DOUBLE_EQ(area(r), 6);
    EXPECT_EQ(names(r), (Names{"left", "right", "bottom", "top"}));
    expect_same_point(point(edge(r, "left").curve, 0), {1, 4}, 0);
    const Part c = good(circle(1, 0, 2, "pin"));
    ASSERT_EQ(c.edges.size(), 1u);
    EXPECT_EQ(c.edges[0].name, "pin/circle");
    EXPECT_DOUBLE_EQ(std::get<Arc>(c.edges[0].curve).sweep, 2 * pi);
    const Part p = good(node(Polygon{{{0, 0}, {0, 3}, {4, 0}}}));  // clockwise: turned, but e0 still knows its own direction
    EXPECT_DOUBLE_EQ(area(p), 6);
    EXPECT_FALSE(edge(p, "e0").along_source);
    expect_same_point(point(edge(p, "e0").curve, 1), {0, 0}, 0);
}

TEST(Csg, RectangleLessCircleHasOneRoundHole) {
    const Part part = good(less({rectangle(0, 0, 10, 6), circle(4, 3, 1.5)}));
    EXPECT_NEAR(area(part), 60 - pi * 2.25, 1e-12 * 60);
    EXPECT_EQ(count_holes(part), 1);
    ASSERT_EQ(part.edges.size(), 5u);
    const Arc& hole = std::get<Arc>(edge(part, "circle").curve);
    EXPECT_EQ(hole.start, 0);
    EXPECT_DOUBLE_EQ(hole.sweep, -2 * pi);
    EXPECT_FALSE(edge(part, "circle").along_source);
    EXPECT_EQ(edge(part, "circle").source_begin, 0);
}

TEST(Csg, UnionOfTwoOverlappingCircles) {
    const double r = 2, d = 3;
    const Part part = good(join({circle(0, 0, r), circle(d, 0, r)}));
    const double lens = 2 * r * r * std::acos(d / (2 * r)) - d / 2 * std::sqrt(4 * r * r - d * d);
    EXPECT_NEAR(area(part), 2 * pi * r * r - lens, 1e-12 * 20);
    EXPECT_EQ(names(part),
              (Names{"0/circle", "1/circle"}));  // the first wraps across nothing, the second across angle 0: one piece each
    for (const Edge& e : part.edges)
        for (double t : {0.0, 0.3, 1.0}) {
            const Vec2 center(e.name[0] == '0' ? 0 : d, 0);
            EXPECT_NEAR((point(e.curve, t) - center).norm(), r, 1e-12 * r);
        }
    expect_same_point(point(edge(part, "0/circle").curve, 1), {d / 2, -std::sqrt(r * r - d * d / 4)});
}

TEST(Csg, PolygonWithNotchCutsAnEdgeInTwoPieces) {
    const Part part = good(less({node(Polygon{{{0, 0}, {8, 0}, {8, 5}, {0, 5}}}), rectangle(3, 4, 5, 6, "notch")}));
    EXPECT_DOUBLE_EQ(area(part), 38);
    EXPECT_EQ(names(part), (Names{"e0", "e1", "e2#0", "e2#1", "e3", "notch/left", "notch/right", "notch/bottom"}));
    EXPECT_EQ(edge(part, "e2#1").source, "e2");
    EXPECT_EQ(edge(part, "e2#0").source_begin, 0);
    EXPECT_DOUBLE_EQ(edge(part, "e2#1").source_begin, 5);  // e2 runs from x = 8 to x = 0
    EXPECT_FALSE(edge(part, "notch/bottom").along_source);
    EXPECT_EQ(edge(part, "notch/left").source_begin, 1);  // its own direction is downwards, from y = 6
}

TEST(Csg, PiecesOfACircleAreCountedFromAngleZero) {
    // A cross of two bars cuts the circle four times; the piece across angle 0 begins last.
    const Part part = good(less({circle(0, 0, 5), rectangle(-1, -9, 1, 9), rectangle(-9, -1, 9, 1)}));
    EXPECT_EQ(part.loops.size(), 4u);
    for (int k = 0; k < 4; ++k) {
        const Edge& e = edge(part, "circle#" + std::to_string(k));
        const Vec2 first = point(e.curve, 0);
        EXPECT_TRUE(e.along_source);
        EXPECT_NEAR(e.source_begin, 5 * (std::asin(0.2) + k * pi / 2), 1e-12 * 30);
        expect_same_point(first, 5 * Vec2(std::cos(e.source_begin / 5), std::sin(e.source_begin / 5)));
    }
    const Part half = good(less({circle(0, 0, 5), rectangle(-9, -9, 0, 9)}));
    EXPECT_NEAR(edge(half, "circle").source_begin, 5 * 1.5 * pi, 1e-12 * 30);  // one piece from 270 through 0 to 90 degrees
    EXPECT_NEAR(length(edge(half, "circle").curve), 5 * pi, 1e-12 * 30);
}

TEST(Csg, NamesOfNodesComeBeforeNamesOfEdges) {
    CsgNode foot = join({rectangle(0, 0, 4, 1, "foot"), rectangle(1, 0.5, 2, 3)});
    foot.name = "base";
    const Part part = good(foot);
    EXPECT_TRUE(names(part).contains("base/foot/left"));
    EXPECT_TRUE(names(part).contains("base/left"));
    EXPECT_TRUE(names(part).contains("base/foot/top#0"));
    const Part same = good(join({rectangle(0, 0, 1, 1, "bar"), rectangle(5, 0, 6, 1, "bar")}));
    EXPECT_TRUE(names(same).contains("0/bar/left"));
    EXPECT_TRUE(names(same).contains("1/bar/left"));
}

TEST(Csg, RotatedSquareFillsRotatedHoleExactly) {
    const auto turned = [](double r) { return place(rectangle(-r, -r, r, r), 30, {7, 3}, {0.25, 0.5}); };
    const CsgNode plate = less({rectangle(-10, -10, 20, 20), turned(2)});
    const Part holed = good(plate);
    EXPECT_NEAR(area(holed), 900 - 16, 1e-11 * 900);
    const Part filled = good(join({plate, turned(2)}));
    EXPECT_EQ(filled.edges.size(), 4u);
    EXPECT_NEAR(area(filled), 900, 1e-11 * 900);
    EXPECT_NE(problem_of(common({plate, turned(2)})), "");  // they share edges only
    EXPECT_EQ(problem_of(common({plate, turned(2.001)})), "");
}

TEST(Csg, NestedPlacementsComposeInDoublesAndExactly) {
    const CsgNode inner = place(rectangle(0, 0, 2, 1), 30, {1, 0}, {0, 0});
    const Part direct = good(place(inner, 90, {0, 5}, {1, 1}));
    const Part through = good(join({place(inner, 90, {0, 5}, {1, 1})}));
    ASSERT_EQ(direct.edges.size(), through.edges.size());
    for (std::size_t i = 0; i < direct.edges.size(); ++i) {
        EXPECT_EQ(direct.edges[i].name, through.edges[i].name);
        for (double t : {0.0, 1.0}) expect_same_point(point(direct.edges[i].curve, t), point(through.edges[i].curve, t), 1e-14);
    }
    // by hand: corner (2, 0) -> (1 + sqrt 3, 1) -> turned about (1, 1): (1, 1 + sqrt 3) -> (1, 6 + sqrt 3)
    expect_same_point(point(edge(direct, "right").curve, 0), {1, 6 + std::sqrt(3.0)});
}

TEST(Csg, RotationsThereAndBackAreExact) {
    const CsgNode square = rectangle(0, 0, 3, 3);
    const CsgNode back = place(place(square, 37), -37);
    const Part part = good(join({square, back}));
    EXPECT_EQ(names(part), (Names{"left", "right", "bottom", "top"}));
}

TEST(Csg, EqualRotationsOnDifferentWaysLeaveNoSlivers) {
    // 15 + 15 degrees is not 30 degrees to the last bit: the edges cross within rounding.
    const CsgNode square = rectangle(-1, -1, 1, 1);
    const CsgNode plate = less({rectangle(-9, -9, 9, 9), place(square, 30)});
    const Part part = good(join({plate, place(place(square, 15), 15)}));
    EXPECT_NEAR(area(part), 324, 1e-11 * 324);
    EXPECT_EQ(part.loops.size(), 1u);
}

TEST(Csg, QuarterDiscByHalfPlanes) {
    const Part part = good(common({circle(0, 0, 2), half_plane(0, 0, -1, 0), half_plane(0, 0, 0, -3)}));
    EXPECT_NEAR(area(part), pi, 1e-12 * pi);
    EXPECT_EQ(names(part), (Names{"circle", "1/line", "2/line"}));
    EXPECT_EQ(edge(part, "circle").source_begin, 0);
    expect_same_point(point(edge(part, "1/line").curve, 0), {0, 2});
    expect_same_point(point(edge(part, "1/line").curve, 1), {0, 0});
}

TEST(Csg, HalfPlanesAloneMakeATriangle) {
    const Part part = good(common({half_plane(0, 0, 0, -1), half_plane(0, 0, -1, 0), half_plane(300, 0, 3, 4)}));
    EXPECT_NEAR(area(part), 300 * 225 / 2.0, 1e-11 * 4e4);
    EXPECT_EQ(part.edges.size(), 3u);
}

TEST(Csg, UncutHalfPlanesAreUnbounded) {
    EXPECT_NE(problem_of(half_plane(0, 0, 1, 0)).find("unbounded"), std::string::npos);
    EXPECT_NE(problem_of(place(half_plane(0, 0, 1, 0), 10)).find("unbounded"), std::string::npos);
    EXPECT_NE(problem_of(join({circle(0, 0, 1), half_plane(5, 0, 1, 0)})).find("unbounded"), std::string::npos);
    EXPECT_NE(problem_of(common({half_plane(0, 0, 1, 0), half_plane(0, 0, 0, 1)})).find("unbounded"), std::string::npos);
    EXPECT_NE(problem_of(less({half_plane(0, 0, 1, 0), circle(0, 0, 1)})).find("unbounded"), std::string::npos);
    EXPECT_EQ(problem_of(less({circle(0, 0, 1), half_plane(0, 0, 1, 0)})), "");
    EXPECT_EQ(problem_of(common({circle(1e6, 0, 1), half_plane(1e6, 0, 1, 0)})), "");
}

TEST(Csg, CoincidentEdgesBelongToTheFirstPrimitive) {
    const Part part = good(join({rectangle(0, 0, 2, 2), rectangle(1, 0, 4, 2)}));
    EXPECT_DOUBLE_EQ(area(part), 8);
    EXPECT_EQ(names(part), (Names{"left", "right", "0/bottom", "1/bottom", "0/top", "1/top"}));
    EXPECT_DOUBLE_EQ(length(edge(part, "0/bottom").curve), 2);
    EXPECT_DOUBLE_EQ(length(edge(part, "1/bottom").curve), 2);
    EXPECT_DOUBLE_EQ(edge(part, "1/bottom").source_begin, 1);
    const Part touching = good(join({rectangle(0, 0, 2, 2), rectangle(2, 0, 4, 2)}));
    EXPECT_EQ(touching.loops.size(), 1u);
    const Part wall = good(less({rectangle(0, 0, 4, 4), rectangle(0, 1, 2, 3)}));
    EXPECT_EQ(names(wall), (Names{"left#0", "left#1", "0/right", "1/right", "0/bottom", "1/bottom", "0/top", "1/top"}));
}

TEST(Csg, PinThatFillsItsHoleLeavesNothing) {
    const CsgNode plate = less({rectangle(-5, -5, 5, 5), circle(0.1, 0.2, 1.3)});
    EXPECT_NE(problem_of(common({plate, circle(0.1, 0.2, 1.3)})).find("empty"), std::string::npos);
    EXPECT_NE(problem_of(less({circle(0.1, 0.2, 1.3), circle(0.1, 0.2, 1.3)})).find("empty"), std::string::npos);
    const Part filled = good(join({plate, circle(0.1, 0.2, 1.3)}));
    EXPECT_EQ(filled.edges.size(), 4u);
}

TEST(Csg, TangentCircleStaysWhole) {
    const Part part = good(less({rectangle(-2, 0, 2, 5), circle(0, 1, 1)}));  // the hole touches the bottom edge
    EXPECT_NEAR(area(part), 20 - pi, 1e-12 * 20);
    EXPECT_EQ(names(part), (Names{"left", "right", "bottom", "top", "circle"}));
    EXPECT_EQ(count_holes(part), 1);
}

TEST(Csg, RotatedCircleCountsFromItsOwnAngleZero) {
    const Part part = good(less({place(circle(0, 0, 1), 90, {3, 0}), rectangle(0, -1, 3, 1)}));
    EXPECT_NEAR(edge(part, "circle").source_begin, pi, 1e-12);  // 270 degrees in the plane, 180 in the circle's own frame
}

TEST(Csg, HundredHolesInARow) {
    std::vector<CsgNode> of{rectangle(-1, -1, 100, 1)};
    for (int i = 0; i < 100; ++i) of.push_back(circle(i - 0.5, 0, 0.5));  // each touches the next: 100 aligned, tangent holes
    of.front() = rectangle(-2, -1, 101, 1);
    const Part part = good(less(of));
    EXPECT_EQ(count_holes(part), 100);
    EXPECT_NEAR(area(part), 206 - 25 * pi, 1e-11 * 206);
    EXPECT_EQ(part.edges.size(), 104u);
    EXPECT_TRUE(names(part).contains("100/circle"));
}

TEST(Csg, DifferencesOfDifferencesAndIslands) {
    const CsgNode ring = less({less({circle(0, 0, 5), circle(0, 0, 4)}), rectangle(-6, -1, 6, 1)});
    const Part island = good(join({ring, circle(0, 0, 1)}));
    EXPECT_EQ(island.loops.size(), 3u);
    EXPECT_EQ(count_holes(island), 0);
    const Part around = good(join({less({circle(0, 0, 5), circle(0, 0, 4)}), circle(0, 0, 1)}));
    EXPECT_EQ(around.loops.size(), 3u);
    EXPECT_EQ(count_holes(around), 1);
    EXPECT_NEAR(area(around), pi * (25 - 16 + 1), 1e-12 * 80);
    EXPECT_LT(std::get<Arc>(around.edges[static_cast<std::size_t>(around.loops[2].edges[0])].curve).sweep,
              0);  // holes come last
}

namespace {

/// A stadium with tangential ends: the corners of such loops lie on lines and circles only within rounding.
CsgNode stadium(double x, double y, double l, double r, double degrees) {
    const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
    const auto at = [&](double u, double v) { return Vec2(x + c * u - s * v, y + s * u + c * v); };
    const double a = degrees * pi / 180;
    return node(Loops{{{{Segment{at(0, -r), at(l, -r)}, "side0", "/0"},
                        {Arc{at(l, 0), r, a - pi / 2, pi}, "end1", "/1"},
                        {Segment{at(l, r), at(0, r)}, "side1", "/2"},
                        {Arc{at(0, 0), r, a + pi / 2, pi}, "end0", "/3"}}}});
}

}  // namespace

TEST(Csg, LoopsWithTangentArcsGoThroughBooleans) {
    for (double degrees : {0.0, 17.3, 45.0, 123.4}) {
        const double whole = 2 * 7.1 * 1.7 + pi * 1.7 * 1.7;
        const Part slotted = good(less({rectangle(-50, -50, 50, 50), stadium(1.3, 2.1, 7.1, 1.7, degrees)}));
        EXPECT_NEAR(area(slotted), 1e4 - whole, 1e-11 * 1e4);
        EXPECT_EQ(names(slotted), (Names{"left", "right", "bottom", "top", "side0", "side1", "end0", "end1"}));
        // Cut across both sides: the cut lies on the lines of the sides themselves.
        const Part cut =
            good(common({stadium(1.3, 2.1, 7.1, 1.7, degrees), place(half_plane(3, 0, 1, 0), degrees, {1.3, 2.1})}));
        EXPECT_NEAR(area(cut), 3 * 2 * 1.7 + pi * 1.7 * 1.7 / 2, 1e-11 * 100);
        EXPECT_EQ(names(cut), (Names{"side0", "side1", "end0", "line"}));
        EXPECT_NEAR(length(edge(cut, "side0").curve), 3, 1e-11);
        EXPECT_NEAR(edge(cut, "side1").source_begin, 4.1, 1e-11);
    }
}

TEST(Csg, CutsThroughATangentialCorner) {
    // The rectangle's left edge runs through both corners of the stadium's end, where the bridges are.
    const CsgNode bar = place(rectangle(0, -3, 2, 3), 30);
    const Part part = good(join({stadium(0, 0, 5, 1, 30), bar}));
    EXPECT_NEAR(area(part), 12 + pi + 6, 1e-11 * 50);
    EXPECT_NEAR(length(edge(part, "left#0").curve), 2, 1e-11);
    EXPECT_NEAR(length(edge(part, "end0").curve), pi, 1e-11);
}

TEST(Csg, LoopsWithCornersBetweenLinesAndArcsFitPrimitivesExactly) {
    // A D-shaped pin drawn by loops in a hole made of a circle and a half plane.
    const double r = 2, h = 1, x = std::sqrt(r * r - h * h);
    const double a = std::atan2(-h, x);
    const CsgNode pin =
        node(Loops{{{{Segment{{-x, -h}, {x, -h}}, "flat", "/0"}, {Arc{{0, 0}, r, a, pi - 2 * a}, "round", "/1"}}}});
    const CsgNode hole = common({circle(0, 0, r), half_plane(0, -h, 0, -1)});
    EXPECT_NE(problem_of(less({pin, hole})).find("empty"), std::string::npos);
    EXPECT_NE(problem_of(less({hole, pin})).find("empty"), std::string::npos);
    EXPECT_EQ(good(join({less({rectangle(-9, -9, 9, 9), hole}), pin})).edges.size(), 4u);
}

TEST(Csg, TwoHalfCirclesInALoopAreTheCircle) {
    const CsgNode halves =
        node(Loops{{{{Arc{{1, 2}, 3, 0.3, pi}, "upper", "/0"}, {Arc{{1, 2}, 3, 0.3 + pi, pi}, "lower", "/1"}}}});
    EXPECT_NE(problem_of(less({halves, circle(1, 2, 3)})).find("empty"), std::string::npos);
    EXPECT_EQ(names(good(join({halves, rectangle(1, 2, 2, 3)}))), (Names{"upper", "lower"}));
}

TEST(Csg, ImportsAreTakenAsTheyAre) {
    Part drawn = good(less({rectangle(0, 0, 6, 4), circle(2, 2, 1)}));
    for (Edge& e : drawn.edges) e.name = e.source = "h" + e.name;
    drawn.name = "PLATE";
    const Part same = good(import(drawn));
    ASSERT_EQ(same.edges.size(), drawn.edges.size());
    EXPECT_EQ(same.name, "");
    for (std::size_t i = 0; i < same.edges.size(); ++i) {
        EXPECT_EQ(same.edges[i].name, drawn.edges[i].name);
        EXPECT_EQ(same.edges[i].along_source, drawn.edges[i].along_source);
    }
    EXPECT_TRUE(names(good(place(import(drawn, "plate"), 45))).contains("plate/hleft"));

    const Part cut = good(less({import(drawn), rectangle(-1, -1, 2, 9, "knife")}));
    EXPECT_NEAR(area(cut), 16 - pi / 2, 1e-11 * 24);
    EXPECT_EQ(names(cut), (Names{"hright", "hbottom", "htop", "hcircle", "knife/right#0", "knife/right#1"}));
    EXPECT_FALSE(edge(cut, "hcircle").along_source);
    EXPECT_NEAR(edge(cut, "hcircle").source_begin, 1.5 * pi, 1e-11);
}

TEST(Csg, PrimitivesWithoutAreaAreProblems) {
    EXPECT_NE(problem_of(rectangle(0, 0, 0, 1)).find("no area"), std::string::npos);
    EXPECT_NE(problem_of(rectangle(0, 2, 1, 1)).find("no area"), std::string::npos);
    EXPECT_NE(problem_of(circle(0, 0, 0)).find("not positive"), std::string::npos);
    EXPECT_NE(problem_of(circle(0, std::nan(""), 1)).find("not finite"), std::string::npos);
    EXPECT_NE(problem_of(node(Polygon{{{0, 0}, {1, 1}}})).find("fewer than three"), std::string::npos);
    EXPECT_NE(problem_of(node(Polygon{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}})).find("cross"), std::string::npos);
    EXPECT_NE(problem_of(half_plane(0, 0, 0, 0)).find("zero"), std::string::npos);
    EXPECT_NE(problem_of(join({})).find("no geometry"), std::string::npos);
    EXPECT_EQ(evaluate(join({circle(0, 0, -1), rectangle(0, 0, 0, 1)})).problems.size(), 2u);  // all of them at once
}

namespace {

CsgNode random_primitive(std::mt19937& random) {
    std::uniform_int_distribution<int> small(-6, 6), kind(0, 4), size(1, 5);
    const double x = small(random), y = small(random), r = size(random);  // whole numbers: coincidences and tangencies abound
    switch (kind(random)) {
        case 0:
            return rectangle(x, y, x + r, y + size(random));
        case 1:
            return circle(x, y, r);
        case 2:
            return place(rectangle(0, 0, r, r), 30, {x, y});
        case 3:
            return node(Polygon{{{x, y}, {x, y + r}, {x + r, y}}});
        default:
            return stadium(x, y, r, 1, 30);
    }
}

CsgNode random_tree(std::mt19937& random, int depth) {
    if (depth == 0 || random() % 4 == 0) return random_primitive(random);
    std::vector<CsgNode> of;
    for (unsigned n = 2 + static_cast<unsigned>(random() % 3); n > 0; --n) of.push_back(random_tree(random, depth - 1));
    switch (random() % 5) {
        case 0:
            return common({of[0], join({of.begin() + 1, of.end()})});
        case 1:
            return place(join(of), 90, {1, 0});
        case 2:
        case 3:
            return join(of);
        default:
            return less(of);
    }
}

/// The tree's meaning, point by point, with the primitives' own boundaries only.
bool inside(const CsgNode& tree, const Vec2& p) {
    const auto in = [&](const CsgNode& child) { return inside(child, p); };
    if (const auto* u = std::get_if<Union>(&tree.shape)) return std::any_of(u->of.begin(), u->of.end(), in);
    if (const auto* i = std::get_if<Intersection>(&tree.shape)) return std::all_of(i->of.begin(), i->of.end(), in);
    if (const auto* d = std::get_if<Difference>(&tree.shape))
        return in(d->of.front()) && std::none_of(d->of.begin() + 1, d->of.end(), in);
    if (const auto* m = std::get_if<Placed>(&tree.shape)) {
        const double a = -m->rotate * pi / 180;
        const Vec2 q = p - m->translate - m->about;
        return inside(m->of.front(),
                      m->about + Vec2(std::cos(a) * q.x() - std::sin(a) * q.y(), std::sin(a) * q.x() + std::cos(a) * q.y()));
    }
    return contains(evaluate(tree).part, p);
}

}  // namespace

TEST(Csg, RandomTreesHoldThePointsThatTheyShould) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> coordinate(-7, 9);
    int n_inside = 0, n_outside = 0;
    for (int run = 0; run < 60; ++run) {
        const CsgNode tree = random_tree(random, 3);
        const CsgResult result = evaluate(tree);
        if (result.problems.empty())
            good(tree);
        else
            EXPECT_NE(result.problems.front().what.find("empty"), std::string::npos) << result.problems.front().what;
        for (int i = 0; i < 40; ++i) {
            const Vec2 p(coordinate(random), coordinate(random));
            const bool expected = inside(tree, p);
            ++(expected ? n_inside : n_outside);
            EXPECT_EQ(contains(result.part, p), expected) << "run " << run << " at " << p.transpose();
        }
    }
    EXPECT_GT(n_inside, 300);
    EXPECT_GT(n_outside, 300);
}

TEST(Csg, AreasOfUnionAndIntersectionAddUp) {
    std::mt19937 random(5);
    for (int run = 0; run < 40; ++run) {
        const CsgNode a = random_primitive(random), b = random_primitive(random);
        const CsgResult both = evaluate(common({a, b}));
        const double shared = both.problems.empty() ? area(both.part) : 0;
        EXPECT_NEAR(area(good(join({a, b}))) + shared, area(evaluate(a).part) + area(evaluate(b).part), 1e-10) << run;
    }
}

TEST(Csg, RepeatedEvaluationGivesTheSamePart) {
    const CsgNode tree = less({join({circle(0, 0, 3), place(rectangle(-5, -1, 5, 1), 12)}), circle(1, 0, 1), circle(-1, 0, 1)});
    const Part a = good(tree), b = good(tree);
    ASSERT_EQ(a.edges.size(), b.edges.size());
    for (std::size_t i = 0; i < a.edges.size(); ++i) {
        EXPECT_EQ(a.edges[i].name, b.edges[i].name);
        for (double t : {0.0, 0.5, 1.0}) expect_same_point(point(a.edges[i].curve, t), point(b.edges[i].curve, t), 0);
    }
}

}  // namespace csg_test
