// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid parts: the limit of stiff ones, without unknowns; what holds them, what they press on, and what they cannot do.
#include "src/plan/rigid_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/brep/input_error.hpp"
#include "src/analysis/analysis.hpp"
#include "src/plan/plan.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::rigid_parts_test {
namespace {

/// A block held at its bottom, and a narrower punch on it.
struct Punch {
    std::string material = "rigid", E = "1e5";
    std::string hold = R"({"on": "punch/left", "symmetry": true})";
    std::string load = R"({"on": "punch/top", "pressure": 10})";
    std::string more_parts = {};
};

std::string text_of(const Punch& p) {
    return R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}, "stiff": {"E": )" + p.E +
           R"(, "nu": 0.3}}, "parts": [
      {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [4, 2]}}},
      {"name": "punch", "material": ")" +
           p.material + R"(", "geometry": {"rectangle": {"min": [1, 2], "max": [3, 3]}}})" + p.more_parts +
           R"(], "supports": [{"on": "block/bottom", "fix": ["x", "y"]})" + (p.hold.empty() ? "" : ", " + p.hold) +
           R"(], "loads": [)" + p.load + R"(], "accuracy": {"cell_size": 0.125},
      "output": {"probes": [{"part": "block", "at": [2, 1.5]}, {"part": "punch", "at": [1, 3]}, {"part": "punch", "at": [3, 2.5]}]}})";
}

Result answer(const Punch& p) {
    return analyze(read_scene_text(text_of(p), "scene.json"), {});
}

std::string first_problem(const Punch& p) {
    try {
        answer(p);
    } catch (const InputError& error) { return error.problems().at(0).where + " " + error.problems().at(0).what; }
    return "none";
}

TEST(RigidParts, CarryNoUnknownsAndNoStress) {
    const Result r = answer({});
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_TRUE(r.parts[1].rigid);
    EXPECT_FALSE(r.parts[0].rigid);
    EXPECT_TRUE(r.parts[1].solved);
    EXPECT_EQ(r.parts[1].unknowns, 0);
    EXPECT_EQ(r.unknowns, r.parts[0].unknowns);
    EXPECT_EQ(r.parts[1].max_von_mises.value, 0);
    EXPECT_EQ(r.solver.factorizations, 1);
    EXPECT_FALSE(r.fields[1].boundary.empty());
    const auto effect =
        std::find_if(r.effects.begin(), r.effects.end(), [](const Effect& e) { return e.name == "rigid parts"; });
    ASSERT_NE(effect, r.effects.end());
    EXPECT_TRUE(effect->on);
    EXPECT_EQ(effect->parts, std::vector<std::string>{"punch"});
    EXPECT_EQ(effect->items, 1);
}

TEST(RigidParts, PressWithTheWholeLoad) {
    const Result r = answer({});
    ASSERT_EQ(r.contacts.size(), 1U);
    EXPECT_NEAR(r.contacts[0].force.y(), -20, 1e-9);
    EXPECT_LT(r.equilibrium.relative_residual, 1e-9);
    EXPECT_LT(r.equilibrium.relative_moment_residual, 1e-9);
}

TEST(RigidParts, MoveAsOneBody) {
    const Result r = answer({.hold = R"({"part": "punch", "rigid": {"translation": [0, null], "rotation": null}})",
                             .load = R"({"on": {"part": "punch", "box": [[1, 2.9], [2.5, 3.1]]}, "pressure": 10})"});
    ASSERT_EQ(r.status, "ok") << r.message;
    const Vec2 a = r.probes[1].displacement, b = r.probes[2].displacement, arm(2, -0.5);
    const double turn = (b.y() - a.y()) / arm.x();
    EXPECT_GT(std::abs(turn), 1e-6);
    EXPECT_NEAR(b.x() - a.x(), -turn * arm.y(), 1e-12 * std::abs(turn));
    EXPECT_NEAR(0.5 * (a.x() + b.x()) + turn * (2.75 - 2.5), 0, 1e-9 * std::abs(turn));  // the centroid stays at x = 2
}

/// The difference to an elastic punch falls with its compliance.
TEST(RigidParts, AreTheLimitOfStiffOnes) {
    const Result rigid = answer({});
    double last = 1;
    for (const char* E : {"1e7", "1e9", "1e11"}) {
        const Result stiff = answer({.material = "stiff", .E = E});
        ASSERT_EQ(stiff.status, "ok") << stiff.message;
        ASSERT_FALSE(stiff.parts[1].rigid);
        const double difference = std::abs(stiff.probes[0].displacement.y() / rigid.probes[0].displacement.y() - 1);
        EXPECT_LT(difference, 0.2 * last) << E;
        last = difference;
    }
    EXPECT_LT(last, 1e-5);
}

