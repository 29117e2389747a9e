// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/budget.hpp"

#include <gtest/gtest.h>

#include "geometry/brep/input_error.hpp"

namespace abut::budget_test {

TEST(Budget, TimeAndMemoryInTheirUnits) {
    EXPECT_EQ(parse_budget("30s").seconds, 30);
    EXPECT_FALSE(parse_budget("30s").bytes);
    EXPECT_EQ(parse_budget("1.5 GB").bytes, 1.5e9);
    const Budget both = parse_budget("5 min, 500 MB");
    EXPECT_EQ(both.seconds, 300);
    EXPECT_EQ(both.bytes, 500e6);
    EXPECT_EQ(parse_budget("2GB,1h").seconds, 3600);
    EXPECT_FALSE(Budget{}.is_given());
}

TEST(Budget, WhatIsNoBoundIsRefused) {
    for (const char* text : {"", ",", "30", "s", "-1 s", "0 GB", "1 s 2", "1 s, 2 min", "3 apples", "nan s", "30s;2GB"}) {
        SCOPED_TRACE(text);
        try {
            parse_budget(text);
            ADD_FAILURE() << "taken";
        } catch (const InputError& error) {
            EXPECT_NE(error.problems().front().what.find("no bound on time or memory"), std::string::npos);
            EXPECT_NE(error.problems().front().hint.find("30s, 2GB"), std::string::npos);
        }
    }
}

}  // namespace abut::budget_test
