// SPDX-License-Identifier: GPL-3.0-or-later
// Load cases: each is what the scene would be under its loads alone, on grids and factors that all have in common.
#include "src/scene/load_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "geometry/brep/input_error.hpp"
#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::load_cases_test {
namespace {

/// A bar that is held on its left, with a rigid or an elastic block on it if the text says so.
Scene scene_with(const std::string& parts, const std::string& rest) {
    return read_scene_text(R"({"abut": 1, "units": {"length": "mm", "force": "N"},
        "materials": {"steel": {"E": 210000, "nu": 0.3, "density": 7.85e-9, "expansion": 1.2e-5, "yield": 200}}, "parts": [)" +
                               parts + "], " + rest + "}",
                           "cases.json");
}

const std::string bar = R"({"name": "bar", "material": "steel", "geometry": {"rectangle": {"min": [0, 0], "max": [40, 10]}}})";

Scene loaded_bar(const std::string& cases) {
    return scene_with(bar, R"("supports": [{"on": "bar/left", "fix": ["x", "y"]}],
        "loads": [{"name": "push", "on": "bar/top", "pressure": "3 + x/20"}, {"name": "pull", "on": "bar/right", "force": [500, 20]},
                  {"name": "heat", "part": "bar", "temperature": "10 + y"}, {"name": "spin", "part": "bar", "spin": {"about": [0, 5], "omega": 900}},
                  {"on": "bar/right", "traction": [0, 1]}],
        "output": {"probes": [{"part": "bar", "at": [31, 4]}, {"part": "bar", "at": [12, 8]}]}, )" +
                               cases);
}

std::vector<double> numbers_of(const Result& r) {
    std::vector<double> all;
    for (const ProbeResult& p : r.probes)
        for (double v : {p.displacement.x(), p.displacement.y(), p.stress.xx, p.stress.yy, p.stress.xy}) all.push_back(v);
    return all;
}

void expect_close(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
    ASSERT_EQ(a.size(), b.size());
    ASSERT_FALSE(a.empty());
    double largest = 0;
    for (double v : a) largest = std::max(largest, std::abs(v));
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], tolerance * largest) << i;
}

TEST(LoadCases, AreSumsOfTheirLoadsWithoutContact) {
    const Scene scene = loaded_bar(R"("cases": [{"name": "none", "loads": {}}, {"name": "a", "loads": {"push": 1}},
        {"name": "b", "loads": {"pull": 1}}, {"name": "both", "loads": {"push": -2, "pull": 0.5}},
        {"name": "heat", "loads": {"heat": 1}}, {"name": "half", "loads": {"heat": -0.5}},
        {"name": "spin", "loads": {"spin": 1}}, {"name": "twice", "loads": {"spin": 4}}])");
    const std::vector<CaseResult> cases = analyze_cases(scene, {});
    ASSERT_EQ(cases.size(), 8U);
    std::vector<std::vector<double>> u;
    for (const CaseResult& c : cases) {
        ASSERT_EQ(c.result.status, "ok") << c.name << ": " << c.result.message;
        EXPECT_EQ(c.result.unknowns, cases[0].result.unknowns) << "one set of grids";
        u.push_back(numbers_of(c.result));
    }
    const auto sum = [&](const std::vector<std::pair<double, int>>& terms, double unnamed) {
        std::vector<double> total(u[0].size(), 0);
        for (std::size_t i = 0; i < total.size(); ++i) {
            total[i] = unnamed * u[0][i];
            for (const auto& [factor, k] : terms) total[i] += factor * u[static_cast<std::size_t>(k)][i];
        }
        return total;
    };
    expect_close(u[3], sum({{-2, 1}, {0.5, 2}}, 1 + 2 - 0.5), 1e-11);
    expect_close(u[5], sum({{-0.5, 4}}, 1.5), 1e-11);
    expect_close(u[7], sum({{4, 6}}, -3), 1e-11);
}

TEST(LoadCases, AreWhatTheSceneWouldBeAlone) {
    const Scene scene = loaded_bar(R"("accuracy": {"cell_size": 1.5}, "cases": [{"name": "a", "loads": {"push": 1, "heat": 2}},
        {"name": "b", "loads": {"pull": -1.5}}])");
    const std::vector<CaseResult> cases = analyze_cases(scene, {});
    for (std::size_t k = 0; k < cases.size(); ++k) {
        const Result alone = analyze(scene_of_case(scene, scene.cases[k]), {});
        expect_close(numbers_of(cases[k].result), numbers_of(alone), 1e-11);
        EXPECT_NEAR(cases[k].result.strain_energy, alone.strain_energy, 1e-11 * alone.strain_energy);
        EXPECT_LT(cases[k].result.equilibrium.relative_residual, 1e-10);
    }
}

