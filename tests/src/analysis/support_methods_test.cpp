// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's supports in all their ways: solution structure, points, springs, rigid; each says how and why.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>
#include <string>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::support_methods_test {
namespace {

constexpr double E = 1000, nu = 0.3;

struct Case {
    std::string geometry = R"("rectangle": {"min": [0, 0], "max": [2, 1]})";
    std::string supports, loads, probes = "[2, 1]";
    std::string accuracy = R"("grids": {"a": {"cells": [5, 3], "offset": [0.03, -0.07]}})";
    std::string material = R"("E": 1000, "nu": 0.3)";
};

Result answer(const Case& c) {
    std::string probes;
    for (std::size_t i = 0; i < c.probes.size(); ++i)
        probes += c.probes[i] == ';' ? std::string("}, {\"part\": \"a\", \"at\": ") : std::string(1, c.probes[i]);
    const std::string text = R"({"abut": 1, "materials": {"m": {)" + c.material +
                             R"(}}, "parts": [{"name": "a", "material": "m", "geometry": {)" + c.geometry +
                             R"(}}], "supports": [)" + c.supports + R"(], "loads": [)" + c.loads + R"(], "accuracy": {)" +
                             c.accuracy + R"(}, "output": {"probes": [{"part": "a", "at": )" + probes + "}]}}";
    return analyze(read_scene_text(text, "s.json"), {});
}

std::string problem_of(const Case& c) {
    try {
        answer(c);
    } catch (const InputError& error) { return one_line(error.problems().front()); }
    return "";
}

std::string with_structure(const std::string& accuracy) {
    return R"("dirichlet": "solution_structure", )" + accuracy;
}

const std::string symmetric = R"({"on": "a/left", "symmetry": true}, {"on": "a/bottom", "symmetry": true})";
const std::string pulled = R"({"on": "a/right", "traction": [10, 0]})";

TEST(SupportMethods, SymmetryByLinearWeightsPassesThePatchTestAtEveryDegree) {
    for (int degree = 1; degree <= 4; ++degree) {
        Case c{.supports = symmetric, .loads = pulled};
        c.accuracy = with_structure(c.accuracy) + ", \"degree\": " + std::to_string(degree);
        const Result r = answer(c);
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_NEAR(r.probes[0].displacement.x(), 10 / E * 2, 1e-12);
        EXPECT_NEAR(r.probes[0].displacement.y(), -nu * 10 / E, 1e-12);
        EXPECT_NEAR(r.probes[0].stress.xx, 10, 1e-9);
        ASSERT_EQ(r.reactions.size(), 2u);
        EXPECT_EQ(r.reactions[0].method, "structure");
        EXPECT_NEAR(r.reactions[0].force.x(), -10, 1e-10);
        ASSERT_TRUE(r.reactions[0].force_from_stress.has_value());
        EXPECT_NEAR(r.reactions[0].force_from_stress->x(), -10, 1e-9);
        EXPECT_FALSE(r.reactions[0].why.empty());
    }
}

TEST(SupportMethods, GridsAtAnAngleHoldBothComponentsByWeightsAndRollersByNitsche) {
    const std::string turned = R"("grids": {"a": {"cells": [7, 5], "angle": 30}})";
    const Result fixed = answer({.supports = R"({"on": "a/left", "displacement": {"x": 0.01, "y": "0.02+0*x"}})",
                                 .loads = "",
                                 .accuracy = with_structure(turned)});
    ASSERT_EQ(fixed.status, "ok") << fixed.message;
    EXPECT_EQ(fixed.reactions[0].method, "structure");
    EXPECT_NEAR(fixed.probes[0].displacement.x(), 0.01, 1e-12);
    EXPECT_NEAR(fixed.probes[0].displacement.y(), 0.02, 1e-12);
    const Result rollers = answer({.supports = symmetric, .loads = pulled, .accuracy = with_structure(turned)});
    EXPECT_EQ(rollers.reactions[0].method, "nitsche");
    EXPECT_NE(rollers.reactions[0].why.find("grid's axes"), std::string::npos) << rollers.reactions[0].why;
    EXPECT_NEAR(rollers.probes[0].displacement.x(), 10 / E * 2, 1e-11);
}

/// Radial displacement a r + b / r of a ring (Lame).
double radial(double r) {
    return 0.01 * r + 0.02 / r;
}

/// Root of the summed squares of the errors of a ring between prescribed displacements of its circles, held by weights.
double ring_error(int n) {
    Case c{R"("difference": [{"circle": {"center": [0, 0], "radius": 2}, "name": "o"},
                             {"circle": {"center": [0, 0], "radius": 1}, "name": "i"}])",
           R"({"on": "a/o/circle", "displacement": {"x": "0.015*x", "y": "0.015*y"}},
              {"on": "a/i/circle", "displacement": {"x": "0.03*x", "y": "0.03*y"}})",
           "", ""};
    for (int k = 0; k < 36; ++k) {
        const double r = 1.05 + 0.9 * k / 35, angle = 2.3 * k;
        c.probes +=
            (k == 0 ? "[" : "; [") + std::to_string(r * std::cos(angle)) + ", " + std::to_string(r * std::sin(angle)) + "]";
    }
    const std::string cells = std::to_string(n) + ", " + std::to_string(n);
    c.accuracy = with_structure(R"("grids": {"a": {"cells": [)" + cells + R"(], "offset": [0.013, -0.021]}})");
    const Result r = answer(c);
    EXPECT_EQ(r.status, "ok") << r.message;
    double sum = 0;
    for (const ProbeResult& p : r.probes) sum += (p.displacement - radial(p.at.norm()) / p.at.norm() * p.at).squaredNorm();
    return std::sqrt(sum);
}

