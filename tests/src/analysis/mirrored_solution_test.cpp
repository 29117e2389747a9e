// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetric scenes solved on the half give what the whole gives on the same grids.
#include "solver/contact/mirrored_solution.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "solver/parts/fold.hpp"
#include "src/analysis/adaptive.hpp"
#include "src/plan/mirror_symmetry.hpp"
#include "src/scene/read_scene.hpp"
#include "src/solution/mirrored_grids.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::mirrored_solution_test {
namespace {

struct Case {
    std::string name, scene;
    int folded;     ///< parts that are their own images
    int followers;  ///< parts that are solved as images of others
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

const std::string head = R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3, "density": 1e-3, "expansion": 1e-5},
    "hard": {"E": 1e6, "nu": 0.3, "density": 1e-3}, "rubber": {"E": 10, "nu": 0.4999, "density": 1e-3}}, )";

std::string part(const std::string& name, const std::string& geometry, const std::string& material = "m") {
    return R"({"name": ")" + name + R"(", "material": ")" + material + R"(", "geometry": )" + geometry + "}";
}

std::string scene(const std::string& parts, const std::string& rest) {
    return head + R"("parts": [)" + parts + "], " + rest + "}";
}

// The dissertation's cases A, B, C and the vise [Grishin10, sections 5.1 and 5.2] without their symmetry supports.
const std::string case_a = scene(
    part("punch", R"({"rectangle": {"min": [-0.5, 0], "max": [0.5, 0.5]}})") + "," +
        part("die", R"({"rectangle": {"min": [-1, -1.1], "max": [1, 0]}})"),
    R"("supports": [{"on": "die/bottom", "fix": ["y"]}, {"part": "die", "rigid": {"translation": [0, null], "rotation": null}}],
             "loads": [{"on": "punch/top", "pressure": 250}],
             "accuracy": {"grids": {"punch": {"cells": [10, 6]}, "die": {"cells": [20, 11]}}})");

const std::string half_discs = part("upper", R"({"intersection": [{"circle": {"center": [0, 1], "radius": 1}},
                                       {"rectangle": {"min": [-1, 0], "max": [1, 1]}}]})") +
                               "," + part("lower", R"({"intersection": [{"circle": {"center": [0, -2], "radius": 2}},
                                       {"rectangle": {"min": [-2, -2], "max": [2, 0]}}]})");
const std::string case_b = scene(half_discs, R"("supports": [{"on": "lower/bottom", "fix": ["y"]},
                           {"part": "lower", "rigid": {"translation": [0, null], "rotation": null}},
                           {"part": "upper", "rigid": {"translation": [0, null], "rotation": 0}}],
             "loads": [{"on": "upper/top", "pressure": 250}],
             "accuracy": {"grids": {"upper": {"cells": [23, 11]}, "lower": {"cells": [38, 19]}}})");
const std::string case_c = scene(part("cylinder", R"({"intersection": [{"circle": {"center": [0, 1], "radius": 1}},
                                                {"rectangle": {"min": [-1, 0], "max": [1, 1]}}]})") +
                                     "," + part("block", R"({"difference": [{"rectangle": {"min": [-3, -2], "max": [3, 2]}},
                                               {"name": "groove", "circle": {"center": [0, 2], "radius": 2}}]})"),
                                 R"("supports": [{"on": "block/bottom", "fix": ["y"]},
                          {"part": "block", "rigid": {"translation": [0, null], "rotation": null}},
                          {"part": "cylinder", "rigid": {"translation": [0, null], "rotation": 0}}],
             "loads": [{"on": "cylinder/top", "pressure": 250}],
             "accuracy": {"grids": {"cylinder": {"cells": [24, 8]}, "block": {"cells": [33, 17]}}})");
const std::string vise_parts =
    part("workpiece", R"({"rectangle": {"min": [-0.6, 0], "max": [0.6, 1.1]}})") + "," +
    part("jaw", R"({"polygon": [[0.6, -0.9], [2.2, -0.9], [2.2, -0.4], [1.0, 0.0], [1.0, 1.1], [0.6, 1.1]]})", "hard") + "," +
    part("other", R"({"polygon": [[-0.6, -0.9], [-2.2, -0.9], [-2.2, -0.4], [-1.0, 0.0], [-1.0, 1.1], [-0.6, 1.1]]})", "hard");
