// SPDX-License-Identifier: GPL-3.0-or-later
// What loads are to rigid parts, against sums by hand.
#include "src/motion/rigid_loads.hpp"

#include <gtest/gtest.h>

#include "src/motion/settle.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::rigid_loads_test {
namespace {

Scene scene_of(const std::string& parts, const std::string& supports, const std::string& loads) {
    return read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3, "density": 2}}, "parts": [)" + parts +
                               R"(], "supports": [)" + supports + R"(], "loads": [)" + loads + "]}",
                           "s.json");
}

std::string part(const std::string& name, const std::string& geometry) {
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": )" + geometry + "}";
}

TEST(RigidLoads, AreForcesAndMomentsAboutTheMiddle) {
    const Scene scene = scene_of(part("plate", R"({"rectangle": {"min": [1, 2], "max": [5, 4]}})"),
                                 R"({"on": "plate/bottom", "fix": ["x", "y"]})",
                                 R"({"on": "plate/right", "pressure": 3}, {"gravity": [0, -10]}, {"part": "plate", "moment": 7},
                                    {"on": "plate/top", "force": [4, 0]})");
    const RigidLoad load = rigid_loads(scene, resolve_conditions(scene)).at(0);
    EXPECT_NEAR((load.force - Vec2(-3 * 2 + 4, -10 * 2 * 8)).norm(), 0, 1e-11);
    EXPECT_NEAR(load.moment, 7 - 4 * 1, 1e-11);
    EXPECT_NEAR(load.stretch, 0, 1e-11);
}

/// Whatever acts through the middle has no moment, not that of its rounding.
TEST(RigidLoads, PressuresInRoundBoresTurnNothing) {
    const auto ring = [](const std::string& name, double inside, double outside) {
        const auto circle = [](const std::string& own, double r) {
            return R"({"circle": {"center": [0.1, 0.7], "radius": )" + std::to_string(r) + R"(}, "name": ")" + own + R"("})";
        };
        return part(name, R"({"difference": [)" + circle("o", outside) + ", " + circle("i", inside) + "]}");
    };
    const Scene scene = scene_of(ring("liner", 10, 20) + ", " + ring("housing", 20.01, 30),
                                 R"({"part": "housing", "rigid": {"translation": [0, 0], "rotation": 0}})",
                                 R"({"on": "liner/i/circle", "pressure": 3})");
    EXPECT_EQ(rigid_loads(scene, resolve_conditions(scene)).at(0).moment, 0);
    EXPECT_EQ(settle(scene, resolve_conditions(scene)).end, Settling::End::stays);
}

TEST(RigidLoads, TurnBackWhatTheyStretch) {
    const Scene scene = scene_of(part("plate", R"({"rectangle": {"min": [1, 2], "max": [5, 4]}})"),
                                 R"({"on": "plate/bottom", "fix": ["x", "y"]})",
                                 R"({"on": "plate/right", "traction": [3, 0]}, {"on": "plate/left", "force": [-5, 0]},
                                    {"on": "plate/top", "force": [2, -4]}, {"on": "plate/right", "pressure": 3})");
    EXPECT_NEAR(rigid_loads(scene, resolve_conditions(scene)).at(0).stretch, 3 * 2 * 2 + 5 * 2 - 4 * 1, 1e-11);
}

}  // namespace
}  // namespace abut::rigid_loads_test