/// The data of two circles blended, weights of curved edges: errors fall as h^3.
TEST(SupportMethods, ARingBetweenTwoPrescribedCirclesConverges) {
    const double coarse = ring_error(16), fine = ring_error(32);
    EXPECT_LT(fine, 1e-3);
    EXPECT_GT(std::log2(coarse / fine), 2.8);
}

/// What quadrature alone keeps from being exact: a linear field prescribed all round.
TEST(SupportMethods, CornersOfWeightsCostLessThanAPerMille) {
    Case c{.supports = R"({"on": "a/*", "displacement": {"x": "0.01*x+0.02*y", "y": "0.03*x-0.004*y"}})", .loads = ""};
    c.probes = "[1.3, 0.6]; [1.9, 0.9]; [0.05, 0.05]";
    c.accuracy = with_structure(R"("grids": {"a": {"cells": [12, 12], "offset": [0.003, -0.007]}})");
    const Result r = answer(c);
    for (const ProbeResult& p : r.probes) {
        EXPECT_NEAR(p.displacement.x(), 0.01 * p.at.x() + 0.02 * p.at.y(), 1e-6);
        EXPECT_NEAR(p.stress.xx, E / (1 - nu * nu) * (0.01 - nu * 0.004), 1e-3 * 9.67);
    }
}

TEST(SupportMethods, PointsHoldAreBalancedAndWarnedOfOnce) {
    const std::string points = R"({"part": "a", "at": [[0.5, 0.5], [1.5, 0.5]], "fix": ["x", "y"]})";
    Case c{.supports = points, .loads = R"({"on": "a/top", "pressure": 1})", .probes = "[0.5, 0.5]; [1.5, 0.5]; [1, 1]"};
    for (const char* dirichlet : {"auto", "aligned", "nitsche", "solution_structure"}) {
        c.accuracy =
            std::string("\"dirichlet\": \"") + dirichlet + R"(", "grids": {"a": {"cells": [12, 6], "offset": [0.01, 0.02]}})";
        const Result r = answer(c);
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_EQ(r.reactions[0].method, dirichlet == std::string("solution_structure") ? "structure" : "point");
        EXPECT_NEAR(r.reactions[0].force.y(), 2, 1e-11);
        EXPECT_NEAR(r.reactions[0].moment, 2, 1e-11);
        EXPECT_LT(r.probes[0].displacement.norm() + r.probes[1].displacement.norm(), 1e-15);
        EXPECT_LT(r.probes[2].displacement.y(), -1e-4);
        int warnings = 0;
        for (const std::string& w : r.warnings) warnings += w.find("held at points") != std::string::npos;
        EXPECT_EQ(warnings, 1);
    }
}

const std::string three_two_one = R"({"part": "a", "at": [0.25, 0.5], "fix": ["x", "y"]},
    {"part": "a", "at": [1.75, 0.5], "fix": ["y"]})";

TEST(SupportMethods, PointsThatOnlyKeepInPlaceChangeNothing) {
    Case c{.supports = three_two_one, .loads = pulled + R"(, {"on": "a/left", "traction": [-10, 0]})"};
    c.accuracy = R"("level": "standard")";
    const Result r = answer(c);
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_TRUE(r.warnings.empty()) << r.warnings.front();
    EXPECT_NEAR(r.probes[0].displacement.x(), 10 / E * 1.75, 1e-12);
    EXPECT_NEAR(r.probes[0].displacement.y(), -nu * 10 / E * 0.5, 1e-12);
    EXPECT_NEAR(r.parts.at(0).max_von_mises.value, 10, 1e-9);
    EXPECT_FALSE(r.parts.at(0).max_von_mises_at_corner);
    c.material = R"("E": 20, "nu": 0.3)";  // strains by half: no motion of the part that it would have to be followed in
    EXPECT_NEAR(answer(c).probes[0].displacement.x(), 10 / 20.0 * 1.75, 1e-9);
}

TEST(SupportMethods, PointsHoldWarmPartsAndThoseOfHeldMeans) {
    Case c{.supports = three_two_one, .loads = R"({"part": "a", "temperature": 50})"};
    c.material = R"("E": 1000, "nu": 0.3, "expansion": 1e-5)";
    const Result warm = answer(c);
    ASSERT_EQ(warm.status, "ok") << warm.message;
    EXPECT_TRUE(warm.warnings.empty()) << warm.warnings.front();
    EXPECT_NEAR(warm.probes[0].displacement.x(), 50e-5 * 1.75, 1e-11);
    EXPECT_NEAR(warm.probes[0].displacement.y(), 50e-5 * 0.5, 1e-11);
    const Result turned = answer({.supports = R"({"part": "a", "at": [0.5, 0.5], "fix": ["x", "y"]},
                                      {"part": "a", "rigid": {"rotation": 1}})",
                                  .loads = ""});
    ASSERT_EQ(turned.status, "ok") << turned.message;
    EXPECT_NEAR(turned.probes[0].displacement.y(), 1.5 * M_PI / 180, 1e-9);
    EXPECT_NEAR(turned.probes[0].displacement.x(), -0.5 * M_PI / 180, 1e-9);
}

/// What an edge or another support holds already is left to it.
TEST(SupportMethods, PointsOfHeldEdgesHoldTheRest) {
    Case c{.supports = R"({"on": "a/bottom", "fix": ["y"]}, {"part": "a", "at": [[0, 0]], "fix": ["x", "y"]},
               {"part": "a", "at": [[0, 0], [0, 0]], "fix": ["x"]})",
           .loads = R"({"on": "a/top", "pressure": 10})"};
    for (const char* dirichlet : {"auto", "nitsche"}) {
        c.accuracy = std::string("\"dirichlet\": \"") + dirichlet + "\"";
        const Result r = answer(c);
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_NEAR(r.probes[0].displacement.x(), nu * 10 / E * 2, 1e-9);
        EXPECT_NEAR(r.reactions[0].force.y(), 20, 1e-9);
        EXPECT_NEAR(r.reactions[1].force.norm(), 0, 1e-9);
    }
    c.supports = R"({"on": "a/bottom", "displacement": {"y": 0.1}}, {"part": "a", "at": [0, 0], "fix": ["x", "y"]})";
    EXPECT_NE(problem_of(c).find("support 0 displaces the edge"), std::string::npos) << problem_of(c);
}

/// A block on a base without friction, pushed aside: the point's force is statics'.
TEST(SupportMethods, PointsHoldWhatContactLeavesFree) {
    const Result r = analyze(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [
        {"name": "base", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [4, 1]}}},
        {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [1, 1], "max": [3, 3]}}}],
        "supports": [{"on": "base/bottom", "fix": ["x", "y"]}, {"part": "block", "at": [3, 1.5], "fix": ["x"]}],
        "loads": [{"on": "block/top", "pressure": 1}, {"on": "block/left", "traction": [0.1, 0]}]})",
                                             "s.json"),
                             {});
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_NEAR(r.reactions.at(1).force.x(), -0.2, 1e-9);
    EXPECT_NEAR(r.reactions.at(1).moment, 0.2 * 1.5, 1e-9);
    EXPECT_NEAR(r.contacts.at(0).force.y(), -2, 1e-9);
}

TEST(SupportMethods, WhatPointsCannotHoldIsRefused) {
    const auto points = [](const std::string& at, const std::string& more) {
        return Case{.supports = R"({"part": "a", "at": )" + at + R"(, "fix": ["x", "y"]})" + more,
                    .loads = R"({"on": "a/top", "pressure": 1})"};
    };
    EXPECT_NE(answer(points("[[0.5, 0.5]]", "")).message.find("a rotates about (0.5, 0.5)"), std::string::npos);
    EXPECT_NE(problem_of(points("[[0.5, 1.5]]", "")).find("outside part a"), std::string::npos);
    Case weighted = points("[[0.5, 0.5]]", R"(, {"part": "a", "rigid": {"rotation": 0}})");
    weighted.accuracy = R"("dirichlet": "solution_structure")";
    EXPECT_NE(problem_of(weighted).find("rigid"), std::string::npos);
}

TEST(SupportMethods, SpringsReportForceAndEnergy) {
    const Result r = answer(
        {.supports = R"({"on": "a/left", "spring": {"normal": 100}}, {"on": "a/bottom", "symmetry": true})", .loads = pulled});
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_NEAR(r.probes[0].displacement.x(), 0.1 + 0.02, 1e-11);
    EXPECT_EQ(r.reactions[0].method, "spring");
    EXPECT_NEAR(r.reactions[0].force.x(), -10, 1e-10);
    ASSERT_TRUE(r.reactions[0].energy.has_value());
    EXPECT_NEAR(*r.reactions[0].energy, 0.5 * 10 * 0.1, 1e-10);
    EXPECT_NEAR(r.strain_energy, 0.5 * 10 * 0.02, 1e-10);
    EXPECT_LT(r.equilibrium.relative_residual, 1e-11);
}

TEST(SupportMethods, SoftSpringsHoldAsTheyAre) {
    const Result r =
        answer({.supports = R"({"on": "a/left", "spring": {"normal": 1e-9, "tangential": 1e-9}})", .loads = pulled});
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_NEAR(r.probes[0].displacement.x(), 1e10, 1);
    EXPECT_NEAR(r.probes[0].stress.xx, 10, 0.01);
    EXPECT_EQ(verdict_of(r), Verdict::solved_but) << "it moves farther than it is large";
}

/// A block on an even bed of springs, pressed by another through a contact: springs and blocks in a row, whichever of them are
/// softer.
TEST(SupportMethods, SpringsOfAnyStiffnessCarryContacts) {
    for (const bool is_rigid : {false, true})
        for (const double k : {1e-8, 1e-2, 1.0, 1e2, 1e4, 1e8}) {
            std::ostringstream stiffness;
            stiffness << k;
            const Result r =
                answer({.geometry = R"("rectangle": {"min": [0, 1], "max": [2, 2]}}}, {"name": "b", "material": ")" +
                                    std::string(is_rigid ? "rigid" : "m") +
                                    R"(", "geometry": {"rectangle": {"min": [0, 0], "max": [2, 1]})",
                        .supports = R"({"on": "b/bottom", "spring": {"normal": )" + stiffness.str() +
                                    R"(}}, {"on": "b/left", "symmetry": true}, {"on": "a/left", "symmetry": true},
                                {"on": "a/top", "displacement": {"y": -0.001}})",
                        .material = R"("E": 1000, "nu": 0)"});
            ASSERT_EQ(r.status, "ok") << r.message;
            const double force = 2 * 0.001 / (1 / k + (is_rigid ? 1 : 2) / E);
            EXPECT_NEAR(r.contacts.at(0).force.norm(), force, 1e-9 * force) << k << " " << is_rigid;
            EXPECT_LT(r.equilibrium.relative_residual * force, 1e-11) << k << " " << is_rigid;  // E times what it moves by is 1
        }
}

TEST(SupportMethods, RigidHoldsWhatIsNotNullWhateverTheGridsAngle) {
    for (int angle : {0, 30, 77}) {
        const std::string grid = R"("grids": {"a": {"cells": [5, 4], "angle": )" + std::to_string(angle) + "}}";
        const auto held = [&](const std::string& motion, const std::string& loads) {
            return answer({.supports = R"({"part": "a", "rigid": )" + motion + "}", .loads = loads, .accuracy = grid});
        };
        const Result all = held(R"({"translation": [0.03, -0.01], "rotation": 2})", pulled);
        ASSERT_EQ(all.status, "ok") << all.message;
        EXPECT_NEAR(all.reactions[0].force.x(), -10, 1e-9);
        EXPECT_EQ(all.reactions[0].method, "rigid");
        const Result moved = held(R"({"translation": [0.03, -0.01], "rotation": 2})", "");
        const double turn = 2 * M_PI / 180;  // about the middle (1, 0.5); the probe is 1 to the right of it and 0.5 above
        EXPECT_NEAR(moved.probes[0].displacement.x(), 0.03 - 0.5 * turn, 1e-12);
        EXPECT_NEAR(moved.probes[0].displacement.y(), -0.01 + 1 * turn, 1e-12);
        const Result free_x = held(R"({"translation": [null, 0], "rotation": 0})", pulled);
        EXPECT_EQ(free_x.status, "failed");  // nothing holds x
        const Result no_x_load =
            held(R"({"translation": [null, 0], "rotation": 0})", R"({"on": "a/right", "traction": [0, 1]})");
        ASSERT_EQ(no_x_load.status, "ok") << no_x_load.message;
        EXPECT_NEAR(no_x_load.reactions[0].force.y(), -1, 1e-9);
        const Result free_turn =
            held(R"({"translation": [0, 0], "rotation": null})", R"({"on": "a/right", "traction": [0, 1]})");
        EXPECT_EQ(free_turn.status, "failed");  // the load turns it
        EXPECT_EQ(held(R"({"translation": [0, 0]})", pulled).status, "ok");
    }
}

TEST(SupportMethods, AutoDropsFunctionsWhereThatIsExactAndNeverPicksAStructure) {
    const auto method = [](const std::string& accuracy) {
        return answer({.supports = symmetric, .loads = pulled, .accuracy = accuracy}).reactions[0];
    };
    const Reaction aligned = method(R"("grids": {"a": {"cells": [5, 3]}})");
    EXPECT_EQ(aligned.method, "aligned");
    EXPECT_NE(aligned.why.find("exact"), std::string::npos);
    const Reaction weak = method(R"("grids": {"a": {"cells": [5, 3], "offset": [0.03, -0.07]}})");
    EXPECT_EQ(weak.method, "nitsche");
    EXPECT_NE(weak.why.find("outermost lines"), std::string::npos);
}

TEST(SupportMethods, HeldPointsMayBeCornersAndNeedAPartThatTheyGoWith) {
    const auto at = [](const std::string& points) { return R"({"part": "a", "fix": ["x", "y"], "at": )" + points + "}"; };
    EXPECT_EQ(problem_of({.supports = at("[[0, 0], [2, 0]]"), .loads = pulled}), "");
    EXPECT_NE(problem_of({.supports = at("[[0, 0], [2, -0.01]]"), .loads = pulled}).find("(2, -0.01) lies outside part a"),
              std::string::npos);
    Case warm{.supports = at("[[0, 0], [2, 0]]"), .loads = R"({"part": "a", "temperature": 10})"};
    warm.material = R"("E": 1000, "nu": 0.3, "expansion": 1e-5)";
    EXPECT_EQ(problem_of(warm), "");
    warm.accuracy = R"("dirichlet": "solution_structure")";
    EXPECT_NE(problem_of(warm).find("whose temperature changes"), std::string::npos);
}

/// A plate that a half bolt squeezes, kept in place by one of its corners: the corner's function must not be what the plate is
/// pinned by, or the support would hold nothing.
TEST(SupportMethods, APartIsKeptByAnyOfItsCorners) {
    for (const char* corner : {"[30, 0]", "[30, 30]", "[6, 0]", "[6, 30]", "[30, 15]"}) {
        const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "plate", "material": "m", "geometry": {"rectangle": {"min": [6, 0], "max": [30, 30]}}},
            {"name": "bolt", "material": "m", "geometry": {"union": [{"rectangle": {"min": [0, -1], "max": [5, 31]}},
                {"rectangle": {"min": [0, -8], "max": [10, 0]}}, {"rectangle": {"min": [0, 30], "max": [10, 38]}}]}}],
            "supports": [{"part": "plate", "at": )" +
                                      std::string(corner) + R"(, "fix": ["y"]},
                {"part": "plate", "rigid": {"translation": [0, null], "rotation": null}},
                {"on": {"part": "bolt", "facing": [-1, 0]}, "symmetry": true}],
            "loads": [{"on": {"part": "bolt", "near": [7, 38]}, "force": [0, -500]},
                      {"on": {"part": "bolt", "near": [7, -8]}, "force": [0, 500]}], "accuracy": {"level": "draft"}})");
        ASSERT_EQ(r.status, "ok") << corner << ": " << r.message;
        EXPECT_LT(r.reactions.at(0).force.norm(), 1e-6) << corner;
        EXPECT_GT(r.contacts.at(0).force.norm(), 200) << corner;
        EXPECT_NEAR(r.contacts.at(0).force.norm(), r.contacts.at(1).force.norm(), 1e-6) << corner;
    }
}

}  // namespace
}  // namespace abut::support_methods_test
