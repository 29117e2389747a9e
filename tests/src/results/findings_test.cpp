// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/findings.hpp"

#include <gtest/gtest.h>

namespace abut::findings_test {
namespace {

TEST(Findings, AreOneWarningAndOneReasonHoweverMany) {
    Result r;
    tell({}, "yield", r);
    EXPECT_TRUE(r.warnings.empty());
    std::vector<Finding> found;
    for (const char* name : {"a", "b", "c", "d", "e", "f", "g"}) {
        const double times = name == std::string("c") ? 3 : 2;
        found.push_back({times, name, std::string("part ") + name + " yields", std::string(name) + " beyond its yield"});
    }
    tell(found, "yield", r);
    EXPECT_EQ(r.warnings, (std::vector<std::string>{"part c yields; the same of 6 others: a, b, d, e and 2 more"}));
    ASSERT_EQ(r.reasons.size(), 1u);
    EXPECT_EQ(r.reasons[0].kind, "yield");
    EXPECT_EQ(r.reasons[0].text, "c beyond its yield (and 6 others)");
}

TEST(Findings, OfOneAreToldAsTheyAre) {
    Result r;
    tell({{1, "a", "part a yields", "a beyond its yield"}}, "yield", r);
    EXPECT_EQ(r.warnings.back(), "part a yields");
    EXPECT_EQ(r.reasons.back().text, "a beyond its yield");
    remark({{1, "a", "part a is rigid"}, {1, "b", "part b is rigid", "no reason"}}, r);
    EXPECT_EQ(r.warnings.back(), "part a is rigid; the same of 1 other: b");
    EXPECT_EQ(r.reasons.size(), 1u) << "a remark is no reason";
}

}  // namespace
}  // namespace abut::findings_test
