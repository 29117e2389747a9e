// SPDX-License-Identifier: GPL-3.0-or-later
// "symmetry": "auto" as a user meets it: scenes on grids of their own, what is said of scenes that are not symmetric.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::half_scene_test {
namespace {

const Effect& symmetry_of(const Result& r) {
    return *std::find_if(r.effects.begin(), r.effects.end(), [](const Effect& e) { return e.name == "symmetry"; });
}

/// A scene of data/ solved as drawn, and on the half.
struct Both {
    Result whole, half;
};
Both both(const std::string& file) {
    Scene scene = read_scene(std::string(ABUT_SOURCE_DIR) + "/data/" + file);
    Both b{analyze(scene, {}), {}};
    scene.fold_symmetry = true;
    b.half = analyze(scene, {});
    return b;
}

class HalfScene : public testing::TestWithParam<const char*> {};

/// The grids differ a little, since those of the half are made symmetric: answers agree to their own estimates.
TEST_P(HalfScene, AgreesOnItsOwnGrids) {
    const auto [whole, half] = both(GetParam());
    ASSERT_EQ(half.status, "ok") << half.message;
    EXPECT_TRUE(symmetry_of(half).on);
    EXPECT_FALSE(symmetry_of(whole).on);
    EXPECT_EQ(symmetry_of(whole).calls, 0);
    EXPECT_GT(symmetry_of(half).calls, 0);
    EXPECT_GT(symmetry_of(half).items, 0.45 * half.unknowns);
    EXPECT_EQ(whole.warnings, half.warnings);
    EXPECT_LT(half.equilibrium.relative_residual, 1e-9);
    ASSERT_EQ(whole.contacts.size(), half.contacts.size());
    for (std::size_t k = 0; k < whole.contacts.size(); ++k) {
        const double p = whole.contacts[k].max_pressure.value, force = whole.contacts[k].force.norm();
        EXPECT_NEAR(half.contacts[k].max_pressure.value, p, 0.03 * p) << k;
        EXPECT_NEAR(half.contacts[k].force.norm(), force, 1e-3 * force) << k;
    }
    EXPECT_NEAR(half.strain_energy, whole.strain_energy, 2e-3 * whole.strain_energy);
}

INSTANTIATE_TEST_SUITE_P(Scenes, HalfScene, testing::Values("scenes/pin_bracket.json", "scenes/cam_follower.json"),
                         [](const auto& info) { return "case" + std::to_string(info.index); });

std::string block(const std::string& first, const std::string& load, const std::string& accuracy) {
    return R"({"abut": 1, "symmetry": "auto", "materials": {"m": {"E": 1e5, "nu": 0.3}},
        "parts": [{"name": "a", "material": "m", "geometry": )" +
           first + R"(}], "supports": [{"on": "a/bottom", "fix": ["x", "y"]}], "loads": [)" + load + R"(], "accuracy": )" +
           accuracy + "}";
}
const std::string square = R"({"rectangle": {"min": [-1, 0], "max": [1, 1]}})";

/// Warnings but for that of the stress at the ends of a clamped edge, which has no limit.
std::vector<std::string> others(const Result& r) {
    std::vector<std::string> warnings;
    std::copy_if(r.warnings.begin(), r.warnings.end(), std::back_inserter(warnings),
                 [](const std::string& w) { return w.find("has no limit there") == std::string::npos; });
    return warnings;
}

TEST(HalfSceneWarnings, SayWhyAllOfItWasSolved) {
    const Result pushed = test::answer(block(square, R"({"on": "a/left", "pressure": 1})", "{}"));
    ASSERT_EQ(others(pushed).size(), 1u);
    EXPECT_NE(others(pushed)[0].find("solved as drawn: not mirror symmetric about x = 0: load 0 has no mirror image"),
              std::string::npos)
        << others(pushed)[0];
    EXPECT_FALSE(symmetry_of(pushed).on);
    const Result shifted = test::answer(
        block(square, R"({"on": "a/top", "pressure": 1})", R"({"grids": {"a": {"cells": [8, 4], "offset": [0.1, 0]}}})"));
    ASSERT_EQ(others(shifted).size(), 1u);
    EXPECT_NE(others(shifted)[0].find("part a: its grid lines have no mirror image"), std::string::npos) << others(shifted)[0];
    EXPECT_FALSE(symmetry_of(shifted).on);
    const Result turned =
        test::answer(block(square, R"({"on": "a/top", "pressure": 1})", R"({"grids": {"a": {"cells": [8, 4], "angle": 20}}})"));
    ASSERT_EQ(others(turned).size(), 1u);
    EXPECT_NE(others(turned)[0].find("its grid is turned against the mirror line"), std::string::npos) << others(turned)[0];
}

/// Of groups that do not interact, too.
TEST(HalfSceneWarnings, AreNotLostWithSeveralGroups) {
    const std::string blocks = R"({"abut": 1, "symmetry": "auto", "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [
        {"name": "a", "material": "m", "geometry": {"rectangle": {"min": [-1, 0], "max": [1, 1]}}},
        {"name": "b", "material": "m", "geometry": {"rectangle": {"min": [-1, 9], "max": [1, 10]}}}],
        "supports": [{"on": ["a/bottom", "b/bottom"], "fix": ["x", "y"]}], "loads": [{"on": ["a/top", "b/top"], "pressure": 1}],
        "accuracy": {"grids": {"a": {"cells": [6, 4]}, "b": {"cells": [6, 4], "offset": [0.1, 0]}}}})";
    const Result r = test::answer(blocks);
    ASSERT_EQ(others(r).size(), 1u);
    EXPECT_NE(others(r)[0].find("part b: its grid lines have no mirror image"), std::string::npos) << others(r)[0];
    EXPECT_FALSE(symmetry_of(r).on);
}

/// Adapted to the stress, without contact: every pass is folded.
TEST(HalfSceneWarnings, AreNoneWithoutContact) {
    const Result notched = test::answer(block(
        R"({"difference": [{"rectangle": {"min": [-1, 0], "max": [1, 1]}}, {"circle": {"center": [0, 1], "radius": 0.3}}]})",
        R"({"on": ["a/left", "a/right"], "pressure": 1})", R"({"target": 0.01})"));
    ASSERT_EQ(notched.status, "ok") << notched.message;
    EXPECT_TRUE(others(notched).empty()) << others(notched)[0];
    EXPECT_EQ(symmetry_of(notched).calls, notched.solver.grids);
}

}  // namespace
}  // namespace abut::half_scene_test
