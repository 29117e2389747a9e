// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of effects: on where the scene calls for it, and off without a trace in the answer.
#include "src/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/src/temporary_folder.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut {
namespace {

/// A plate held at its bottom and pressed on its top, and what a test adds to it.
struct Variation {
    std::string more_parts = {}, more_loads = {}, more_supports = {}, contacts = {};
    std::string hold = R"({"on": "plate/bottom", "fix": ["x", "y"]})";
    bool plate_last = false;
};

std::string scene_text(const Variation& v) {
    const std::string plate =
        R"({"name": "plate", "material": "m", "geometry": {"difference": [{"rectangle": {"min": [0, 0], "max": [4, 2]}},
                                                                          {"circle": {"center": [2.1, 0.9], "radius": 0.4}}]}})";
    const std::string parts =
        v.more_parts.empty() ? plate : (v.plate_last ? v.more_parts + ", " + plate : plate + ", " + v.more_parts);
    return R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3, "density": 1e-3}}, "parts": [)" + parts +
           R"(], "supports": [)" + v.hold + v.more_supports + R"(], "loads": [{"on": "plate/top", "pressure": "10 + x"})" +
           v.more_loads + "]" + (v.contacts.empty() ? "" : R"(, "contacts": )" + v.contacts) +
           R"(, "output": {"probes": [{"part": "plate", "at": [1, 1.5]}, {"part": "plate", "at": [2.1, 1.4]}]}})";
}

/// Too far from the plate to be found, or lying on it.
const std::string far_block =
    R"({"name": "block", "material": "m", "geometry": {"rectangle": {"min": [100, 0], "max": [101, 1]}}})";
const std::string next_block =
    R"({"name": "block", "material": "m", "geometry": {"rectangle": {"min": [4, 0], "max": [5, 1]}}})";
const std::string hold_block = R"(, {"on": "block/right", "fix": ["x", "y"]})";

Scene scene_of(const Variation& v) {
    const TemporaryFolder folder;
    return read_scene(folder.write("scene.json", scene_text(v)));
}

std::set<std::string> effects_on(const Variation& v) {
    std::set<std::string> names;
    for (const Effect& e : plan_effects(scene_of(v)))
        if (e.on && e.name != "elasticity") names.insert(e.name);
    return names;
}

using Names = std::set<std::string>;

TEST(Plan, APlateUnderPressureNeedsEdgeLoadsOnly) {
    EXPECT_EQ(effects_on({}), Names{"edge loads"});
    EXPECT_EQ(effects_on({.more_loads = R"(, {"on": "plate/left", "traction": [1, 0]})"}), Names{"edge loads"});
    EXPECT_EQ(effects_on({.more_loads = R"(, {"on": "plate/left", "force": [1, 0]})"}), Names{"edge loads"});
}

TEST(Plan, EachLoadTurnsOnItsOwnEffect) {
    EXPECT_EQ(effects_on({.more_loads = R"(, {"part": "plate", "body_force": [1, 0]})"}), (Names{"edge loads", "body force"}));
    EXPECT_EQ(effects_on({.more_loads = R"(, {"part": "plate", "force": [1, 0]})"}), (Names{"edge loads", "body force"}));
    EXPECT_EQ(effects_on({.more_loads = R"(, {"gravity": [0, -9.81]})"}), (Names{"edge loads", "gravity"}));
}

TEST(Plan, ARigidSupportIsAnEffect) {
    EXPECT_EQ(effects_on({.hold = R"({"part": "plate", "rigid": {"translation": [0, 0], "rotation": 0}})"}),
              (Names{"edge loads", "rigid supports"}));
}

