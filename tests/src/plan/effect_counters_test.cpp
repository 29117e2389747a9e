// SPDX-License-Identifier: GPL-3.0-or-later
// The plan's parts and pairs, what each effect did, and that nothing of what is off was entered; groups of parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include "src/plan/plan.hpp"
#include "src/scene/load_cases.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/src/analysis/plate_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::effect_counters_test {
namespace {

const Effect& effect_named(const Result& r, const std::string& name) {
    return *std::find_if(r.effects.begin(), r.effects.end(), [&](const Effect& e) { return e.name == name; });
}

TEST(PlanOfTheRun, KnowsPartsAndPairsBefore) {
    const Scene scene = scene_of({.more_parts = next_block + ", " + R"({"name": "far", "material": "m",
        "geometry": {"rectangle": {"min": [100, 0], "max": [101, 1]}}})",
                                  .more_loads = R"(, {"part": "block", "body_force": [1, 0]})"});
    using Pairs = std::vector<std::array<std::string, 2>>;
    std::map<std::string, Effect> plan;
    for (const Effect& e : plan_effects(scene, resolve_conditions(scene))) plan[e.name] = e;
    EXPECT_EQ(plan["contact"].pairs, (Pairs{{"plate", "block"}}));
    EXPECT_EQ(plan["contact"].parts, (std::vector<std::string>{"plate", "block"}));
    EXPECT_EQ(plan["edge loads"].parts, std::vector<std::string>{"plate"});
    EXPECT_EQ(plan["body force"].parts, std::vector<std::string>{"block"});
    EXPECT_EQ(plan["elasticity"].parts, (std::vector<std::string>{"plate", "block", "far"}));
    EXPECT_TRUE(plan["gravity"].parts.empty());
    const Scene given = scene_of(
        {.more_parts = next_block, .contacts = R"({"detect": false, "pairs": [{"between": ["plate/right", "block/left"],
                                                  "kind": "bonded"}]})"});
    for (const Effect& e : plan_effects(given, resolve_conditions(given)))
        if (e.name == "bonding") { EXPECT_EQ(e.pairs, (Pairs{{"plate", "block"}})); }
}

TEST(PlanOfTheRun, CountsWhatEachEffectDid) {
    const Result r = test::answer(
        scene_text({.more_parts = next_block, .more_loads = R"(, {"gravity": [0, -1]})", .more_supports = hold_block}));
    ASSERT_EQ(r.status, "ok") << r.message;
    double share = 0;
    for (const Effect& e : r.effects) share += e.share;
    EXPECT_GT(share, 0.05);
    EXPECT_LE(share, 1 + 1.0);  // two parts side by side add up
    for (const char* name : {"elasticity", "contact", "edge loads", "gravity"}) {
        EXPECT_GT(effect_named(r, name).seconds, 0) << name;
        EXPECT_GT(effect_named(r, name).items, 0) << name;
    }
    EXPECT_EQ(effect_named(r, "contact").pairs.size(), 1u);
}

/// The plan is made from the scene, the counters by the code: no effect that is off has been entered, in any scene of ours.
TEST(PlanOfTheRun, WhatIsOffIsNotEntered) {
    int scenes = 0, off = 0, used = 0;
    for (const char* folder : {"/data/scenes", "/data/verification"})
        for (const auto& entry : std::filesystem::directory_iterator(std::string(ABUT_SOURCE_DIR) + folder)) {
            if (entry.path().extension() != ".json") continue;
            Scene scene = read_scene(entry.path().string());
            if (!scene.cases.empty()) scene = scene_of_case(scene, scene.cases.back());
            scene.accuracy.level = "draft";
            scene.accuracy.target.reset();
            scene.accuracy.adapt = false;  // one solution is enough to enter what will be entered
            const Result r = analyze(scene, {});
            ++scenes;
            for (const Effect& e : r.effects) {
                if (e.on && e.items > 0) ++used;
                if (e.on) continue;
                ++off;
                EXPECT_EQ(e.seconds, 0) << entry.path() << " " << e.name;
                EXPECT_EQ(e.share, 0) << entry.path() << " " << e.name;
                EXPECT_EQ(e.items, 0) << entry.path() << " " << e.name;
                EXPECT_TRUE(e.parts.empty() && e.pairs.empty()) << entry.path() << " " << e.name;
            }
        }
    EXPECT_GT(scenes, 40);
    EXPECT_GT(off, 8 * scenes);
    EXPECT_GT(used, 2 * scenes);
}

