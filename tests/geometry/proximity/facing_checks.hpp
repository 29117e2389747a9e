// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for facing zones and their pairs, whatever the parts.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geometry/proximity/facing.hpp"

namespace abut::geometry::test {

inline Part turned(const Part& part, double angle, const Vec2& d) {
    return transformed(part, std::cos(angle), std::sin(angle), d);
}

/// Pairs of points found by following a zone from its beginning.
inline std::vector<FacingPair> walk(const Part& part1, const Part& part2, const FacingZone& zone, int n) {
    std::vector<FacingPair> pairs;
    double guess = zone.begin2;
    for (int i = 0; i <= n; ++i) {
        pairs.push_back(pair_from_first(part1, part2, zone, zone.begin1 + (zone.end1 - zone.begin1) * i / n, guess));
        guess = pairs.back().s2;
    }
    return pairs;
}

inline double length_on_first(const std::vector<FacingZone>& zones) {
    double sum = 0;
    for (const FacingZone& zone : zones) sum += zone.end1 - zone.begin1;
    return sum;
}

/// Bounds of the checks below: roundings of models of a given size and kind of curves.
struct FacingBounds {
    double exact;                 ///< of gaps, of the way back from the partner, a tenth of that of a zone's end
    double on_normal;             ///< of a pair's line against its normal, and of equal angles
    double difference;            ///< of finite differences against derivatives
    bool advances_within = true;  ///< do partners run backwards, and middles forward, all along a zone?
};

inline void expect_consistent_pair(const Part& part1, const Part& part2, double distance, const FacingZone& zone,
                                   const FacingPair& p, const FacingBounds& bounds) {
    ASSERT_TRUE(p.found) << "s1 = " << p.s1;
    EXPECT_NEAR(cross(p.on2.x - p.on1.x, p.normal), 0, bounds.on_normal);
    EXPECT_NEAR(p.normal.dot(p.on1.normal), -p.normal.dot(p.on2.normal), bounds.on_normal);
    EXPECT_LE(std::abs(p.gap), distance * (1 + 1e-9));
    EXPECT_GE(p.gap, zone.gap_min - bounds.exact);
    EXPECT_LE(p.gap, zone.gap_max + bounds.exact);
    const double inward = p.s1 + 0.01 * (0.5 * (zone.begin1 + zone.end1) - p.s1);
    const FacingPair back = pair_from_second(part1, part2, zone, p.s2, inward);
    ASSERT_TRUE(back.found);
    EXPECT_NEAR((back.on1.x - p.on1.x).norm(), 0, bounds.exact);
}

/// Every pair of every zone.
inline void expect_consistent(const Part& part1, const Part& part2, double distance, const FacingBounds& bounds) {
    for (const FacingZone& zone : find_facing_zones(part1, part2, distance)) {
        ASSERT_LT(zone.begin1, zone.end1);
        ASSERT_GT(zone.begin2, zone.end2);
        const std::vector<FacingPair> pairs = walk(part1, part2, zone, 60);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            expect_consistent_pair(part1, part2, distance, zone, pairs[i], bounds);
            if (::testing::Test::HasFatalFailure()) return;
            // at a joint the curvature may be that of the edge beyond the end
            if (!bounds.advances_within || i == 0 || i + 1 == pairs.size()) continue;
            EXPECT_LT(pairs[i].slope, 0);
            EXPECT_GT(pairs[i].length_rate, 0);
        }
        const double end2 = pairs.back().s2;
        const double off = zone.chain2.closed ? std::remainder(end2 - zone.end2, zone.chain2.length) : end2 - zone.end2;
        EXPECT_NEAR(off, 0, bounds.exact * 10);
    }
}

/// Finite differences against the analytic slope and stretch, inside one pair of edges.
inline void expect_derivatives(const Part& part1, const Part& part2, const FacingZone& zone, double s1, double guess,
                               const FacingBounds& bounds) {
    const double h = 1e-5;
    const FacingPair p = pair_from_first(part1, part2, zone, s1, guess);
    const FacingPair a = pair_from_first(part1, part2, zone, s1 - h, p.s2),
                     b = pair_from_first(part1, part2, zone, s1 + h, p.s2);
    ASSERT_TRUE(a.found && p.found && b.found);
    EXPECT_NEAR((b.s2 - a.s2) / (2 * h), p.slope, bounds.difference);
    const Vec2 dm = (b.on1.x + b.on2.x - a.on1.x - a.on2.x) / (4 * h);
    EXPECT_NEAR(std::abs(cross(p.normal, dm)), p.length_rate, bounds.difference);
    // curvature is the rate at which the normal turns along the tangent
    EXPECT_NEAR(((b.on1.normal - a.on1.normal) / (2 * h) - p.on1.curvature * p.on1.tangent).norm(), 0, bounds.difference);
}

}  // namespace abut::geometry::test
