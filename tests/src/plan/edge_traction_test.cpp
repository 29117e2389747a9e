// SPDX-License-Identifier: GPL-3.0-or-later
// Moments, forces off the edge and the force of a pin: what is spread, what comes of it, and what is refused.
#include "src/plan/edge_traction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/analysis/analysis.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/plan/loads.hpp"
#include "src/scene/read_scene.hpp"

namespace edge_traction_test {

namespace {

using namespace abut;
constexpr double pi = std::numbers::pi;

/// A plate 40 x 10, 2 thick, held at its left edge; a plate with a hole of radius 5 about (30, 20), held at its bottom.
std::string beam(const std::string& load) {
    return R"({"abut": 1, "units": {"length": "mm", "force": "N"}, "thickness": 2,
      "materials": {"m": {"E": 1000, "nu": 0}}, "parts": [{"name": "b", "material": "m",
      "geometry": {"rectangle": {"min": [0, -5], "max": [40, 5]}}}], "supports": [{"on": "b/left", "fix": ["x", "y"]}],
      "loads": [)" +
           load + R"(], "output": {"probes": [{"part": "b", "at": [40, 0]}, {"part": "b", "at": [20, 5]}]}})";
}
std::string lug(const std::string& load) {
    return R"({"abut": 1, "thickness": 3, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [{"name": "lug", "material": "m",
      "geometry": {"difference": [{"rectangle": {"min": [0, 0], "max": [60, 40]}},
                                  {"circle": {"center": [30, 20], "radius": 5}, "name": "hole"}]}}],
      "supports": [{"on": "lug/bottom", "fix": ["x", "y"]}], "loads": [)" +
           load + "]}";
}

Result answer(const std::string& text) {
    Result result = analyze(read_scene_text(text, "scene.json"), {});
    EXPECT_EQ(result.status, "ok") << result.message;
    return result;
}

std::string refusal(const std::string& text) {
    try {
        const Scene scene = read_scene_text(text, "scene.json");
        resolve_conditions(scene);
    } catch (const InputError& error) {
        return error.problems().front().where + ": " + error.problems().front().what + "; " + error.problems().front().hint;
    }
    return "none";
}

/// A straight side may be a spline that is drawn faster and slower: what is spread along it adds up all the same.
TEST(EdgeTraction, AddsUpAlongSplinesWhereverTheirKnotsAre) {
    const Scene scene = read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [{"name": "p",
      "material": "m", "geometry": {"loops": [[{"line": {"from": [0, 0], "to": [4, 0]}}, {"line": {"from": [4, 0], "to": [4, 1]}},
        {"nurbs": {"degree": 2, "knots": [0, 0, 0, 0.03, 1, 1, 1], "points": [[4, 1], [3.9, 1], [0.5, 1], [0, 1]]}},
        {"line": {"from": [0, 1], "to": [0, 0]}}]]}}],
      "supports": [{"part": "p", "rigid": {"translation": [0, 0], "rotation": 0}}],
      "loads": [{"on": "p/e2", "force": [3, 0]}]})",
                                        "scene.json");
    const EdgeTraction spread = edge_traction(scene, scene.loads[0], resolve_conditions(scene).loads[0]);
    EXPECT_NEAR(spread.even.x(), 3.0 / 4, 1e-13);
}

TEST(EdgeTraction, AMomentBendsABarAsBeamsBend) {
    // sigma = M y / I and u_y = M x^2 / (2 E I), I = 2 * 10^3 / 12: quadratic, so the splines have it.
    const double moment = 500, second = 2 * 1000 / 12.0;
    const Result result = answer(beam(R"({"on": "b/right", "moment": "0.5 N m"})"));
    EXPECT_NEAR(result.probes[0].displacement.y(), moment * 1600 / (2 * 1000 * second), 1e-8);
    EXPECT_NEAR(result.probes[1].stress.xx, -moment * 5 / second, 1e-8);
    EXPECT_NEAR(result.reactions[0].moment, -moment, 1e-8);
}

TEST(EdgeTraction, AForceOffItsEdgeIsAForceAndAMoment) {
    const Result off = answer(beam(R"({"on": "b/right", "force": [3, -7], "at": [100, 20]})"));
    const Result both = answer(beam(R"({"on": "b/right", "force": [3, -7]}, {"on": "b/right", "moment": -480})"));
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR((off.probes[k].displacement - both.probes[k].displacement).norm(), 0, 1e-12);
    EXPECT_NEAR((off.reactions[0].force - Vec2(-3, 7)).norm(), 0, 1e-9);
    EXPECT_NEAR(off.reactions[0].moment, -(100 * -7 - 20 * 3), 1e-7);
}

