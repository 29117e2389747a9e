// SPDX-License-Identifier: GPL-3.0-or-later
// Facing zones and pairs of ellipses and splines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/curves/spline_shape.hpp"
#include "geometry/interfaces/interface_kind.hpp"
#include "geometry/proximity/facing.hpp"
#include "tests/geometry/cells/random_grids.hpp"
#include "tests/geometry/curves/sample_curves.hpp"
#include "tests/geometry/proximity/facing_checks.hpp"

namespace abut::geometry::facing_general_test {
namespace {

constexpr double pi = std::numbers::pi;
/// Rounding of pairs and of bisected ends on models of size 1 to 10: arc lengths come out of quadrature.
constexpr double exact = 1e-10;
constexpr test::FacingBounds bounds{.exact = exact, .on_normal = 1e-12, .difference = 1e-7, .advances_within = false};

using test::add_loop;
using test::ellipse;
using test::length_on_first;
using test::nurbs_circle;
using test::turned;
using test::walk;

Part alone(const std::vector<Curve>& curves) {
    Part part;
    add_loop(part, curves);
    return part;
}

/// Edges 0 bottom, 1 right, 2 top, 3 left.
Part block(double x0, double y0, double x1, double y1) {
    return alone(
        {Segment{{x0, y0}, {x1, y0}}, Segment{{x1, y0}, {x1, y1}}, Segment{{x1, y1}, {x0, y1}}, Segment{{x0, y1}, {x0, y0}}});
}

/// A square plate of half width `half` with a hole: edge 4.
Part plate(double half, const Curve& hole) {
    Part part = block(-half, -half, half, half);
    add_loop(part, {reversed(hole)});
    return part;
}

/// A cam: closed cubic B-spline through n control points at the radii r(angle).
Curve cam(const Vec2& center, int n) {
    Nurbs nurbs{3, {}, {}, {}};
    for (int i = 0; i < n + 3; ++i) {
        const double a = 2 * pi * (i % n) / n, r = 2 + 0.5 * std::cos(a) + 0.05 * std::sin(2 * a);
        nurbs.points.push_back(center + r * Vec2(std::cos(a), std::sin(a)));
    }
    for (int i = 0; i < n + 7; ++i) nurbs.knots.push_back(i);
    const std::vector<Curve> curves = nurbs_curves(nurbs);
    EXPECT_EQ(curves.size(), 1u);
    return curves.front();
}

void expect_consistent(const Part& part1, const Part& part2, double distance) {
    test::expect_consistent(part1, part2, distance, bounds);
}

void expect_derivatives(const Part& part1, const Part& part2, const FacingZone& zone, double s1, double guess) {
    test::expect_derivatives(part1, part2, zone, s1, guess, bounds);
}

TEST(FacingGeneral, EllipticalPinInAHoleThatIsLargerAllRound) {
    for (const double c : {0.3, 1e-4, 1e-8}) {
        const Part pin = alone({ellipse({0, 0}, 3, 2, 0.3)}), hole = plate(10, ellipse({0, 0}, 3 + c, 2 + c, 0.3));
        const auto zones = find_facing_zones(pin, hole, 0.5);
        ASSERT_EQ(zones.size(), 1u) << c;
        EXPECT_TRUE(zones[0].closed);
        EXPECT_NEAR(zones[0].end1 - zones[0].begin1, zones[0].chain1.length, exact);
        // the gap is extreme where the normals are parallel: there it is the difference of the support functions
        double least = c;
        for (int k = 0; k <= 20000; ++k) {
            const double a = pi / 2 * k / 20000, x = std::cos(a), y = std::sin(a);
            const double inner = std::hypot(3 * x, 2 * y), outer = std::hypot((3 + c) * x, (2 + c) * y);
            least = std::min(least, c * ((6 + c) * x * x + (4 + c) * y * y) / (inner + outer));
        }
        EXPECT_NEAR(zones[0].gap_max, c, 1e-14);
        EXPECT_NEAR(zones[0].gap_min, least, 1e-14 + 1e-8 * c);
        EXPECT_LT(zones[0].gap_min, 0.999 * c);
        expect_consistent(pin, hole, 0.5);
    }
}

TEST(FacingGeneral, EllipseInItsOwnHole) {
    for (const double seam : {0.0, 1.0}) {
        const Part pin = alone({ellipse({1, 2}, 3, 2, 0.3)}), hole = plate(10, ellipse({1, 2}, 3, 2, 0.3, seam));
        const auto zones = find_facing_zones(pin, hole, 0.5);
        ASSERT_EQ(zones.size(), 1u);
        EXPECT_TRUE(zones[0].closed);
        EXPECT_EQ(zones[0].begin1, 0);
        EXPECT_NEAR(zones[0].gap_min, 0, 1e-12);
        EXPECT_NEAR(zones[0].gap_max, 0, 1e-12);
        for (const FacingPair& p : walk(pin, hole, zones[0], 200)) {
            ASSERT_TRUE(p.found);
            EXPECT_NEAR((p.on1.x - p.on2.x).norm(), 0, 1e-12);
        }
        expect_consistent(pin, hole, 0.5);
    }
}

TEST(FacingGeneral, EllipseTouchingABlock) {
    const double d = 0.05;
    for (const double angle : {0.0, 0.7, 2.0}) {
        const Part ball = turned(alone({ellipse({0.4, 1}, 2, 1)}), angle, {0, 0}),
                   base = turned(block(-3, -1, 3, 0), angle, {0, 0});
        const auto zones = find_facing_zones(ball, base, d);
        ASSERT_EQ(zones.size(), 1u);
        EXPECT_NEAR(zones[0].gap_min, 0, 1e-14);
        EXPECT_NEAR(zones[0].gap_max, d, 1e-12);
        EXPECT_TRUE(zones[0].begin_is_limit && zones[0].end_is_limit);
        EXPECT_NEAR(0.5 * (zones[0].begin1 + zones[0].end1), 0.75 * zones[0].chain1.length, exact);  // symmetric
        EXPECT_NEAR(0.5 * (zones[0].begin2 + zones[0].end2), 3 - 0.4, exact);
        expect_consistent(ball, base, d);
        expect_consistent(base, ball, d);
        expect_derivatives(ball, base, zones[0], zones[0].begin1 + 0.1, zones[0].begin2);
        expect_derivatives(base, ball, find_facing_zones(base, ball, d)[0], 2.7, 0.75 * zones[0].chain1.length);
    }
}

TEST(FacingGeneral, DistancesFarBelowTheArcsTolerance) {
    for (const double d : {1e-5, 1e-7, 1e-9}) {
        const auto zones = find_facing_zones(alone({ellipse({0.4, 1}, 2, 1)}), block(-3, -1, 3, 0), d);
        ASSERT_EQ(zones.size(), 1u) << d;
        // curvature at the vertex of the short axis is 1/4: gap s^2/8
        EXPECT_NEAR(zones[0].end1 - zones[0].begin1, 2 * std::sqrt(8 * d), 1e-2 * std::sqrt(d)) << d;
        EXPECT_NEAR(zones[0].gap_min, 0, 1e-14);
    }
    EXPECT_TRUE(find_facing_zones(alone({ellipse({0.4, 1 + 1e-7}, 2, 1)}), block(-3, -1, 3, 0), 0.9e-7).empty());
    EXPECT_EQ(find_facing_zones(alone({ellipse({0.4, 1 + 1e-7}, 2, 1)}), block(-3, -1, 3, 0), 1.1e-7).size(), 1u);
}

TEST(FacingGeneral, CamOnAFlat) {
    const Curve profile = cam({0, 0}, 12);
    const Box2 box = bounding_box(profile);
    for (const double lift : {0.0, 0.01, -0.01}) {
        const Part follower = block(-3, box.max.y() + lift, 3, box.max.y() + 2), wheel = alone({profile});
        const auto zones = find_facing_zones(wheel, follower, 0.1);
        ASSERT_EQ(zones.size(), 1u);
        EXPECT_NEAR(zones[0].gap_min, lift, 1e-13);
        EXPECT_NEAR(zones[0].gap_max, 0.1, 1e-12);
        expect_consistent(wheel, follower, 0.1);
        expect_consistent(follower, wheel, 0.1);
        expect_derivatives(wheel, follower, zones[0], zones[0].begin1 + 0.3 * (zones[0].end1 - zones[0].begin1),
                           zones[0].begin2);
    }
}

/// A spline's edge on top of a block, with corners at its ends.
std::vector<Curve> under(const Curve& top, double depth) {
    const Vec2 a = point(top, 0), b = point(top, 1);  // runs from right to left
    const Vec2 low(0, std::min(a.y(), b.y()) - depth);
    const Vec2 left(b.x(), low.y()), right(a.x(), low.y());
    return {top, Segment{b, left}, Segment{left, right}, Segment{right, a}};
}
std::vector<Curve> over(const Curve& bottom, double height) {
    const Vec2 a = point(bottom, 0), b = point(bottom, 1);  // runs from left to right
    const double y = std::max(a.y(), b.y()) + height;
    return {bottom, Segment{b, {b.x(), y}}, Segment{{b.x(), y}, {a.x(), y}}, Segment{{a.x(), y}, a}};
}

TEST(FacingGeneral, SplineUnderItself) {
    const Curve wave = bezier_curve({{4, 0}, {3, 1.5}, {1, -1.5}, {0, 0.3}}, {});
    const Part lower = alone(under(wave, 1));
    for (const double lift : {0.0, 1e-7, 1e-3, 0.05}) {
        const Part upper = alone(over(transformed(reversed(wave), 1, 0, {0, lift}), 1));
        const auto zones = find_facing_zones(lower, upper, 0.2);
        ASSERT_EQ(zones.size(), 1u) << lift;
        EXPECT_LE(zones[0].gap_max, lift + 1e-12);
        // curves moved apart by a lift are that times the cosine of their slope apart, here at most 61 degrees, and the pairing
        // normal is that of the middle
        EXPECT_GE(zones[0].gap_min, std::cos(61.5 * pi / 180) * lift - 1e-12);
        EXPECT_GT(zones[0].end1 - zones[0].begin1, length(wave) - 2 * lift - exact);
        if (lift == 0) {
            EXPECT_EQ(zones[0].begin1, 0);
            EXPECT_EQ(zones[0].end1, zones[0].chain1.length);
            EXPECT_EQ(zones[0].end2, 0);
            EXPECT_EQ(zones[0].begin2, zones[0].chain2.length);
        }
        expect_consistent(lower, upper, 0.2);
    }
}

TEST(FacingGeneral, ParabolaAgainstItsParallelOffset) {
    // the parallel curve of y = x^2/2 at distance h is rational of no low degree: interpolated here by short Bezier pieces with
    // exact ends and tangents, its error h_piece^4
    const double h = 0.3;
    const auto offset = [&](double x) { return Vec2(Vec2(x, x * x / 2) + h * Vec2(-x, 1) / std::sqrt(1 + x * x)); };
    const auto along = [&](double x) { return Vec2(Vec2(1, x) * (1 - h / std::pow(1 + x * x, 1.5))); };
    constexpr int n = 40;
    std::vector<Curve> pieces;
    for (int i = 0; i < n; ++i) {
        const double a = -1 + 2.0 * i / n, b = -1 + 2.0 * (i + 1) / n;
        pieces.push_back(
            bezier_curve({offset(a), offset(a) + (b - a) / 3 * along(a), offset(b) - (b - a) / 3 * along(b), offset(b)}, {}));
    }
    const Vec2 from = offset(-1), to = offset(1);
    pieces.push_back(Segment{to, {to.x(), 3}});
    pieces.push_back(Segment{{to.x(), 3}, {from.x(), 3}});
    pieces.push_back(Segment{{from.x(), 3}, from});
    const Part lower = alone(under(bezier_curve({{1.5, 1.125}, {0, -1.125}, {-1.5, 1.125}}, {}), 2)), upper = alone(pieces);
    const auto zones = find_facing_zones(lower, upper, 0.32);  // less than to the sides of the upper part
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_NEAR(zones[0].gap_min, h, 1e-6);
    EXPECT_NEAR(zones[0].gap_max, h, 1e-6);
    const double reach = std::sqrt(2.0) + std::asinh(1.0);  // the parabola's length over [-1, 1]
    EXPECT_NEAR(zones[0].end1 - zones[0].begin1, reach, 1e-6);
    expect_consistent(lower, upper, 0.32);
}

TEST(FacingGeneral, NurbsCirclesDoAsCirclesDo) {
    const Curve circle = Arc{{0.02, -0.03}, 2, 0, 2 * pi}, hole = Arc{{0, 0}, 2.05, 0, 2 * pi};
    const Part pin = alone({circle}), frame = plate(5, hole);
    const Part nurbs_pin = alone({nurbs_circle({0.02, -0.03}, 2)}), nurbs_frame = plate(5, nurbs_circle({0, 0}, 2.05));
    const Part base = block(-4, -4, 4, -2.04);
    const auto compare = [](const Part& a1, const Part& a2, const Part& b1, const Part& b2, double d) {
        const auto expected = find_facing_zones(a1, a2, d), found = find_facing_zones(b1, b2, d);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i].closed, expected[i].closed);
            EXPECT_NEAR(found[i].begin1, expected[i].begin1, 1e-9);
            EXPECT_NEAR(found[i].end1, expected[i].end1, 1e-9);
            EXPECT_NEAR(found[i].begin2, expected[i].begin2, 1e-9);
            EXPECT_NEAR(found[i].end2, expected[i].end2, 1e-9);
            EXPECT_NEAR(found[i].gap_min, expected[i].gap_min, 1e-12);
            EXPECT_NEAR(found[i].gap_max, expected[i].gap_max, 1e-12);
            const auto p = walk(a1, a2, expected[i], 20), q = walk(b1, b2, found[i], 20);
            for (std::size_t k = 0; k < p.size(); ++k) {
                EXPECT_NEAR(p[k].gap, q[k].gap, 1e-12);
                EXPECT_NEAR((p[k].on1.x - q[k].on1.x).norm(), 0, 1e-9);
                EXPECT_NEAR((p[k].on2.x - q[k].on2.x).norm(), 0, 1e-9);
                EXPECT_NEAR(p[k].length_rate, q[k].length_rate, 1e-9);
                EXPECT_NEAR(p[k].slope, q[k].slope, 1e-9);
            }
        }
    };
    for (const double d : {0.5, 0.05}) {
        compare(pin, frame, nurbs_pin, frame, d);
        compare(pin, frame, pin, nurbs_frame, d);
        compare(pin, frame, nurbs_pin, nurbs_frame, d);
        compare(frame, pin, nurbs_frame, nurbs_pin, d);
        compare(pin, base, nurbs_pin, base, d);
        compare(base, pin, base, nurbs_pin, d);
    }
}

