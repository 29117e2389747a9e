// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/number_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace abut::number_text_test {
namespace {

TEST(NumberText, NumbersAreShort) {
    EXPECT_EQ(number_text(0.0115, 3), "0.0115");
    EXPECT_EQ(number_text(120000, 2), "1.2e+05");
    EXPECT_EQ(number_text(12345, 3), "12300");
    EXPECT_EQ(number_text(132.40001, 4), "132.4");
    EXPECT_EQ(number_text(9.9996, 4), "10");
    EXPECT_EQ(number_text(99999.9, 4), "1e+05");
    EXPECT_EQ(number_text(-0.0, 3), "0");
    EXPECT_EQ(number_text(-2.5e-7, 3), "-2.5e-07");
    EXPECT_EQ(number_text(0.1 + 0.2, 6), "0.3");
    EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN(), 3), "n/a");
}

TEST(NumberText, SharesAreToldFromTheirLimit) {
    EXPECT_EQ(percent_beside(1.026, 1), "103 %");
    EXPECT_EQ(percent_beside(0.9962, 1), "99.6 %");
    EXPECT_EQ(percent_beside(0.01004, 0.01), "1.004 %");
    EXPECT_EQ(percent_beside(0.5, 1), "50 %");
    EXPECT_EQ(percent_beside(1, 1), "100 %");
    EXPECT_EQ(number_beside(0.176327, 0.1763, 4), "0.17633");
}

TEST(NumberText, CoordinatesNeverUseExponents) {
    EXPECT_EQ(coordinate_text(1234567.891), "1234567.89");
    EXPECT_EQ(coordinate_text(-0.001), "0");
    EXPECT_EQ(coordinate_text(0.5), "0.5");
    EXPECT_EQ(coordinate_text(1e-9), "0");
}

}  // namespace
}  // namespace abut::number_text_test
