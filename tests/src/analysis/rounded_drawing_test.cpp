// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that a drawing's rounding inclines to the loads by a little.
#include <gtest/gtest.h>

#include <string>

#include "tests/verification/scene_answers.hpp"

namespace abut::rounded_drawing_test {
namespace {

/// A plate on three fixed rollers, its underside drawn from -rise to rise over its length of 90; 100 N straight down, and
/// `sideways` along.
Result on_rollers(double rise, double sideways) {
    std::string parts = R"({"name": "plate", "material": "m", "geometry": {"polygon": [[-45, )" + test::number(-rise) +
                        "], [45, " + test::number(rise) + "], [45, 20], [-45, 20]]}}";
    std::string supports;
    for (int k = 0; k < 3; ++k) {
        const std::string name = "r" + std::to_string(k);
        parts += R"(, {"name": ")" + name + R"(", "material": "m", "geometry": {"circle": {"center": [)" +
                 std::to_string(25 * (k - 1)) + R"(, -10], "radius": 10}}})";
        supports += (k == 0 ? "" : ", ") + (R"({"part": ")" + name + R"(", "rigid": {"translation": [0, 0], "rotation": 0}})");
    }
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [)" + parts +
                        R"(], "supports": [)" + supports +
                        R"(], "contacts": {"overlap": "press_fit"}, "accuracy": {"level": "draft"},
                        "loads": [{"on": "plate/e2", "force": [)" +
                        test::number(sideways) + ", -100]}]}");
}

TEST(RoundedDrawing, ALittleTiltOfAFaceIsNoPush) {
    for (double rise : {0.0, 1e-6, -1e-5}) {
        const Result r = on_rollers(rise, 0);
        EXPECT_EQ(r.status, "ok") << rise << ": " << r.message;
    }
}

TEST(RoundedDrawing, APushIsOneHoweverSmall) {
    const Result r = on_rollers(0, 1e-3);
    EXPECT_EQ(r.status, "failed");
    EXPECT_NE(r.message.find("plate slides along"), std::string::npos) << r.message;
}

}  // namespace
}  // namespace abut::rounded_drawing_test
