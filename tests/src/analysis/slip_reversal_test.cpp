// SPDX-License-Identifier: GPL-3.0-or-later
// Where friction that slips turns round, tractions jump, and the stress along the face grows with the logarithm of the cells.
#include <gtest/gtest.h>

#include "tests/verification/scene_answers.hpp"

namespace abut::slip_reversal_test {

/// A shaft in a bush that is pressed into a housing: on either side of its lowest place it slips away from there.
TEST(SlipReversal, StressHasNoLimitThere) {
    const Result r =
        test::answer(R"({"abut": 1, "materials": {"steel": {"E": 210000, "nu": 0.3}, "bronze": {"E": 100000, "nu": 0.34}},
        "thickness": 10, "parts": [
          {"name": "h", "material": "steel", "geometry": {"difference": [{"name": "o", "rectangle": {"min": [-40, -40], "max": [40, 40]}},
            {"name": "i", "circle": {"center": [0, 0], "radius": 22}}]}},
          {"name": "bush", "material": "bronze", "geometry": {"difference": [{"name": "o", "circle": {"center": [0, 0], "radius": 22}},
            {"name": "i", "circle": {"center": [0, 0], "radius": 18}}]}},
          {"name": "s", "material": "steel", "geometry": {"circle": {"center": [0, -0.02], "radius": 17.98}}}],
        "supports": [{"on": "h/o/bottom", "fix": ["x", "y"]}], "loads": [{"part": "s", "force": [0, -7931.8]}],
        "contacts": {"friction": 0.1, "pairs": [{"between": ["h/i/circle", "bush/o/circle"], "interference": 0.01476}]}})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_TRUE(r.parts.at(2).max_von_mises_at_corner);
    EXPECT_NEAR((r.parts.at(2).max_von_mises.at - Vec2(0, -18)).norm(), 0, 0.1);
    EXPECT_FALSE(r.parts.at(1).max_von_mises_at_corner);
}

}  // namespace abut::slip_reversal_test
