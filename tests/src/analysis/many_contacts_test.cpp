// SPDX-License-Identifier: GPL-3.0-or-later
// Bearings whose rows of contact are many: those that stay open are left out, which the answer must not show.
#include <gtest/gtest.h>

#include "solver/contact/load_answers.hpp"
#include "src/analysis/analyzed.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::many_contacts_test {
namespace {

Scene bearing(int rollers, const std::string& level) {
    Scene scene = read_scene(ABUT_SOURCE_DIR "/data/scenes/roller_bearing.json", {{"rollers", rollers}});
    scene.accuracy.level = level;
    return scene;
}

}  // namespace

TEST(ManyContacts, AreAnsweredAsByAllOfTheirRows) {
    const Scene scene = bearing(24, "draft");
    const Analyzed answered = analyze_and_keep(scene, {});
    const SolvedAssembly& solved = answered.outcome.solved;
    ASSERT_GT(solved.solution.n_multipliers, 500) << "rows are left out from there on";
    solver::LoadAnswers with_all(solved.problem, {}, {}, 1);
    const solver::LoadAnswer all = with_all.answer(Eigen::VectorXd(0));
    ASSERT_TRUE(all.converged);
    double largest = 0, farthest = 0;
    for (std::size_t f = 0; f < all.pressure.size(); ++f) {
        largest = std::max(largest, all.pressure[f].maxCoeff());
        farthest = std::max(farthest, (all.pressure[f] - solved.solution.pressure[f]).cwiseAbs().maxCoeff());
    }
    EXPECT_LT(farthest, 1e-7 * largest);
    EXPECT_LT(solved.solution.residual, 1e-10);
}

/// What holds a part without having to carry anything leaves rounding, which has no scale but the loads.
TEST(ManyContacts, AreNotDoubtedForPartsThatCarryNothing) {
    for (const std::string loads : {R"({"on": "bar/left", "force": [-1000, 0]}, {"on": "bar/right", "force": [1000, 0]})",
                                    R"({"part": "bar", "spin": {"about": [250, 5], "omega": 314}})"}) {
        const Result r = analyze(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3, "density": 8e-9}},
            "parts": [{"name": "bar", "material": "m", "geometry": {"rectangle": {"min": [200, 0], "max": [300, 10]}}},
                      {"name": "disc", "material": "m", "geometry": {"circle": {"center": [0, 10], "radius": 10}}},
                      {"name": "bed", "material": "m", "geometry": {"rectangle": {"min": [-40, -30], "max": [40, 0]}}}],
            "supports": [{"part": "bar", "rigid": {"translation": [0, 0], "rotation": 0}},
                         {"on": "bed/bottom", "fix": ["x", "y"]}, {"part": "disc", "rigid": {"translation": [0, null], "rotation": 0}}],
            "loads": [{"part": "disc", "force": [0, -500]}, )" +
                                                     loads + "]}",
                                                 "test.json"),
                                 {});
        EXPECT_EQ(r.status, "ok") << r.message;
        EXPECT_LT(r.solver.contact_residual.value(), 1e-7);
    }
}

TEST(ManyContacts, RollersThatNothingHoldsDoNotDecideOnTheAccuracy) {
    const Result r = analyze(bearing(48, "draft"), {});
    EXPECT_TRUE(r.accuracy.reached) << r.message;
    EXPECT_LE(r.passes.size(), 5u);
}

}  // namespace abut::many_contacts_test
