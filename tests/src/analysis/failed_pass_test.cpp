// SPDX-License-Identifier: GPL-3.0-or-later
// Passes that fail after others gave answers.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <new>
#include <string>

#include "src/analysis/analysis.hpp"
#include "src/analysis/grid_walk.hpp"
#include "src/plan/plan.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::failed_pass_test {
namespace {

Scene scene_named(const std::string& name) {
    Scene scene = read_scene(std::string(ABUT_SOURCE_DIR) + "/data/scenes/" + name);
    scene.accuracy.target = 0.002;
    return scene;
}

/// Memory that ends with the pass of that number.
AnalyzeOptions without_memory_from(int pass) {
    AnalyzeOptions options;
    options.progress = [n = 0, pass](const std::string&) mutable {
        if (++n == pass) throw std::bad_alloc();
    };
    return options;
}

/// What a walk over solutions that are changed so says of its end; all ends of contact are at corners.
template <class Change>
std::string failed_by(Change change) {
    const Scene scene = read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [
        {"name": "low", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [4, 1]}}},
        {"name": "high", "material": "m", "geometry": {"rectangle": {"min": [1, 1], "max": [3, 2]}}}],
        "supports": [{"on": "low/bottom", "fix": ["x", "y"]}, {"on": "high/left", "fix": ["x"]}],
        "loads": [{"on": "high/top", "pressure": 10}]})",
                                        "");
    const ResolvedConditions conditions = resolve_conditions(scene);
    Stopwatches seconds;
    EffectUses uses;
    GridWalk walk(scene, conditions, seconds, PartGroup(scene.parts.size(), true), search_scene(scene, 1, seconds, uses), 1);
    for (bool is_over = false; !is_over;) {
        const PassAsk ask = walk.ask();
        SolvedAssembly s = solve_pass(scene, conditions, walk.candidates(), ask.parts, ask.wanted, ask.coarseness, seconds);
        change(s);
        is_over = walk.take(std::move(s));
    }
    return walk.failed();
}

}  // namespace

TEST(FailedPass, TheLastAnswerStandsAndSaysWhatFailed) {
    const Scene scene = scene_named("vise.json");
    const Result whole = analyze(scene, {}), cut = analyze(scene, without_memory_from(4));
    ASSERT_GE(whole.passes.size(), 4u);
    ASSERT_EQ(cut.status, "ok") << cut.message;
    EXPECT_FALSE(cut.accuracy.reached);
    EXPECT_NE(cut.accuracy.why.find("more memory than there is"), std::string::npos) << cut.accuracy.why;
    ASSERT_FALSE(cut.reasons.empty());
    EXPECT_EQ(cut.reasons[0].kind, "accuracy");
    // the same grids, and the same answer on them
    ASSERT_EQ(cut.passes.size(), 3u);
    EXPECT_EQ(cut.passes[2].unknowns, whole.passes[2].unknowns);
    // and the end knows what the parts' stiffness misses, besides
    ASSERT_TRUE(cut.accuracy.estimate && whole.passes[2].estimated_error);
    EXPECT_GE(*cut.accuracy.estimate, *whole.passes[2].estimated_error);
    EXPECT_LT(*cut.accuracy.estimate, 1.1 * *whole.passes[2].estimated_error);
    EXPECT_FALSE(cut.fields.empty());
}

TEST(FailedPass, TheFirstPassesFailAsAWhole) {
    const Scene scene = scene_named("vise.json");
    EXPECT_THROW(analyze(scene, without_memory_from(1)), std::bad_alloc);
    EXPECT_THROW(analyze(scene, without_memory_from(2)), std::bad_alloc);  // of the first nobody knows the error
}

TEST(FailedPass, CasesEndOnTheSameGrids) {
    const Scene scene = scene_named("pin_bracket_cases.json");
    const std::vector<CaseResult> cut = analyze_cases(scene, without_memory_from(4));
    for (const CaseResult& c : cut) {
        ASSERT_EQ(c.result.status, "ok") << c.result.message;
        EXPECT_EQ(c.result.passes.size(), 3u);
        EXPECT_EQ(c.result.passes.back().unknowns, cut[0].result.passes.back().unknowns);
        EXPECT_FALSE(c.result.fields.empty());
    }
    EXPECT_NE(cut[0].result.accuracy.why.find("more memory than there is"), std::string::npos);
}