/// Half of a disc on half of a table: half width and peak of Hertz' contact grow with the root of the force.
TEST(LoadCases, FollowHertzOnCommonGrids) {
    const Scene scene = scene_with(
        R"({"name": "disc", "material": "steel", "geometry": {"intersection": [{"circle": {"center": [0, 10], "radius": 10}},
              {"rectangle": {"min": [0, 0], "max": [10, 10]}}]}},
           {"name": "table", "material": "steel", "geometry": {"rectangle": {"min": [0, -40], "max": [40, 0]}}})",
        R"("supports": [{"on": ["disc/left", "table/left", "table/bottom"], "symmetry": true}],
           "loads": [{"name": "weight", "on": "disc/top", "pressure": 50}],
           "cases": [{"name": "one", "loads": {"weight": 1}}, {"name": "two", "loads": {"weight": 2}}, {"name": "four", "loads": {"weight": 4}}])");
    const std::vector<CaseResult> cases = analyze_cases(scene, {});
    const double modulus = 210000.0 / 2;
    for (const CaseResult& c : cases) {
        ASSERT_EQ(c.result.status, "ok") << c.result.message;
        ASSERT_EQ(c.result.contacts.size(), 1U);
        const double force = 500 * c.factors.at("weight");  // of the half
        const double half_width = std::sqrt(4 * 2 * force * 10 / (std::numbers::pi * modulus));
        const double peak = 2 * 2 * force / (std::numbers::pi * half_width);
        EXPECT_NEAR(c.result.contacts[0].force.norm(), force, 1e-8 * force);
        EXPECT_NEAR(c.result.contacts[0].max_pressure.value, peak, 0.01 * peak) << c.name;
        EXPECT_NEAR(c.result.contacts[0].contact_length, half_width, 0.02 * half_width) << c.name;
        EXPECT_TRUE(c.result.accuracy.reached) << c.name;
    }
    const Envelope all = envelope_of(cases);
    ASSERT_EQ(all.contacts.size(), 1U);
    EXPECT_EQ(all.contacts[0].max_pressure.in_case, 2U);
    EXPECT_EQ(all.contacts[0].max_pressure.value, cases[2].result.contacts[0].max_pressure.value);
    ASSERT_TRUE(all.parts[0].utilisation);
    EXPECT_EQ(all.parts[0].utilisation->value, all.parts[0].max_von_mises.value / 200);
}

Scene disc_on_table(const std::vector<double>& weights) {
    std::ostringstream cases;
    for (std::size_t k = 0; k < weights.size(); ++k)
        cases << (k > 0 ? "," : "") << R"({"name": ")" << k << R"(", "loads": {"weight": )" << weights[k] << "}}";
    return scene_with(
        R"({"name": "disc", "material": "steel", "geometry": {"circle": {"center": [0, 10], "radius": 10}}},
           {"name": "table", "material": "steel", "geometry": {"rectangle": {"min": [-40, -40], "max": [40, 0]}}})",
        R"("supports": [{"on": "table/bottom", "fix": ["x", "y"]}, {"part": "disc", "rigid": {"translation": [0, null], "rotation": 0}}],
           "loads": [{"name": "weight", "part": "disc", "force": [0, -1000]}], "cases": [)" +
            cases.str() + "]");
}