TEST(RigidParts, AStiffEnoughPartIsTakenAsOne) {
    const Result rigid = answer({}), stiff = answer({.material = "stiff", .E = "1.01e11"}),
                 softer = answer({.material = "stiff", .E = "0.99e11"});
    EXPECT_TRUE(stiff.parts[1].rigid);
    EXPECT_FALSE(softer.parts[1].rigid);
    EXPECT_EQ(stiff.probes[0].displacement, rigid.probes[0].displacement);
    EXPECT_EQ(stiff.contacts[0].max_pressure.value, rigid.contacts[0].max_pressure.value);
}

/// Stiff enough, but its own loads bend it between its supports, or its temperature makes it grow.
TEST(RigidParts, APartThatDeformsByItselfIsNotTakenAsOne) {
    const auto strip = [](const std::string& held, const std::string& loads) {
        return test::answer(
            R"({"abut": 1, "materials": {"steel": {"E": 2e5, "nu": 0.3, "expansion": 1e-5}, "foam": {"E": 0.1, "nu": 0.3}},
            "parts": [{"name": "strip", "material": "steel", "geometry": {"rectangle": {"min": [0, 0], "max": [40, 2]}}},
                      {"name": "pad", "material": "foam", "geometry": {"rectangle": {"min": [10, -5], "max": [30, 0]}}}],
            "supports": [{"on": "pad/bottom", "fix": ["x", "y"]}, )" +
            held + R"(], "loads": [)" + loads + R"(], "accuracy": {"level": "draft"}})");
    };
    const std::string ends = R"({"on": ["strip/left", "strip/right"], "fix": ["x", "y"]})";
    EXPECT_FALSE(strip(ends, R"({"on": "strip/top", "pressure": 1})").parts[0].rigid);
    EXPECT_FALSE(strip(R"({"on": "strip/left", "symmetry": true})", R"({"part": "strip", "temperature": 100})").parts[0].rigid);
    const Result pushed = strip(R"({"part": "strip", "rigid": {"translation": [0, null], "rotation": 0}})",
                                R"({"on": "strip/top", "pressure": 1e-4})");
    ASSERT_EQ(pushed.status, "ok") << pushed.message;
    EXPECT_TRUE(pushed.parts[0].rigid);
    EXPECT_TRUE(std::any_of(pushed.warnings.begin(), pushed.warnings.end(),
                            [](const std::string& w) { return w.find("computed as a rigid body") != std::string::npos; }));
}

TEST(RigidParts, FollowWhatIsPrescribed) {
    const Result r = answer({.hold = R"({"on": "punch/top", "displacement": {"x": 0, "y": "-0.001 - 0.0002*x + 0.0004"}})",
                             .load = R"({"on": "block/left", "pressure": 0})"});
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_NEAR(r.probes[1].displacement.y(), -0.0008, 1e-15);
    EXPECT_NEAR(r.probes[2].displacement.y(), -0.0012, 1e-15);
    ASSERT_EQ(r.reactions.size(), 2U);
    EXPECT_NEAR(r.reactions[1].force.y(), r.contacts[0].force.y(), 1e-9 * std::abs(r.contacts[0].force.y()));
    EXPECT_EQ(r.reactions[1].method, "rigid");
}

TEST(RigidParts, SeveralSupportsBalanceTheLoads) {
    const Result r = answer({.hold = R"({"on": "punch/left", "fix": ["x", "y"]}, {"on": "punch/right", "fix": ["x", "y"]})"});
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.reactions.size(), 3U);
    EXPECT_NEAR(r.reactions[1].force.y(), 10, 1e-9);  // half of what no contact takes: the punch does not move
    EXPECT_NEAR(r.reactions[2].force.y(), 10, 1e-9);
    EXPECT_LT(r.equilibrium.relative_moment_residual, 1e-9);
}

TEST(RigidParts, SayWhatTheyCannotDo) {
    EXPECT_NE(first_problem({.hold = R"({"on": "punch/top", "displacement": {"y": "-0.001*x^2"}})"})
                  .find("/supports/1 the supports of the rigid part punch prescribe displacements that no rigid motion has"),
              std::string::npos);
}

