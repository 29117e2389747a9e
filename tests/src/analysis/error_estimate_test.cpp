// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/error_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/src/analysis/synthetic_passes.hpp"

namespace abut::error_estimate_test {
namespace {

using synthetic::pass;
using synthetic::record;

ContactRecord scaled(int cells, double factor) {
    return record(cells, [=](double s) { return factor * (2 + std::sin(3 * s)); });
}

ErrorEstimate estimate(const std::vector<PassRecord>& passes) {
    return estimate_errors(passes, {});
}

}  // namespace

TEST(ErrorEstimate, OneSolutionHasNothingToCompareWith) {
    const ErrorEstimate e = estimate({pass({scaled(10, 1)})});
    ASSERT_EQ(e.contacts.size(), 1u);
    EXPECT_FALSE(e.contacts[0]);
    EXPECT_FALSE(e.contact_pressure || e.peak || e.energy || e.stress);
}

/// Of a step that was stuck nothing is recorded: the next pass, which had an answer, was compared with its contacts.
TEST(ErrorEstimate, ASolutionThatHadNoAnswerBeforeHasNothingToCompareWith) {
    const ErrorEstimate e = estimate({PassRecord{}, pass({scaled(20, 1)})});
    EXPECT_FALSE(e.contact_pressure);
    EXPECT_EQ(e.contacts.size(), 1U);
}

TEST(ErrorEstimate, GrowsWithTheChange) {
    const auto with_change = [](double change) { return estimate({pass({scaled(20, 1 - change)}), pass({scaled(20, 1)})}); };
    const ErrorEstimate small = with_change(0.01), large = with_change(0.02);
    ASSERT_TRUE(small.contact_pressure && large.contact_pressure && small.contacts[0] && large.contacts[0]);
    EXPECT_GT(*small.contact_pressure, 0.001);  // less than the change, and not nothing
    EXPECT_LT(*small.contact_pressure, 0.01);
    EXPECT_NEAR(*large.contact_pressure / *small.contact_pressure, 2, 0.1);
    EXPECT_NEAR(*large.peak / *small.peak, 2, 0.1);
    EXPECT_NEAR(large.contacts[0]->force / small.contacts[0]->force, 2, 0.1);
}

TEST(ErrorEstimate, BondsDoNotDecideWhatContactsAreKnownTo) {
    ContactRecord before = scaled(20, 0.9), now = scaled(20, 1);
    before.is_bond = now.is_bond = true;
    const ErrorEstimate alone = estimate({pass({before}), pass({now})});
    EXPECT_TRUE(alone.contacts[0]);
    EXPECT_FALSE(alone.contact_pressure || alone.peak);
    const ErrorEstimate contact = estimate({pass({scaled(20, 0.99)}), pass({scaled(20, 1)})}),
                        both = estimate({pass({before, scaled(20, 0.99)}), pass({now, scaled(20, 1)})});
    EXPECT_EQ(*both.contact_pressure, *contact.contact_pressure);
    EXPECT_EQ(*both.peak, *contact.peak);
    EXPECT_GT(both.contacts[0]->pressure, *both.contact_pressure);
}

TEST(ErrorEstimate, ErrorsOfFreeEndsCountFromOneSolution) {
    ContactRecord now = scaled(10, 1);
    now.stretches[0].at_end = {StretchEnd::Kind::free, 0.1, 0.03};
    const ErrorEstimate e = estimate({pass({now}), pass({now})});
    const double norm = change_of(now, now).norm;
    ASSERT_TRUE(e.contacts[0]);
    EXPECT_NEAR(e.contacts[0]->ends, 0.03 / norm, 1e-14);
    EXPECT_NEAR(*e.contact_pressure, 0.03 / norm, 1e-14);
    EXPECT_EQ(e.contacts[0]->inside, 0);
    EXPECT_GT(*e.peak, 0);  // an end that is off moves the peak, too
    now.stretches[0].at_begin = {StretchEnd::Kind::free, 0.1, 0.04};
    EXPECT_NEAR(*estimate({pass({now}), pass({now})}).contact_pressure, 0.05 / norm, 1e-14);
}

/// A solution 1 % above the theory, after one that has the same force and leans to one side.
TEST(ErrorEstimate, IsNoMoreThanTheDistanceFromTheory) {
    const PlaneStretch stretch{0.5, 0.6, {1}};
    const std::vector<std::optional<PlanePressure>> theory{PlanePressure{{0, 1}, {0, 1}, {stretch}, 0}};
    const auto leaning = [&](double by) {
        return record(40,
                      [=](double s) { return 1.01 * pressure_at(stretch, s) * (1 + by * std::sin(2 * std::numbers::pi * s)); });
    };
    const std::vector<PassRecord> passes{pass({leaning(0.8)}), pass({leaning(0)})};
    const double by_change = *estimate(passes).contact_pressure;
    EXPECT_GT(by_change, 0.05);
    const ErrorEstimate known = estimate_errors(passes, {}, theory);
    EXPECT_NEAR(*known.contact_pressure, 0.01 / 1.01, 1e-3);
    EXPECT_NEAR(*known.peak, 0.01 / 1.01, 1e-3);
    std::vector<std::optional<PlanePressure>> doubtful = theory;
    doubtful[0]->doubt = 0.02;
    EXPECT_NEAR(*estimate_errors(passes, {}, doubtful).contact_pressure, std::hypot(0.01 / 1.01, 0.02), 1e-3);
    // where theory is farther off than the change says, of another zone, or unknown, it says nothing
    const std::vector<std::optional<PlanePressure>> other{PlanePressure{{0, 1}, {0, 1}, {{0.5, 0.6, {2}}}, 0}};
    const std::vector<std::optional<PlanePressure>> elsewhere{PlanePressure{{0, 2}, {0, 2}, {stretch}, 0}};
    const std::vector<std::optional<PlanePressure>> unknown(1);
    for (const auto& none : {other, elsewhere, unknown})
        EXPECT_EQ(*estimate_errors(passes, {}, none).contact_pressure, by_change);
    const std::vector<PassRecord> same{pass({leaning(0)}), pass({leaning(0)})};
    EXPECT_EQ(*estimate_errors(same, {}, theory).contact_pressure, 0);
}

TEST(ErrorEstimate, OpenContactsHaveNone) {
    const ErrorEstimate e = estimate({pass({scaled(10, 0)}), pass({scaled(10, 0)})});
    EXPECT_FALSE(e.contacts[0]);
    EXPECT_FALSE(e.contact_pressure);
}

TEST(ErrorEstimate, WeakContactsCountLittle) {
    const ErrorEstimate e =
        estimate({pass({scaled(10, 1), scaled(10, 0.01)}), pass({scaled(10, 1), scaled(10, 0.02)})});  // the second doubled
    ASSERT_TRUE(e.contacts[0] && e.contacts[1]);
    EXPECT_EQ(e.contacts[0]->pressure, 0);
    EXPECT_GT(e.contacts[1]->pressure, 0.1);
    EXPECT_NEAR(e.contacts[1]->share, 0.02, 1e-12);
    EXPECT_NEAR(*e.contact_pressure, 0.02 * e.contacts[1]->pressure, 1e-12);
}

TEST(ErrorEstimate, PeaksAtCornersAreSaidAndLeftOut) {
    const auto rising = [](double factor) {
        ContactRecord r = record(20, [=](double s) { return factor / (s + 0.05); });
        r.stretches[0].at_begin = {StretchEnd::Kind::corner, 0.05, 0};
        return r;
    };
    const ErrorEstimate e = estimate({pass({rising(1)}), pass({rising(1.1)})});
    ASSERT_TRUE(e.contacts[0]);
    EXPECT_TRUE(e.contacts[0]->at_corner);
    EXPECT_GT(e.contacts[0]->peak, 0);
    EXPECT_EQ(*e.peak, 0);
    EXPECT_FALSE(estimate({pass({scaled(20, 1)}), pass({scaled(20, 1.1)})}).contacts[0]->at_corner);
}

/// A contact that is nowhere but beside a corner is known by its force, and counts by it.
TEST(ErrorEstimate, WhatLiesBesideACornerAsAWholeIsKnownByItsForce) {
    const auto at_corner = [](double factor) {
        ContactRecord r = record(20, [=](double) { return factor; });
        r.stretches[0].at_begin = {StretchEnd::Kind::corner, 1, 0};
        return r;
    };
    const ErrorEstimate alone = estimate({pass({at_corner(1)}), pass({at_corner(1.25)})});
    ASSERT_TRUE(alone.contacts[0]);
    EXPECT_TRUE(alone.contacts[0]->at_corner);
    EXPECT_NEAR(alone.contacts[0]->force, 0.33 * 0.2, 1e-3);
    EXPECT_FALSE(alone.contact_pressure);  // nothing is known of it but that
    const ContactRecord even = record(20, [](double) { return 1; });
    const ErrorEstimate beside = estimate({pass({at_corner(0.01), even}), pass({at_corner(0.0125), even})});
    EXPECT_NEAR(beside.contacts[0]->share, 0.0125, 1e-12);
    EXPECT_EQ(*beside.contact_pressure, 0);
}

/// A solution on the same cells changes nothing, and tells nothing.
TEST(ErrorEstimate, OnTheSameCellsTheEstimateBeforeStands) {
    const std::vector<PassRecord> first{pass({scaled(10, 0.98)}), pass({scaled(20, 1)})};
    const ErrorEstimate before = estimate(first);
    const ErrorEstimate same = estimate_errors(std::vector<PassRecord>{first[1], first[1]}, before);
    EXPECT_DOUBLE_EQ(*same.contact_pressure, *before.contact_pressure);
    EXPECT_DOUBLE_EQ(*same.peak, *before.peak);
    const ErrorEstimate finer = estimate_errors(std::vector<PassRecord>{first[1], pass({scaled(40, 1)})}, before);
    EXPECT_LT(*finer.contact_pressure, 0.5 * *before.contact_pressure);
}

TEST(ErrorEstimate, BesideCornersASmallChangeMayBeByChance) {
    ContactRecord now = scaled(40, 1);
    ErrorEstimate before;
    before.contacts = {ContactError{}};
    before.contacts[0]->inside = before.contacts[0]->kept = 0.1;
    EXPECT_EQ(*estimate_errors(std::vector<PassRecord>{pass({now}), pass({now})}, {}).contact_pressure, 0);
    const PassRecord coarser = pass({scaled(20, 1)});
    EXPECT_LT(*estimate_errors(std::vector<PassRecord>{coarser, pass({now})}, before).contact_pressure, 0.01);
    now.stretches[0].at_begin = {StretchEnd::Kind::corner, 0.05, 0};
    EXPECT_GT(*estimate_errors(std::vector<PassRecord>{coarser, pass({now})}, before).contact_pressure, 0.01);
}

/// A spike beside a free end is as high as that end is near: where the end moved by its width, another of the same height does
/// not confirm it.
TEST(ErrorEstimate, APeakBesideAnEndThatMovedIsNotKnown) {
    const auto spike = [](double middle) {
        ContactRecord r = record(200, [=](double s) { return 1 + 9 * std::exp(-std::pow((s - middle) / 0.01, 2)); });
        r.stretches[0].at_begin = {StretchEnd::Kind::free, 0.1, 0};
        return r;
    };
    EXPECT_LT(*estimate({pass({spike(0.05)}), pass({spike(0.05)})}).peak, 1e-9);
    const ErrorEstimate moved = estimate({pass({spike(0.05)}), pass({spike(0.03)})});
    EXPECT_GT(*moved.peak, 0.5);
    EXPECT_LT(moved.contacts[0]->peak_inside, 0.01);
}

}  // namespace abut::error_estimate_test
