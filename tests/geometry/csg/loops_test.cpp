// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/loops.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/brep/self_crossing.hpp"
#include "geometry/curves/curve_meetings.hpp"
#include "geometry/curves/elliptic_arc.hpp"
#include "geometry/curves/spline_shape.hpp"
#include "tests/geometry/csg/outlines.hpp"

namespace loops_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::outlines;
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

/// One line, with all the words.
void expect_only(const std::string& text, const std::vector<std::string>& words) {
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
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
                   {"'e0' and 'e2'", "cross", "(-1.73205, 0)"});
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

TEST(Loops, LoopsDrawnTwiceAreOneProblem) {
    expect_only(findings({box(0, 0, 4, 4), disc(2, 2, 1), disc(2, 2, 1)}), {"'e4' and 'e5' are the same"});
    expect_only(findings({box(0, 0, 4, 4), {Arc{{2, 2}, 1, 0.3, 2 * pi}}, {Arc{{2, 2}, 1, 2, -2 * pi}}}), {"the same"});
    expect_only(findings({box(0, 0, 4, 4), box(0, 0, 4, 4)}), {"the loops of edges 'e0' and 'e4' are the same", "/loops/4"});
    // the same outline with other corners on its sides
    expect_only(findings({box(0, 0, 4, 4), closed({{4, 4}, {0, 4}, {0, 1}, {0, 0}, {3, 0}, {4, 0}})}),
                {"the loops of edges 'e0' and 'e4' are the same"});
    // half of it only: the three sides that they share, and no corner beside these
    EXPECT_EQ(check({box(0, 0, 4, 4), box(0, 0, 2, 4)}).problems.size(), 3u);
}

TEST(Loops, EdgesDrawnTwice) {
    auto edges = box(0, 0, 4, 4);
    edges.push_back(reversed(edges[1]));
    expect_only(findings({edges}), {"'e1' and 'e4' are the same, from (4, 0) to (4, 4)"});
    expect_only(findings({box(0, 0, 4, 4), box(4, 1, 6, 3)}), {"two loops touch", "'e1' and 'e7'", "(4, 1) to (4, 3)"});
}

TEST(Loops, Spikes) {
    // partly, wholly, and out and back over two edges
    expect_only(findings({closed({{0, 0}, {4, 0}, {4, 4}, {4, 1}, {0, 1}})}), {"a spike", "'e1' and 'e2'", "(4, 1) to (4, 4)"});
    expect_only(findings({closed({{0, 0}, {4, 0}, {8, 0}, {4, 0}, {4, 4}, {0, 4}})}),
                {"a spike", "'e1' and 'e2'", "(4, 0) to (8, 0)"});
    expect_finding({closed({{0, 0}, {4, 0}, {8, 0}, {6, 0}, {4, 0}, {4, 4}, {0, 4}})},
                   {"a spike: edges 'e1' and 'e2'", "'e1' and 'e3' run along each other", "(4, 0) to (6, 0)"});
    // there and back on a circle
    expect_only(findings({{Segment{{0, 0}, {2, 0}}, Arc{{0, 0}, 2, 0, 1.5}, Arc{{0, 0}, 2, 1.5, -0.5},
                           Segment{2 * Vec2(std::cos(1), std::sin(1)), {0, 0}}}}),
                {"a spike", "'e1' and 'e2'"});
    // a needle, and cusps between arcs that bend apart, are sharp but no spikes
    EXPECT_EQ(findings({closed({{0, 0}, {4, 0}, {0, 1e-6}})}), "");
    for (const double turn : {0.0, 0.1, 1.3}) {
        const auto at = [&](double x, double y) {
            return Vec2(std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y);
        };
        const double lens = std::acos(0.5);
        EXPECT_EQ(findings({{Arc{at(0, 0), 1, turn, lens}, Arc{at(1, 0), 1, turn + pi - lens, -(pi - lens)},
                             Arc{at(3, 0), 1, turn + pi, -pi}, Segment{at(4, 0), at(4, -3)}, Segment{at(4, -3), at(1, -3)},
                             Segment{at(1, -3), at(1, 0)}}}),
                  "")
            << turn;
    }
}