TEST(FacingGeneral, RigidMotionChangesNothing) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> angle(-3, 3), shift(-20, 20);
    const Part base = alone(under(bezier_curve({{3, 0}, {1, 0.8}, {-1, -0.4}, {-3, 0}}, {}), 1)),
               foot = alone({ellipse({0, 1.3}, 1.5, 1, 0.2)});
    const auto still = find_facing_zones(base, foot, 0.3);
    ASSERT_EQ(still.size(), 1u);
    for (int k = 0; k < 10; ++k) {
        const double a = angle(random);
        const Vec2 d(shift(random), shift(random));
        const auto moved = find_facing_zones(turned(base, a, d), turned(foot, a, d), 0.3);
        ASSERT_EQ(moved.size(), 1u);
        EXPECT_NEAR(moved[0].begin1, still[0].begin1, 1e-9);
        EXPECT_NEAR(moved[0].end1, still[0].end1, 1e-9);
        EXPECT_NEAR(moved[0].begin2, still[0].begin2, 1e-9);
        EXPECT_NEAR(moved[0].end2, still[0].end2, 1e-9);
        EXPECT_NEAR(moved[0].gap_min, still[0].gap_min, 1e-12);
        EXPECT_NEAR(moved[0].gap_max, still[0].gap_max, 1e-12);
    }
}

