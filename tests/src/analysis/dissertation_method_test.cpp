// SPDX-License-Identifier: GPL-3.0-or-later
// A scene by the dissertation's method: what it consists of, what it answers, what it refuses.
#include "src/scene/dissertation_method.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::dissertation_method_test {
namespace {

struct Blocks {
    std::string accuracy = R"("method": "dissertation", "cell_size": 0.3)";
    std::string contacts = R"("formulation": "penalty", "penalty": 500)";
    std::string supports = R"({"on": ["lower/left", "upper/left", "lower/bottom"], "symmetry": true})";
    std::string loads = R"({"on": "upper/top", "pressure": 100})";
    std::string material = R"("m": {"E": 1e5, "nu": 0.3, "expansion": 1e-5})";
    std::string more = "";
};

/// Two blocks under the pressure 100: uniform stress.
Scene scene_of(const Blocks& b) {
    return read_scene_text(
        R"({"abut": 1, "materials": {)" + b.material + R"(}, "parts": [
        {"name": "lower", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [2, 1]}}},
        {"name": "upper", "material": "m", "geometry": {"rectangle": {"min": [0, 1], "max": [2, 2]}}}],
        "supports": [)" +
            b.supports + R"(], "loads": [)" + b.loads + R"(], "contacts": {)" + b.contacts + R"(}, "accuracy": {)" +
            b.accuracy + R"(}, "output": {"probes": [{"part": "upper", "at": [1, 2]}, {"part": "lower", "at": [1, 0.5]}]})" +
            b.more + "}",
        "s.json");
}

std::string problem_of(const Blocks& b) {
    try {
        analyze(scene_of(b), {});
    } catch (const InputError& error) { return one_line(error.problems().front()); }
    return "";
}

TEST(DissertationMethod, IsMadeOfItsParts) {
    const Scene scene = scene_of({});
    EXPECT_TRUE(is_by_dissertation(scene));
    EXPECT_EQ(scene.accuracy.basis, "normalized");
    EXPECT_EQ(scene.accuracy.dirichlet, "solution_structure");
    EXPECT_EQ(scene.accuracy.weights, "r_function");
    ASSERT_TRUE(scene.contacts.penalty);
    EXPECT_EQ(scene.contacts.penalty->factor, 500);
    EXPECT_EQ(scene.contacts.penalty->pairing, Pairing::master);
    EXPECT_FALSE(scene.contacts.penalty->split_by_second);
    EXPECT_EQ(scene_of({.accuracy = R"("method": "dissertation", "weights": "blended")"}).accuracy.weights, "blended");
}

/// Whatever the weights: linear functions lie in the space only with linear weights, the others come near.
TEST(DissertationMethod, FindsUniformStress) {
    const auto solved = [](const std::string& weights) {
        return analyze(scene_of({.accuracy = R"("method": "dissertation", "cell_size": 0.3, "weights": ")" + weights + "\""}),
                       {});
    };
    for (const char* weights : {"r_function", "joined"}) {
        const Result r = solved(weights);
        ASSERT_EQ(r.status, "ok") << r.message;
        ASSERT_EQ(r.contacts.size(), 1U);
        EXPECT_NEAR(r.probes[1].stress.yy, -100, 1e-6);
        EXPECT_NEAR(r.contacts[0].force.norm(), 200, 1e-6);
        // 100 / 1e5 over both, and the penetration 100 / beta, beta = 500 E / the first part's cell
        EXPECT_NEAR(r.probes[0].displacement.y(), -2e-3 - 100 * 0.3 / (500 * 1e5), 1e-9);
        EXPECT_EQ(r.reactions[0].method, "structure");
    }
    const Result r = solved("blended");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_NEAR(r.probes[1].stress.yy, -100, 5);
    EXPECT_NEAR(r.contacts[0].force.norm(), 200, 1e-2);
}

/// Both parts' grids are pieces of the one grid.
TEST(DissertationMethod, SplitsOneGrid) {
    const Result r = analyze(scene_of({}), {});
    ASSERT_EQ(r.parts.size(), 2U);
    const std::vector<double>&lower = r.parts[0].grid_y, &upper = r.parts[1].grid_y;
    EXPECT_EQ(lower.size(), 5U);  // 0 to 1.2
    EXPECT_NEAR(lower.front(), 0, 1e-12);
    EXPECT_NEAR(lower.back(), 1.2, 1e-12);
    EXPECT_NEAR(upper.front(), 0.9, 1e-12);
    EXPECT_NEAR(upper.back(), 2.1, 1e-12);
    EXPECT_EQ(r.parts[0].cells_outer, 0);
    EXPECT_EQ(r.solver.grids, 1);
}

TEST(DissertationMethod, HasAConditionNumberOfTheWholeMatrix) {
    const Result written = analyze(scene_of({}), {}), ours = analyze(scene_of({.accuracy = R"("cell_size": 0.3)"}), {});
    ASSERT_TRUE(written.solver.assembled_condition);
    EXPECT_FALSE(ours.solver.assembled_condition);
    // a hundredfold penalty makes a matrix of that much larger entries, whose smallest eigenvalue stays
    const Result stiff = analyze(scene_of({.contacts = R"("formulation": "penalty", "penalty": 50000)"}), {});
    const double ratio = *stiff.solver.assembled_condition / *written.solver.assembled_condition;
    EXPECT_GT(ratio, 50);
    EXPECT_LT(ratio, 150);
}