TEST(EdgeTraction, AMomentOnAPartIsSpreadOverItsArea) {
    const Result result = answer(beam(R"({"part": "b", "moment": 11})"));
    EXPECT_NEAR(result.reactions[0].force.norm(), 0, 1e-9);
    EXPECT_NEAR(result.reactions[0].moment, -11, 1e-9);
}

TEST(EdgeTraction, APinPressesByTheCosine) {
    for (const double degrees : {0.0, 37.0, 90.0, 200.0}) {
        const Vec2 way(std::cos(degrees * pi / 180), std::sin(degrees * pi / 180));
        std::ostringstream load;
        load.precision(17);
        load << R"({"on": "lug/hole/*", "bearing": [)" << 100 * way.x() << ", " << 100 * way.y() << "]}";
        const Scene scene = read_scene_text(lug(load.str()), "scene.json");
        const ResolvedConditions conditions = resolve_conditions(scene);
        const EdgeTraction spread = edge_traction(scene, scene.loads[0], conditions.loads[0]);
        // p = 2 F / (pi R t) cos(angle)
        EXPECT_NEAR((spread.pressing - 2 * 100 / (pi * 5 * 3) * way).norm(), 0, 1e-10);
        double pressed = 0;
        for (const EdgePortion& p : conditions.loads[0])
            pressed += length(scene.parts[0].part.edges[static_cast<std::size_t>(p.edge)].curve, p.t0, p.t1);
        EXPECT_NEAR(pressed, pi * 5, 1e-9) << "half of the hole";
        for (const double at : {-89.0, -30.0, 0.0, 60.0}) {
            const double angle = (degrees + at) * pi / 180;
            const Vec2 out(std::cos(angle), std::sin(angle));
            const Vec2 t = traction_at(scene.loads[0], spread, Vec2(30, 20) + 5 * out, -out);
            EXPECT_NEAR((t - 2 * 100 / (pi * 5 * 3) * std::cos(at * pi / 180) * out).norm(), 0, 1e-10);
        }
        const Result result = answer(lug(load.str()));
        EXPECT_NEAR((result.reactions[0].force + 100 * way).norm(), 0, 1e-7);
        EXPECT_NEAR(result.reactions[0].moment, -(30 * 100 * way.y() - 20 * 100 * way.x()), 1e-5);
    }
}

TEST(EdgeTraction, APinInHalfAHoleMayPushAcrossIt) {
    // The wall of a half hole takes a force at 40 degrees from its middle by a pressure that leans over.
    const std::string text = R"({"abut": 1, "thickness": 3, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [{"name": "p",
      "material": "m", "geometry": {"difference": [{"rectangle": {"min": [0, 0], "max": [60, 20]}},
                                                   {"circle": {"center": [30, 20], "radius": 5}, "name": "hole"}]}}],
      "supports": [{"on": "p/bottom", "fix": ["x", "y"]}], "loads": [{"on": "p/hole/*", "bearing": [40, -60]}]})";
    const Result result = answer(text);
    EXPECT_NEAR((result.reactions[0].force - Vec2(-40, 60)).norm(), 0, 1e-7);
}

TEST(EdgeTraction, WhatMakesNoSenseIsRefused) {
    EXPECT_NE(refusal(beam(R"({"on": "b/right", "bearing": [5, 0]})")).find("/loads/0: these edges cannot carry"),
              std::string::npos);
    EXPECT_NE(refusal(beam(R"({"on": "b/right", "bearing": [-5, 1]})")).find("/loads/0: these edges cannot carry"),
              std::string::npos);
    EXPECT_EQ(refusal(beam(R"({"on": "b/right", "bearing": [-5, 0]})")), "none");
    EXPECT_NE(refusal(beam(R"({"on": "b/right", "pressure": 1, "at": [0, 0]})")).find("/loads/0/at: 'at' goes with 'force'"),
              std::string::npos);
    EXPECT_EQ(refusal(beam(R"({"on": "b/right", "bearing": [0, 0]})")), "none") << "a step that lets go";
    EXPECT_NE(refusal(beam(R"({"part": "b", "bearing": [1, 0]})")).find("'part' does not go with 'bearing'"),
              std::string::npos);
    EXPECT_NE(refusal(beam(R"({"on": "b/right", "moment": "3 kN"})")).find("a moment"), std::string::npos);
    std::string around = beam(R"({"on": "b/right", "moment": 3})");
    around.replace(around.find("\"thickness\": 2"), 14, R"("analysis": "axisymmetric")");
    EXPECT_NE(refusal(around).find("a moment in the plane of the section is not axisymmetric"), std::string::npos);
}

}  // namespace

}  // namespace edge_traction_test
