// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of effects: on where the scene calls for it, and off without a trace in the answer.
#include "src/plan/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "tests/src/analysis/plate_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::plan_test {
namespace {

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
    EXPECT_EQ(names,
              (Names{"elasticity", "contact", "rigid parts", "edge loads", "body force", "gravity", "rigid supports",
                     "held points", "interference", "bonding", "friction", "springs", "temperature", "preload", "spin", "incompressibility"}));
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

}  // namespace
}  // namespace abut::plan_test
