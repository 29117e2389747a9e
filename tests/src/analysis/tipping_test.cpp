// SPDX-License-Identifier: GPL-3.0-or-later
// A stiff punch of half width 10 on a half plane, loaded at e: it lifts off its other end, and presses over 4 (10 - e).
#include "src/analysis/tipping.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/verification/scene_answers.hpp"

namespace abut::tipping_test {
namespace {

Result punch_loaded_at(double e, double height) {
    return test::answer(R"({"abut": 1, "analysis": "plane_strain", "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "base", "material": "m", "geometry": {"rectangle": {"min": [-200, -200], "max": [200, 0]}}},
        {"name": "punch", "material": "rigid", "geometry": {"rectangle": {"min": [-10, 0], "max": [10, )" +
                        test::number(height) + R"(]}}}],
        "supports": [{"on": "base/bottom", "fix": ["x", "y"]}, {"part": "punch", "rigid": {"translation": [0, null]}}],
        "loads": [{"on": "punch/top", "force": [0, -1000], "at": )" +
                        test::pair_text(e, height) + "}]}");
}

TEST(Tipping, RestsOnAsLittleAsTheLoadLeavesHoweverHighItIs) {
    for (const double height : {2.0, 40.0})
        for (const double e : {8.5, 9.0, 9.6, 9.9}) {
            const Result r = punch_loaded_at(e, height);
            ASSERT_EQ(r.status, "ok") << e << " " << height << r.message;
            EXPECT_NEAR(r.contacts.at(0).contact_length, 4 * (10 - e), 0.02 * 4 * (10 - e)) << e << " " << height;
        }
}

TEST(Tipping, BeyondItsEdgeItTips) {
    const Result r = punch_loaded_at(10.02, 40);
    EXPECT_NE(r.status, "ok");
    EXPECT_NE(r.message.find("punch rotates"), std::string::npos) << r.message;
}

}  // namespace
}  // namespace abut::tipping_test
