// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/verdict.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "src/report/report.hpp"
#include "tests/src/results/synthetic_result.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::verdict_test {
namespace {

/// Contact pressures known to 0.7 %, where 1 % was asked for.
Result reached() {
    Result r = synthetic::bracket();
    r.accuracy.of = "contact pressure";
    r.accuracy.target = 0.01;
    r.accuracy.estimate = 0.007;
    r.accuracy.reached = true;
    return r;
}

TEST(Verdict, HasThreeStates) {
    Result r = reached();
    EXPECT_EQ(verdict_of(r), Verdict::reached);
    EXPECT_EQ(verdict_sentence(r), "Solved, accuracy reached: contact pressures known to 0.7 %");
    r.reasons = {{"yield", "strap at 2.75 times its yield"}};
    EXPECT_EQ(verdict_of(r), Verdict::solved_but);
    EXPECT_EQ(verdict_sentence(r), "Solved, but: strap at 2.75 times its yield; contact pressures known to 0.7 %");
    r.status = "failed";
    r.message = "the pin slides";
    EXPECT_EQ(verdict_of(r), Verdict::failed);
    EXPECT_EQ(verdict_sentence(r), "Failed: the pin slides");
}

TEST(Verdict, TheSentenceSaysEachErrorOnce) {
    Result r = reached();
    r.reasons = {{"accuracy", "contact pressures known to 3 %, not to 1 %"}};
    EXPECT_EQ(verdict_sentence(r), "Solved, but: contact pressures known to 3 %, not to 1 %");
    r.reasons = {{"corner", "the largest pressure of contact 0 stands at a sharp corner, where it has no limit"}};
    EXPECT_TRUE(verdict_sentence(r).ends_with("; contact pressures known to 0.7 % away from corners"));
    r.reasons.clear();
    r.accuracy.reached = false;  // nothing was asked for
    EXPECT_EQ(verdict_sentence(r), "Solved: contact pressures known to 0.7 %");
    r.accuracy.of = "stress";
    EXPECT_EQ(verdict_sentence(r), "Solved: stresses known to 0.7 % in the energy norm");
    r.accuracy.estimate.reset();
    EXPECT_EQ(verdict_sentence(r), "Solved");
}

TEST(Verdict, IsInTheJsonTheTableAndTheReport) {
    Result r = reached();
    EXPECT_EQ(nlohmann::json::parse(result_json(r))["verdict"], "reached");
    r.reasons = {{"yield", "strap at <2.75> times its yield"}, {"corner", "a corner"}};
    const auto json = nlohmann::json::parse(result_json(r));
    EXPECT_EQ(json["verdict"], "solved_but");
    ASSERT_EQ(json["reasons"].size(), 2u);
    EXPECT_EQ(json["reasons"][0]["kind"], "yield");
    EXPECT_EQ(json["reasons"][0]["text"], r.reasons[0].text);
    EXPECT_NE(result_table(r).find("\nSolved, but: strap at <2.75> times its yield; a corner;"), std::string::npos);
    EXPECT_NE(report_html(r).find("<p class=\"verdict doubtful\">Solved, but: strap at &lt;2.75&gt; times"), std::string::npos);
    r.status = "failed";
    EXPECT_EQ(nlohmann::json::parse(result_json(r))["verdict"], "failed");
}

TEST(Impossible, NothingInAnOrdinaryAnswer) {
    EXPECT_EQ(impossible_in(reached()), "");
    EXPECT_EQ(impossible_in(Result{}), "");
}

TEST(Impossible, NumbersThatAreNotFiniteAreNamedWhereverTheyAre) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    const std::pair<std::function<void(Result&)>, const char*> cases[] = {
        {[&](Result& r) { r.strain_energy = nan; }, "the strain energy"},
        {[&](Result& r) { r.parts[1].max_von_mises.value = infinity; }, "part pin"},
        {[&](Result& r) { r.fields[0].samples[7].stress.zz = nan; }, "part bracket"},
        {[&](Result& r) { r.fields[1].boundary[0][3].displacement.y() = nan; }, "part pin"},
        {[&](Result& r) { r.contacts[0].force.x() = nan; }, "contact 1"},
        {[&](Result& r) { r.contacts[0].profile.pressure[5] = -infinity; }, "contact 1"},
        {[&](Result& r) {
             r.contacts[0].errors = ContactErrors{0.01, nan, 0.01, 0.01, false};
         },
         "contact 1"},
        {[&](Result& r) { r.reactions[1].moment = nan; }, "the reaction of fix x on bracket/left"},
        {[&](Result& r) { r.probes[0].stress.xy = nan; }, "the probe in part bracket"},
        {[&](Result& r) { r.equilibrium.relative_residual = nan; }, "the balance of forces"},
        {[&](Result& r) { r.error_estimate.energy = infinity; }, "the estimated errors"},
        {[&](Result& r) { r.solver.condition_estimate = infinity; }, "the condition number"}};
    for (const auto& [spoil, name] : cases) {
        Result r = reached();
        spoil(r);
        const std::string text = impossible_in(r);
        EXPECT_NE(text.find(std::string("not finite (") + name + ")"), std::string::npos) << name << ": " << text;
    }
}

TEST(Impossible, EnergyBelowZeroButForRounding) {
    Result r = reached();
    r.energy_rounding = 1e-9;
    r.strain_energy = -0.9e-9;
    EXPECT_EQ(impossible_in(r), "");
    r.strain_energy = -1.1e-9;
    EXPECT_EQ(impossible_in(r), "the strain energy is below zero (-1.1e-09)");
}

TEST(Impossible, ForcesOrMomentsOutOfBalance) {
    Result r = reached();
    r.equilibrium.relative_residual = r.equilibrium.relative_moment_residual = 0.9e-6;
    EXPECT_EQ(impossible_in(r), "");
    r.equilibrium.relative_residual = 0.02;
    EXPECT_EQ(impossible_in(r), "forces are out of balance by 2 % of the largest");
    r.equilibrium.relative_residual = 0;
    r.equilibrium.relative_moment_residual = 1.1e-2;
    EXPECT_EQ(impossible_in(r).find("moments are out of balance by 1.1 %"), 0u) << impossible_in(r);
}

TEST(Impossible, ConditionsOfContactThatAreNotMet) {
    Result r = reached();
    r.solver.contact_residual = 0.9e-2;
    EXPECT_EQ(impossible_in(r), "");
    r.solver.contact_residual = 0.7;
    EXPECT_EQ(impossible_in(r), "the conditions of contact are violated by 70 % of the largest pressure or closing");
}

}  // namespace
}  // namespace abut::verdict_test
