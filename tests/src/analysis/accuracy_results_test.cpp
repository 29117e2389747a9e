// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/accuracy_results.hpp"

#include <gtest/gtest.h>

#include "tests/verification/scene_answers.hpp"

namespace abut::accuracy_results_test {
namespace {

/// Two passes with one contact: no estimate, then this one.
Outcome outcome(double pressure, double peak, PathEnd end) {
    Outcome out;
    out.target = 0.01;
    out.end = end;
    out.passes = {{{ContactRecord{}}, 1, 1000, 10, 0.1}, {{ContactRecord{}}, 1, 2000, 20, 0.3}};
    ErrorEstimate error;
    error.contacts = {ContactError{pressure, pressure, 0, 0, peak, 0.001, 0, 1, 1}};
    error.contact_pressure = pressure;
    error.peak = peak;
    error.energy = 4e-4;
    error.stress = 0.02;
    out.errors = {ErrorEstimate{{std::nullopt}, {}, {}, {}, {}, {}}, error};
    return out;
}

Result filled(const Outcome& out, const std::vector<double>& of_pairs = {}) {
    Result result;
    result.contacts.emplace_back();
    result.contacts[0].max_pressure.value = 100;
    result.contacts[0].parts = {"plate", "pin"};
    fill_errors(out, {of_pairs, {}}, result);
    return result;
}

Result solved_in(double first_error, double last_error, double seconds) {
    Result result;
    result.accuracy.target = 0.01;
    result.accuracy.estimate = last_error;
    result.error_estimate.contact_pressure = last_error;
    result.passes = {
        {1000, 0, 0.1 * seconds, std::nullopt}, {2000, 0, 0.4 * seconds, first_error}, {4000, 0, seconds, last_error}};
    return result;
}

}  // namespace

TEST(AccuracyResults, ForcesErrLikeTheEnergyAndNoLessThanTheirChangeSays) {
    Outcome out = outcome(0.008, 0.002, PathEnd::reached);  // 0.001 by the change
    for (const auto& [energy, force] : {std::pair(4e-4, 0.001), std::pair(0.003, 0.0015), std::pair(3.0, 1.0)}) {
        out.errors.back().energy = energy;
        EXPECT_DOUBLE_EQ(filled(out).contacts[0].errors->force, force);
    }
}

TEST(AccuracyResults, WhatHardlyMissesTheTargetIsToldFromIt) {
    const Result result = filled(outcome(0.010004, 0.002, PathEnd::out_of_passes));
    ASSERT_FALSE(result.reasons.empty());
    EXPECT_NE(result.reasons[0].text.find("known to 1.0004 %, not to 1 %"), std::string::npos) << result.reasons[0].text;
}

TEST(AccuracyResults, ReachedTargetsWarnOfNothing) {
    const Result result = filled(outcome(0.008, 0.002, PathEnd::reached));
    EXPECT_TRUE(result.warnings.empty());
    EXPECT_TRUE(result.reasons.empty());
    EXPECT_TRUE(result.accuracy.reached);
    EXPECT_EQ(result.accuracy.of, "contact pressure");
    EXPECT_EQ(result.accuracy.target, 0.01);
    EXPECT_EQ(result.accuracy.estimate, 0.008);
    EXPECT_EQ(result.accuracy.why, "");
    ASSERT_TRUE(result.contacts[0].errors);
    EXPECT_EQ(result.contacts[0].errors->pressure, 0.008);
    EXPECT_EQ(result.contacts[0].errors->peak, 0.002);
    EXPECT_EQ(result.contacts[0].errors->force, 0.001);
    EXPECT_EQ(result.error_estimate.stress, 0.02);
    ASSERT_EQ(result.passes.size(), 2u);
    EXPECT_FALSE(result.passes[0].estimated_error);
    EXPECT_EQ(result.passes[1].estimated_error, 0.008);
    EXPECT_EQ(result.passes[1].unknowns, 2000);
}

TEST(AccuracyResults, ThePeakCountsWhereItIsWorse) {
    const Result result = filled(outcome(0.008, 0.03, PathEnd::out_of_cells));
    EXPECT_EQ(result.accuracy.estimate, 0.03);
    EXPECT_FALSE(result.accuracy.reached);
}

TEST(AccuracyResults, MissedTargetsSayWhy) {
    for (const auto& [end, words] : {std::pair{PathEnd::out_of_cells, "as many cells"},
                                     {PathEnd::out_of_passes, "do not bring it down"},
                                     {PathEnd::out_of_digits, "rounding"},
                                     {PathEnd::out_of_budget, "of about 12000 unknowns, in 3.1 s and 0.036 GB"},
                                     {PathEnd::finer_failed, "gave no answer: a basis"},
                                     {PathEnd::fixed_grids, "adapt"}}) {
        Outcome out = outcome(0.03, 0.002, end);
        if (end == PathEnd::out_of_budget) out.next = PassCost{12000, 3.1, 36e6};
        if (end == PathEnd::finer_failed) out.why = "gave no answer: a basis";
        const Result result = filled(out);
        EXPECT_FALSE(result.accuracy.reached);
        EXPECT_NE(result.accuracy.why.find(words), std::string::npos) << result.accuracy.why;
        EXPECT_TRUE(test::warns(result.warnings, "above the 1 % aimed at"));
        ASSERT_EQ(result.reasons.size(), 1u);
        EXPECT_EQ(result.reasons[0].kind, "accuracy");
        EXPECT_EQ(result.reasons[0].text, "contact pressures known to 3 %, not to 1 %");
    }
}

TEST(AccuracyResults, PairsOfWherePartsWereDrawnCount) {
    const Result well = filled(outcome(0.003, 0.002, PathEnd::reached), {0.004}),
                 off = filled(outcome(0.003, 0.002, PathEnd::reached), {0.02});
    EXPECT_TRUE(well.accuracy.reached);
    EXPECT_FALSE(off.accuracy.reached);
    EXPECT_NEAR(off.contacts[0].errors->peak, 0.02, 2e-4);
    EXPECT_NEAR(off.contacts[0].errors->pressure, 0.04, 2e-4);
    ASSERT_EQ(off.reasons.size(), 1u);
    EXPECT_EQ(off.reasons[0].kind, "accuracy");
    EXPECT_TRUE(test::warns(
        off.warnings, "contact 1 is paired where its parts are drawn, and they move away from there; draw plate and pin"));
    Outcome single = outcome(0.003, 0.002, PathEnd::no_need);  // of one solution, which has no estimate
    single.errors.back() = single.errors.front();
    const Result told = filled(single, {0.02});
    ASSERT_EQ(told.reasons.size(), 1u);
    EXPECT_EQ(told.reasons[0].text, "the largest pressure of contact 1 known to 2 %");
    EXPECT_TRUE(filled(single, {0.004}).reasons.empty());
}

TEST(AccuracyResults, PeaksAtCornersDoNotCountWhereverPartsWereDrawn) {
    Outcome corner = outcome(0.003, 0, PathEnd::reached);
    corner.errors.back().contacts[0]->at_corner = true;
    corner.errors.back().contacts[0]->peak = 0.2;
    const Result result = filled(corner, {0.001});
    EXPECT_TRUE(result.accuracy.reached);
    EXPECT_LT(*result.accuracy.estimate, 0.004);
}

/// A face of contact along y = x, under a pressure of 100 that errs by 1 %, which the stress of 120 beside it lacks 4 of.
TEST(AccuracyResults, StressesUnderContactErrByWhatTheyMissOfItsPressure) {
    const auto error_at = [](const Vec2& at, double own, double thickness = 1) {
        Outcome out = outcome(0.005, 0.01, PathEnd::reached);
        Result result = filled(out);
        out.solved.contacts.resize(1);
        out.solved.contacts[0].face.thickness = 1;
        out.solved.grids.resize(1);
        out.solved.grids[0].part = 0;
        out.solved.grids[0].input.thickness = thickness;
        out.largest.resize(1);
        out.largest[0].cell = 0.1;
        out.largest[0].stress = {-60, -76, 28, 0};  // across the face (-60 - 76) / 2 - 28 = -96
        result.parts.resize(1);
        result.parts[0].name = "plate";
        result.parts[0].max_von_mises = {120, at};
        result.parts[0].max_von_mises_error = own;
        ContactProfile& profile = result.contacts[0].profile;
        profile.x = profile.y = profile.x2 = profile.y2 = {0, 1, 2};
        profile.pressure = {100, 100, 0};
        fill_stress_errors(out, result);
        return *result.parts[0].max_von_mises_error;
    };
    EXPECT_NEAR(error_at({0.5, 0.5}, 1e-4), (4 + 0.01 * 100) / 120, 1e-4);
    EXPECT_NEAR(error_at({0.5, 0.5}, 1e-4, 2), (46 + 0.01 * 50) / 120, 1e-4) << "a part of twice the contact's thickness";
    EXPECT_EQ(error_at({0.5, 0.5}, 0.3), 0.3);
    EXPECT_EQ(error_at({0.5, 0.6}, 1e-4), 1e-4) << "away from the face";
}

TEST(AccuracyResults, DisplacementsOfAHeldPartErrByItsContactsAsFarAsTheyCarry) {
    const auto error_beside = [](double share) {
        Outcome out = outcome(0.008, 0.002, PathEnd::reached);
        ErrorEstimate& error = out.errors.back();
        error.own_energy = {1e-4};
        error.contacts.resize(2, error.contacts[0]);
        error.contacts[1]->share = share;
        Result result = filled(out);
        result.contacts.push_back(result.contacts[0]);
        result.contacts[0].errors = ContactErrors{0.008, 0.002, 0.003, 0.001, false};
        result.contacts[1].errors = ContactErrors{1, 1, 1, 1, false};  // nothing is known of it
        out.solved.grids.resize(1);
        out.solved.grids[0].part = 0;
        out.solved.problem.parts.resize(1);  // which moves freely in no way
        out.largest.resize(1);
        result.parts.resize(1);
        result.parts[0].name = "plate";
        result.parts[0].max_displacement.value = 1;
        fill_displacement_errors(out, result);
        return result.parts[0].max_displacement_error.value();
    };
    EXPECT_EQ(error_beside(1), 1);
    EXPECT_DOUBLE_EQ(error_beside(0.01), 0.01);
    EXPECT_DOUBLE_EQ(error_beside(1e-6), 0.003);
}

TEST(AccuracyResults, DoubtfulPeaksAreWarnedAbout) {
    EXPECT_TRUE(test::warns(filled(outcome(0.005, 0.2, PathEnd::out_of_passes)).warnings, "uncertain by 20 %"));
    Outcome corner = outcome(0.005, 0, PathEnd::reached);
    corner.errors.back().contacts[0]->at_corner = true;
    corner.errors.back().contacts[0]->peak = 0.2;
    EXPECT_TRUE(test::warns(filled(corner).warnings, "sharp corner"));
    EXPECT_FALSE(test::warns(filled(corner).warnings, "uncertain"));
    ASSERT_EQ(filled(corner).reasons.size(), 1u);
    EXPECT_EQ(filled(corner).reasons[0].kind, "corner");
}

TEST(AccuracyResults, ManyPeaksAtCornersAreOneWarningThatNamesTheLargest) {
    Outcome out = outcome(0.005, 0.2, PathEnd::reached);
    std::vector<std::optional<ContactError>>& errors = out.errors.back().contacts;
    errors[0]->at_corner = true;
    errors.resize(3, errors[0]);
    Result result;
    for (const double pressure : {100, 300, 200}) result.contacts.emplace_back().max_pressure.value = pressure;
    fill_errors(out, {}, result);
    ASSERT_EQ(result.warnings.size(), 1u);
    EXPECT_EQ(result.warnings[0].find("the largest pressure of contact 2 stands at a sharp corner"), 0u);
    EXPECT_NE(result.warnings[0].find("the same of 2 others: contact 3, contact 1"), std::string::npos) << result.warnings[0];
    EXPECT_EQ(result.reasons.size(), 1u);
}

TEST(AccuracyResults, DoubtfulPeaksAreReasonsWhereNothingWasAimedAt) {
    const Result result = filled(outcome(0.005, 0.2, PathEnd::no_need));
    ASSERT_EQ(result.reasons.size(), 1u);
    EXPECT_EQ(result.reasons[0].text, "the largest pressure of contact 1 known to 20 %");
}

TEST(AccuracyResults, PeaksOfContactsThatCarryNextToNothingAreNoReasons) {
    for (const bool at_corner : {false, true}) {
        Outcome out = outcome(0.005, 0.2, PathEnd::reached);
        out.errors.back().contacts[0]->at_corner = at_corner;
        EXPECT_EQ(filled(out).reasons.size(), 1u);
        out.errors.back().contacts[0]->share_of_peak = 0.009;  // of the largest pressure, less than the target
        EXPECT_TRUE(filled(out).reasons.empty());
        EXPECT_EQ(filled(out).warnings.size(), 1u);
    }
}

TEST(AccuracyResults, WithoutContactItIsOfStress) {
    Outcome out = outcome(0, 0, PathEnd::no_need);
    out.errors.back().contacts = {};
    out.errors.back().contact_pressure.reset();
    out.errors.back().peak.reset();
    const Result result = filled(out);
    EXPECT_EQ(result.accuracy.of, "stress in the energy norm");
    EXPECT_EQ(result.accuracy.estimate, 0.02);
    EXPECT_FALSE(result.contacts[0].errors);
}

TEST(NextLevel, IsTheNextFinerOne) {
    const auto next_of = [](double target) {
        Result result = solved_in(0.02, 0.008, 1);
        result.accuracy.target = target;
        predict_next_level(result);
        return result.next_level;
    };
    ASSERT_TRUE(next_of(0.05) && next_of(0.03) && next_of(0.01) && next_of(0.002));
    EXPECT_EQ(next_of(0.05)->accuracy, "standard");
    EXPECT_EQ(next_of(0.03)->accuracy, "standard");
    EXPECT_EQ(next_of(0.01)->accuracy, "fine");
    EXPECT_EQ(next_of(0.002)->accuracy, "0.0004");
    EXPECT_DOUBLE_EQ(next_of(0.002)->target, 0.0004);
}

TEST(NextLevel, CostsMoreThanThisOneAndGrowsWithIt) {
    for (double seconds : {0.01, 1.0, 100.0}) {
        Result result = solved_in(0.03, 0.008, seconds);
        predict_next_level(result);
        ASSERT_TRUE(result.next_level);
        EXPECT_GT(result.next_level->seconds, seconds);
        EXPECT_LT(result.next_level->seconds, 50 * seconds);
        Result slower = solved_in(0.03, 0.008, 2 * seconds);
        predict_next_level(slower);
        EXPECT_NEAR(slower.next_level->seconds, 2 * result.next_level->seconds, 1e-12 * seconds);
        Result worse = solved_in(0.03, 0.02, seconds);
        predict_next_level(worse);
        EXPECT_GT(worse.next_level->seconds, result.next_level->seconds);
    }
}

TEST(NextLevel, NothingToGoByIsNoPrediction) {
    Result none;
    predict_next_level(none);
    EXPECT_FALSE(none.next_level);
    Result exact = solved_in(0.02, 0, 1);
    predict_next_level(exact);
    EXPECT_FALSE(exact.next_level);
    Result missed = solved_in(0.03, 0.02, 1);
    missed.accuracy.why = "too many cells";
    predict_next_level(missed);
    EXPECT_FALSE(missed.next_level);
}

/// A fit that presses all round has a resultant of rounding, which may err by any times itself.
TEST(AccuracyResults, ABalancedResultantIsNoErrorOfThePressure) {
    Outcome out = outcome(0.003, 0.003, PathEnd::reached);
    out.errors.back().contacts[0]->force = 14;
    EXPECT_GE(filled(out).contacts[0].errors->pressure, 14);
    out.errors.back().contacts[0]->of_integral = 1e-8;
    const ContactErrors balanced = *filled(out).contacts[0].errors;
    EXPECT_EQ(balanced.pressure, 0.003);
    EXPECT_EQ(balanced.peak, 0.003);
    EXPECT_GE(balanced.force, 14);
    EXPECT_LT(balanced.length, 0.01);
}

}  // namespace abut::accuracy_results_test