/// What cases share on one set of grids is not what one of them leaves to the next.
TEST(LoadCases, OfTheSameLoadsAreTheSame) {
    const std::vector<CaseResult> cases = analyze_cases(disc_on_table({1, 9, 1, 0.2}), {});
    ASSERT_EQ(cases.size(), 4U);
    for (const CaseResult& c : cases) {
        ASSERT_EQ(c.result.status, "ok") << c.result.message;
        EXPECT_EQ(c.result.unknowns, cases[0].result.unknowns) << "one set of grids";
        EXPECT_NEAR(c.result.contacts[0].force.norm(), 1000 * c.factors.at("weight"), 1e-8 * 1000);
    }
    EXPECT_EQ(cases[0].result.contacts[0].profile.pressure, cases[2].result.contacts[0].profile.pressure);
    EXPECT_EQ(cases[0].result.parts[0].max_von_mises.value, cases[2].result.parts[0].max_von_mises.value);
    EXPECT_NE(cases[0].result.contacts[0].profile.pressure, cases[1].result.contacts[0].profile.pressure);
    EXPECT_LT(cases[0].result.solver.grids, cases[1].result.solver.grids) << "what has all it wants waits for the last grids";
    // the middle of the disc's face is pressed as the root of the force, to the errors that both state
    const auto& one = cases[0].result.contacts[0];
    const auto& nine = cases[1].result.contacts[0];
    ASSERT_TRUE(one.errors && nine.errors);
    EXPECT_NEAR(nine.max_pressure.value / one.max_pressure.value, 3.0, 2 * (one.errors->peak + nine.errors->peak) + 0.01);
}

/// The first asks for cells that no coordinates tell apart: the second goes on to finer grids all the same.
TEST(LoadCases, OneThatIsTooSmallForItsPartsEndsAlone) {
    const std::vector<CaseResult> cases = analyze_cases(disc_on_table({1e-12, 1}), {});
    EXPECT_FALSE(cases[0].result.accuracy.reached);
    const std::string told = "; compute what lies around that place";
    const std::string& why = cases[0].result.accuracy.why;
    EXPECT_NE(why.find(told), std::string::npos) << why;
    EXPECT_EQ(why.find(told), why.rfind(told)) << why;
    const Result& other = cases[1].result;
    ASSERT_EQ(other.status, "ok") << other.message;
    EXPECT_GT(other.solver.grids, 2);
    ASSERT_TRUE(other.contacts[0].errors);
    const double modulus = 210000 / (2 * (1 - 0.3 * 0.3)), peak = std::sqrt(1000 * modulus / (std::numbers::pi * 10));
    EXPECT_NEAR(other.contacts[0].max_pressure.value, peak, 2 * other.contacts[0].errors->peak * peak);
}

/// Cases are solved side by side: the first four at once, then twice as many.
TEST(LoadCases, AreTheSameOnAnyNumberOfThreads) {
    const Scene scene = disc_on_table({1, 9, 1, 0.2, 4, 2, 7, 0.5, 3, 8});
    AnalyzeOptions options;
    options.threads = 1;
    const std::vector<CaseResult> one = analyze_cases(scene, options);
    options.threads = 3;
    const std::vector<CaseResult> three = analyze_cases(scene, options);
    ASSERT_EQ(one.size(), three.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        const Result &a = one[k].result, &b = three[k].result;
        EXPECT_EQ(a.contacts[0].profile.pressure, b.contacts[0].profile.pressure) << one[k].name;
        EXPECT_EQ(a.parts[0].max_von_mises.value, b.parts[0].max_von_mises.value) << one[k].name;
        EXPECT_EQ(a.strain_energy, b.strain_energy) << one[k].name;
        EXPECT_EQ(a.solver.condition_estimate, b.solver.condition_estimate) << one[k].name;
        EXPECT_EQ(a.unknowns, b.unknowns) << one[k].name;
        EXPECT_EQ(a.solver.grids, b.solver.grids) << one[k].name;
    }
}

/// A block on a table that is pushed down or lifted on a spring: contact in the one case, none in the other.
TEST(LoadCases, OpenAndCloseContacts) {
    const Scene scene = scene_with(
        R"({"name": "block", "material": "steel", "geometry": {"rectangle": {"min": [0, 0], "max": [10, 10]}}},
           {"name": "table", "material": "steel", "geometry": {"rectangle": {"min": [-10, -10], "max": [20, 0]}}})",
        R"("supports": [{"on": "table/bottom", "fix": ["x", "y"]}, {"on": "block/top", "spring": {"normal": 10, "tangential": 10}}],
           "loads": [{"name": "push", "on": "block/top", "force": [0, -1000]}],
           "cases": [{"name": "down", "loads": {"push": 1}}, {"name": "up", "loads": {"push": -1}}])");
    const std::vector<CaseResult> cases = analyze_cases(scene, {});
    ASSERT_EQ(cases[0].result.status, "ok") << cases[0].result.message;
    ASSERT_EQ(cases[1].result.status, "ok") << cases[1].result.message;
    const Envelope all = envelope_of(cases);
    ASSERT_EQ(all.contacts.size(), 1U);
    EXPECT_EQ(all.contacts[0].open_in, (std::vector<std::size_t>{1}));
    EXPECT_EQ(all.contacts[0].force.in_case, 0U);
    EXPECT_GT(cases[1].result.parts[0].max_displacement.value, cases[0].result.parts[0].max_displacement.value);
}

