// SPDX-License-Identifier: GPL-3.0-or-later
// What the next pass will take, and paths that end before it is spent.
#include "src/analysis/pass_cost.hpp"

#include <gtest/gtest.h>

#include "src/analysis/adaptive.hpp"
#include "src/analysis/analysis.hpp"
#include "src/plan/plan.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::pass_cost_test {
namespace {

Outcome beam(const std::string& budget, double target) {
    Scene scene = read_scene(std::string(ABUT_SOURCE_DIR) + "/data/scenes/four_pin_beam.json");
    scene.accuracy.target = target;
    if (!budget.empty()) scene.accuracy.budget = parse_budget(budget);
    Stopwatches seconds;
    return solve_adaptively(scene, resolve_conditions(scene), {}, seconds);
}

/// A disc of radius 1 pressed on a block: Hertz' half width is 3.4e-3 sqrt(F).
Result pressed_disc(double F) {
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
        {"name": "disc", "material": "m", "geometry": {"circle": {"center": [0, 1], "radius": 1}}},
        {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [-2, -2], "max": [2, 0]}}}],
        "supports": [{"on": "block/bottom", "fix": ["x", "y"]},
                     {"part": "disc", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"part": "disc", "force": [0, -)" +
                        test::number(F) + "]}]}");
}

}  // namespace

TEST(PassCost, MemoryEndsThePathBeforeItIsSpent) {
    const Outcome bound = beam("45 MB", 0.002);
    ASSERT_EQ(bound.end, PathEnd::out_of_budget);
    ASSERT_TRUE(bound.next);
    EXPECT_GT(bound.next->bytes, 45e6);
    EXPECT_LT(bound.passes.back().unknowns, bound.next->unknowns);
    EXPECT_FALSE(bound.stress.empty());
}

TEST(PassCost, TimeEndsThePathAfterTheFirstPass) {
    const Outcome bound = beam("1e-9 s", 0.01);
    EXPECT_EQ(bound.end, PathEnd::out_of_budget);
    EXPECT_EQ(bound.passes.size(), 1u);
    ASSERT_TRUE(bound.next);
    EXPECT_GT(bound.next->seconds, 0);
    EXPECT_NE(cost_text(*bound.next).find(" unknowns, in "), std::string::npos);
}

/// Every case has a solution in memory: the grids that one may have are too fine for all of them.
TEST(PassCost, CasesKeepToABudgetTogether) {
    const auto solved = [](const std::string& budget) {
        std::string cases;
        for (int k = 0; k < 12; ++k)
            cases += (k > 0 ? "," : "") + (R"({"name": ")" + std::to_string(k)) + R"(", "loads": {"F": )" +
                     std::to_string(1 + 0.5 * k) + "}}";
        Scene scene = read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
            {"name": "disc", "material": "m", "geometry": {"circle": {"center": [0, 1], "radius": 1}}},
            {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [-2, -2], "max": [2, 0]}}}],
            "supports": [{"on": "block/bottom", "fix": ["x", "y"]},
                         {"part": "disc", "rigid": {"translation": [0, null], "rotation": 0}}],
            "loads": [{"name": "F", "part": "disc", "force": [0, -100]}], "cases": [)" +
                                          cases + "]}",
                                      "cases.json");
        scene.accuracy.budget = parse_budget(budget);
        return analyze_cases(scene, {});
    };
    const std::vector<CaseResult> free = solved("10 h"), bound = solved("40 MB");
    for (std::size_t k = 0; k < free.size(); ++k) {
        EXPECT_TRUE(free[k].result.accuracy.reached);
        EXPECT_EQ(bound[k].result.status, "ok") << bound[k].result.message;
        EXPECT_FALSE(bound[k].result.accuracy.reached);
        EXPECT_NE(bound[k].result.accuracy.why.find("the next grids of all cases, of about "), std::string::npos);
        EXPECT_LT(bound[k].result.unknowns, free[k].result.unknowns);
    }
    // what is solved again on the last grids is not compared with itself
    for (const CaseResult& c : bound)
        for (std::size_t k = 1; k < c.result.passes.size(); ++k)
            EXPECT_GT(c.result.passes[k].unknowns, c.result.passes[k - 1].unknowns);
}

/// Stresses of one grid have an estimate, pressures have none.
TEST(PassCost, PressuresOfOneGridAreNotToldByStresses) {
    Scene scene = read_scene(std::string(ABUT_SOURCE_DIR) + "/data/scenes/four_pin_beam.json");
    scene.accuracy.budget = parse_budget("1e-9 s");
    const Result result = analyze(scene, {});
    EXPECT_FALSE(result.accuracy.reached);
    ASSERT_FALSE(result.reasons.empty());
    EXPECT_EQ(result.reasons[0].text, "contact pressures of one grid alone, which may be far off");
    EXPECT_NE(result.accuracy.why.find("beyond the budget"), std::string::npos) << result.accuracy.why;
    scene.accuracy.target = 0.5;  // stresses are as good, pressures may be anything
    EXPECT_FALSE(analyze(scene, {}).accuracy.reached);
}

TEST(PassCost, ABudgetThatIsEnoughChangesNothing) {
    const Outcome free = beam("", 0.01), bound = beam("10 h", 0.01);
    EXPECT_EQ(bound.end, PathEnd::reached);
    EXPECT_EQ(bound.passes.back().unknowns, free.passes.back().unknowns);
    EXPECT_EQ(bound.passes.back().energy, free.passes.back().energy);
    EXPECT_FALSE(free.next);
    // what was foretold of the last pass
    ASSERT_TRUE(bound.next);
    EXPECT_NEAR(bound.next->unknowns, bound.passes.back().unknowns, 0.15 * bound.passes.back().unknowns);
}

TEST(PassCost, ContactsTooSmallForTheirCoordinatesAreToldOrRefused) {
    EXPECT_EQ(pressed_disc(1e-6).reasons.size(), 0u);
    const Result told = pressed_disc(1e-9), refused = pressed_disc(1e-12);
    EXPECT_EQ(told.status, "ok");
    EXPECT_FALSE(told.accuracy.reached);
    EXPECT_EQ(refused.status, "failed");
    for (const std::string& text : {told.accuracy.why, refused.message}) {
        EXPECT_NE(text.find("in disc ("), std::string::npos) << text;
        EXPECT_NE(text.find("assembly of its own"), std::string::npos) << text;
    }
}

}  // namespace abut::pass_cost_test