TEST(DissertationMethod, WarnsWhereContactLeavesTheCells) {
    // a roller pressed to a half width of 0.16: cells of 0.003 see the drawn gap up to 0.08, cells of 0.05 up to 0.3
    const auto scene = [](double cell) {
        return read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [
            {"name": "floor", "material": "m", "geometry": {"rectangle": {"min": [0, -1], "max": [2, 0]}}},
            {"name": "roller", "material": "m", "geometry": {"intersection": [{"circle": {"center": [0, 1], "radius": 1}},
              {"rectangle": {"min": [0, 0], "max": [1, 1]}}]}}],
            "supports": [{"on": ["floor/left", "roller/left", "floor/bottom"], "symmetry": true}],
            "loads": [{"on": "roller/top", "pressure": 5}],
            "accuracy": {"method": "dissertation", "grids": {"floor": {"cells": [40, 20]}, "roller": {"cells": [20, 20]}}, "cell_size": )" +
                                   std::to_string(cell) + "}}",
                               "s.json");
    };
    const auto warns = [](const Result& r) {
        for (const std::string& w : r.warnings)
            if (w.find("end of what was searched") != std::string::npos && w.find("cell_size") != std::string::npos)
                return true;
        return false;
    };
    EXPECT_TRUE(warns(analyze(scene(0.003), {})));
    EXPECT_FALSE(warns(analyze(scene(0.05), {})));
}

TEST(DissertationMethod, RefusesWhatItHasNoFormulationFor) {
    struct Refused {
        Blocks scene;
        std::string where, what;
    };
    const std::string method = R"("method": "dissertation", "cell_size": 0.3)";
    const std::vector<Refused> refused{
        {{.supports = R"({"on": "lower/bottom", "spring": {"normal": 1e4}})"}, "/supports/0", "edges on springs"},
        {{.supports = R"({"part": "lower", "rigid": {"translation": [0, 0], "rotation": 0}})"}, "/supports/0", "mean motion"},
        {{.loads = R"({"part": "lower", "temperature": 10})"}, "/loads/0", "temperatures"},
        {{.contacts = R"("pairs": [{"between": ["lower/top", "upper/bottom"], "kind": "bonded"}])"},
         "/contacts/pairs/0",
         "bonded edges"},
        {{.more = R"(, "analysis": "axisymmetric")"}, "/analysis", "around an axis"},
        {{.contacts = R"("formulation": "mortar")"}, "/contacts/formulation", "by penalty"},
        {{.contacts = R"("search_distance": 0.1)"}, "/contacts/search_distance", "does not go with"},
        {{.accuracy = method + R"(, "basis": "web")"}, "/accuracy/basis", "does not go with"},
        {{.accuracy = method + R"(, "target": 0.01)"}, "/accuracy/target", "does not go with"},
        {{.accuracy = R"("weights": "blended")"}, "/accuracy/weights", "solution structure"},
        {{.accuracy = R"("method": "dissertation", "grids": {"lower": {"cells": [7, 4], "angle": 20}})"},
         "/supports/0",
         "cannot hold edge"},
    };
    for (const Refused& r : refused) {
        const std::string text = problem_of(r.scene);
        EXPECT_NE(text.find(r.where), std::string::npos) << r.where << ": " << text;
        EXPECT_NE(text.find(r.what), std::string::npos) << r.what << ": " << text;
    }
}

/// The lower left edge of an L goes on inside it: as a whole line it would hold the L there.
TEST(DissertationMethod, RefusesWholeLinesThatGoOnInside) {
    const auto scene = [](const std::string& weights) {
        return read_scene_text(
            R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [{"name": "l", "material": "m",
            "geometry": {"polygon": [[0, 1], [1, 1], [1, 0], [2, 0], [2, 2], [0, 2]]}}],
            "supports": [{"on": "l/e0", "fix": ["x", "y"]}], "loads": [{"on": "l/e4", "pressure": 1}],
            "accuracy": {"method": "dissertation", "weights": ")" +
                weights + "\"}}",
            "s.json");
    };
    try {
        analyze(scene("r_function"), {});
        FAIL() << "not refused";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problems().front().where, "s.json /supports/0");
        EXPECT_NE(error.problems().front().what.find("e0"), std::string::npos) << error.problems().front().what;
    }
    EXPECT_EQ(analyze(scene("joined"), {}).status, "ok");
    EXPECT_EQ(analyze(scene("blended"), {}).status, "ok");
}

/// All sides of a window together are the R-function of its rectangle: no line goes on through the part.
TEST(DissertationMethod, HoldsAWindowByItsTree) {
    const auto scene = [](const std::string& weights, const std::string& held) {
        return read_scene_text(
            R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [{"name": "p", "material": "m",
            "geometry": {"difference": [{"rectangle": {"min": [0, 0], "max": [6, 4]}, "name": "plate"},
                                        {"rectangle": {"min": [2, 1], "max": [4, 2]}, "name": "window"}]}}],
            "supports": [{"on": ")" +
                held + R"(", "fix": ["x", "y"]}], "loads": [{"on": "p/plate/top", "pressure": 1}],
            "output": {"probes": [{"part": "p", "at": [3, 3.9]}]},
            "accuracy": {"method": "dissertation", "cell_size": 0.1, "weights": ")" +
                weights + "\"}}",
            "s.json");
    };
    const Result tree = analyze(scene("r_function", "p/window/*"), {}), joined = analyze(scene("joined", "p/window/*"), {});
    ASSERT_EQ(tree.status, "ok") << tree.message;
    ASSERT_EQ(joined.status, "ok") << joined.message;
    EXPECT_NE(tree.probes[0].displacement.y(), joined.probes[0].displacement.y());
    EXPECT_NEAR(tree.probes[0].displacement.y() / joined.probes[0].displacement.y(), 1, 0.02);
    EXPECT_THROW(analyze(scene("r_function", "p/window/left"), {}), InputError);
}

}  // namespace
}  // namespace abut::dissertation_method_test