// Groups of parts that do not interact, and problems without unilateral pairs

/// Two columns of two blocks, the second one stiffer and far from the first; either may be left out.
std::string columns(bool first, bool second, const std::string& more = {}) {
    std::string parts, supports, loads;
    const auto add = [&](const std::string& name, const std::string& x0, const std::string& x1, const std::string& pressure) {
        const auto block = [&](const std::string& which, const std::string& y0, const std::string& y1) {
            return R"({"name": ")" + name + which + R"(", "material": ")" + name + R"(", "geometry": {"rectangle": {"min": [)" +
                   x0 + ", " + y0 + "], \"max\": [" + x1 + ", " + y1 + "]}}}";
        };
        const std::string comma = parts.empty() ? "" : ", ";
        parts += comma + block("low", "0", "1") + ", " + block("high", "1", "2");
        supports += comma + R"({"on": ")" + name + R"(low/bottom", "fix": ["x", "y"]})";
        loads += comma + R"({"on": ")" + name + R"(high/top", "pressure": ")" + pressure + R"("})";
    };
    if (first) add("a", "0", "2", "10 + x");
    if (second) add("b", "50", "52", "700 + (x - 50)");
    return R"({"abut": 1, "materials": {"a": {"E": 1e5, "nu": 0.3}, "b": {"E": 3e6, "nu": 0.2}}, "parts": [)" + parts +
           R"(], "supports": [)" + supports + R"(], "loads": [)" + loads + R"(], "accuracy": {"cell_size": 0.11})" + more + "}";
}

TEST(Groups, AreSolvedAsIfTheyWereAlone) {
    const Result both = test::answer(columns(true, true)), a = test::answer(columns(true, false)),
                 b = test::answer(columns(false, true));
    for (const Result* r : {&both, &a, &b}) ASSERT_EQ(r->status, "ok") << r->message;
    EXPECT_EQ(both.solver.groups, 2);
    EXPECT_EQ(both.solver.contact_problems, 2);
    EXPECT_EQ(a.solver.groups, 1);
    const auto compare = [&](const Result& alone, std::size_t contact, std::size_t part) {
        const ContactResult &x = both.contacts.at(contact), &y = alone.contacts.at(0);
        EXPECT_EQ(x.force, y.force);
        EXPECT_EQ(x.max_pressure.value, y.max_pressure.value);
        EXPECT_EQ(x.profile.pressure, y.profile.pressure);
        EXPECT_EQ(x.profile.gap, y.profile.gap);
        ASSERT_GT(x.profile.pressure.size(), 20u);
        for (std::size_t k : {std::size_t{0}, std::size_t{1}}) {
            EXPECT_EQ(both.parts[part + k].max_displacement.value, alone.parts[k].max_displacement.value);
            EXPECT_EQ(both.parts[part + k].max_von_mises.value, alone.parts[k].max_von_mises.value);
        }
    };
    compare(a, 0, 0);
    compare(b, 1, 2);
}

TEST(Groups, WithoutUnilateralPairsThereIsOneLinearSolution) {
    const std::string bonded = R"(, "contacts": {"pairs": [{"between": ["alow/top", "ahigh/bottom"], "kind": "bonded"}]})";
    const Result r = test::answer(columns(true, false, bonded)), contact = test::answer(columns(true, false));
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_EQ(r.solver.contact_problems, 0);
    EXPECT_EQ(r.solver.contact_iterations, 0);
    EXPECT_GT(r.multipliers, 0);
    EXPECT_LT(r.equilibrium.relative_residual, 1e-9);
    EXPECT_GT(contact.solver.contact_iterations, 0);
    EXPECT_EQ(contact.solver.contact_problems, 1);
}

}  // namespace
}  // namespace abut::effect_counters_test
