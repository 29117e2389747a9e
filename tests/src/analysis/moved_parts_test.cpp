// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/moved_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::moved_parts_test {
namespace {

/// A block beside or on a ledge that ends at x = 0, led by its upper edge.
Result led(const std::string& block, const std::string& x, const std::string& y) {
    return analyze(read_scene_text(R"({"abut": 1, "thickness": 10, "materials": {"steel": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "ledge", "material": "steel", "geometry": {"rectangle": {"min": [-60, -30], "max": [0, 0]}}},
            {"name": "block", "material": "steel", "geometry": {"rectangle": )" +
                                       block + R"(}}], "supports": [{"on": "ledge/bottom", "fix": ["x", "y"]},
                {"on": "block/top", "displacement": {"x": )" +
                                       x + R"(, "y": )" + y + "}}]}",
                                   "scene.json"),
                   {});
}

std::string warning_of(const Result& r, const std::string& words) {
    for (const std::string& w : r.warnings)
        if (w.find(words) != std::string::npos) return w;
    return "";
}

bool has_reason(const Result& r, const std::string& kind) {
    return std::any_of(r.reasons.begin(), r.reasons.end(), [&](const Reason& reason) { return reason.kind == kind; });
}

TEST(MovedParts, ThatComeOverEachOtherAreTold) {
    // over the ledge's corner by 0.7, and 0.2 into it
    const Result r = led(R"({"min": [0.3, 0.1], "max": [40, 30.1]})", "-1", "-0.3");
    EXPECT_NE(warning_of(r, "overlap by 0.2"), "") << testing::PrintToString(r.warnings);
    EXPECT_TRUE(has_reason(r, "missed_contact"));
    EXPECT_EQ(warning_of(led(R"({"min": [0.3, 0.1], "max": [40, 30.1]})", "-1", "-0.05"), "overlap by"), "");
    EXPECT_EQ(warning_of(led(R"({"min": [0.3, 0.1], "max": [40, 30.1]})", "-0.2", "-0.3"), "overlap by"), "");
}

TEST(MovedParts, ThatPressAreAsTheyPress) {
    const Result r = led(R"({"min": [-20, 0], "max": [20, 30]})", "-1", "-0.01");
    EXPECT_EQ(warning_of(r, "where the answer has them"), "") << testing::PrintToString(r.warnings);
}

TEST(MovedParts, ThatSlideOffEachOtherAreTold) {
    const Result r = led(R"({"min": [-0.5, 0], "max": [40, 30]})", "0.8", "-0.002");
    EXPECT_NE(warning_of(r, "have slid off each other"), "") << testing::PrintToString(r.warnings);
    EXPECT_TRUE(has_reason(r, "moved_pairs"));
}

}  // namespace
}  // namespace abut::moved_parts_test