/// Ellipses, cams and blocks under waves, in poses where they meet.
Part random_part(std::mt19937& random, int kind, const Vec2& shift) {
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    if (kind == 0) return alone({ellipse(shift, uniform(0.5, 2), uniform(0.5, 2), uniform(-3, 3), uniform(0, 6))});
    if (kind == 1) return turned(alone({cam({0, 0}, 8)}), uniform(-3, 3), shift);
    if (kind == 2) {
        const Part wave =
            alone(under(bezier_curve({{2, 0}, {0.7, uniform(-0.8, 0.8)}, {-0.7, uniform(-0.8, 0.8)}, {-2, 0}}, {}), 1.5));
        return turned(wave, uniform(-3, 3), shift);
    }
    return turned(plate(5, ellipse({0, 0}, uniform(2, 3), uniform(2, 3))), uniform(-3, 3), 0.1 * shift);
}

/// Does a zone end near a centre of curvature, where neighbouring points draw together?
bool folds(const Part& part1, const Part& part2, const std::vector<FacingZone>& zones) {
    for (const FacingZone& zone : zones)
        for (const FacingPair& p : walk(part1, part2, zone, 10)) {
            const double r = p.gap / (p.on1.normal - p.on2.normal).norm();
            if (1 + std::min(r * p.on1.curvature, r * p.on2.curvature) < 0.3) return true;
        }
    return false;
}

