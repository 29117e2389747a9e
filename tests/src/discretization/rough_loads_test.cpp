// SPDX-License-Identifier: GPL-3.0-or-later
// Loads and displacements that vary along an edge within less than a cell.
#include <gtest/gtest.h>

#include <cmath>

#include "src/analysis/analysis.hpp"
#include "src/discretization/boundary_points.hpp"
#include "src/discretization/part_grid.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::rough_loads_test {
namespace {

std::string block(const std::string& supports, const std::string& loads) {
    return R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [{"name": "a", "material": "m", "geometry":
      {"rectangle": {"min": [0, 0], "max": [10, 10]}}}], "supports": [{"on": "a/bottom", "fix": ["x", "y"]})" +
           supports + R"(], "loads": [)" + loads + R"(], "accuracy": {"level": "draft"}})";
}

Result answer(const std::string& text) {
    return analyze(read_scene_text(text, "rough.json"), {});
}

TEST(RoughLoads, ANarrowPressureIsAllThere) {
    for (const double half_width : {0.02, 0.05, 0.1, 1.0}) {
        const std::string hat = "max(0,1-abs(x-5.2)/" + std::to_string(half_width) + ")";
        const Result pressed = answer(block("", R"({"on": "a/top", "pressure": ")" + hat + R"("})"));
        ASSERT_EQ(pressed.status, "ok") << pressed.message;
        EXPECT_NEAR(pressed.reactions.at(0).force.y(), half_width, 1e-5 * half_width);
        const Result pulled = answer(block("", R"({"on": "a/top", "traction": [")" + hat + R"(", 0]})"));
        EXPECT_NEAR(pulled.reactions.at(0).force.x(), -half_width, 1e-5 * half_width);
    }
}

TEST(RoughLoads, ANarrowDisplacementIsNotLost) {
    const Result r = answer(block(R"x(, {"on": "a/top", "displacement": {"y": "0.01*max(0,1-abs(x-5.2)/0.05)"}})x", ""));
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_GT(r.reactions.at(1).force.y(), 1);
    EXPECT_FALSE(r.accuracy.reached);
}

TEST(RoughLoads, CutsAreWhereTheFieldIsNotSmooth) {
    const Scene scene = read_scene_text(block("", R"({"on": "a/top", "pressure": 1})"), "rough.json");
    const PartGrid grid = grid_of_part(scene, 0, {}, 1, 1);
    const PartOnGrid on_grid = discretize(scene, 0, grid.frame, grid.grid, grid.degree);
    const EdgePortion top{0, 3, 0, 1};  // left, bottom, right, top
    const auto cuts = [&](const EdgeField& field) { return cut_where_rough(on_grid, top, field).size(); };
    EXPECT_EQ(cuts([](const Vec2& x, const Vec2&) { return Vec2(1 + x.x() + x.x() * x.x(), 3); }), 1U);
    EXPECT_EQ(cuts([](const Vec2&, const Vec2&) { return Vec2(0, 0); }), 1U);
    EXPECT_GT(cuts([](const Vec2& x, const Vec2&) { return Vec2(std::max(0.0, x.x() - 0.1), 0); }), 3U);
}

}  // namespace
}  // namespace abut::rough_loads_test
