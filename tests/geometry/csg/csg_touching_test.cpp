// SPDX-License-Identifier: GPL-3.0-or-later
// Parts whose loops touch in single points, tiny edges and slivers: what comes out does not hang on roundings, and is told.
#include <cmath>

#include "tests/geometry/csg/csg_nodes.hpp"

namespace csg_touching_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::csg_nodes;

/// Rotations and shifts that no two sums or products round alike under.
struct View {
    double degrees;
    Vec2 shift;
};
std::vector<View> views() {
    std::vector<View> all;
    for (int k = 0; k < 12; ++k) all.push_back({30.0 * k + (k % 3 == 0 ? 0 : 2.3), {0.1 * k, -0.7 * k}});
    return all;
}

/// Where curves touch is known to the root of the rounding of their distance, 1e-16 times the size 10, and curvature 1.
constexpr double touch_place = 1e-7;

int count(const CsgResult& result, const std::string& words) {
    return static_cast<int>(std::count_if(result.repairs.begin(), result.repairs.end(),
                                          [&](const Repair& r) { return r.what.find(words) != std::string::npos; }));
}

CsgResult checked(const CsgNode& tree) {
    CsgResult result = evaluate(tree);
    for (const GeometryProblem& problem : result.problems) ADD_FAILURE() << problem.what;
    expect_valid(result.part);
    return result;
}

}  // namespace

TEST(CsgTouching, InscribedCircleAndEllipseLeaveFourCorners) {
    for (const View& view : views()) {
        const auto seen = [&](CsgNode n) { return place(std::move(n), view.degrees, view.shift); };
        for (const auto& [a, b, rounds] : {std::tuple(1.0, 1.0, "circle"), std::tuple(2.0, 1.0, "ellipse")}) {
            const CsgNode round = a == b ? circle(0, 0, a, "r") : ellipse(0, 0, a, b, 0, "r");
            const CsgResult corners = checked(less({seen(rectangle(-a, -b, a, b, "s")), seen(round)}));
            EXPECT_NEAR(area(corners.part), (4 - pi) * a * b, 1e-11 * area(corners.part)) << view.degrees;
            ASSERT_EQ(corners.part.loops.size(), 4u) << rounds << " " << view.degrees;
            EXPECT_EQ(corners.part.edges.size(), 12u);
            EXPECT_EQ(count_holes(corners.part), 0);
            EXPECT_EQ(count(corners, "touch at the point"), 4);
            for (int k = 0; k < 4; ++k)
                EXPECT_NEAR(edge(corners.part, std::string("r/") + rounds + "#" + std::to_string(k)).source_begin,
                            k * perimeter(good(round)) / 4, touch_place)
                    << view.degrees;
            EXPECT_EQ(checked(join({seen(rectangle(-a, -b, a, b)), seen(round)})).part.edges.size(), 4u);
            EXPECT_EQ(checked(common({seen(rectangle(-a, -b, a, b)), seen(round)})).part.edges.size(), 1u);
        }
    }
}

TEST(CsgTouching, HoleThatTouchesTheBoundaryStaysAHole) {
    for (const View& view : views()) {
        const auto seen = [&](CsgNode n) { return place(std::move(n), view.degrees, view.shift); };
        for (const CsgNode& hole : {circle(0, 1, 1, "h"), ellipse(0, 1, 2, 1, 0, "h")}) {
            const CsgResult result = checked(less({seen(rectangle(-3, 0, 3, 5)), seen(hole)}));
            EXPECT_EQ(result.part.loops.size(), 2u);
            EXPECT_EQ(count_holes(result.part), 1);
            EXPECT_EQ(result.part.edges.size(), 5u);
            ASSERT_EQ(count(result, "touches the boundary at"), 1) << view.degrees;
            expect_same_point(result.repairs.front().at, view.shift, touch_place);
        }
    }
}

TEST(CsgTouching, HoleThatTouchesWithinRounding) {
    // 0.3 - 0.1 is not 0.2 in doubles: the circle is a few 1e-17 beyond the edge, or short of it.
    for (int k = 1; k < 60; ++k) {
        const double y = 0.1 * k, r = 0.1 * (k % 7 + 1);
        const CsgResult result = checked(less({rectangle(-5, -9, 5, y), circle(0.3, y - r, r)}));
        EXPECT_EQ(count_holes(result.part), 1) << k;
        EXPECT_EQ(result.part.edges.size(), 5u) << k;
        EXPECT_EQ(count(result, "the hole of edge 'circle' touches the boundary at"), 1) << k;
    }
}

TEST(CsgTouching, DiscsThatTouchAreTwoRegions) {
    for (int k = 0; k < 40; ++k) {
        const double a = 0.37 * k, r = 0.1 * (k + 1);
        const Vec2 other = Vec2(0.3, 0.7) + (0.3 + r) * Vec2(std::cos(a), std::sin(a));
        const CsgResult result = checked(join({circle(0.3, 0.7, 0.3), circle(other.x(), other.y(), r)}));
        EXPECT_EQ(result.part.loops.size(), 2u) << k;
        EXPECT_EQ(names(result.part), (Names{"0/circle", "1/circle"}));
        EXPECT_EQ(count(result, "the regions of edges '0/circle' and '1/circle' touch at the point"), 1) << k;
    }
}

TEST(CsgTouching, CircleBetweenTwoWallsCutsTheStripInTwo) {
    for (int k = 1; k < 30; ++k) {
        const double r = 0.1 * k;
        const CsgResult result = checked(less({rectangle(-9, 0.7, 9, 0.7 + 2 * r), circle(0.3, 0.7 + r, r)}));
        EXPECT_EQ(result.part.loops.size(), 2u) << k;
        EXPECT_EQ(count_holes(result.part), 0) << k;
        EXPECT_EQ(names(result.part),
                  (Names{"left", "right", "top#0", "top#1", "bottom#0", "bottom#1", "circle#0", "circle#1"}));
    }
}

