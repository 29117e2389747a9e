// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/proximity/facing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <random>
#include <stdexcept>

#include "tests/geometry/cells/random_grids.hpp"
#include "tests/geometry/proximity/facing_checks.hpp"

namespace abut::geometry::facing_test {
namespace {

constexpr double pi = std::numbers::pi;
/// Rounding of closed-form pairs and bisected ends on models of size 1 to 100, with room to spare.
constexpr double exact = 1e-11;
constexpr test::FacingBounds bounds{.exact = exact, .on_normal = exact, .difference = 1e-8};

using test::add_loop;
using test::length_on_first;
using test::turned;
using test::walk;

Part polygon(const std::vector<Vec2>& p) {
    Part part;
    add_loop(part, test::closed(p));
    return part;
}

/// Edges 0 bottom, 1 right, 2 top, 3 left.
Part block(double x0, double y0, double x1, double y1) {
    return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

Part disc(const Vec2& center, double radius, double seam = 0) {
    Part part;
    add_loop(part, {Arc{center, radius, seam, 2 * pi}});
    return part;
}

/// A square plate of half width `half` with a round hole: edge 4.
Part plate_with_hole(double half, const Vec2& center, double radius, double seam = 0) {
    Part part = block(-half, -half, half, half);
    add_loop(part, {Arc{center, radius, seam, -2 * pi}});
    return part;
}

/// [x0, x1] x [y0, y1] with corners rounded by r; edges run from the bottom: line, arc, line, arc, ...
Part rounded(double x0, double y0, double x1, double y1, double r) {
    Part part;
    add_loop(part, {Segment{{x0 + r, y0}, {x1 - r, y0}}, Arc{{x1 - r, y0 + r}, r, -pi / 2, pi / 2},
                    Segment{{x1, y0 + r}, {x1, y1 - r}}, Arc{{x1 - r, y1 - r}, r, 0, pi / 2},
                    Segment{{x1 - r, y1}, {x0 + r, y1}}, Arc{{x0 + r, y1 - r}, r, pi / 2, pi / 2},
                    Segment{{x0, y1 - r}, {x0, y0 + r}}, Arc{{x0 + r, y0 + r}, r, pi, pi / 2}});
    return part;
}

void expect_consistent(const Part& part1, const Part& part2, double distance) {
    test::expect_consistent(part1, part2, distance, bounds);
}

void expect_derivatives(const Part& part1, const Part& part2, const FacingZone& zone, double s1, double guess) {
    test::expect_derivatives(part1, part2, zone, s1, guess, bounds);
}

TEST(Chains, CornersSplitAndTangentJointsJoin) {
    EXPECT_EQ(smooth_chains(block(0, 0, 1, 1)).size(), 4u);
    const Part part = rounded(0, 0, 4, 2, 0.5);
    const auto chains = smooth_chains(part);
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_TRUE(chains[0].closed);
    EXPECT_NEAR(chains[0].length, perimeter(part), exact);
    EXPECT_EQ(chains[0].edges.front(), 0);
}

TEST(Chains, OpenChainStartsAtItsCorner) {
    // a drop: two edges that meet in one corner, at (0, -2), listed so that the loop begins elsewhere
    const double a = std::acos(0.5);  // tangents from (0, -2) to the unit circle
    const Vec2 right(std::cos(-pi / 2 + a), std::sin(-pi / 2 + a)), left(-right.x(), right.y());
    Part part;
    add_loop(part, {Arc{{0, 0}, 1, -pi / 2 + a, 2 * pi - 2 * a}, Segment{left, {0, -2}}, Segment{{0, -2}, right}});
    const auto chains = smooth_chains(part);
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_FALSE(chains[0].closed);
    EXPECT_EQ(chains[0].edges, (std::vector<int>{2, 0, 1}));
    EXPECT_NEAR((chain_point(part, chains[0], 0).x - Vec2(0, -2)).norm(), 0, exact);
    EXPECT_NEAR((chain_point(part, chains[0], chains[0].length).x - Vec2(0, -2)).norm(), 0, exact);
}

TEST(Chains, PointsAreContinuousAndPeriodic) {
    const Part part = rounded(0, 0, 4, 2, 0.5);
    const Chain chain = smooth_chains(part)[0];
    for (const double s : chain.begin) {
        const ChainPoint before = chain_point(part, chain, s - 1e-9), after = chain_point(part, chain, s + 1e-9);
        EXPECT_NEAR((before.x - after.x).norm(), 2e-9, 1e-12);
        EXPECT_NEAR((before.normal - after.normal).norm(), 0, 1e-8);
    }
    EXPECT_NEAR((chain_point(part, chain, 0.3).x - chain_point(part, chain, 0.3 - 2 * chain.length).x).norm(), 0, exact);
    EXPECT_NEAR((chain_point(part, chain, -1e-18).x - chain_point(part, chain, 0).x).norm(), 0, exact);
}

TEST(Facing, CirclesTouchingAtAPoint) {
    const Part a = disc({0, 0}, 1), b = disc({2, 0}, 1);
    const double d = 0.05;
    const auto zones = find_facing_zones(a, b, d);
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_NEAR(zones[0].gap_min, 0, exact);
    EXPECT_NEAR(zones[0].gap_max, d, exact);
    EXPECT_TRUE(zones[0].begin_is_limit && zones[0].end_is_limit);
    // mirror pairs: gap = 2 (1 - cos), ends where it is d; the zone crosses the seam of the first circle
    EXPECT_NEAR(zones[0].end1 - zones[0].begin1, 2 * std::acos(1 - d / 2), exact);
    EXPECT_NEAR(zones[0].begin1, 2 * pi - std::acos(1 - d / 2), exact);
    expect_consistent(a, b, d);
}

TEST(Facing, CircleOnBlock) {
    const Part ball = disc({0, 1}, 1), base = block(-2, -1, 2, 0);
    const double d = 0.1;
    const auto zones = find_facing_zones(ball, base, d);
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_NEAR(zones[0].gap_min, 0, exact);
    EXPECT_NEAR(0.5 * (zones[0].begin1 + zones[0].end1), 1.5 * pi, exact);
    EXPECT_NEAR(0.5 * (zones[0].begin2 + zones[0].end2), 2, exact);
    expect_consistent(ball, base, d);
    expect_derivatives(ball, base, zones[0], 1.5 * pi + 0.2, 2);
    expect_derivatives(ball, base, zones[0], 1.5 * pi, 2);
}

TEST(Facing, CircleFarFromTheDistanceIsNotFound) {
    EXPECT_TRUE(find_facing_zones(disc({0, 1.2}, 1), block(-2, -1, 2, 0), 0.1).empty());
    EXPECT_FALSE(find_facing_zones(disc({0, 1.2}, 1), block(-2, -1, 2, 0), 0.21).empty());
    EXPECT_THROW(find_facing_zones(disc({0, 1.2}, 1), block(-2, -1, 2, 0), std::nan("")), std::logic_error);
}

TEST(Facing, TinyDistanceOnLongEdges) {
    const auto zones = find_facing_zones(disc({0, 1}, 1), block(-1000, -1, 1000, 0), 1e-4);
    ASSERT_EQ(zones.size(), 1u);
    // half the angle is the tilt of the pair: gap = (1 - cos a) / cos(a/2), near a^2 / 2
    EXPECT_NEAR(zones[0].end1 - zones[0].begin1, 2 * std::sqrt(2e-4), 1e-5);
}

/// Where the centre is far off, the points of an arc are numbers apart that are coarse beside those of the face.
TEST(Facing, NearlyFlatArcsPairAllAlong) {
    for (const double radius : {1e3, 2e4, 1e6, 1e8}) {
        SCOPED_TRACE(radius);
        const double half = std::asin(20 / radius), sag = radius * (1 - std::cos(half));
        Part crown;
        add_loop(crown, {Arc{{0, radius}, radius, -pi / 2 - half, 2 * half}, Segment{{20, sag}, {20, 20}},
                         Segment{{20, 20}, {-20, 20}}, Segment{{-20, 20}, {-20, sag}}});
        const Part base = block(-50, -30, 50, 0);
        const auto zones = find_facing_zones(base, crown, 1);
        ASSERT_EQ(zones.size(), 1u);
        const FacingZone& zone = zones[0];
        const double length1 = zone.end1 - zone.begin1, rate = (zone.end2 - zone.begin2) / length1;
        for (int k = 1; k < 1000; ++k) {
            const double along = k / 1000.0 * length1;
            const FacingPair pair =
                pair_from_first(base, crown, zone, zone.begin1 + along, zone.begin2 + along * rate + 0.3 * std::sin(k));
            ASSERT_TRUE(pair.found) << k;
            const double x = pair.on1.x.x(), first = x * x / (2 * radius);
            ASSERT_NEAR(pair.gap, first, first * x * x / (radius * radius) + 1e-15 * radius + 1e-12) << k;
        }
    }
}

TEST(Facing, PinTouchingTheBottomOfItsHole) {
    const Part pin = disc({0, -0.05}, 10), plate = plate_with_hole(20, {0, 0}, 10.05);
    const auto zones = find_facing_zones(pin, plate, 1);
    ASSERT_EQ(zones.size(), 1u);
    const FacingZone& zone = zones[0];
    EXPECT_TRUE(zone.closed);
    EXPECT_NEAR(zone.gap_min, 0, exact);
    EXPECT_NEAR(zone.gap_max, 0.1, exact);
    EXPECT_NEAR(zone.begin1, 10 * pi / 2, exact);  // the largest gap is on top
    EXPECT_NEAR(zone.end1 - zone.begin1, zone.chain1.length, exact);
    EXPECT_NEAR(zone.begin2 - zone.end2, zone.chain2.length, exact);
    expect_consistent(pin, plate, 1);
    for (const double s1 : {20.0, 40.0, 70.0})
        expect_derivatives(pin, plate, zone, s1, walk(pin, plate, zone, 1)[0].s2 - (s1 - zone.begin1));
}

TEST(Facing, PinOfTheHolesSize) {
    for (const double seam : {0.0, 1.0}) {
        const Part pin = disc({3, 4}, 10), plate = plate_with_hole(20, {3, 4}, 10, seam);
        const auto zones = find_facing_zones(pin, plate, 0.5);
        ASSERT_EQ(zones.size(), 1u);
        EXPECT_TRUE(zones[0].closed);
        EXPECT_NEAR(zones[0].begin1, 0, exact);
        EXPECT_NEAR(zones[0].gap_min, 0, exact);
        EXPECT_NEAR(zones[0].gap_max, 0, exact);
        expect_consistent(pin, plate, 0.5);
    }
}

TEST(Facing, PinBiggerThanItsHoleOverlapsAllRound) {
    const Part pin = disc({0.01, 0}, 10.05), plate = plate_with_hole(20, {0, 0}, 10);
    const auto zones = find_facing_zones(pin, plate, 0.5);
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_TRUE(zones[0].closed);
    EXPECT_NEAR(zones[0].gap_min, -0.06, exact);
    EXPECT_NEAR(zones[0].gap_max, -0.04, exact);
    expect_consistent(pin, plate, 0.5);
}

TEST(Facing, SmallPinInALargeHole) {
    const Part pin = disc({0, -1}, 1), plate = plate_with_hole(5, {0, 0}, 2);
    const auto all_round = find_facing_zones(pin, plate, 3);
    ASSERT_EQ(all_round.size(), 1u);
    EXPECT_TRUE(all_round[0].closed);
    EXPECT_NEAR(all_round[0].gap_max, 2, exact);
    expect_consistent(pin, plate, 3);
    const auto near = find_facing_zones(pin, plate, 0.3);
    ASSERT_EQ(near.size(), 1u);
    EXPECT_FALSE(near[0].closed);
    EXPECT_TRUE(near[0].begin_is_limit && near[0].end_is_limit);
    EXPECT_NEAR(0.5 * (near[0].begin1 + near[0].end1), 1.5 * pi, exact);
    expect_consistent(pin, plate, 0.3);
    expect_derivatives(pin, plate, near[0], 1.5 * pi + 0.4, 0.5 * (near[0].begin2 + near[0].end2));
}

TEST(Facing, FlatsOverlapPartially) {
    const Part base = block(0, 0, 2, 1), top = block(0.5, 1, 1.5, 2);
    const auto zones = find_facing_zones(base, top, 0.1);
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_EQ(zones[0].begin1, 0.5);
    EXPECT_EQ(zones[0].end1, 1.5);
    EXPECT_EQ(zones[0].begin2, 1);
    EXPECT_EQ(zones[0].end2, 0);
    EXPECT_FALSE(zones[0].begin_is_limit || zones[0].end_is_limit);
    expect_consistent(base, top, 0.1);
    // shifted against each other with a gap: [0, 1.1] against [-0.9, 0.2]
    const auto shifted = find_facing_zones(block(0, 0, 1, 1.1), block(1.02, -0.9, 2, 0.2), 0.1);
    ASSERT_EQ(shifted.size(), 1u);
    EXPECT_NEAR(shifted[0].begin1, 0, exact);
    EXPECT_NEAR(shifted[0].end1, 0.2, exact);
    EXPECT_NEAR(shifted[0].gap_min, 0.02, exact);
    EXPECT_NEAR(shifted[0].gap_max, 0.02, exact);
}

TEST(Facing, CommonCornersEndTheZoneExactly) {
    for (const double angle : {0.0, 0.7, 2.0}) {
        const Part a = turned(block(0, 0, 1, 3), angle, {5, -2}), b = turned(block(1, 0, 4, 3), angle, {5, -2});
        const auto zones = find_facing_zones(a, b, 0.2);
        ASSERT_EQ(zones.size(), 1u);
        EXPECT_EQ(zones[0].begin1, 0);
        EXPECT_EQ(zones[0].end1, zones[0].chain1.length);
        EXPECT_EQ(zones[0].begin2, zones[0].chain2.length);
        EXPECT_EQ(zones[0].end2, 0);
        expect_consistent(a, b, 0.2);
    }
}

TEST(Facing, OverlappingBlocks) {
    const auto zones = find_facing_zones(block(0, 0, 1, 1), block(0.9, 0, 2, 1), 0.3);
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_NEAR(zones[0].gap_min, -0.1, exact);
    EXPECT_EQ(zones[0].begin1, 0);
    EXPECT_EQ(zones[0].end1, 1);
    EXPECT_TRUE(find_facing_zones(block(0, 0, 1, 1), block(0.9, 0, 2, 1), 0.09).empty());
}

TEST(Facing, FacesThatCrossAtAnAngle) {
    // a wedge whose underside passes through the face of the block: both signs of the gap, one zone
    const Part base = block(-3, -1, 3, 0), wedge = polygon({{-2, -0.1}, {2, 0.1}, {2, 1}, {-2, 1}});
    const auto zones = find_facing_zones(base, wedge, 0.5);
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_LT(zones[0].gap_min, -0.09);
    EXPECT_GT(zones[0].gap_max, 0.09);
    expect_consistent(base, wedge, 0.5);
    // a distance far below the depth leaves only the neighbourhood of the crossing
    const auto narrow = find_facing_zones(base, wedge, 1e-3);
    ASSERT_EQ(narrow.size(), 1u);
    EXPECT_NEAR(narrow[0].gap_min, -1e-3, exact);
    EXPECT_NEAR(narrow[0].gap_max, 1e-3, exact);
    EXPECT_TRUE(narrow[0].begin_is_limit && narrow[0].end_is_limit);
}

TEST(Facing, RoundedBlockOnAFlat) {
    const Part base = block(-5, -1, 5, 0), foot = rounded(-1, 0, 1, 2, 0.25);
    const auto zones = find_facing_zones(base, foot, 0.1);
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_NEAR(zones[0].gap_min, 0, exact);
    EXPECT_NEAR(zones[0].gap_max, 0.1, exact);
    EXPECT_TRUE(zones[0].begin_is_limit && zones[0].end_is_limit);
    EXPECT_GT(zones[0].end1 - zones[0].begin1, 1.5);  // runs over the joints into both arcs
    EXPECT_NEAR(zones[0].begin1 + zones[0].end1, 10, exact);
    expect_consistent(base, foot, 0.1);
    expect_consistent(foot, base, 0.1);
    // curvature jumps at the joint, the pairing does not
    const double joint = 5 - 0.75;  // arc length on the base's top edge at x = 0.75
    const FacingPair a = pair_from_first(base, foot, zones[0], joint - 1e-7, zones[0].begin2);
    const FacingPair b = pair_from_first(base, foot, zones[0], joint + 1e-7, zones[0].begin2);
    ASSERT_TRUE(a.found && b.found);
    EXPECT_NEAR(a.s2 - b.s2, 2e-7, 1e-8);
}

TEST(Facing, ExchangingThePartsGivesTheSamePairs) {
    const Part pin = disc({0.02, -0.03}, 10, 0.4), plate = plate_with_hole(20, {0, 0}, 10.05, 2);
    const Part base = block(-5, -1, 5, 0), foot = turned(rounded(-1, 0, 1, 2, 0.25), 0.02, {0, 0.01});
    for (const auto& [a, b] : {std::pair(pin, plate), std::pair(base, foot)}) {
        const auto there = find_facing_zones(a, b, 0.1), back = find_facing_zones(b, a, 0.1);
        ASSERT_EQ(there.size(), 1u);
        ASSERT_EQ(back.size(), 1u);
        EXPECT_NEAR(there[0].gap_min, back[0].gap_min, exact);
        EXPECT_NEAR(there[0].gap_max, back[0].gap_max, exact);
        for (const FacingPair& p : walk(a, b, there[0], 20)) {
            const FacingPair q = pair_from_first(b, a, back[0], p.s2, p.s1);
            ASSERT_TRUE(q.found);
            EXPECT_NEAR((q.on2.x - p.on1.x).norm(), 0, exact);
            EXPECT_NEAR(q.gap, p.gap, exact);
            EXPECT_NEAR((q.normal + p.normal).norm(), 0, exact);
        }
    }
}

TEST(Facing, RigidMotionChangesNothing) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> angle(-3, 3), shift(-20, 20);
    const Part base = block(-5, -1, 5, 0), foot = rounded(-1, 0.01, 1, 2, 0.25);
    const auto still = find_facing_zones(base, foot, 0.1);
    ASSERT_EQ(still.size(), 1u);
    for (int k = 0; k < 20; ++k) {
        const double a = angle(random);
        const Vec2 d(shift(random), shift(random));
        const auto moved = find_facing_zones(turned(base, a, d), turned(foot, a, d), 0.1);
        ASSERT_EQ(moved.size(), 1u);
        EXPECT_NEAR(moved[0].begin1, still[0].begin1, exact);
        EXPECT_NEAR(moved[0].end1, still[0].end1, exact);
        EXPECT_NEAR(moved[0].begin2, still[0].begin2, exact);
        EXPECT_NEAR(moved[0].gap_max, still[0].gap_max, exact);
    }
}

TEST(Facing, FarSidesDoNotFace) {
    // a sheet on a block: its upper side is within the distance too
    const auto sheet = find_facing_zones(block(0, 0, 2, 0.01), block(0, -1, 2, 0), 0.3);
    ASSERT_EQ(sheet.size(), 1u);
    EXPECT_EQ(sheet[0].chain1.edges, std::vector<int>{0});
    // a ring on a pin: its outer side is within the distance too
    Part ring = disc({0, 0}, 1.1);
    add_loop(ring, {Arc{{0, 0}, 1, 0, -2 * pi}});
    const auto zones = find_facing_zones(disc({0, 0}, 1), ring, 0.5);
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_EQ(zones[0].chain2.edges, std::vector<int>{1});
    // a pin inside a solid block faces nothing: its own material lies between its far side and the block's
    EXPECT_TRUE(find_facing_zones(disc({0, 0}, 1), block(-2, -2, 2, 2), 5).empty());
}

TEST(Facing, MaterialBetweenHidesWhatLiesBehind) {
    // a C whose upper arm covers [1, 3] of its lower one, with a block above both
    const Part c = polygon({{0, 0}, {3, 0}, {3, 0.5}, {3.5, 0.5}, {3.5, 1}, {1, 1}, {1, 0.8}, {3, 0.8}, {3, 0.7}, {0, 0.7}});
    const Part roof = block(0, 1.2, 3.5, 2);
    const auto zones = find_facing_zones(c, roof, 1);
    ASSERT_EQ(zones.size(), 2u);
    EXPECT_NEAR(zones[0].gap_min, 0.2, exact);
    EXPECT_NEAR(length_on_first({zones[0]}), 2.5, exact);
    EXPECT_NEAR(zones[1].gap_min, 0.5, exact);
    EXPECT_NEAR(length_on_first({zones[1]}), 1, 1e-6);
}

/// A block with a slot from above: straight sides, and a bottom that is flat or round.
Part slotted(double width, bool is_round) {
    Part part;
    const double left = 10, right = left + width, bottom = 5;
    std::vector<Curve> edges{Segment{{0, 0}, {20, 0}}, Segment{{20, 0}, {20, 20}}, Segment{{20, 20}, {right, 20}},
                             Segment{{right, 20}, {right, bottom}}};
    if (is_round)
        edges.push_back(Arc{{left + width / 2, bottom}, width / 2, 0, -pi});
    else
        edges.push_back(Segment{{right, bottom}, {left, bottom}});
    edges.insert(edges.end(), {Segment{{left, bottom}, {left, 20}}, Segment{{left, 20}, {0, 20}}, Segment{{0, 20}, {0, 0}}});
    add_loop(part, edges);
    return part;
}

TEST(OwnFacing, ASlotFacesItselfOnce) {
    for (const double angle : {0.0, 0.3}) {
        const Part flat = turned(slotted(0.5, false), angle, {1, 2}), round = turned(slotted(0.5, true), angle, {1, 2});
        const std::vector<FacingZone> zones = find_own_facing_zones(flat, 1);
        ASSERT_EQ(zones.size(), 1u);
        EXPECT_NEAR(length_on_first(zones), 15, exact);
        EXPECT_NEAR(zones[0].gap_min, 0.5, exact);
        for (const FacingPair& p : walk(flat, flat, zones[0], 20)) EXPECT_NEAR((p.on1.x - p.on2.x).norm(), 0.5, exact);
        ASSERT_EQ(find_own_facing_zones(round, 1).size(), 1u);
        // all points of a round bottom are partners of each other: of none
        EXPECT_NEAR(length_on_first(find_own_facing_zones(round, 1)), 15, exact);
        EXPECT_TRUE(find_own_facing_zones(flat, 0.4).empty());
    }
}

/// The far side of a wall is nearer than the other side of the slot beside it.
TEST(OwnFacing, WallsAndNotchesAndHolesDoNot) {
    Part walled;
    add_loop(walled, test::closed({{0, 0}, {10, 0}, {10, 9}, {6, 9}, {6, 2}, {4, 2}, {4, 9}, {3.8, 9}, {3.8, 2}, {0, 2}}));
    const std::vector<FacingZone> zones = find_own_facing_zones(walled, 3);
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_NEAR(zones[0].gap_min, 2, exact);
    EXPECT_TRUE(find_own_facing_zones(polygon({{0, 0}, {10, 0}, {10, 10}, {7, 10}, {5, 5}, {3, 10}, {0, 10}}), 5).empty());
    EXPECT_EQ(find_own_facing_zones(polygon({{0, 0}, {10, 0}, {10, 10}, {5.2, 10}, {5, 2}, {4.8, 10}, {0, 10}}), 5).size(), 1u);
    EXPECT_TRUE(find_own_facing_zones(plate_with_hole(10, {0, 0}, 2), 10).empty());
    EXPECT_TRUE(find_own_facing_zones(disc({0, 0}, 2), 10).empty());
}

TEST(Facing, NearerOfTwoPartners) {
    // a disc in a V groove of 90 degrees, nearer to the right wall: each point takes the nearer wall
    const Part groove = polygon({{0, 0}, {-3, 3}, {-3, -1}, {3, -1}, {3, 3}});
    const Part ball = disc({0.1, std::sqrt(2.0) + 0.15}, 1);
    const auto zones = find_facing_zones(ball, groove, 1.5);
    ASSERT_EQ(zones.size(), 2u);
    EXPECT_NEAR(zones[0].end1, zones[1].begin1, exact);
    const FacingPair left = pair_from_first(ball, groove, zones[0], zones[0].end1, zones[0].end2);
    const FacingPair right = pair_from_first(ball, groove, zones[1], zones[1].begin1, zones[1].begin2);
    EXPECT_NEAR(left.gap, right.gap, 1e-9);
    EXPECT_FALSE(zones[0].end_is_limit || zones[1].begin_is_limit);
}

TEST(Facing, GuessFarAwayStillConverges) {
    const Part base = block(-5, -1, 5, 0), foot = rounded(-1, 0.01, 1, 2, 0.25);
    const FacingZone zone = find_facing_zones(base, foot, 0.1).at(0);
    const FacingPair near = pair_from_first(base, foot, zone, 5, 0.5 * (zone.begin2 + zone.end2));
    for (const double guess : {zone.begin2, zone.end2, zone.begin2 + 0.3, zone.end2 - 0.3}) {
        const FacingPair far = pair_from_first(base, foot, zone, 5, guess);
        ASSERT_TRUE(far.found);
        EXPECT_NEAR((far.on2.x - near.on2.x).norm(), 0, exact);
    }
}

TEST(Facing, BeyondTheEndOfAnOpenChainNothingIsFound) {
    const Part base = block(0, 0, 2, 1), top = block(0.5, 1, 1.5, 2);
    const FacingZone zone = find_facing_zones(base, top, 0.1).at(0);
    EXPECT_FALSE(pair_from_first(base, top, zone, 0.4, 1).found);
    EXPECT_TRUE(pair_from_first(base, top, zone, 0.5 - 1e-12, 1).found);
}

TEST(Facing, RandomPosesAreConsistentAndSymmetric) {
    std::mt19937 random(11);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    int n_zones = 0;
    for (int k = 0; k < 300; ++k) {
        // in statements of their own: compilers differ in which argument of a call they compute first
        const double rounding = uniform(0.1, 0.9), angle = uniform(-3, 3), other = uniform(-3, 3), share = uniform(0, 1);
        const Vec2 place{uniform(-3, 3), uniform(-3, 3)};
        const Part a = turned(k % 2 ? rounded(-2, -1, 2, 1, rounding) : block(-2, -1, 2, 1), angle, {0, 0});
        const Part b = k % 3 == 0   ? disc(place, 0.2 + 1.8 * share, other)
                       : k % 3 == 1 ? plate_with_hole(5, 0.13 * place, 2 + share, other)
                                    : turned(rounded(-1, -1, 1, 1, 0.3), other, place);
        const double d = uniform(0.01, 1);
        expect_consistent(a, b, d);
        const auto there = find_facing_zones(a, b, d), back = find_facing_zones(b, a, d);
        ASSERT_EQ(there.size(), back.size()) << k;
        double second = 0;
        for (const FacingZone& zone : there) second += zone.begin2 - zone.end2;
        EXPECT_NEAR(length_on_first(back), second, 1e-9) << k;
        n_zones += static_cast<int>(there.size());
        if (::testing::Test::HasFailure()) FAIL() << "pose " << k;
    }
    EXPECT_GT(n_zones, 300);
}

/// A gear-like outline of n short edges, for the cost.
Part toothed(const Vec2& center, double radius, int n, bool hole) {
    std::vector<Vec2> points;
    for (int i = 0; i < n; ++i) {
        const double a = 2 * pi * (hole ? -i : i) / n, r = radius * (1 + 0.002 * std::sin(40 * a));
        points.push_back(center + r * Vec2(std::cos(a), std::sin(a)));
    }
    return polygon(points);
}

TEST(Facing, ManyShortEdges) {
    Part outer = block(-3, -3, 3, 3);
    const Part hole = toothed({0, 0}, 1.01, 5000, true);
    Loop loop;
    for (const Edge& edge : hole.edges) {
        loop.edges.push_back(static_cast<int>(outer.edges.size()));
        outer.edges.push_back(edge);
    }
    outer.loops.push_back(loop);
    const Part pin = toothed({0, 0}, 1, 5000, false);
    const auto start = std::chrono::steady_clock::now();
    const auto zones = find_facing_zones(pin, outer, 0.02);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    // every edge of the pin faces the hole; corners of both leave wedges of a share below the turn of a corner
    EXPECT_NEAR(length_on_first(zones) / perimeter(pin), 1, 0.02);
    EXPECT_LT(seconds, 20);  // 0.3 s optimised; quadratic behaviour takes minutes
}

/// A prism of 60 degrees stands on a wall: both of its faces are at the limit, wherever rounding has them.
TEST(Facing, FacesAtTheLimitCountHoweverTheyAreTurned) {
    const Part wall = block(-50, -10, 50, 0),
               prism = polygon(
                   {{0, 0}, {20 * std::sin(pi / 6), 20 * std::cos(pi / 6)}, {-20 * std::sin(pi / 6), 20 * std::cos(pi / 6)}});
    for (int degrees = 0; degrees < 90; ++degrees) {
        const double angle = degrees * pi / 180;
        EXPECT_EQ(find_facing_zones(turned(prism, angle, {0, 0}), turned(wall, angle, {0, 0}), 5).size(), 2U) << degrees;
    }
}

}  // namespace
}  // namespace abut::geometry::facing_test
