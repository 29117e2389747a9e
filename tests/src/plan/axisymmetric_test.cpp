// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes around an axis, and what a load needs: what is refused, and what forces mean.
#include <gtest/gtest.h>

#include <cmath>

#include "src/plan/plan.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::axisymmetric_test {
namespace {

/// A tube from radius 1 to 2, or a bar from the axis, 1 high, on a roller.
struct Tube {
    std::string analysis = "axisymmetric", geometry = R"({"rectangle": {"min": [1, 0], "max": [2, 1]}})",
                loads = R"([{"on": "tube/top", "pressure": 10}])", supports = R"([{"on": "tube/bottom", "fix": ["y"]}])", more,
                material = R"({"E": 1000, "nu": 0.3, "density": 2, "expansion": 1e-3})", thickness;
    bool rigid = false;
    std::string text() const {
        return R"({"abut": 1, "analysis": ")" + analysis + R"(", )" + thickness + R"("materials": {"m": )" + material +
               R"(}, "parts": [{"name": "tube", "material": ")" + (rigid ? "rigid" : "m") + R"(", "geometry": )" + geometry +
               R"(}], "supports": )" + supports + R"(, "loads": )" + loads + more + "}";
    }
};

std::string refusal(const Tube& tube) {
    try {
        test::answer(tube.text());
    } catch (const InputError& error) {
        std::string all;
        for (const Problem& p : error.problems()) all += p.where + ": " + p.what + "; " + p.hint + "\n";
        return all;
    }
    return "none";
}

void expect_refusal(const Tube& tube, const std::string& where, const std::string& what) {
    const std::string text = refusal(tube);
    EXPECT_NE(text.find(where), std::string::npos) << text;
    EXPECT_NE(text.find(what), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
}

TEST(Axisymmetric, RefusesWhatHasNoMeaningAroundAnAxis) {
    EXPECT_EQ(refusal({}), "none");
    Tube t;
    t.geometry = R"({"rectangle": {"min": [-0.1, 0], "max": [2, 1]}})";
    expect_refusal(t, "/parts/0", "across the axis");
    t = {};
    t.loads = R"([{"gravity": [1, 0]}])";
    expect_refusal(t, "/loads/0/gravity", "not axisymmetric");
    t = {};
    t.loads = R"([{"part": "tube", "spin": {"about": [0, 0], "omega": 3}}])";
    expect_refusal(t, "/loads/0/spin/about", "leave 'about' out");
    t = {};
    t.supports = R"([{"part": "tube", "rigid": {"translation": [0, 0], "rotation": null}}])";
    expect_refusal(t, "/supports/0/rigid", "no rigid motion but along y");
    t = {};
    t.supports = R"([{"part": "tube", "at": [[1.5, 0.5]], "fix": ["y"]}])";
    expect_refusal(t, "/supports/0", "points cannot be held");
    t = {};
    t.thickness = R"("thickness": 2, )";
    expect_refusal(t, "/thickness", "no thickness");
    t = {};
    t.more = R"(, "accuracy": {"dirichlet": "solution_structure"})";
    expect_refusal(t, "/accuracy/dirichlet", "no weight functions");
    t = {};
    t.more = R"(, "accuracy": {"grids": {"tube": {"cells": [4, 4], "angle": 10}}})";
    expect_refusal(t, "/accuracy/grids/tube/angle", "turned grid");
    t = {};
    t.more = R"(, "accuracy": {"grids": {"tube": {"x": [-0.5, 0.7, 2], "y": [0, 0.5, 1]}}})";
    expect_refusal(t, "/accuracy/grids/tube", "over the axis");
}

TEST(Axisymmetric, EdgesOnTheAxisTakeNoLoadAndNoHold) {
    Tube t;
    t.geometry = R"({"rectangle": {"min": [0, 0], "max": [2, 1]}})";
    EXPECT_EQ(refusal(t), "none");
    t.loads = R"([{"on": "tube/left", "pressure": 10}])";
    expect_refusal(t, "/loads/0", "tube/left lies on the axis");
    t.loads = "[]";
    t.supports = R"([{"on": "tube/left", "fix": ["x", "y"]}])";
    expect_refusal(t, "/supports/0", "tube/left lies on the axis");
    t.supports = R"([{"on": "tube/left", "symmetry": true}, {"on": "tube/bottom", "fix": ["y"]}])";
    EXPECT_EQ(refusal(t), "none") << "that is held anyway";
}

/// A rigid ring moves along the axis and in no other way.
TEST(Axisymmetric, RigidPartsMoveAlongTheAxis) {
    Tube t;
    t.rigid = true;
    const Result held = test::answer(t.text());
    ASSERT_EQ(held.status, "ok") << held.message;
    EXPECT_NEAR(held.equilibrium.reaction.y(), 10 * M_PI * 3, 1e-9);
    EXPECT_EQ(held.parts[0].max_displacement.value, 0);
    t.supports = R"([{"on": "tube/bottom", "displacement": {"y": 0.25}}, {"on": "tube/right", "fix": ["x"]}])";
    const Result moved = test::answer(t.text());
    ASSERT_EQ(moved.status, "ok") << moved.message;
    EXPECT_NEAR(moved.parts[0].max_displacement.value, 0.25, 1e-12);
    t.supports = R"([{"on": "tube/bottom", "fix": ["y"]}, {"on": "tube/right", "displacement": {"x": 0.01}}])";
    expect_refusal(t, "/supports/1", "prescribe displacements that no rigid motion has (off by 0.01)");
    t.supports = R"([{"on": "tube/right", "fix": ["x"]}])";
    const Result loose = test::answer(t.text());
    EXPECT_EQ(loose.status, "failed");
    EXPECT_NE(loose.message.find("tube slides along (0, "), std::string::npos) << loose.message;
}

TEST(Loads, NeedTheirMaterialsNumbers) {
    Tube t;
    t.material = R"({"E": 1000, "nu": 0.3})";
    t.loads = R"([{"part": "tube", "spin": {"omega": 3}}])";
    expect_refusal(t, "/loads/0", "spin needs the 'density' of the material 'm'");
    t.loads = R"([{"part": "tube", "temperature": 10}])";
    expect_refusal(t, "/loads/0", "temperature needs the 'expansion' of the material 'm'");
    t = {};
    t.analysis = "plane_strain";
    t.loads = R"([{"part": "tube", "spin": {"omega": 3}}])";
    expect_refusal(t, "/loads/0/spin", "'about' is missing");
    t.loads = R"([{"part": "tube", "temperature": "1/(x-1.5)^0.5"}])";
    expect_refusal(t, "/loads/0", "no finite value");
}

/// Forces are totals over the circle, pressures are what they are.
TEST(Axisymmetric, ForcesAreTotalsOverTheFullCircle) {
    Tube t;
    const Result pressed = test::answer(t.text());
    ASSERT_EQ(pressed.status, "ok") << pressed.message;
    const double total = 10 * M_PI * 3;
    EXPECT_NEAR(pressed.equilibrium.applied.y(), -total, 1e-9 * total);
    EXPECT_NEAR(pressed.equilibrium.reaction.y(), total, 1e-9 * total);
    EXPECT_LT(pressed.equilibrium.relative_residual, 1e-10);
    t.loads = R"([{"on": "tube/top", "force": [0, )" + test::number(-total) + "]}]";
    const Result pushed = test::answer(t.text());
    EXPECT_NEAR(pushed.parts[0].max_displacement.value, pressed.parts[0].max_displacement.value,
                1e-9 * pressed.parts[0].max_displacement.value);
    t.loads = R"([{"part": "tube", "force": [0, -7]}])";
    EXPECT_NEAR(test::answer(t.text()).equilibrium.applied.y(), -7, 1e-9);
    t.loads = R"([{"gravity": [0, -10]}])";
    EXPECT_NEAR(test::answer(t.text()).equilibrium.applied.y(), -20 * 3 * M_PI, 1e-7);
    t.loads = R"([{"on": "tube/left", "pressure": 10}])";
    const Result inside = test::answer(t.text());
    EXPECT_EQ(inside.equilibrium.applied, Vec2(0, 0)) << "radial forces have no resultant";
    EXPECT_LT(inside.equilibrium.relative_residual, 1e-10);
    EXPECT_EQ(inside.equilibrium.relative_moment_residual, 0);
}

TEST(Axisymmetric, NothingButTheAxisDirectionIsFree) {
    Tube t;
    t.supports = "[]";
    const Result driven = test::answer(t.text());
    EXPECT_EQ(driven.status, "failed");
    EXPECT_NE(driven.message.find("tube"), std::string::npos);
    t.loads = R"([{"on": "tube/left", "pressure": 10}])";
    const Result neutral = test::answer(t.text());
    ASSERT_EQ(neutral.status, "ok") << neutral.message;
    EXPECT_EQ(neutral.warnings.size(), 1U) << "it may slide along the axis";
    ASSERT_EQ(neutral.as_drawn.parts.size(), 1U);
    EXPECT_EQ(neutral.as_drawn.parts[0].free.size(), 1U);
}

TEST(Axisymmetric, ThePlanSaysWhoseAxisIsHeld) {
    const auto why = [](const std::string& text) {
        for (const Effect& e : plan_effects(read_scene_text(text, "s.json")))
            if (e.name == "axisymmetry") return e.why;
        return std::string("absent");
    };
    Tube t;
    EXPECT_EQ(why(t.text()).find("held"), std::string::npos);
    t.geometry = R"({"rectangle": {"min": [0, 0], "max": [2, 1]}})";
    EXPECT_NE(why(t.text()).find("held on the axis of tube"), std::string::npos);
    t.analysis = "plane_strain";
    EXPECT_EQ(why(t.text()), "absent");
}

}  // namespace
}  // namespace abut::axisymmetric_test