TEST(Loops, EdgesWithoutLengthAndLoopsWithoutArea) {
    expect_only(findings({closed({{0, 0}, {4, 0}, {4, 0}, {4, 4}})}), {"'e1' has no length", "(4, 0)"});
    expect_finding({closed({{0, 0}, {4, 0}, {2, 0}})}, {"'e0' and 'e1'"});
    expect_only(findings({{Segment{{0, 0}, {1, 0}}, Segment{{1, 0}, {0, 0}}}}), {"'e0' and 'e1' are the same"});
    expect_only(findings({box(0, 0, 4, 4), closed({{1, 1}, {2, 1}, {2, 1 + 8.4e-9}, {1, 1 + 8.4e-9}})}), {"'e4' has no area"});
    expect_only(findings({{Segment{{0, 0}, {std::nan(""), 0}}}}), {"not finite"});
    expect_only(findings({{Arc{{0, 0}, 0, 0, 2 * pi}}}), {"positive radius"});
    expect_only(findings({{Arc{{0, 0}, 1, 0, 7}}}), {"more than once around"});
    expect_only(findings({}), {"no edges"});
}

/// Squares and discs inside each other at random places: nesting by counting the outlines around each, O(n^2).
TEST(Loops, NestingOfRandomIslandsIsThatOfCounting) {
    std::mt19937 random(9);
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    struct Shape {
        Vec2 center;
        double radius;
        bool round;
        bool holds(const Shape& o) const {
            const double reach = (o.center - center).cwiseAbs().maxCoeff() + o.radius;
            return round ? (o.center - center).norm() + 1.5 * o.radius < radius : reach < radius;
        }
        bool apart(const Shape& o) const { return (o.center - center).cwiseAbs().maxCoeff() > 1.01 * (radius + o.radius); }
    };
    for (int run = 0; run < 10; ++run) {
        std::vector<Shape> shapes;
        for (int k = 0; k < 1500; ++k) {
            const double x = uniform(), y = uniform();
            const Shape shape{{x, y}, 0.4 * std::pow(uniform(), 3) + 1e-3, random() % 2 == 0};
            if (std::ranges::all_of(shapes, [&](const Shape& o) { return o.apart(shape) || o.holds(shape) || shape.holds(o); }))
                shapes.push_back(shape);
        }
        std::vector<std::vector<Curve>> loops;
        for (const auto& [c, r, round] : shapes)
            loops.push_back(round ? disc(c.x(), c.y(), r) : box(c.x() - r, c.y() - r, c.x() + r, c.y() + r));
        const Boundary b = check(loops);
        ASSERT_TRUE(b.problems.empty()) << b.problems.front().what;
        int n_holes = 0;
        for (std::size_t l = 0; l < shapes.size(); ++l) {
            int n_around = 0, smallest = -1;
            for (std::size_t o = 0; o < shapes.size(); ++o)
                if (o != l && shapes[o].holds(shapes[l])) {
                    ++n_around;
                    if (smallest < 0 || shapes[o].radius < shapes[static_cast<std::size_t>(smallest)].radius)
                        smallest = static_cast<int>(o);
                }
            ASSERT_EQ(b.loops[l].hole_of, n_around % 2 ? smallest : -1) << run << " " << l;
            n_holes += n_around % 2;
        }
        EXPECT_GT(n_holes, 20);
    }
}

TEST(Loops, TinyEdgesAreLeftOutAndToldAsRepairs) {
    const double tolerance = 1e-9 * std::sqrt(32.0);
    const auto with_step = [](double step) { return closed({{0, 0}, {4, 0}, {4, step}, {4, 4}, {0, 4}}); };
    const Boundary tiny = check({with_step(0.9 * tolerance)});
    ASSERT_TRUE(tiny.problems.empty()) << tiny.problems.front().what;
    ASSERT_EQ(tiny.loops.size(), 1u);
    EXPECT_EQ(tiny.loops[0].edges.size(), 4u);
    EXPECT_EQ(tiny.dropped, std::vector<int>{1});
    ASSERT_EQ(tiny.repairs.size(), 1u);
    EXPECT_NE(tiny.repairs[0].what.find("'e1'"), std::string::npos);
    EXPECT_DOUBLE_EQ(tiny.repairs[0].size, 0.9 * tolerance);
    EXPECT_EQ(tiny.repairs[0].at, Vec2(4, 0));

    const Boundary short_one = check({with_step(1.1 * tolerance)});
    EXPECT_TRUE(short_one.problems.empty());
    EXPECT_TRUE(short_one.repairs.empty());
    EXPECT_EQ(short_one.loops.at(0).edges.size(), 5u);

    // Two tiny ones in a row are longer than the tolerance together: their neighbours do not meet, and that is said.
    const Boundary two = check({closed({{0, 0}, {4, 0}, {4, 0.6 * tolerance}, {4, 1.2 * tolerance}, {4, 4}, {0, 4}})});
    EXPECT_EQ(two.repairs.size(), 2u);
    ASSERT_EQ(two.problems.size(), 1u);
    EXPECT_NE(two.problems[0].what.find("open: edges 'e0' and 'e3'"), std::string::npos) << two.problems[0].what;

    const Boundary dot = check({box(0, 0, 4, 4), disc(2, 2, tolerance / 7)});
    ASSERT_EQ(dot.problems.size(), 1u);
    EXPECT_NE(dot.problems[0].what.find("'e4' has no edge longer than"), std::string::npos) << dot.problems[0].what;
}