TEST(FailedPass, GridsAndNumbersFailButMechanicsAreTheAnswer) {
    EXPECT_EQ(failed_by([](SolvedAssembly& s) { s.failure = "no basis"; }), "no basis");
    EXPECT_EQ(failed_by([](SolvedAssembly& s) { s.solution.converged = false; }), "the contact iterations did not converge");
    EXPECT_EQ(failed_by([](SolvedAssembly& s) {
                  for (Eigen::VectorXd& u : s.solution.displacement) u.array() *= std::numeric_limits<double>::quiet_NaN();
              }).substr(0, 16),
              "the solution of ");
    EXPECT_EQ(failed_by([](SolvedAssembly&) {}), "");
    EXPECT_EQ(failed_by([](SolvedAssembly& s) { s.solution.mechanism.push_back({}); }), "");
    EXPECT_EQ(failed_by([](SolvedAssembly& s) {
                  s.failure = "tightening moves part a";
                  s.is_lost = true;
              }),
              "");
    EXPECT_EQ(failed_by([](SolvedAssembly& s) { s.solution.displacement[0].array() += 100; }), "");  // farther than its size
}

namespace {

/// A block on a table, turned by an angle, pressed by a force at a distance from its middle; half of it is 20 wide.
Result pressed_beside_its_middle(double distance, double angle) {
    const auto turned = [=](double x, double y) {
        return "[" + std::to_string(x * std::cos(angle) - y * std::sin(angle)) + ", " +
               std::to_string(x * std::sin(angle) + y * std::cos(angle)) + "]";
    };
    const auto rectangle = [&](double x0, double y0, double x1, double y1) {
        return R"({"polygon": [)" + turned(x0, y0) + ", " + turned(x1, y0) + ", " + turned(x1, y1) + ", " + turned(x0, y1) +
               "]}";
    };
    return analyze(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [
        {"name": "table", "material": "m", "geometry": )" +
                                       rectangle(-150, -30, 150, 0) + R"(},
        {"name": "block", "material": "m", "geometry": )" +
                                       rectangle(-20, 0, 20, 30) + R"(}],
        "supports": [{"on": "table/e0", "fix": ["x", "y"]}],
        "loads": [{"on": "block/e2", "force": )" +
                                       turned(0, -1000) + R"(, "at": )" + turned(distance, 30) + R"(}],
        "contacts": {"friction": 0.5}, "accuracy": {"level": "draft"}})",
                                   "scene.json"),
                   {});
}

}  // namespace

/// First cells whose last pressure has its middle farther in do not tell that a part tips.
TEST(FailedPass, OfPartsThatSeemToTipIsFollowedByCellsThatTell) {
    for (const double angle : {0.0, 0.3})
        for (const double distance : {18.5, 19.5, 19.9}) {
            const Result r = pressed_beside_its_middle(distance, angle);
            EXPECT_EQ(r.status, "ok") << distance << " " << angle << ": " << r.message;
        }
    const Result tips = pressed_beside_its_middle(20.1, 0);
    EXPECT_EQ(tips.status, "failed");
    ASSERT_FALSE(tips.driven.empty());
    const Screw& twist = tips.driven.front().twist;
    EXPECT_NEAR(-twist[1] / twist[2], 20, 0.05) << "about its corner";
}

/// A clamped bar that grows against a wall it sticks to: on some cells there is no state of sticking and slipping.
TEST(FailedPass, AStateOfFrictionThatIsNotFoundIsLookedForOnOtherCells) {
    double finest = 0;
    for (const char* level : {"fine", "standard", "draft"}) {
        const Result r = test::answer(R"({"abut": 1, "analysis": "plane_stress", "thickness": 10, "materials": {
            "steel": {"E": 210000, "nu": 0.3}, "alu": {"E": 70000, "nu": 0.33, "expansion": 2.3e-05}}, "parts": [
            {"name": "bar", "material": "alu", "geometry": {"rectangle": {"min": [0, 0], "max": [50, 8]}}},
            {"name": "wall", "material": "steel", "geometry": {"rectangle": {"min": [50, -10], "max": [70, 20]}}}],
            "supports": [{"on": "bar/left", "fix": ["x", "y"]}, {"on": "wall/right", "fix": ["x", "y"]}],
            "loads": [{"part": "bar", "temperature": 50}], "contacts": {"friction": 0.3}, "accuracy": {"level": ")" +
                                      std::string(level) + R"("}})");
        ASSERT_EQ(r.status, "ok") << level << r.message;
        const double force = r.contacts.at(0).force.norm();
        if (finest == 0) finest = force;
        EXPECT_NEAR(force, finest, 0.003 * finest) << level;
    }
}

}  // namespace abut::failed_pass_test