TEST(LoadCases, OneThatFailsLeavesTheOthers) {
    const Scene scene = scene_with(
        R"({"name": "block", "material": "steel", "geometry": {"rectangle": {"min": [0, 0], "max": [10, 10]}}},
           {"name": "table", "material": "steel", "geometry": {"rectangle": {"min": [-10, -10], "max": [20, 0]}}})",
        R"("supports": [{"on": "table/bottom", "fix": ["x", "y"]}, {"on": "block/left", "fix": ["x"]}],
           "loads": [{"name": "push", "on": "block/top", "force": [0, -1000]}],
           "cases": [{"name": "up", "loads": {"push": -1}}, {"name": "down", "loads": {"push": 1}}])");
    const std::vector<CaseResult> cases = analyze_cases(scene, {});
    EXPECT_EQ(cases[0].result.status, "failed");
    EXPECT_NE(cases[0].result.message.find("block"), std::string::npos);
    ASSERT_EQ(cases[1].result.status, "ok") << cases[1].result.message;
    EXPECT_NEAR(cases[1].result.contacts[0].force.y(), 1000, 1e-6);
    EXPECT_EQ(verdict_of(cases), Verdict::failed);
    EXPECT_EQ(envelope_of(cases).contacts[0].force.in_case, 1U);
}

/// A part that is stiff enough to be rigid in one case alone is elastic in all: what a part is made of is common.
TEST(LoadCases, APartIsRigidInAllOrNone) {
    const auto scene = [](const std::string& first, const std::string& second) {
        return read_scene_text(R"({"abut": 1, "materials": {"hard": {"E": 1e9, "nu": 0.3}, "soft": {"E": 100, "nu": 0.3}},
            "parts": [{"name": "beam", "material": "hard", "geometry": {"rectangle": {"min": [0, 0], "max": [50, 5]}}},
                      {"name": "pad", "material": "soft", "geometry": {"rectangle": {"min": [20, 5], "max": [30, 10]}}}],
            "supports": [{"on": "beam/left", "fix": ["x", "y"]}, {"on": "pad/left", "fix": ["x"]}],
            "loads": [{"name": "pad", "on": "pad/top", "pressure": 1}, {"name": "beam", "on": "beam/right", "force": [0, -100000]}],
            "cases": [{"name": ")" +
                                   first + R"(", "loads": {")" + first + R"(": 1}}, {"name": ")" + second +
                                   R"(", "loads": {")" + second + R"(": 1}}]})",
                               "cases.json");
    };
    for (const auto& [first, second] : {std::pair("pad", "beam"), std::pair("beam", "pad")}) {
        const Scene together = scene(first, second);
        const std::vector<CaseResult> cases = analyze_cases(together, {});
        for (std::size_t k = 0; k < cases.size(); ++k) {
            if (cases[k].name != "beam") continue;
            const Result alone = analyze(scene_of_case(together, together.cases[k]), {});
            EXPECT_FALSE(cases[k].result.parts[0].rigid);
            EXPECT_GT(alone.parts[0].max_displacement.value, 0);
            EXPECT_NEAR(cases[k].result.parts[0].max_displacement.value, alone.parts[0].max_displacement.value,
                        0.01 * alone.parts[0].max_displacement.value);
        }
    }
}