TEST(Plan, ContactNeedsTwoPartsAndAPairToSearch) {
    EXPECT_EQ(effects_on({.more_parts = far_block}), (Names{"edge loads", "contact"}));
    EXPECT_EQ(effects_on({.more_parts = far_block, .contacts = R"({"detect": false})"}), Names{"edge loads"});
    EXPECT_EQ(effects_on({.more_parts = far_block,
                          .contacts = R"({"detect": false, "pairs": [{"between": ["plate/*", "block/*"]}]})"}),
              (Names{"edge loads", "contact"}));
    EXPECT_EQ(effects_on({.contacts = R"({"detect": true})"}), Names{"edge loads"});
}

TEST(Plan, InterferenceIsOnWhereGapsAreClosed) {
    EXPECT_EQ(effects_on({.more_parts = next_block,
                          .contacts = R"({"pairs": [{"between": ["plate/right", "block/left"], "interference": 0.01}]})"}),
              (Names{"edge loads", "contact", "interference"}));
    EXPECT_EQ(effects_on({.more_parts = next_block,
                          .contacts = R"({"pairs": [{"between": ["plate/right", "block/left"], "interference": 0}]})"}),
              (Names{"edge loads", "contact"}));
    EXPECT_EQ(effects_on({.more_parts = next_block, .contacts = R"({"overlap": "press_fit"})"}),
              (Names{"edge loads", "contact", "interference"}));
}

TEST(Plan, SaysWhyOfEveryEffect) {
    Names names;
    for (const Effect& e : plan_effects(scene_of({}))) {
        EXPECT_FALSE(e.why.empty()) << e.name;
        EXPECT_TRUE(names.insert(e.name).second) << e.name << " twice";
    }
    EXPECT_EQ(names, (Names{"elasticity", "contact", "rigid parts", "edge loads", "body force", "gravity", "rigid supports",
                            "interference", "bonding", "friction", "springs", "temperature", "spin", "incompressibility",
                            "symmetry", "large displacement"}));
}

TEST(Plan, IncompressibilityIsForPlaneStrainNearAHalf) {
    const auto is_on = [](Analysis analysis, double nu) {
        Scene scene = scene_of({});
        scene.analysis = analysis;
        scene.materials.at(0).nu = nu;
        const std::vector<Effect> effects = plan_effects(scene);
        return std::find_if(effects.begin(), effects.end(), [](const Effect& e) { return e.name == "incompressibility"; })->on;
    };
    EXPECT_TRUE(is_on(Analysis::plane_strain, 0.4999));
    EXPECT_TRUE(is_on(Analysis::plane_strain, projection_from));
    EXPECT_FALSE(is_on(Analysis::plane_strain, std::nextafter(projection_from, 0.0)));
    EXPECT_FALSE(is_on(Analysis::plane_stress, 0.4999));
}

// Which parts are solved

TEST(Plan, ALoadReachesWhatItsPartTouches) {
    const Variation v{.more_parts =
                          far_block +
                          R"(, {"name": "c", "material": "m", "geometry": {"rectangle": {"min": [200, 0], "max": [201, 1]}}},
                                                   {"name": "d", "material": "m", "geometry": {"rectangle": {"min": [300, 0], "max": [301, 1]}}})"};
    const Scene scene = scene_of(v);
    EXPECT_EQ(parts_to_solve(scene, resolve_conditions(scene), {}), (std::vector<bool>{true, false, false, false}));
    EXPECT_EQ(parts_to_solve(scene, resolve_conditions(scene), {{0, 1}}), (std::vector<bool>{true, true, false, false}));
    EXPECT_EQ(parts_to_solve(scene, resolve_conditions(scene), {{1, 2}, {0, 1}}), (std::vector<bool>{true, true, true, false}));
    EXPECT_EQ(parts_to_solve(scene, resolve_conditions(scene), {{1, 2}, {2, 3}}),
              (std::vector<bool>{true, false, false, false}));
}

TEST(Plan, WhatActsOnAPartMakesItSolved) {
    const auto solved = [](const Variation& v) {
        const Scene varied = scene_of(v);
        return parts_to_solve(varied, resolve_conditions(varied), {});
    };
    const std::vector<bool> both{true, true};
    EXPECT_EQ(solved({.more_parts = far_block, .more_loads = R"(, {"part": "block", "body_force": [1, 0]})"}), both);
    EXPECT_EQ(solved({.more_parts = far_block, .more_loads = R"(, {"part": "*", "body_force": [1, 0]})"}), both);
    EXPECT_EQ(solved({.more_parts = far_block, .more_loads = R"(, {"gravity": [0, -1]})"}), both);
    EXPECT_EQ(solved({.more_parts = far_block, .more_supports = R"(, {"on": "block/left", "displacement": {"x": 0.1}})"}),
              both);
    EXPECT_EQ(solved({.more_parts = far_block,
                      .more_supports = R"(, {"part": "block", "rigid": {"translation": [0.1, 0], "rotation": 0}})"}),
              both);
    EXPECT_EQ(solved({.more_parts = far_block,
                      .more_supports = R"(, {"part": "block", "rigid": {"translation": [0, 0], "rotation": 0}})"}),
              (std::vector<bool>{true, false}));
}

const PartResult& part_named(const Result& r, const std::string& name) {
    return *std::find_if(r.parts.begin(), r.parts.end(), [&](const PartResult& p) { return p.name == name; });
}

std::size_t index_of(const Result& r, const std::string& name) {
    return static_cast<std::size_t>(&part_named(r, name) - r.parts.data());
}

/// Every number that an answer gives about one part: displacements, stresses, reactions, energy.
std::vector<double> numbers_of(const Result& r, const std::string& part) {
    std::vector<double> v{r.strain_energy, r.equilibrium.applied.x(), r.equilibrium.applied.y()};
    const auto append = [&](const FieldSample& s) {
        v.insert(v.end(), {s.at.x(), s.at.y(), s.displacement.x(), s.displacement.y(), s.stress.xx, s.stress.yy, s.stress.xy,
                           s.stress.zz});
    };
    const PartResult& p = part_named(r, part);
    v.insert(v.end(), {p.max_displacement.value, p.max_von_mises.value});
    const PartField& field = r.fields[index_of(r, part)];
    for (const FieldSample& s : field.samples) append(s);
    for (const auto& loop : field.boundary)
        for (const FieldSample& s : loop) append(s);
    for (const ProbeResult& s : r.probes)
        if (s.part == part) append({s.at, s.displacement, s.stress});
    for (const Reaction& s : r.reactions)
        if (s.label.find(part) != std::string::npos) v.insert(v.end(), {s.force.x(), s.force.y()});
    return v;
}

/// How many numbers differ in any bit; all of them where there are not equally many.
std::size_t differing(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) return std::max(a.size(), b.size());
    std::size_t n = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!(a[i] == b[i]) || std::signbit(a[i]) != std::signbit(b[i])) ++n;
    return n;
}

TEST(IdleParts, TheComparisonSeesTheLastBit) {
    const Result r = test::answer(scene_text({}));
    ASSERT_EQ(r.status, "ok") << r.message;
    const std::vector<double> v = numbers_of(r, "plate");
    ASSERT_GT(v.size(), 1000u);
    EXPECT_GT(std::count_if(v.begin(), v.end(), [](double x) { return x != 0; }), 1000);
    for (std::size_t i : {std::size_t{0}, v.size() / 2, v.size() - 1}) {
        std::vector<double> w = v;
        w[i] = std::nextafter(w[i], std::numeric_limits<double>::infinity());
        EXPECT_EQ(differing(v, w), 1u);
    }
    EXPECT_EQ(differing(v, {v.begin(), v.end() - 1}), v.size());
}

TEST(IdleParts, AreNotSolvedAndLeaveNoTrace) {
    const Result alone = test::answer(scene_text({}));
    ASSERT_EQ(alone.status, "ok") << alone.message;
    const Variation variations[] = {
        {.more_parts = far_block},
        {.more_parts = far_block, .plate_last = true},
        {.more_parts = far_block, .more_supports = hold_block},
        {.more_parts = next_block, .contacts = R"({"detect": false})"},
        {.more_parts = next_block, .contacts = R"({"pairs": [{"between": ["plate/*", "block/*"], "kind": "ignore"}]})"},
    };
    for (std::size_t k = 0; k < std::size(variations); ++k) {
        const Result r = test::answer(scene_text(variations[k]));
        ASSERT_EQ(r.status, "ok") << k << ": " << r.message;
        ASSERT_EQ(r.parts.size(), 2u);
        const PartResult &idle = part_named(r, "block"), &plate = part_named(r, "plate");
        EXPECT_FALSE(idle.solved) << k;
        EXPECT_EQ(idle.unknowns, 0) << k;
        EXPECT_EQ(idle.cells_inner + idle.cells_boundary + idle.cells_outer, 0) << k;
        EXPECT_TRUE(r.fields[index_of(r, "block")].samples.empty()) << k;
        EXPECT_TRUE(plate.solved) << k;
        EXPECT_EQ(plate.unknowns, alone.unknowns) << k;
        EXPECT_EQ(r.unknowns, alone.unknowns) << k;
        EXPECT_EQ(r.cells, alone.cells) << k;
        EXPECT_EQ(r.multipliers, 0) << k;
        EXPECT_EQ(r.solver.factorizations, alone.solver.factorizations) << k;
        EXPECT_TRUE(r.contacts.empty()) << k;
        EXPECT_EQ(differing(numbers_of(r, "plate"), numbers_of(alone, "plate")), 0u) << k;
    }
}

/// The other way round: a part that touches the loaded one is solved, and the plate's answer is another one.
TEST(IdleParts, ANeighbourIsNotIdle) {
    const Result alone = test::answer(scene_text({})),
                 r = test::answer(scene_text({.more_parts = next_block, .more_supports = hold_block}));
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_TRUE(part_named(r, "block").solved);
    EXPECT_GT(part_named(r, "block").unknowns, 0);
    EXPECT_GT(r.multipliers, 0);
    EXPECT_GT(differing(numbers_of(r, "plate"), numbers_of(alone, "plate")), 0u);
}

TEST(IdleParts, EffectsThatAreOffHaveZeroCounters) {
    const Result r = test::answer(scene_text({}));
    EXPECT_EQ(r.multipliers, 0);
    EXPECT_TRUE(r.contacts.empty());
    EXPECT_EQ(r.solver.factorizations, r.solver.grids);  // one part, and one linear solution a grid
    for (const Effect& e : r.effects) {
        if (!e.on) { EXPECT_EQ(e.seconds, 0) << e.name; }
    }
}

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
    EXPECT_EQ(effect_named(r, "elasticity").calls, r.solver.factorizations);
    EXPECT_EQ(effect_named(r, "gravity").calls, r.solver.factorizations);
    EXPECT_EQ(effect_named(r, "edge loads").calls, r.solver.grids);  // of one part only
    EXPECT_EQ(effect_named(r, "contact").pairs.size(), 1u);
}

/// The plan is made from the scene, the counters by the code: no effect that is off has been entered, in any scene of ours.
TEST(PlanOfTheRun, WhatIsOffIsNotEntered) {
    int scenes = 0, off = 0, used = 0;
    for (const char* folder : {"/data/scenes", "/data/verification"})
        for (const auto& entry : std::filesystem::directory_iterator(std::string(ABUT_SOURCE_DIR) + folder)) {
            if (entry.path().extension() != ".json") continue;
            Scene scene = read_scene(entry.path().string());
            scene.accuracy.level = "draft";
            scene.accuracy.target.reset();
            scene.accuracy.adapt = false;  // one solution is enough to enter what will be entered
            const Result r = analyze(scene, {});
            ++scenes;
            for (const Effect& e : r.effects) {
                if (e.on && e.calls + e.items > 0) ++used;
                if (e.on) continue;
                ++off;
                EXPECT_EQ(e.seconds, 0) << entry.path() << " " << e.name;
                EXPECT_EQ(e.share, 0) << entry.path() << " " << e.name;
                EXPECT_EQ(e.calls, 0) << entry.path() << " " << e.name;
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
}  // namespace abut
