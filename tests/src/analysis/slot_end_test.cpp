// SPDX-License-Identifier: GPL-3.0-or-later
// A pin at the end of a slot that is pressed towards a side: contact runs from the end's arc on to the straight side.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/verification/scene_answers.hpp"

namespace abut::slot_end_test {
namespace {

Result pressed(double degrees, double clearance, double friction, const std::string& level) {
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "thickness": 10, "parts": [
        {"name": "p", "material": "m", "geometry": {"difference": [{"name": "o", "rectangle": {"min": [-40, -25], "max": [40, 25]}},
            {"slot": {"from": [-12, 0], "to": [12, 0], "radius": )" +
                        std::to_string(8 + clearance) +
                        R"(}}]}}, {"name": "pin", "material": "m", "geometry": {"circle": {"center": )" +
                        test::pair_text(12 + clearance * c, clearance * s) + R"(, "radius": 8}}}],
        "supports": [{"on": "p/o/bottom", "fix": ["x", "y"]}], "loads": [{"part": "pin", "force": )" +
                        test::pair_text(5000 * c, 5000 * s) + R"(}], "contacts": {"friction": )" + std::to_string(friction) +
                        R"(}, "accuracy": {"level": ")" + level + R"("}})");
}

}  // namespace

/// Forces that missed the pin's centre on the side had nothing to balance them: pressure ended at the arc's end as at a corner.
TEST(SlotEnd, PressureRunsOnToTheSide) {
    for (const double degrees : {75.0, 80.0}) {
        const Result r = pressed(degrees, 0.05, 0, "draft"), finer = pressed(degrees, 0.05, 0, "standard"),
                     with_friction = pressed(degrees, 0.05, 0.005, "draft");
        ASSERT_EQ(r.status, "ok") << r.message;
        ASSERT_EQ(finer.status, "ok") << finer.message;
        ASSERT_EQ(with_friction.status, "ok") << with_friction.message;
        const double peak = finer.contacts.at(0).max_pressure.value;
        EXPECT_TRUE(finer.reasons.empty());
        EXPECT_NEAR(r.contacts.at(0).max_pressure.value / peak, 1, 0.05) << degrees;
        EXPECT_NEAR(with_friction.contacts.at(0).max_pressure.value / peak, 1, 0.05) << degrees;
        EXPECT_LT(peak, 1514);  // all of it on the side alone, by Hertz
    }
}

}  // namespace abut::slot_end_test