/// Without slivers: what lies in the line of sight is looked for at samples, which may miss it for one order of the parts.
std::vector<FacingZone> worth_counting(std::vector<FacingZone> zones) {
    constexpr double sliver = 1e-3;
    std::erase_if(zones, [](const FacingZone& z) { return z.end1 - z.begin1 < sliver && z.begin2 - z.end2 < sliver; });
    return zones;
}

void expect_consistent_and_symmetric(int n_cases, unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    int n_zones = 0;
    for (int k = 0; k < n_cases; ++k) {
        const Part a = random_part(random, k % 3, {0, 0});
        const Part b = random_part(random, k % 4, {uniform(-4, 4), uniform(-4, 4)});
        const double d = uniform(0.01, 1);
        expect_consistent(a, b, d);
        const auto there = worth_counting(find_facing_zones(a, b, d)), back = worth_counting(find_facing_zones(b, a, d));
        n_zones += static_cast<int>(there.size());
        EXPECT_EQ(there.size(), back.size()) << k;
        double second = 0;
        for (const FacingZone& zone : there) second += zone.begin2 - zone.end2;
        // ends where a nearer partner takes over are those of the arcs, and those near a centre of curvature depend on where an
        // arc ends
        if (!folds(a, b, there)) { EXPECT_NEAR(length_on_first(back), second, 1e-3) << k; }
        for (const FacingZone& zone : there)
            for (const FacingPair& p : walk(a, b, zone, 10)) {
                FacingZone exchanged = zone;
                std::swap(exchanged.chain1, exchanged.chain2);
                const FacingPair q = pair_from_first(b, a, exchanged, p.s2, p.s1);
                ASSERT_TRUE(q.found);
                EXPECT_NEAR((q.on2.x - p.on1.x).norm(), 0, 1e-11) << k;
                EXPECT_NEAR(q.gap, p.gap, 1e-12) << k;
            }
        if (::testing::Test::HasFailure()) FAIL() << "pose " << k;
    }
    EXPECT_GT(n_zones, n_cases / 3);
}

