// SPDX-License-Identifier: GPL-3.0-or-later
// Made-up bodies that friction holds: 2000 come to rest, with no shear beyond its bound, all in balance, and work that is
// spent and not gained; of those loaded beyond what friction bears the motion is named.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/generated/friction_cases.hpp"

namespace abut::friction_sweep_test {
namespace {

constexpr double rounding = 1e-9;
constexpr std::uint64_t cases_of_a_kind = 500, in_sample = 10;

using Answers = std::vector<Result>;

Answers answers_of(const std::string& text) {
    AnalyzeOptions options;
    options.threads = 1;
    const Scene scene = read_scene_text(text, "friction.json");
    if (scene.cases.empty()) return {analyze(scene, options)};
    Answers answers;
    for (CaseResult& c : analyze_cases(scene, options)) answers.push_back(std::move(c.result));
    return answers;
}

void append_faults(const ContactResult& c, std::vector<std::string>& faults) {
    if (!c.friction) return;
    const ContactProfile& p = c.profile;
    double largest = 0, beyond = 0, slip = 0;
    for (std::size_t k = 0; k < p.shear.size(); ++k) {
        const double bound = c.friction->coefficient * p.pressure[k];
        largest = std::max(largest, bound);
        beyond = std::max(beyond, std::abs(p.shear[k]) - bound);
        slip = std::max(slip, std::abs(p.slip[k]));
    }
    const auto at_most = [&](double value, double limit, const std::string& what) {
        if (!(value <= limit)) faults.push_back(what + " by " + std::to_string(value / limit) + " times what rounding leaves");
    };
    at_most(beyond, rounding * largest, "shear exceeds its bound");
    at_most(-c.friction->dissipated, rounding * c.friction->coefficient * c.friction->normal_force * slip, "work is gained");
}

void append_faults(const Result& r, std::vector<std::string>& faults) {
    if (r.status != "ok") {
        faults.push_back("no answer: " + r.message);
        return;
    }
    if (!r.solver.converged) faults.push_back("not converged");
    for (double residual : {r.equilibrium.relative_residual, r.equilibrium.relative_moment_residual})
        if (!(residual <= rounding))
            faults.push_back("off balance by " + std::to_string(residual / rounding) + " times rounding");
    for (const ContactResult& c : r.contacts) append_faults(c, faults);
}

std::vector<std::string> faults_of(const test::FrictionCase& known) {
    std::vector<std::string> faults;
    Answers answers;
    try {
        answers = answers_of(known.text);
    } catch (const std::exception& e) { return {std::string("refused: ") + e.what()}; }
    for (std::size_t k = 0; k + (known.rests ? 0 : 1) < answers.size(); ++k) append_faults(answers[k], faults);
    if (known.rests) return faults;
    const Result& last = answers.back();
    if (last.status != "failed")
        faults.push_back("rests beyond what friction bears");
    else if (last.message.find("upper") == std::string::npos)
        faults.push_back("names no motion: " + last.message);
    return faults;
}

/// Known to fail. On blocks with small coefficients all slips but a place that a free motion needs.
const std::map<std::string, std::string> failing{};

void expect_sound(const std::string& kind, std::uint64_t first, std::uint64_t count) {
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const std::string what = kind + " " + std::to_string(seed);
        const test::FrictionCase known = test::friction_case(kind, seed);
        std::string all;
        for (const std::string& line : faults_of(known)) all += "\n  " + line;
        if (const auto found = failing.find(what); found != failing.end()) {
            std::cout << (all.empty() ? "no longer fails: " : "left out: ") << what << ": " << found->second << all << "\n";
            continue;
        }
        EXPECT_TRUE(all.empty()) << what << ":" << all << "\n" << known.text;
    }
}

class FrictionSweep : public testing::TestWithParam<std::string> {};
class LongFrictionSweep : public testing::TestWithParam<std::string> {};

TEST_P(FrictionSweep, RestsOrNamesItsMotion) {
    expect_sound(GetParam(), 1, in_sample);
}

TEST_P(LongFrictionSweep, RestsOrNamesItsMotion) {
    expect_sound(GetParam(), in_sample + 1, cases_of_a_kind - in_sample);
}

/// A coefficient so small that a trifle of the tractions' bounds is below the rounding of pivots.
TEST(FrictionSteps, SmallBoundsAreFoundByTheOtherTies) {
    const Answers steps = answers_of(
        R"({"abut":1,"accuracy":{"level":"draft"},"contacts":{"friction":0.0075938945512965435},
            "loads":[{"force":[0.0,-4.439269224149585],"name":"press","on":"top/top"},{"force":[0.028630333543582458,0.0],"name":"shear","on":"top/top"}],
            "materials":{"hard":{"E":1000000.0,"nu":0.3},"soft":{"E":100000.0,"nu":0.2784410766411609}},
            "parts":[{"geometry":{"rectangle":{"max":[2.0,0.0],"min":[-2.0,-2.0]}},"material":"hard","name":"base"},
            {"geometry":{"rectangle":{"max":[0.9011103609872866,0.5588972981946096],"min":[-0.9011103609872866,0.0]}},"material":"soft","name":"top"}],
            "steps":[{"loads":{"press":1},"name":"pressed"},
            {"loads":{"press":1,"shear":1},"name":"sheared"},{"loads":{"press":1},"name":"released"},{"loads":{"press":1,"shear":-1},"name":"back"}],
            "supports":[{"fix":["x","y"],"on":"base/bottom"}],"title":"block_on_block 96"})");
    ASSERT_EQ(steps.size(), 4U);
    std::vector<std::string> faults;
    for (const Result& step : steps) append_faults(step, faults);
    EXPECT_TRUE(faults.empty()) << faults.front();
}

const auto name = [](const auto& kind) { return kind.param; };
INSTANTIATE_TEST_SUITE_P(Of, FrictionSweep, testing::ValuesIn(test::friction_kinds()), name);
INSTANTIATE_TEST_SUITE_P(Of, LongFrictionSweep, testing::ValuesIn(test::friction_kinds()), name);

}  // namespace
}  // namespace abut::friction_sweep_test
