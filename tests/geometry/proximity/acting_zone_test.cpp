// SPDX-License-Identifier: GPL-3.0-or-later
// The lines that contact forces act on: what a body's own shape lets slide does no work.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/geometry/cells/random_grids.hpp"
#include "tests/geometry/proximity/facing_checks.hpp"

namespace abut::geometry::acting_zone_test {
namespace {

constexpr double exact = 1e-11;

Part polygon(const std::vector<Vec2>& p) {
    Part part;
    test::add_loop(part, test::closed(p));
    return part;
}

Part block(double x0, double y0, double x1, double y1) {
    return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

Part disc(const Vec2& center, double radius) {
    Part part;
    test::add_loop(part, {Arc{center, radius, 0.3, 2 * std::numbers::pi}});
    return part;
}

/// A bar with a half circle below; its flat part joins the arcs of small fillets.
Part filleted(double half, double r) {
    constexpr double quarter = 0.5 * std::numbers::pi;
    Part part;
    test::add_loop(part, {Segment{{-half, 0}, {half, 0}}, Arc{{half, r}, r, -quarter, quarter},
                          Segment{{half + r, r}, {half + r, 3}}, Segment{{half + r, 3}, {-half - r, 3}},
                          Segment{{-half - r, 3}, {-half - r, r}}, Arc{{-half, r}, r, 2 * quarter, quarter}});
    return part;
}

std::vector<FacingZone> acting_zones(const Part& a, const Part& b, double distance) {
    std::vector<FacingZone> zones;
    for (const FacingZone& zone : find_facing_zones(a, b, distance)) zones.push_back(acting_zone(a, b, zone));
    return zones;
}

/// Largest deviation of the pairs' normals from a direction, and of their lines from it.
double deviation(const Part& a, const Part& b, const FacingZone& zone, const Vec2& direction) {
    double worst = 0;
    for (const FacingPair& p : test::walk(a, b, zone, 40)) {
        EXPECT_TRUE(p.found);
        worst = std::max({worst, (p.normal - direction).norm(), std::abs(cross(p.on2.x - p.on1.x, p.normal))});
    }
    return worst;
}

TEST(ActingZone, AFlatLendsItsNormalToWhateverIsCurved) {
    const Part base = block(-5, -1, 5, 0);
    for (const Part& other : {disc({0.3, 1.02}, 1), test::turned(filleted(0.5, 0.2), 0, {0.1, 0.01})}) {
        const std::vector<FacingZone> below = acting_zones(base, other, 0.1), above = acting_zones(other, base, 0.1);
        ASSERT_EQ(below.size(), 1u);
        ASSERT_EQ(above.size(), 1u);
        EXPECT_LT(deviation(base, other, below[0], {0, 1}), exact);
        EXPECT_LT(deviation(other, base, above[0], {0, -1}), exact);
    }
}

TEST(ActingZone, CirclesActAlongTheLineOfCentres) {
    // R1 n1 - R2 n2 is the way between the centres less that between the pair, which lies along it
    const Part small = disc({0, 0}, 1), large = disc({0.6, 2.8}, 2 - 0.15);
    const FacingZone zone = acting_zones(small, large, 0.4).at(0);
    EXPECT_LT(deviation(small, large, zone, Vec2(0.6, 2.8).normalized()), exact);
}

TEST(ActingZone, ACornerTakesTheNormalOfWhatItStandsOn) {
    const Part base = block(-5, -1, 5, 0), round = disc({0, -3}, 3);
    for (double tilt : {1e-7, 1e-3, 0.02, 0.3}) {
        const Part top = test::turned(block(0, 0, 2, 1), tilt, {0, 0});
        for (const FacingZone& zone : acting_zones(base, top, 0.1)) EXPECT_LT(deviation(base, top, zone, {0, 1}), exact);
        for (const FacingZone& zone : acting_zones(top, base, 0.1)) EXPECT_LT(deviation(top, base, zone, {0, -1}), exact);
        EXPECT_NEAR(acting_zones(top, base, 0.1).at(0).begin1, 0, exact);  // the corner itself is in the zone
        // the same on a round part: along its radius
        for (const FacingZone& zone : acting_zones(top, round, 0.1))
            for (const FacingPair& p : test::walk(top, round, zone, 20))
                EXPECT_LT((p.normal + (p.on2.x - Vec2(0, -3)).normalized()).norm(), 1e-9);
    }
}

/// A plate with a slot from -12 to 12, r wide on either side.
Part slotted(double r) {
    constexpr double half = std::numbers::pi;
    Part part = block(-30, -20, 30, 20);
    test::add_loop(part, {Segment{{-12, r}, {12, r}}, Arc{{12, 0}, r, 0.5 * half, -half}, Segment{{12, -r}, {-12, -r}},
                          Arc{{-12, 0}, r, -0.5 * half, -half}});
    return part;
}

/// At a slot's end forces on a pin pass through its centre, on the sides of the slot, too.
TEST(ActingZone, ARoundPartInAHollowLendsItsNormalBesideItToo) {
    const Part plate = slotted(8.05);
    for (const double angle : {0.5, 1.3, 1.55}) {
        const Vec2 center = Vec2(12, 0) + 0.05 * Vec2(std::cos(angle), std::sin(angle));
        const Part pin = disc(center, 8);
        int n_beside = 0;
        for (const FacingZone& zone : acting_zones(plate, pin, 0.5))
            for (const FacingPair& p : test::walk(plate, pin, zone, 200)) {
                EXPECT_LT(std::abs(cross(p.on2.x - center, p.normal)), 1e-9) << angle;
                n_beside += p.on1.x.x() < 12 && std::abs(p.on1.x.y()) > 8;
            }
        EXPECT_GT(n_beside, 3) << angle;
        for (const FacingZone& zone : acting_zones(pin, plate, 0.5))
            for (const FacingPair& p : test::walk(pin, plate, zone, 40))
                EXPECT_LT(std::abs(cross(p.on1.x - center, p.normal)), 1e-9) << angle;
    }
}

/// A pin that rests on the side of a slot may slide along it until it meets the end.
TEST(ActingZone, AFarHollowLendsNothing) {
    const Part plate = slotted(8.05);
    for (const double x : {0.0, 9.0, 11.0}) {
        const Part pin = disc({x, 0.05}, 8);
        int n_on_side = 0;
        for (const FacingZone& zone : acting_zones(plate, pin, 0.2))
            for (const FacingPair& p : test::walk(plate, pin, zone, 100)) {
                if (p.on1.x.x() > 12 - 1e-9 || p.on1.x.y() < 8) continue;
                EXPECT_LT((p.normal - Vec2(0, -1)).norm(), 1e-9) << x;
                ++n_on_side;
            }
        EXPECT_GT(n_on_side, 3) << x;
    }
}

TEST(ActingZone, ExchangingThePartsGivesTheSamePairs) {
    const Part a = test::turned(filleted(0.7, 0.15), 0.01, {0, 0.02}), b = disc({0.1, -2}, 1.98);
    const FacingZone there = acting_zones(a, b, 0.05).at(0), back = acting_zones(b, a, 0.05).at(0);
    for (const FacingPair& p : test::walk(a, b, there, 30)) {
        const FacingPair q = pair_from_first(b, a, back, p.s2, p.s1);
        ASSERT_TRUE(q.found);
        EXPECT_NEAR(q.gap, p.gap, 1e-10);
        EXPECT_LT((q.normal + p.normal).norm(), 1e-9);
    }
}

TEST(ActingZone, NoneIsInsideOut) {
    // wedges whose tips lie beyond the end of an arc: its normals may have no pair on the faces that its middle normals meet
    const auto direction = [](double angle) { return Vec2(std::cos(angle), std::sin(angle)); };
    constexpr double up = 0.5 * std::numbers::pi, half = 0.5, steep = 1.2;
    const Vec2 right = direction(up - half), left = direction(up + half), below(0, -0.5);
    Part dome;
    test::add_loop(dome, {Arc{{0, 0}, 1, up - half, 2 * half}, Segment{left, left + below},
                          Segment{left + below, right + below}, Segment{right + below, right}});
    int n_zones = 0;
    for (const double at : {0.5, 0.53, 0.56, 0.6})
        for (const double tilt : {-0.5, -0.3, -0.1, 0.0, 0.2, 0.4})
            for (const double gap : {0.05, 0.1, 0.15})
                for (const double side : {0.3, 1.0}) {
                    const Vec2 tip = (1 + gap) * direction(up + at);
                    const double axis = up + at + tilt;
                    const Part wedge = polygon({tip + side * direction(axis + steep), tip, tip + side * direction(axis - steep),
                                                tip + 3 * direction(axis)});
                    for (const auto& [a, b] : {std::pair<const Part*, const Part*>(&dome, &wedge), {&wedge, &dome}})
                        for (const FacingZone& zone : acting_zones(*a, *b, 0.25)) {
                            ++n_zones;
                            EXPECT_LT(zone.begin1, zone.end1) << at << " " << tilt << " " << gap << " " << side;
                            EXPECT_GT(zone.begin2, zone.end2) << at << " " << tilt << " " << gap << " " << side;
                        }
                }
    EXPECT_GT(n_zones, 100);
}

}  // namespace
}  // namespace abut::geometry::acting_zone_test