TEST(FacingGeneral, RandomPosesAreConsistentAndSymmetric) {
    expect_consistent_and_symmetric(12, 11);
}
TEST(LongFacingGeneral, RandomPosesAreConsistentAndSymmetric) {
    expect_consistent_and_symmetric(2000, 12);
}

TEST(FacingGeneral, SmallHoleInALargePlate) {
    const Part pin = alone({ellipse({0, 0}, 0.01, 0.02)}), frame = plate(100, ellipse({0, 0}, 0.0101, 0.0201));
    const auto zones = find_facing_zones(pin, frame, 0.005);
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_TRUE(zones[0].closed);
    EXPECT_NEAR(zones[0].gap_max, 1e-4, 1e-14);
}

TEST(InterfaceKinds, OfEllipsesAndSplines) {
    const Part base = block(-3, -1, 3, 0), ball = alone({ellipse({0, 1}, 2, 1)});
    const Part hole = plate(10, ellipse({0, 0}, 3, 2));
    EXPECT_EQ(interface_kind(base, 2, ball, 0), "flat-on-round");
    EXPECT_EQ(interface_kind(ball, 0, base, 2), "round-on-flat");
    EXPECT_EQ(interface_kind(ball, 0, ball, 0), "round-on-round");
    EXPECT_EQ(interface_kind(ball, 0, hole, 4), "pin-in-hole");
    EXPECT_EQ(interface_kind(base, 2, hole, 4), "general");
    const Part flat = alone(under(bezier_curve({{2, 0}, {0.5, 0}, {-0.5, 0}, {-2, 0}}, {}), 1));
    EXPECT_EQ(interface_kind(flat, 0, block(-1, 0, 1, 1), 0), "flat-on-flat");
    // a wave that is convex at x > 0 and concave at x < 0: what counts is where the ball lies
    const Part wave = alone(under(bezier_curve({{3, 0}, {1, 2}, {-1, -2}, {-3, 0}}, {}), 2));
    EXPECT_EQ(interface_kind(wave, 0, alone({ellipse({-1.3, -0.1}, 0.3, 0.3)}), 0), "round-in-groove");
    EXPECT_EQ(interface_kind(wave, 0, alone({ellipse({1.3, 1.1}, 0.3, 0.3)}), 0), "round-on-round");
}

}  // namespace
}  // namespace abut::geometry::facing_general_test
