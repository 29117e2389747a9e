// SPDX-License-Identifier: GPL-3.0-or-later
// Where sticking and slipping meet on faces with friction.
#include "src/solution/contact_states.hpp"

#include <gtest/gtest.h>

#include "src/analysis/analysis.hpp"
#include "src/analysis/analyzed.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::contact_states_test {
namespace {

/// Half a roller of steel that is pressed on a block of rubber, and moved along it.
Analyzed pressed_roller(double along) {
    return analyze_and_keep(
        read_scene_text(R"({"abut": 1, "materials": {"steel": {"E": 2e5, "nu": 0.3}, "soft": {"E": 100, "nu": 0}},
            "parts": [{"name": "roller", "material": "steel", "geometry": {"intersection": [
                {"circle": {"center": [0, 5], "radius": 5}}, {"rectangle": {"min": [-5, 0], "max": [5, 5]}}]}},
            {"name": "block", "material": "soft", "geometry": {"rectangle": {"min": [-10, -10], "max": [10, 0]}}}],
            "supports": [{"on": "block/bottom", "fix": ["x", "y"]}, {"part": "roller", "rigid": {"translation": [)" +
                            test::number(along) + R"(, null], "rotation": 0}}],
            "loads": [{"on": "roller/top", "force": [0, -5]}], "contacts": {"friction": 0.2}})",
                        "."),
        {});
}

TEST(ContactStates, WhereAllSlipsRoundingIsNoBorder) {
    const Analyzed all = pressed_roller(0.1);
    ASSERT_EQ(all.result.status, "ok") << all.result.message;
    ASSERT_FALSE(all.outcome.solved.stretches.at(0).empty());
    EXPECT_TRUE(stick_borders(all.outcome.solved, 0).empty());
    EXPECT_EQ(all.result.contacts.at(0).friction.value().stick_length, 0);
}

/// What is pressed alone slips outward beside a middle that sticks [Spence75].
TEST(ContactStates, WhereTheMiddleSticksThereAreTwoBorders) {
    const Analyzed middle = pressed_roller(0);
    ASSERT_EQ(middle.result.status, "ok") << middle.result.message;
    EXPECT_EQ(stick_borders(middle.outcome.solved, 0).size(), 2u);
}

}  // namespace
}  // namespace abut::contact_states_test