const std::string vise_rest = R"("supports": [{"on": "workpiece/bottom", "symmetry": true},
        {"on": ["jaw/e0", "other/e0"], "fix": ["y"]}, {"on": "jaw/e1", "displacement": {"x": -0.01}},
        {"on": "other/e1", "displacement": {"x": 0.01}}],
    "accuracy": {"grids": {"workpiece": {"cells": [12, 11]}, "jaw": {"cells": [16, 20]}, "other": {"cells": [16, 20]}}})";

std::string vise(const std::string& formulation) {
    return scene(vise_parts, R"("contacts": {"formulation": ")" + formulation + R"("}, )" + vise_rest);
}

/// The four-pin beam pulled along itself: pins and holes are mirrored about its own axis.
std::string beam() {
    std::string parts, plate = R"({"name": "plate", "rectangle": {"min": [0, 0], "max": [29, 19]}})", rest;
    int k = 0;
    for (const char* center : {"[5, 5]", "[14, 5]", "[5, 14]", "[14, 14]"}) {
        const std::string n = std::to_string(++k);
        plate += R"(, {"circle": {"center": )" + std::string(center) + R"(, "radius": 3}})";
        parts += part("pin" + n, R"({"difference": [{"circle": {"center": )" + std::string(center) +
                                     R"(, "radius": 3}}, {"name": "core", "circle": {"center": )" + center +
                                     R"(, "radius": 1}}]})") +
                 ", ";
    }
    return scene(
        parts + part("beam", R"({"difference": [)" + plate + "]}"),
        R"("supports": [{"on": "pin*/core/*", "fix": ["x", "y"]}], "loads": [{"on": "beam/plate/right", "force": [1000, 0]}],
                    "accuracy": {"cell_size": 0.83})");
}

/// Two discs pressed together: their contact lies on the mirror line.
std::string discs(const std::string& material, const std::string& rest) {
    return scene(part("left", R"({"circle": {"center": [-1, 0], "radius": 1}})", material) + "," +
                     part("right", R"({"circle": {"center": [1, 0], "radius": 1}})", material),
                 rest + R"("supports": [{"part": "left", "rigid": {"translation": [0.04, 0], "rotation": 0}},
                                 {"part": "right", "rigid": {"translation": [-0.04, 0], "rotation": 0}}],
                    "accuracy": {"cell_size": 0.11})");
}

/// Two bonded blocks: one on the other, or side by side across the mirror line.
std::string bonded(const std::string& first, const std::string& second, const std::string& between) {
    return scene(part("a", R"({"rectangle": )" + first + "}") + "," + part("b", R"({"rectangle": )" + second + "}", "m"),
                 R"("supports": [{"on": ["a/bottom", "b/bottom"], "spring": {"normal": 1e4, "tangential": 1e3}}],
                    "loads": [{"on": ["a/top", "b/top"], "pressure": "3 + x^2"}],
                    "contacts": {"pairs": [{"between": )" +
                     between + R"(, "kind": "bonded"}]}, "accuracy": {"cell_size": 0.13})");
}

std::string ring_on_pin(const std::string& rest) {
    return scene(part("plate", R"({"difference": [{"rectangle": {"min": [-3, -2], "max": [3, 2.5]}},
                                                  {"name": "hole", "circle": {"center": [0, 0], "radius": 1}}]})") +
                     "," + part("pin", R"({"circle": {"center": [0, 0], "radius": 1}})", "hard"),
                 R"("supports": [{"on": "plate/bottom", "fix": ["x", "y"]},
                              {"part": "pin", "rigid": {"translation": [null, null], "rotation": 0}}], )" +
                     rest);
}

std::string block(const std::string& material, const std::string& loads, const std::string& more,
                  const std::string& rest = "") {
    return scene(part("block", R"({"difference": [{"rectangle": {"min": [-2, 0], "max": [2, 1.7]}},
                                                  {"circle": {"center": [0, 1.7], "radius": 0.6}},
                                                  {"slot": {"from": [-1.3, 0.3], "to": [-1.3, 1.2], "radius": 0.02}},
                                                  {"slot": {"from": [1.3, 0.3], "to": [1.3, 1.2], "radius": 0.02}}]})",
                      material),
                 rest + R"("supports": [{"on": "block/bottom", "fix": ["x", "y"]}], "loads": [)" + loads +
                     R"(], "accuracy": {"cell_size": 0.13)" + more + "}");
}

const std::string squeezed = R"({"on": ["block/left", "block/right"], "pressure": "1 + y"}, {"gravity": [0, -10]})";

/// Three bonded blocks that nothing holds along the mirror line: two mirrored ones pressed from below, the middle one from
/// above; off: by how much the loads are out of balance.
std::string free_blocks(double off) {
    return scene(part("l", R"({"rectangle": {"min": [-3, 0], "max": [-1, 1]}})") + "," +
                     part("r", R"({"rectangle": {"min": [1, 0], "max": [3, 1]}})") + "," +
                     part("o", R"({"rectangle": {"min": [-3, 1], "max": [3, 2]}})"),
                 R"("supports": [{"part": "o", "rigid": {"translation": [0, null], "rotation": 0}}],
                    "loads": [{"on": ["l/bottom", "r/bottom"], "pressure": 3}, {"on": "o/top", "pressure": )" +
                     test::number(2 + off) + R"(}],
                    "contacts": {"pairs": [{"between": ["l/top", "o/bottom"], "kind": "bonded"},
                                           {"between": ["r/top", "o/bottom"], "kind": "bonded"}]},
                    "accuracy": {"cell_size": 0.23})");
}

std::vector<Case> cases() {
    std::vector<Case> list{
        {"case A", case_a, 2, 0},
        {"case B", case_b, 2, 0},
        {"case C", case_c, 2, 0},
        {"vise", vise("mortar"), 1, 1},
        {"vise by penalty", vise("penalty"), 1, 1},
        {"pulled beam", beam(), 1, 2},
        {"discs", discs("m", ""), 0, 1},
        {"rubber discs", discs("rubber", R"("analysis": "plane_strain", )"), 0, 1},
        {"bonded neighbours",
         bonded(R"({"min": [-1, 0], "max": [0, 2]})", R"({"min": [0, 0], "max": [1, 2]})", R"(["a/right", "b/left"])"), 0, 1},
        {"bonded blocks",
         bonded(R"({"min": [-1, 0], "max": [1, 1]})", R"({"min": [-0.6, 1], "max": [0.6, 2]})", R"(["a/top", "b/bottom"])"), 2,
         0},
        {"rubber block", block("rubber", squeezed, "", R"("analysis": "plane_strain", )"), 1, 0},
        {"loaded pin", ring_on_pin(R"("loads": [{"part": "pin", "force": [0, -5e3]}], "accuracy": {"cell_size": 0.21})"), 2, 0},
        {"pressed pin",
         ring_on_pin(R"("contacts": {"pairs": [{"between": ["plate/hole*", "pin/circle"], "interference": 1e-3}]},
                        "accuracy": {"cell_size": 0.21})"),
         2, 0},
        {"rigid pin",
         scene(part("plate", R"({"difference": [{"rectangle": {"min": [-3, -2], "max": [3, 2.5]}},
                                                {"name": "hole", "circle": {"center": [0, 0], "radius": 1}}]})") +
                   "," + part("pin", R"({"circle": {"center": [0, 0], "radius": 0.999}})", "rigid"),
               R"("supports": [{"on": "plate/bottom", "fix": ["x", "y"]}], "loads": [{"part": "pin", "force": [0, -5e3]}],
                  "accuracy": {"cell_size": 0.17})"),
         2, 0},
        {"heated block", block("m", R"({"part": "block", "temperature": "100 + 5*x^2*y"})", ""), 1, 0},
        {"spinning block", block("m", R"({"part": "block", "spin": {"about": [0, -3], "omega": 20}})", ""), 1, 0},
        {"block on springs",
         scene(part("block", R"({"rectangle": {"min": [-2, 0], "max": [2, 1]}})"),
               R"("supports": [{"on": "block/bottom", "spring": {"normal": 1e3, "tangential": 10}}],
                  "loads": [{"on": {"part": "block", "box": [[-0.5, 0.9], [0.5, 1.1]]}, "pressure": 3}],
                  "accuracy": {"cell_size": 0.19})"),
         1, 0},
    };
    list.push_back({"tubes shrunk together",
                    scene(part("in", R"({"rectangle": {"min": [1, 0], "max": [2, 1]}})") + "," +
                              part("out", R"({"rectangle": {"min": [2, -0.5], "max": [3, 1.5]}})"),
                          R"("analysis": "axisymmetric", "supports": [{"on": "out/right", "spring": {"normal": 10}}],
                             "loads": [{"on": ["out/top", "out/bottom"], "pressure": 5}],
                             "contacts": {"pairs": [{"between": ["in/right", "out/left"], "interference": 0.002}]},
                             "accuracy": {"cell_size": 0.11})"),
                    2, 0});
    list.push_back({"rings pressed together",
                    scene(part("low", R"({"intersection": [{"circle": {"center": [2, -1], "radius": 1}},
                                                           {"rectangle": {"min": [0, -1], "max": [4, 0.1]}}]})") +
                              "," + part("high", R"({"intersection": [{"circle": {"center": [2, 1], "radius": 1}},
                                                           {"rectangle": {"min": [0, -0.1], "max": [4, 1]}}]})"),
                          R"("analysis": "axisymmetric", "supports": [{"on": "low/bottom", "displacement": {"y": 0.05}},
                                                                      {"on": "high/top", "displacement": {"y": -0.05}}],
                             "accuracy": {"cell_size": 0.09})"),
                    0, 1});
    list.push_back({"apart from each other",
                    scene(part("left", R"({"rectangle": {"min": [-4, 0], "max": [-3, 1]}})") + "," +
                              part("right", R"({"rectangle": {"min": [3, 0], "max": [4, 1]}})") + "," +
                              part("mid", R"({"circle": {"center": [0, 0], "radius": 1}})"),
                          R"("supports": [{"on": ["left/bottom", "right/bottom"], "fix": ["x", "y"]},
                                          {"part": "mid", "rigid": {"translation": [0, 0], "rotation": 0}}],
                             "loads": [{"on": "left/top", "traction": [2, -5]}, {"on": "right/top", "traction": [-2, -5]},
                                       {"part": "mid", "body_force": ["x", "y^2"]}],
                             "accuracy": {"cell_size": 0.11})"),
                    1, 1});
    list.push_back({"free blocks", free_blocks(0), 1, 1});
    list.push_back({"free blocks out of balance by rounding", free_blocks(1e-11), 1, 1});
    for (int degree : {1, 2, 3, 4})
        list.push_back({"block of degree " + std::to_string(degree),
                        block("m", squeezed, R"(, "degree": )" + std::to_string(degree)), 1, 0});
    return list;
}

struct Pass {
    SolvedAssembly whole, half;
};

Pass solved_both_ways(const std::string& text) {
    const Scene scene = read_scene_text(text, "scene.json");
    ResolvedConditions conditions = resolve_conditions(scene);
    const MirrorSymmetry symmetry = find_mirror_symmetry(scene, conditions);
    EXPECT_TRUE(symmetry.found) << symmetry.why_not;
    std::vector<Candidate> candidates = find_candidates(scene, 1);
    put_seams_on_mirror(scene, symmetry.line, candidates);
    const std::size_t n = scene.parts.size();
    Stopwatches seconds;
    Pass pass;
    pass.whole = solve_pass(scene, conditions, candidates, std::vector<bool>(n, true), WantedSizes(n), 1, seconds);
    conditions.mirror = symmetry.line;
    pass.half = solve_pass(scene, conditions, candidates, std::vector<bool>(n, true), WantedSizes(n), 1, seconds);
    return pass;
}

double relative_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return (a - b).lpNorm<Eigen::Infinity>() / std::max(a.lpNorm<Eigen::Infinity>(), 1e-300);
}

class MirroredSolution : public testing::TestWithParam<Case> {};

TEST_P(MirroredSolution, EqualsTheWhole) {
    const Pass pass = solved_both_ways(GetParam().scene);
    ASSERT_EQ(pass.half.failure, "");
    ASSERT_TRUE(pass.half.is_folded) << pass.half.not_folded;
    const solver::AssemblySolution &whole = pass.whole.solution, &half = pass.half.solution;
    ASSERT_TRUE(whole.converged && half.converged);
    int folded = 0, followers = 0, unknowns = 0;
    for (const solver::PartSystem& s : pass.half.problem.parts) {
        folded += solver::is_folded(s.input) ? 1 : 0;
        followers += solver::is_follower(s.input) ? 1 : 0;
        unknowns += s.n_kept;
    }
    EXPECT_EQ(folded, GetParam().folded);
    EXPECT_EQ(followers, GetParam().followers);
    int all = 0;
    for (const solver::PartSystem& s : pass.whole.problem.parts) all += s.n_kept;
    EXPECT_NEAR(unknowns, 0.5 * all, 0.03 * all + 4);
    double largest = 0;
    for (const Eigen::VectorXd& u : whole.displacement) largest = std::max(largest, u.lpNorm<Eigen::Infinity>());
    for (std::size_t k = 0; k < whole.displacement.size(); ++k)
        EXPECT_LT((whole.displacement[k] - half.displacement[k]).lpNorm<Eigen::Infinity>(), 1e-9 * largest) << k;
    ASSERT_EQ(whole.pressure.size(), half.pressure.size());
    double highest = 0;
    for (const Eigen::VectorXd& p : whole.pressure) highest = std::max(highest, p.lpNorm<Eigen::Infinity>());
    for (std::size_t k = 0; k < whole.pressure.size(); ++k)
        EXPECT_LT((whole.pressure[k] - half.pressure[k]).lpNorm<Eigen::Infinity>(), 1e-9 * highest) << k;
    for (std::size_t k = 0; k < whole.load.size(); ++k) EXPECT_LT(relative_difference(whole.load[k], half.load[k]), 1e-9) << k;
}

/// Every comparison sees a difference that is ten times what it lets pass.
TEST(Asymmetry, OfAPartIsSeen) {
    const Scene scene = read_scene_text(case_a, "scene.json");
    ResolvedConditions conditions = resolve_conditions(scene);
    conditions.mirror = find_mirror_symmetry(scene, conditions).line;
    Stopwatches seconds;
    const SolvedAssembly solved =
        solve_pass(scene, conditions, find_candidates(scene, 1), {true, true}, WantedSizes(2), 1, seconds);
    const auto seen = [&](const auto& change) {
        SolvedAssembly again =
            solve_pass(scene, conditions, find_candidates(scene, 1), {true, true}, WantedSizes(2), 1, seconds);
        change(again.problem);
        const solver::MirrorFailure of_parts = asymmetry_of_parts(again.problem);
        return of_parts.what.empty() ? solver::solve_mirrored(again.problem).failure.what : of_parts.what;
    };
    const double off = 10 * solver::asymmetry;
    EXPECT_EQ(seen([](auto&) {}), "");
    EXPECT_NE(seen([&](auto& p) { p.parts[0].load[0] += off * p.parts[0].load.cwiseAbs().maxCoeff(); }), "");
    EXPECT_NE(seen([&](auto& p) { p.parts[1].prescribed[0] += off; }), "");
    EXPECT_NE(seen([&](auto& p) { p.parts[0].stiffness.block[0] *= 1 + off; }), "");
    EXPECT_NE(seen([&](auto& p) { p.parts[0].dropped[0] = !p.parts[0].dropped[0]; }), "");
    EXPECT_NE(seen([&](auto& p) { p.interfaces[0].points[2].gap += 1e-6; }), "");
    EXPECT_NE(seen([&](auto& p) { p.interfaces[0].points[2].weight *= 1 + 100 * off; }), "");
    EXPECT_NE(seen([&](auto& p) {
                  p.interfaces[0].bilateral = !p.interfaces[0].bilateral;
                  p.interfaces[0].points[2].gap = 1;
              }),
              "");
}

INSTANTIATE_TEST_SUITE_P(Scenes, MirroredSolution, testing::ValuesIn(cases()),
                         [](const testing::TestParamInfo<Case>& instance) {
                             std::string name = instance.param.name;
                             std::replace(name.begin(), name.end(), ' ', '_');
                             return name;
                         });

}  // namespace
}  // namespace abut::mirrored_solution_test
