// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/loops.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/curve_meetings.hpp"

namespace {

using namespace abut::geometry;
constexpr double pi = std::numbers::pi;
using EdgeList = std::vector<LoopEdge>;

/// Names e0, e1, ... in file order over all loops.
Loops named(std::vector<std::vector<Curve>> curves) {
    Loops loops;
    int k = 0;
    for (const auto& loop : curves) {
        loops.loops.emplace_back();
        for (const Curve& curve : loop) {
            loops.loops.back().push_back({curve, "e" + std::to_string(k), "/loops/" + std::to_string(k)});
            ++k;
        }
    }
    return loops;
}

std::vector<Curve> closed(const std::vector<Vec2>& points) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < points.size(); ++i) curves.push_back(Segment{points[i], points[(i + 1) % points.size()]});
    return curves;
}
std::vector<Curve> box(double x0, double y0, double x1, double y1) {
    return closed({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}
std::vector<Curve> disc(double x, double y, double r) {
    return {Arc{{x, y}, r, 0, 2 * pi}};
}

Boundary check(std::vector<std::vector<Curve>> curves) {
    return boundary_of(named(std::move(curves)), "/geometry");
}

/// What is said of the loops, all findings in one text; empty if there are none.
std::string findings(std::vector<std::vector<Curve>> curves) {
    std::string text;
    const Boundary boundary = check(std::move(curves));
    for (const GeometryProblem& p : boundary.problems) text += p.where + ": " + p.what + "\n";
    EXPECT_EQ(boundary.loops.empty(), !boundary.problems.empty());
    return text;
}

void expect_finding(std::vector<std::vector<Curve>> curves, const std::vector<std::string>& words) {
    const std::string text = findings(std::move(curves));
    for (const std::string& word : words)
        EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' is not in: " << text;
}

Part part_of(const Loops& loops, const Boundary& boundary) {
    EdgeList all;
    for (const auto& loop : loops.loops) all.insert(all.end(), loop.begin(), loop.end());
    Part part;
    for (const BoundaryLoop& loop : boundary.loops) {
        part.loops.emplace_back();
        for (const OrientedEdge& e : loop.edges) {
            const Curve& curve = all[static_cast<std::size_t>(e.edge)].curve;
            part.loops.back().edges.push_back(static_cast<int>(part.edges.size()));
            part.edges.push_back({e.along ? curve : reversed(curve), "", ""});
        }
    }
    return part;
}

}  // namespace

TEST(Loops, NestingTellsHolesFromIslands) {
    const Boundary b = check({disc(5, 5, 1), box(0, 0, 10, 10), box(2, 2, 8, 8), box(20, 0, 21, 1)});
    ASSERT_TRUE(b.problems.empty());
    ASSERT_EQ(b.loops.size(), 4u);
    EXPECT_EQ(b.loops[0].hole_of, -1);  // an island in the hole
    EXPECT_EQ(b.loops[1].hole_of, -1);
    EXPECT_EQ(b.loops[2].hole_of, 1);
    EXPECT_EQ(b.loops[3].hole_of, -1);
    EXPECT_FALSE(b.loops[2].edges[0].along);
    EXPECT_TRUE(b.loops[1].edges[0].along);
}

TEST(Loops, ShuffledAndReversedEdgesGiveTheSameArea) {
    std::vector<Vec2> points;
    for (int i = 0; i < 40; ++i) points.push_back((i % 2 ? 3.0 : 5.0) * Vec2(std::cos(i * pi / 20), std::sin(i * pi / 20)));
    std::vector<Curve> outer = closed(points);
    std::mt19937 random(7);
    for (int run = 0; run < 20; ++run) {
        std::shuffle(outer.begin(), outer.end(), random);
        for (Curve& curve : outer)
            if (random() % 2) curve = reversed(curve);
        const Loops loops = named({disc(0, 0, 1), outer});
        const Boundary boundary = boundary_of(loops, "");
        ASSERT_TRUE(boundary.problems.empty()) << boundary.problems.front().what;
        const Part part = part_of(loops, boundary);
        EXPECT_NEAR(area(part), 20 * 15 * std::sin(pi / 20) - pi, 1e-12 * 60);
        for (const Loop& loop : part.loops)
            for (std::size_t i = 0; i < loop.edges.size(); ++i) {
                const auto here = static_cast<std::size_t>(loop.edges[i]);
                const auto next = static_cast<std::size_t>(loop.edges[(i + 1) % loop.edges.size()]);
                EXPECT_LE((point(part.edges[here].curve, 1) - point(part.edges[next].curve, 0)).norm(), 1e-14);
            }
    }
}

TEST(Loops, TangentArcsAreNoCrossings) {
    // a rounded square whose arcs join at multiples of a degree-odd angle, and a lens of two arcs
    for (double a : {0.0, 0.1, 1.234}) {
        std::vector<Curve> curves;
        for (int k = 0; k < 4; ++k) {
            const double b = a + k * pi / 2;
            const Vec2 n(std::cos(b), std::sin(b)), t = left_of(n), corner = 2 * n + 2 * t;
            curves.push_back(Segment{3 * n - 2 * t, 3 * n + 2 * t});
            curves.push_back(Arc{corner, 1, b, pi / 2});
        }
        EXPECT_EQ(findings({curves}), "") << a;
    }
    EXPECT_EQ(findings({{Arc{{0, -1}, std::sqrt(2.0), pi / 4, pi / 2}, Arc{{0, 1}, std::sqrt(2.0), 1.25 * pi, pi / 2}}}), "");
}

TEST(Loops, EndsMayMissEachOtherByRoundingOnly) {
    const double size = std::sqrt(200.0);
    auto curves = box(0, 0, 10, 10);
    std::get<Segment>(curves[1]).from = {10, 0.9e-9 * size};
    EXPECT_EQ(findings({curves}), "");
    std::get<Segment>(curves[1]).from = {10, 1.1e-9 * size};
    expect_finding({curves}, {"open", "'e0' and 'e1'", "(10, 0)"});
}

TEST(Loops, OpenLoopsNameBothEdgesDistanceAndPlace) {
    auto curves = box(0, 0, 10, 10);
    std::get<Segment>(curves[2]).to = {0, 9.75};
    expect_finding({curves}, {"/loops/2", "open", "'e2' and 'e3'", "0.25 apart"});
    expect_finding({{Segment{{0, 0}, {1, 0}}}}, {"open", "'e0'", "1 apart"});
    expect_finding({{Arc{{0, 0}, 1, 0, 3}}}, {"open", "'e0'"});
}

TEST(Loops, SelfCrossingLoopsNameEdgesAndPlace) {
    expect_finding({closed({{0, 0}, {4, 4}, {4, 0}, {0, 4}})}, {"'e0' and 'e2'", "cross", "(2, 2)"});
    expect_finding({{Segment{{-2, 0}, {2, 0}}, Segment{{2, 0}, {2, 1}}, Arc{{0, 1}, 2, 0, -pi}, Segment{{-2, 1}, {-2, 0}}}},
                   {"'e0' and 'e2'", "cross", "(1.73205, 0)"});
}

TEST(Loops, CrossingAndTouchingLoops) {
    expect_finding({box(0, 0, 4, 4), box(2, 1, 6, 3)}, {"'e1' and 'e4'", "cross at (4, 1)", "'e1' and 'e6'", "(4, 3)"});
    expect_finding({box(0, 0, 4, 4), disc(4, 2, 1)}, {"'e1' and 'e4'", "cross at"});
    expect_finding({disc(0, 0, 1), disc(2, 0, 1)}, {"'e0' and 'e1'", "touch at (1, 0)"});
    expect_finding({box(0, 0, 4, 4), disc(2, 1, 1)}, {"'e0' and 'e4'", "touch at (2, 0)"});
    EXPECT_EQ(findings({box(0, 0, 4, 4), disc(2, 1 + 1e-7, 1)}), "");
    expect_finding({box(0, 0, 4, 4), box(4, 4, 5, 5)}, {"two loops touch", "(4, 4)"});
    expect_finding({box(0, 0, 4, 4), box(4, 1, 6, 3)}, {"'e1'", "touch"});
}

TEST(Loops, AVertexTouchedTwice) {
    expect_finding({closed({{0, 0}, {2, 1}, {4, 0}, {4, 2}, {2, 1}, {0, 2}})},
                   {"touches itself", "(2, 1)", "'e0', 'e1', 'e3', 'e4'"});
}

TEST(Loops, EdgesDrawnTwiceAndFoldedBack) {
    auto twice = box(0, 0, 4, 4);
    const Loops one_more = named({twice, {Arc{{2, 2}, 1, 0, 2 * pi}}, {Arc{{2, 2}, 1, 0, 2 * pi}}});
    const Boundary b = boundary_of(one_more, "");
    ASSERT_EQ(b.problems.size(), 1u);
    EXPECT_NE(b.problems[0].what.find("'e4' and 'e5' are the same"), std::string::npos);
    expect_finding({closed({{0, 0}, {4, 0}, {4, 4}, {4, 1}, {0, 1}})}, {"'e1' and 'e2'", "touch"});  // a spike without width
}

TEST(Loops, EdgesWithoutLengthAndLoopsWithoutArea) {
    expect_finding({closed({{0, 0}, {4, 0}, {4, 0}, {4, 4}})}, {"'e1' has no length", "(4, 0)"});
    expect_finding({closed({{0, 0}, {4, 0}, {2, 0}})}, {"'e0'"});
    expect_finding({{Segment{{0, 0}, {1, 0}}, Segment{{1, 0}, {0, 0}}}}, {"'e0' and 'e1' are the same"});
    expect_finding({{Segment{{0, 0}, {std::nan(""), 0}}}}, {"not finite"});
    expect_finding({{Arc{{0, 0}, 0, 0, 2 * pi}}}, {"positive radius"});
    expect_finding({}, {"no edges"});
}

TEST(Loops, NamesGivenTwice) {
    Loops loops = named({box(0, 0, 1, 1)});
    loops.loops[0][2].name = "e0";
    const Boundary b = boundary_of(loops, "");
    ASSERT_EQ(b.problems.size(), 1u);
    EXPECT_NE(b.problems[0].what.find("'e0' is given twice"), std::string::npos);
    EXPECT_EQ(b.problems[0].where, "/loops/2");
}

TEST(Loops, MeetingPointsFindNearMissesWithinTheTolerance) {
    const Curve line = Segment{{-3, 1 + 1e-6}, {3, 1 + 1e-6}}, arc = Arc{{0, 0}, 1, 0, pi};
    EXPECT_FALSE(meeting_points(line, arc, 1.1e-6).empty());
    EXPECT_TRUE(meeting_points(line, arc, 0.9e-6).empty());
    EXPECT_TRUE(meeting_points(line, Curve(Arc{{0, 0}, 1, pi, pi}), 1.1e-6).empty());  // the other half of the circle
    EXPECT_FALSE(
        meeting_points(Curve(Arc{{0, 0}, 1, 0, pi}), Curve(Arc{{0, 0}, 1, pi / 2, pi}), 1e-9).empty());  // a shared stretch
}
