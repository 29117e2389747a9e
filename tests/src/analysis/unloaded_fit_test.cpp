// SPDX-License-Identifier: GPL-3.0-or-later
// Parts drawn exactly into each other and under no load press each other by the rounding of their outlines alone.
#include <gtest/gtest.h>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::unloaded_fit_test {
namespace {

/// A pin in a hole of its own radius, drawn away from the origin.
std::string pin_in_plate(const std::string& rest) {
    return R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "plate", "material": "m", "geometry": {"difference": [{"rectangle": {"min": [70, -130], "max": [130, -70]}},
            {"circle": {"center": [100, -100], "radius": 10}}]}},
        {"name": "pin", "material": "m", "geometry": {"circle": {"center": [100, -100], "radius": 10}}}],
        "supports": [{"on": "plate/bottom", "fix": ["x", "y"]}], )" +
           rest + R"(, "accuracy": {"level": "draft"}})";
}

}  // namespace

TEST(UnloadedFit, HasNoContactToRefine) {
    const Result r = test::answer(pin_in_plate(R"("loads": [{"part": "pin", "force": [0, 0]}])"));
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_EQ(r.contacts.at(0).contact_length, 0);
    EXPECT_TRUE(r.reasons.empty());
    EXPECT_LE(r.solver.grids, 3);
}

TEST(UnloadedFit, IsWhereUnloadingEnds) {
    for (const std::string friction : {"0", "0.2"}) {
        const std::vector<CaseResult> steps =
            analyze_cases(read_scene_text(pin_in_plate(R"("contacts": {"friction": )" + friction +
                                                       R"(}, "loads": [{"name": "f", "part": "pin", "force": [0, -1000]}],
            "steps": [{"name": "on", "loads": {"f": 1}}, {"name": "off", "loads": {}}])"),
                                          "s.json"),
                          {});
        ASSERT_EQ(steps.size(), 2u);
        EXPECT_NEAR(steps[0].result.contacts.at(0).force.norm(), 1000, 1e-6);
        EXPECT_EQ(steps[1].result.status, "ok") << steps[1].result.message;
        EXPECT_NEAR(steps[1].result.contacts.at(0).force.norm(), 0, 1e-6);
    }
}

/// By much smaller loads than anybody has it is pressed all the same.
TEST(UnloadedFit, CarriesTheSmallestLoads) {
    const Result r = test::answer(pin_in_plate(R"("loads": [{"part": "pin", "force": [0, -1e-5]}])"));
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_NEAR(r.contacts.at(0).force.y(), -1e-5, 1e-11);
    EXPECT_GT(r.contacts.at(0).contact_length, 10);
}

}  // namespace abut::unloaded_fit_test