/// What one case cannot be solved for is not the others' failure, whichever comes first; idle parts are left out of a case.
TEST(LoadCases, ShareNeitherFailuresNorIdleParts) {
    const auto scene = [](const std::string& cases) {
        return scene_with(
            bar + R"(, {"name": "other", "material": "steel", "geometry": {"rectangle": {"min": [0, 100], "max": [40, 110]}}})",
            R"end("supports": [{"on": "bar/left", "fix": ["x", "y"]}], "accuracy": {"dirichlet": "solution_structure"},
                             "loads": [{"name": "push", "on": "bar/top", "pressure": 3}, {"name": "heat", "part": "bar", "temperature": 10},
                                       {"name": "bad", "on": "bar/top", "pressure": "1/(x-x)"},
                                       {"name": "spin", "part": "other", "spin": {"about": [20, 105], "omega": 9}}], "cases": [)end" +
                cases + "]");
    };
    const std::string push = R"({"name": "push", "loads": {"push": 1}})", heat = R"({"name": "heat", "loads": {"heat": 1}})",
                      bad = R"({"name": "bad", "loads": {"bad": 1}})", spin = R"({"name": "spin", "loads": {"spin": 1}})";
    for (const std::string& order : {heat + "," + bad + "," + push + "," + spin, spin + "," + push + "," + bad + "," + heat}) {
        for (const CaseResult& c : analyze_cases(scene(order), {})) {
            EXPECT_EQ(c.result.status, c.name == "heat" || c.name == "bad" ? "failed" : "ok")
                << c.name << ": " << c.result.message;
            EXPECT_TRUE(c.name != "push" || !c.result.parts[1].solved) << "nothing acts on it here";
            EXPECT_TRUE(c.name != "spin" || !c.result.parts[0].solved);
        }
    }
}

TEST(LoadCases, AreNotAnsweredAsOneScene) {
    const Scene scene = loaded_bar(R"("cases": [{"name": "a", "loads": {"push": 1}}])");
    EXPECT_THROW(analyze(scene, {}), InputError);
    EXPECT_THROW(case_named(scene, "b"), InputError);
    EXPECT_EQ(case_named(scene, "a").factors.at("push"), 1);
    EXPECT_TRUE(scene_of_case(scene, scene.cases[0]).cases.empty());
    EXPECT_EQ(scene_of_case(scene, scene.cases[0]).loads.size(), 2U) << "push, and the one without a name";
}

TEST(LoadCases, ALoadThatActsNowhereIsSaid) {
    const Scene scene = loaded_bar(R"("cases": [{"name": "a", "loads": {"push": 1, "pull": 0, "spin": 1}}])");
    int n_said = 0;
    for (const std::string& warning : scene.warnings)
        n_said += warning == "the load 'pull' acts in no load case" || warning == "the load 'heat' acts in no load case";
    EXPECT_EQ(n_said, 2);
}

TEST(LoadCases, WhatIsWrongIsToldWithItsPlace) {
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {R"("cases": [])", "/cases"},
        {R"("cases": [{"name": "a", "loads": {"pusch": 1}}])", "did you mean 'push'"},
        {R"("cases": [{"name": "a", "loads": ["push"]}])", "/cases/0/loads"},
        {R"("cases": [{"loads": {"push": 1}}])", "name"},
        {R"("cases": [{"name": "a", "loads": {"push": "1 N"}}])", "/cases/0/loads/push"},
        {R"("cases": [{"name": "a", "loads": {"spin": -1}}])", "negative"},
        {R"("cases": [{"name": "a", "loads": {}}, {"name": "a", "loads": {}}])", "another load case"},
        {R"("cases": [{"name": "a", "loads": {}}], "expect": [{"quantity": "strain_energy", "value": 1, "tolerance": 1}])",
         "give \"case\""},
        {R"("cases": [{"name": "left", "loads": {}}], "expect": [{"case": "lift", "quantity": "strain_energy", "value": 1, "tolerance": 1}])",
         "did you mean 'left'"},
        {R"("expect": [{"case": "a", "quantity": "strain_energy", "value": 1, "tolerance": 1}])", "no load cases"}};
    for (const auto& [text, words] : wrong) {
        try {
            loaded_bar(text);
            ADD_FAILURE() << text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.problems().size(), 1U) << text;
            EXPECT_NE(one_line(error.problems().front()).find(words), std::string::npos)
                << one_line(error.problems().front()) << "\n"
                << text;
        }
    }
}

/// Factors in common have one condition, found once; that of a case alone is the same.
TEST(LoadCases, TellTheConditionOfTheirCommonFactors) {
    Scene scene = loaded_bar(R"("cases": [{"name": "a", "loads": {"push": 1}}, {"name": "b", "loads": {"pull": 1}}])");
    scene.accuracy.cell_size = 2;
    const std::vector<CaseResult> cases = analyze_cases(scene, {});
    ASSERT_EQ(cases.size(), 2U);
    const double alone = analyze(scene_of_case(scene, scene.cases[1]), {}).solver.condition_estimate;
    EXPECT_GT(alone, 1);
    for (const CaseResult& c : cases) EXPECT_NEAR(c.result.solver.condition_estimate, alone, 1e-6 * alone) << c.name;
}

}  // namespace
}  // namespace abut::load_cases_test