TEST(Loops, NestedRingsOfAnyDepthAndOrder) {
    constexpr int n = 24;
    std::mt19937 random(3);
    std::vector<int> order(n);
    for (int k = 0; k < n; ++k) order[static_cast<std::size_t>(k)] = k;
    for (int run = 0; run < 20; ++run) {
        std::shuffle(order.begin(), order.end(), random);
        std::vector<std::vector<Curve>> loops;
        for (const int k : order) {
            const double r = std::pow(1.5, k);  // each around the next smaller one, whichever of the two is round
            loops.push_back(k % 2 ? disc(0.3, 0.2, r)
                                  : closed({{0.3 - r, 0.2}, {0.3, 0.2 - r}, {0.3 + r, 0.2}, {0.3, 0.2 + r}}));
        }
        const Boundary b = check(loops);
        ASSERT_TRUE(b.problems.empty()) << b.problems.front().what;
        for (std::size_t l = 0; l < loops.size(); ++l) {
            const bool is_hole = (n - 1 - order[l]) % 2 == 1;
            ASSERT_EQ(b.loops[l].hole_of >= 0, is_hole);
            if (is_hole) { EXPECT_EQ(order[static_cast<std::size_t>(b.loops[l].hole_of)], order[l] + 1); }
        }
    }
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

namespace {

/// The cubic (-1, 0), (c, 1), (-c, 1), (1, 0), turned: it crosses itself for c > 1, at the parameters 1/2 -+ u with
/// u^2 = 3 (c - 1) / (4 (1 + 3 c)), and has a cusp for c = 1.
Curve bow(double c, double turn) {
    const auto at = [&](double x, double y) {
        return Vec2(std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y);
    };
    return bezier_curve({at(-1, 0), at(c, 1), at(-c, 1), at(1, 0)}, {});
}

/// A closed periodic cubic around the origin whose control points lie at the radii, in order of their angles.
std::vector<Curve> ring(const std::vector<double>& radii, int turns = 1) {
    Nurbs nurbs{3, {}, {}, {}};
    const std::size_t n = radii.size();
    for (std::size_t k = 0; k < n + 3; ++k) {
        const double angle = 2 * pi * turns * static_cast<double>(k % n) / static_cast<double>(n);
        nurbs.points.push_back(radii[k % n] * Vec2(std::cos(angle), std::sin(angle)));
    }
    for (std::size_t k = 0; k < n + 7; ++k) nurbs.knots.push_back(static_cast<double>(k));
    return nurbs_curves(nurbs);
}

Curve full_ellipse(double x, double y, double a, double b, double angle) {
    const Vec2 u(std::cos(angle), std::sin(angle));
    return EllipticArc{{x, y}, a * u, b * left_of(u), 0, 2 * pi};
}

}  // namespace

TEST(SelfCrossing, BowsCrossWhereTheFormulaSays) {
    constexpr double near = 2e-8;  // the tolerance by the sine of the least angle of crossing, 0.07
    for (double turn = 0; turn < 6.3; turn += 0.41)
        for (const double c : {1.001, 1.01, 1.1, 1.5, 2.0, 4.0, 20.0}) {
            const double u = std::sqrt(3 * (c - 1) / (4 * (1 + 3 * c)));
            const auto found = self_meeting(bow(c, turn), 1e-9);
            ASSERT_TRUE(found) << c << " " << turn;
            EXPECT_TRUE(found->crosses);
            EXPECT_NEAR(found->t0, 0.5 - u, near / u) << c << " " << turn;
            EXPECT_NEAR(found->t1, 0.5 + u, near / u) << c << " " << turn;
            EXPECT_NEAR((found->at - 3 * (0.25 - u * u) * Vec2(-std::sin(turn), std::cos(turn))).norm(), 0, near);
        }
}

TEST(SelfCrossing, CuspsWavesAndClosedCurvesDoNot) {
    for (double turn = 0; turn < 6.3; turn += 0.41)
        for (const double c : {-1.0, 0.0, 0.9, 0.999, 1.0}) EXPECT_FALSE(self_meeting(bow(c, turn), 1e-9)) << c << " " << turn;
    std::mt19937 random(11);
    for (int run = 0; run < 100; ++run) {
        // control polygons that wind once around the origin with radii from 1 to 1.5: star-shaped
        std::vector<double> radii(8 + random() % 8);
        for (double& r : radii) r = 1 + 0.5 * static_cast<double>(random()) / 4294967296.0;
        for (const Curve& curve : ring(radii)) ASSERT_FALSE(self_meeting(curve, 1e-9)) << run;
    }
    EXPECT_FALSE(self_meeting(Arc{{0, 0}, 1, 0, 2 * pi}, 1e-9));
}

TEST(SelfCrossing, AClosedCurveThatWindsTwice) {
    // twice around in one curve: it must cross itself an odd number of times
    std::vector<double> radii;
    for (int k = 0; k < 20; ++k) radii.push_back(k < 10 ? 1.0 : 2.0);
    const std::vector<Curve> curves = ring(radii, 2);
    ASSERT_EQ(curves.size(), 1u);
    const auto found = self_meeting(curves[0], 1e-9);
    ASSERT_TRUE(found);
    EXPECT_NEAR((point(curves[0], found->t0) - point(curves[0], found->t1)).norm(), 0, 1e-9);
    EXPECT_GT(found->t1 - found->t0, 0.2);
}

TEST(SelfCrossing, ACurveThatRunsBackOverItself) {
    for (double turn = 0; turn < 6.3; turn += 0.41) {
        const Vec2 u(std::cos(turn), std::sin(turn));
        const auto found = self_meeting(bezier_curve({0 * u, 3 * u, u}, {}), 1e-9);  // out to 9/5 and back
        ASSERT_TRUE(found) << turn;
        EXPECT_FALSE(found->crosses);
    }
}

TEST(Loops, EdgesThatCrossThemselvesAreNamedWithPlaceAndParameters) {
    expect_only(findings({{bow(2, 0), Segment{{1, 0}, {-1, 0}}}}),
                {"/loops/0", "edge 'e0' crosses itself at (", "0.428571)", "0.172673 and 0.827327"});
    EXPECT_EQ(findings({{bow(0.5, 0), Segment{{1, 0}, {-1, 0}}}}), "");
}

TEST(Loops, EllipsesAndSplinesMeetEachOther) {
    // in a box 4 x 2: inside, touching its sides, across them
    const auto in_box = [](const Curve& curve) { return findings({box(-2, -1, 2, 1), {curve}}); };
    EXPECT_EQ(in_box(full_ellipse(0, 0, 1.9, 0.9, 0)), "");
    EXPECT_EQ(in_box(full_ellipse(0, 0, 2 - 1e-6, 1 - 1e-6, 0)), "");
    EXPECT_EQ(check({box(-2, -1, 2, 1), {full_ellipse(0, 0, 2, 1, 0)}}).problems.size(), 4u);
    expect_finding({box(-2, -1, 2, 1), {full_ellipse(0, 0, 2, 0.5, 0)}}, {"two loops touch", "'e1' and 'e4'", "(2, 0)"});
    expect_finding({box(-2, -1, 2, 1), {full_ellipse(0, 0, 1, 2, 0)}}, {"two loops cross", "'e0' and 'e4'", "'e2' and 'e4'"});
    EXPECT_EQ(in_box(ring({0.9, 0.8, 0.7, 0.9, 0.6, 0.8, 0.9})[0]), "");
    expect_finding({box(-2, -1, 2, 1), ring({1.5, 1.6, 1.7, 1.5, 1.6, 1.7, 1.5})}, {"two loops cross"});
    // ellipses drawn twice, the second from another beginning
    const EllipticArc once = std::get<EllipticArc>(full_ellipse(1, 0, 3, 2, 0.4));
    EllipticArc again = once;
    again.start = 1;
    expect_only(findings({{once}, {again}}), {"'e0' and 'e1' are the same"});
    expect_only(findings({ring({1, 1.2, 1, 1.1, 1.3}), ring({1, 1.2, 1, 1.1, 1.3})}), {"'e0' and 'e1' are the same"});
}

TEST(Loops, SmoothJointsOfAllKindsAreNoMeetings) {
    for (double turn = 0; turn < 6.3; turn += 0.29) {
        const Vec2 u(std::cos(turn), std::sin(turn)), v = left_of(u);
        // half an ellipse, a line, a Bezier that leaves the line tangentially, and an arc back
        const std::vector<Curve> outline{Curve(from_conjugate(2 * v, -v, 1.5 * u, 0, -pi)),
                                         Curve(Segment{3 * v, 3 * v + 3 * u}),
                                         bezier_curve({3 * v + 3 * u, 3 * v + 5 * u, 5 * u + 2 * v, 5 * u}, {}),
                                         Curve(Segment{5 * u, -u + 1e-3 * v}), Curve(Segment{-u + 1e-3 * v, v})};
        EXPECT_EQ(findings({outline}), "") << turn;
        EXPECT_EQ(check({outline}).loops.size(), 1u);
    }
}

}  // namespace loops_test
