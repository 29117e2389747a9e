// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/pass_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/src/analysis/synthetic_passes.hpp"

namespace abut::pass_record_test {
namespace {

using synthetic::record;

double smooth(double s) {
    return 2 + std::sin(3 * s);
}

/// Linear functions are their Greville values on every grid.
double slope(double s) {
    return 1 + s;
}

/// Zero at both ends with its slope: periodic over the unit length.
double bump(double s) {
    const double x = std::sin(std::numbers::pi * (s - std::floor(s)));
    return x * x;
}

}  // namespace

TEST(PassRecord, TheSameSolutionDidNotChange) {
    const ContactRecord r = record(20, smooth);
    const PressureChange c = change_of(r, r);
    EXPECT_EQ(c.difference, 0);
    EXPECT_EQ(c.inside, 0);
    EXPECT_EQ(c.peak, c.peak_before);
    EXPECT_EQ(c.force, c.force_before);
    EXPECT_NEAR(c.refinement, 1, 1e-14);
}

TEST(PassRecord, NormPeakAndForceOfALine) {
    ContactRecord r = record(7, slope);
    r.thickness = 3;
    const PressureChange c = change_of(r, r);
    EXPECT_NEAR(c.norm, std::sqrt(7.0 / 3), 1e-13);
    EXPECT_NEAR(c.force, 4.5, 1e-13);
    EXPECT_NEAR(c.peak, 2, 0.02);  // at the last point of the rule
}

TEST(PassRecord, AScaledPressureChangesByTheScale) {
    const ContactRecord now = record(20, smooth), before = record(20, [](double s) { return 0.9 * smooth(s); });
    const PressureChange c = change_of(now, before);
    EXPECT_NEAR(c.difference / c.norm, 0.1, 1e-13);
    EXPECT_NEAR(c.peak_before / c.peak, 0.9, 1e-13);
    EXPECT_NEAR(c.force_before / c.force, 0.9, 1e-13);
}

/// A contact over part of the zone, with a free end at `end`.
ContactRecord ending_at(double end, int cells) {
    ContactRecord r = record(cells, smooth);
    r.stretches = {{0, end, true, false, {}, {StretchEnd::Kind::free, 0, 0}}};
    return r;
}

TEST(PassRecord, FreeEndsHaveLeftToGoWhatTheirKnotsTell) {
    // knots a quarter as far apart: the end was off by eight times as much, and moved by seven eighths of that
    EXPECT_NEAR(change_of(ending_at(0.5, 40), ending_at(0.53, 10)).ends_left, 0.03 / 7 / 0.5, 1e-12);
    // no closer: about twice what it moved
    EXPECT_NEAR(change_of(ending_at(0.5, 40), ending_at(0.53, 40)).ends_left, 2 * 0.03 / 0.5, 0.2 * 0.03 / 0.5);
    EXPECT_EQ(change_of(ending_at(0.5, 40), ending_at(0.5, 10)).ends_left, 0);
    EXPECT_EQ(change_of(record(40, smooth), ending_at(0.5, 10)).ends_left, 0) << "no free end";
}

TEST(PassRecord, DisplacementsChangeByTheLargestAlongTheEdges) {
    PassRecord now = synthetic::pass({}), before = now;
    now.moved = {{{0, 0}, {1, 1}}, {{2, 0}}};
    before.moved = {{{0, 0}, {1, 1}}, {{2, 0.5}}};
    EXPECT_EQ(change_of_displacement(now, before, 0), 0);
    EXPECT_EQ(change_of_displacement(now, before, 1), 0.5);
}

TEST(PassRecord, OtherKnotsOfTheSameFunctionAreNoChange) {
    const PressureChange c = change_of(record(22, slope), record(11, slope));
    EXPECT_LT(c.difference, 1e-13);
    EXPECT_NEAR(c.force, c.force_before, 1e-13);
    EXPECT_NEAR(c.refinement, 0.5, 1e-13);
}

/// Whatever the knots, forces are the splines' own: statics shows no change.
TEST(PassRecord, ForcesAreIntegralsOfEitherSpline) {
    const ContactRecord coarse = record(5, slope), fine = record(64, slope);
    ContactRecord kinked = fine;
    kinked.coefficients[30] += 1;  // between the points of the coarse solution's rule
    const double area = 1.0 / 64;
    EXPECT_NEAR(change_of(coarse, kinked).force_before, 1.5 + area, 1e-13);
    EXPECT_NEAR(change_of(kinked, coarse).force, 1.5 + area, 1e-13);
}

/// A ring pressed all round: its resultant is rounding, which says nothing of its pressure.
TEST(PassRecord, ForcesChangeByTheIntegralWhereResultantsAreRounding) {
    ContactRecord now = record(20, smooth), before = record(20, [](double s) { return 0.9 * smooth(s); });
    now.resultant = Vec2(1e-15, 0);
    before.resultant = Vec2(-3e-15, 0);
    EXPECT_NEAR(change_of(now, before).force_change, 0.1, 1e-13);
    now.resultant = Vec2(2, 0);
    before.resultant = Vec2(1, 0);
    EXPECT_NEAR(change_of(now, before).force_change, 0.5, 1e-13);
}

TEST(PassRecord, PlacesAreComparedAlongTheFirstChain) {
    ContactRecord before = record(20, smooth);
    before.s = {0, 1};
    ContactRecord now = before;
    now.s1 = {0, 1};
    before.s1 = {-0.5, 0.5};  // the same spline half a length farther: other places
    EXPECT_GT(change_of(now, before).difference, 0.1);
}

TEST(PassRecord, AClosedZoneMayBeginElsewhere) {
    const ContactRecord now = record(40, bump);
    ContactRecord before = record(40, [](double s) { return bump(s + 0.25); });
    before.s1 = {0.25, 1.25};
    EXPECT_LT(change_of(now, before).difference, 1e-3 * change_of(now, now).norm);
    before.s1 = {0, 1};
    EXPECT_GT(change_of(now, before).difference, 0.3 * change_of(now, now).norm);
}

TEST(PassRecord, NeighbourhoodsOfCornersAndFreeEndsAreLeftOut) {
    const ContactRecord before = record(50, smooth);
    ContactRecord now = before;
    now.coefficients[0] += 1;  // lives on [0, 0.02]
    EXPECT_GT(change_of(now, before).difference, 0.01);
    now.stretches[0].at_begin = {StretchEnd::Kind::corner, 0.03, 0};
    EXPECT_EQ(change_of(now, before).difference, 0);
    EXPECT_LT(change_of(now, before).norm, change_of(before, before).norm);
    now.stretches[0].at_begin = {StretchEnd::Kind::free, 0.03, 0};
    EXPECT_GT(change_of(now, before).difference, 0.01);
    EXPECT_EQ(change_of(now, before).inside, 0);
}

TEST(PassRecord, AContactWithoutInterfaceDidNotChange) {
    EXPECT_EQ(change_of(record(5, slope), ContactRecord{}).norm, 0);
    EXPECT_EQ(change_of(ContactRecord{}, record(5, slope)).norm, 0);
}

}  // namespace abut::pass_record_test