TEST(CsgTouching, RingOfHolesCutsOutWhatIsInside) {
    // Four discs about the origin, each touching two others, leave a star between them.
    const CsgResult result =
        checked(less({rectangle(-5, -5, 5, 5), circle(1, 1, 1), circle(-1, 1, 1), circle(-1, -1, 1), circle(1, -1, 1)}));
    EXPECT_EQ(result.part.loops.size(), 3u);  // plate, star, and one hole around it
    EXPECT_EQ(count_holes(result.part), 1);
    EXPECT_NEAR(area(result.part), 100 - 4 * pi, 1e-12 * 100);
    EXPECT_NEAR(perimeter(result.part), 40 + 8 * pi, 1e-12 * 100);
}

TEST(CsgTouching, HolesInARowTouchEachOther) {
    const CsgResult result = checked(less({rectangle(-2, -2, 9, 2), circle(0, 0, 1), circle(2, 0, 1), circle(4, 0, 1)}));
    EXPECT_EQ(count_holes(result.part), 3);
    EXPECT_EQ(count(result, "the holes of edges"), 2);
}

TEST(CsgTouching, NothingIsReportedWhereNothingTouches) {
    EXPECT_TRUE(checked(less({rectangle(-2, -2, 2, 2), circle(0, 0, 1), ellipse(0, 1.5, 0.5, 0.2)})).repairs.empty());
    EXPECT_TRUE(checked(join({rectangle(0, 0, 2, 2), rectangle(2, 1, 4, 3)})).repairs.empty());
}

TEST(CsgTouching, TinyEdgesAreLeftOutAndReported) {
    for (double step : {1e-9, 1e-10, 1e-11}) {
        // Two bars side by side whose tops differ by less than the merge length.
        const CsgResult result = checked(join({rectangle(0, 0, 2, 2), rectangle(2, 0, 4, 2 + step)}));
        EXPECT_EQ(names(result.part), (Names{"left", "right", "0/bottom", "1/bottom", "0/top", "1/top"})) << step;
        ASSERT_EQ(result.repairs.size(), 1u);
        EXPECT_NE(result.repairs[0].what.find("tiny edge of 'left'"), std::string::npos);
        expect_same_point(result.repairs[0].at, {2, 2}, 1e-8);
        EXPECT_NEAR(result.repairs[0].size, step, 1e-14);
        EXPECT_NEAR(area(result.part), 8, 1e-8);
    }
    const CsgResult kept = checked(join({rectangle(0, 0, 2, 2), rectangle(2, 0, 4, 2 + 1e-7)}));
    EXPECT_EQ(kept.part.edges.size(), 7u);
    EXPECT_TRUE(kept.repairs.empty());
}

TEST(CsgTouching, TinyChamferGivesTheSharpCornerBack) {
    const double c = 1e-10;
    const CsgNode chamfered = common({rectangle(0, 0, 4, 3), half_plane(4 - c, 3, 1, 1)});
    const CsgResult result = checked(chamfered);
    EXPECT_EQ(result.part.edges.size(), 4u);
    EXPECT_EQ(result.repairs.size(), 1u);
    expect_same_point(point(edge(result.part, "right").curve, 1), {4, 3}, 1e-15);
}

TEST(CsgTouching, SliversOfCurvesAreLeftOutAndReported) {
    // The cap is thinner than the finest arcs resolve.
    const CsgNode cap = common({ellipse(0, 0, 2, 1), half_plane(2 - 1e-9, 0, -1, 0)});
    const CsgResult result = checked(join({rectangle(-1, 2, 1, 4), cap}));
    EXPECT_EQ(result.part.edges.size(), 4u);
    ASSERT_EQ(count(result, "sliver"), 1);
    EXPECT_LE(result.repairs[0].size, 1e-9);
    expect_same_point(result.repairs[0].at, {2, 0}, 1e-4);
}

TEST(CsgTouching, ThinCrescentsAreKept) {
    // A pin that touches its hole at both ends.
    const CsgNode plate = less({rectangle(-5, -5, 5, 5), ellipse(0, 0, 2, 1 + 1e-5, 0, "hole")});
    const CsgResult result = checked(join({plate, ellipse(0, 0, 2, 1, 0, "pin")}));
    EXPECT_EQ(names(result.part), (Names{"left", "right", "bottom", "top", "hole/ellipse", "pin/ellipse"}));
    EXPECT_NEAR(area(result.part), 100 - 2e-5 * pi, 1e-12 * 100);
    EXPECT_EQ(count(result, "touches the boundary at"), 1);  // two edges are named at one place at most
}

TEST(CsgTouching, RunOverTheSeamSurvivesATouchThere) {
    // The slot's end touches the ellipse from inside just where the ellipse begins.
    const CsgNode bar = slot(1, 8, -3, 8, 0.5), round = ellipse(0, 8, 1.5, 1);
    EXPECT_EQ(names(checked(join({bar, round})).part), (Names{"side0", "side1", "end1", "ellipse"}));
    EXPECT_NEAR(area_of(join({bar, round})) + area_of(common({bar, round})), area_of(bar) + area_of(round), 1e-11);
}

TEST(CsgTouching, CapsThatAreRoundingAreNotEdges) {
    // The disc's top is at the bar's, or a few 1e-17 above or below.
    for (int k = 1; k < 60; ++k) {
        const double y = 0.1 * k, r = 0.1 * (k % 7 + 1);
        EXPECT_EQ(checked(join({rectangle(-5, -9, 5, y), circle(0.3, y - r, r)})).part.edges.size(), 4u) << k;
    }
}

}  // namespace csg_touching_test
