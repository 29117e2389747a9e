// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/study_prices.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "src/io/number_text.hpp"
#include "src/study/study_chart.hpp"
#include "src/study/study_plan.hpp"
#include "tests/src/study/synthetic_study.hpp"

namespace abut::study_prices_test {
namespace {

using Kind = StudySetting::Kind;

std::vector<StudyRun> runs_of_family(const Study& study, const std::string& name) {
    for (const StudyFamily& f : families_of(study)) {
        if (f.name != name) continue;
        std::vector<StudyRun> runs;
        for (std::size_t i : f.runs) runs.push_back(study.runs[i]);
        return runs;
    }
    return {};
}

TEST(StudyPrices, HalvingCostsTwoToThePowerOfTheLawsExponents) {
    for (double growth : {1.0, 1.25, 2.0}) {
        const Study study = synthetic::study(growth);
        const std::vector<PriceOfHalving> prices = prices_of_halving(study, 0);
        ASSERT_EQ(prices.size(), 3U);  // levels, degrees 1 and 2
        for (const PriceOfHalving& p : prices) EXPECT_NEAR(p.factor, std::exp2(growth), 1e-9) << p.family;
        for (const StudyFamily& f : families_of(study)) EXPECT_NEAR(*time_exponent(study, f), growth, 1e-9) << f.name;
    }
}

TEST(StudyPrices, NoPriceWhereTheErrorDoesNotFall) {
    Study study = synthetic::study(1);
    for (StudyRun& run : study.runs) run.error[0] = 0.01;
    EXPECT_TRUE(prices_of_halving(study, 0).empty());
    EXPECT_EQ(prices_of_halving(study, 1).size(), 3U);
}

TEST(StudyPrices, FamiliesHoldWhatWasSolvedInOrderOfUnknowns) {
    Study study = synthetic::study(1);
    std::reverse(study.runs.begin(), study.runs.end());
    EXPECT_EQ(families_of(study).size(), 3U);
    for (const char* name : {"levels", "degree 1", "degree 2"}) {
        const std::vector<StudyRun> runs = runs_of_family(study, name);
        ASSERT_GE(runs.size(), 3U) << name;
        EXPECT_TRUE(std::is_sorted(runs.begin(), runs.end(), [](auto& a, auto& b) { return a.unknowns < b.unknowns; })) << name;
    }
}

/// An error that passes through zero on the way must not make a coarse grid look good.
TEST(StudyPrices, LuckyErrorsAreNotKept) {
    Study study = synthetic::study(1);
    const auto lucky = std::find_if(study.runs.begin(), study.runs.end(),
                                    [](const StudyRun& r) { return r.setting.kind == Kind::graded && r.setting.degree == 2; });
    lucky->error[0] = 1e-9;
    const auto i = static_cast<std::size_t>(lucky - study.runs.begin());
    EXPECT_DOUBLE_EQ(kept_errors(study, 0)[i], study.runs[i + 1].error[0]);
    EXPECT_TRUE(std::isnan(kept_errors(study, 0)[study.runs.size() - 1]));
    for (const CheapestSetting& c : cheapest_settings(study, 0))
        if (c.error < study.runs[i + 1].error[0]) { EXPECT_NE(c.grid, i); }
}

/// By trying all runs.
TEST(StudyPrices, TheCheapestSettingIsTheCheapest) {
    const Study study = synthetic::study(1.3);
    const std::vector<double> kept = kept_errors(study, 0);
    const std::vector<CheapestSetting> list = cheapest_settings(study, 0);
    ASSERT_GE(list.size(), 5U);
    EXPECT_DOUBLE_EQ(list.front().error, 0.2);
    for (const CheapestSetting& c : list)
        for (const bool level : {true, false}) {
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < study.runs.size(); ++i)
                if ((study.runs[i].setting.kind == Kind::level) == level && kept[i] <= c.error)
                    least = std::min(least, study.runs[i].solver_seconds);
            const std::optional<std::size_t>& chosen = level ? c.level : c.grid;
            ASSERT_EQ(chosen.has_value(), std::isfinite(least)) << c.error;
            if (chosen) { EXPECT_DOUBLE_EQ(study.runs[*chosen].solver_seconds, least) << c.error; }
        }
    EXPECT_FALSE(list.back().level);  // the levels end at 0.125 %, the grids at 0.031 %
    EXPECT_TRUE(list.back().grid);
}

TEST(StudyPrices, HeldQuantitiesAreNotWhatItIsAbout) {
    Study study = synthetic::study(1);
    EXPECT_EQ(main_measure(study), 0U);
    study.measures[0].held = true;
    EXPECT_EQ(main_measure(study), 1U);
    study.measures[1].held = true;
    EXPECT_FALSE(main_measure(study));
}

TEST(StudyPrices, TimesArePredictedFromTheNextCoarserOfTheFamily) {
    const Study study = synthetic::study(1.25);
    const StudySetting finer{Kind::graded, "", 2, "web", std::sqrt(2000.0 / 32000), 1};
    EXPECT_NEAR(*predicted_seconds(study.runs, finer), 2e-6 * std::pow(32000, 1.25), 1e-6);
    EXPECT_FALSE(predicted_seconds(study.runs, {Kind::graded, "", 2, "normalized", 0.1, 1}));
    EXPECT_FALSE(predicted_seconds(study.runs, {Kind::graded, "", 2, "web", 4, 1}));  // none is coarser
}

TEST(StudyPlan, HasAllDegreesSizesAndBasesFromCoarseToFine) {
    const std::vector<StudySetting> settings = grid_settings({}, {});
    for (const char* basis : {"web", "normalized"})
        for (int degree : {1, 2, 3, 4})
            for (double size : {4.0, 2.8, 2.0, 1.4, 1.0, 0.7, 0.5})
                EXPECT_EQ(std::count(settings.begin(), settings.end(), StudySetting{Kind::graded, "", degree, basis, size, 1}),
                          1);
    const auto by_dissertation = [](const StudySetting& s) { return s.basis == basis_of_dissertation; };
    EXPECT_EQ(std::count_if(settings.begin(), settings.end(), by_dissertation), 7);
    EXPECT_TRUE(std::is_sorted(settings.begin(), settings.end(), [](const auto& a, const auto& b) { return a.size > b.size; }));
    Scene given;
    given.accuracy.cell_size = 1;
    EXPECT_LT(reference_setting(given, {}).size, settings.back().size);
    EXPECT_EQ(reference_setting({}, {}).level, level_reference);
    // what the dissertation's method refuses is not tried; a scene of its own has nothing else
    Scene warm;
    warm.loads.emplace_back().kind = Load::Kind::temperature;
    for (const StudySetting& s : grid_settings(warm, {})) EXPECT_FALSE(by_dissertation(s));
    Scene own;
    own.accuracy.method = "dissertation";
    for (const StudySetting& s : grid_settings(own, {})) EXPECT_TRUE(by_dissertation(s));
    EXPECT_TRUE(by_dissertation(reference_setting(own, {})));
    EXPECT_EQ(level_settings(own).size(), 1U);
}

TEST(StudyChart, TicksLieWithinTheAxisAndAreNeitherManyNorFew) {
    for (double low : {1e-9, 0.0013, 0.8, 5.0, 12345.0})
        for (double factor : {2.0, 3.0, 7.0, 30.0, 200.0, 1e4, 1e8}) {
            const std::vector<double> ticks = report::log_ticks(low, low * factor);
            EXPECT_GE(ticks.size(), 1U) << low << " " << factor;
            EXPECT_LE(ticks.size(), 10U) << low << " " << factor;
            for (double t : ticks) EXPECT_TRUE(t >= low && t <= low * factor) << t;
        }
}

TEST(StudyWords, QuantitiesAreShort) {
    EXPECT_EQ(percent_text(0.0123), "1.2 %");
    EXPECT_EQ(percent_text(2e-5), "0.002 %");
    EXPECT_EQ(duration_text(0.00081), "0.81 ms");
    EXPECT_EQ(duration_text(0.0444), "44 ms");
    EXPECT_EQ(duration_text(0.2346), "235 ms");
    EXPECT_EQ(duration_text(1.25), "1.2 s");
    EXPECT_EQ(duration_text(123.4), "123 s");
    EXPECT_EQ(count_text(999), "999");
    EXPECT_EQ(count_text(13794), "13.8k");
    EXPECT_EQ(count_text(1.25e6), "1.25M");
    EXPECT_EQ(memory_text(2.57e7), "25.7 MB");
    EXPECT_EQ(memory_text(1.5e9), "1.5 GB");
}

}  // namespace
}  // namespace abut::study_prices_test