/// A bar on an even bed of springs sinks, slides and turns; the load acts beside it.
TEST(RigidParts, RestOnSprings) {
    const Result r = answer(
        {.hold = R"({"on": "punch/left", "symmetry": true}, {"on": "bar/bottom", "spring": {"normal": 50, "tangential": 20}})",
         .load = R"({"on": "punch/top", "pressure": 10}, {"on": "bar/top", "force": [3, -10], "at": [12, 2]})",
         .more_parts =
             R"(, {"name": "bar", "material": "rigid", "geometry": {"rectangle": {"min": [10, 0], "max": [20, 1]}}})"});
    ASSERT_EQ(r.status, "ok") << r.message;
    const auto bar =
        std::find_if(r.reactions.begin(), r.reactions.end(), [](const Reaction& x) { return x.method == "spring"; });
    ASSERT_NE(bar, r.reactions.end());
    EXPECT_NEAR(bar->force.x(), -3, 1e-11);
    EXPECT_NEAR(bar->force.y(), 10, 1e-11);
    const double slid = 3.0 / 200, sunk = -10.0 / 500, turned = (3 * 10 - 2 * 3) / (50 * 1000.0 / 12);
    ASSERT_TRUE(bar->energy.has_value());
    EXPECT_NEAR(*bar->energy, 0.5 * (3 * slid - 10 * sunk + 24 * turned), 1e-11);
    EXPECT_LT(r.equilibrium.relative_residual, 1e-12);
    EXPECT_LT(r.equilibrium.relative_moment_residual, 1e-12);
}

/// Along its guide a wedge gives way to a spring on its inclined side, which pushes it against the guide.
TEST(RigidParts, AGuideTakesWhatASpringPushesAside) {
    const Result r = answer(
        {.hold =
             R"({"on": "punch/left", "symmetry": true}, {"part": "wedge", "rigid": {"translation": [null, 0], "rotation": 0}},
            {"on": {"part": "wedge", "facing": [1, 1]}, "spring": {"normal": 50}})",
         .load = R"({"on": "punch/top", "pressure": 10}, {"part": "wedge", "force": [4, 0]})",
         .more_parts = R"(, {"name": "wedge", "material": "rigid", "geometry": {"polygon": [[10, 0], [14, 0], [10, 4]]}})"});
    ASSERT_EQ(r.status, "ok") << r.message;
    const auto by = [&](const std::string& method) {
        const auto found =
            std::find_if(r.reactions.rbegin(), r.reactions.rend(), [&](const Reaction& x) { return x.method == method; });
        return found == r.reactions.rend() ? Vec2(0, 0) : found->force;
    };
    EXPECT_NEAR((by("spring") - Vec2(-4, -4)).norm(), 0, 1e-11);
    EXPECT_NEAR((by("rigid") - Vec2(0, 4)).norm(), 0, 1e-11);
}

TEST(RigidParts, AFreeOneIsAMechanism) {
    const Result r = answer({.hold = "", .load = R"({"on": "punch/left", "pressure": 10})"});
    EXPECT_EQ(r.status, "failed");
    EXPECT_NE(r.message.find("punch"), std::string::npos) << r.message;
}

const std::string second_punch =
    R"(, {"name": "ram", "material": "rigid", "geometry": {"rectangle": {"min": [1.5, 3], "max": [2.5, 4]}}})";

TEST(RigidParts, CannotBePressedAgainstEachOther) {
    const Result pressed = answer({.hold = R"({"on": "punch/left", "symmetry": true},
                                             {"on": "ram/top", "displacement": {"x": 0, "y": -0.1}})",
                                   .load = R"({"on": "block/left", "pressure": 1})",
                                   .more_parts = second_punch});
    EXPECT_EQ(pressed.status, "failed");
    EXPECT_NE(pressed.message.find("the rigid parts punch and ram are pushed into each other"), std::string::npos)
        << pressed.message;
    const Result apart =
        answer({.hold = R"({"on": "punch/left", "symmetry": true}, {"on": "ram/top", "displacement": {"x": 0, "y": 0.1}})",
                .more_parts = second_punch});
    EXPECT_EQ(apart.status, "ok") << apart.message;
}

TEST(RigidParts, ThatWouldRestOnAnotherAreNamedWithIt) {
    const Result r = analyze(read_scene_text(R"({"abut": 1, "parts": [
        {"name": "table", "material": "rigid", "geometry": {"rectangle": {"min": [0, 0], "max": [9, 1]}}},
        {"name": "weight", "material": "rigid", "geometry": {"rectangle": {"min": [3, 1], "max": [5, 3]}}}],
        "supports": [{"on": "table/bottom", "fix": ["x", "y"]}], "loads": [{"on": "weight/top", "pressure": 1}]})",
                                             "scene.json"),
                             {});
    EXPECT_EQ(r.status, "failed");
    EXPECT_NE(r.message.find("table and weight face each other, but both are rigid"), std::string::npos) << r.message;
}

TEST(RigidParts, CarryForcesOnTheWholePart) {
    const Result r = answer({.load = R"({"on": "punch/top", "pressure": 10}, {"part": "punch", "force": [0, -5]})"});
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_NEAR(r.contacts[0].force.y(), -25, 1e-9);
    EXPECT_NEAR(r.equilibrium.applied.y(), -25, 1e-12);
}

}  // namespace
}  // namespace abut::rigid_parts_test
