// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/written_digits.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace abut::geometry {
namespace {

TEST(WrittenDigits, TheLastDecimalIsThatOfAllNumbers) {
    EXPECT_DOUBLE_EQ(last_digit({3, -200, 0}), 1);
    EXPECT_DOUBLE_EQ(last_digit({2.5, 3.125, -17}), 1e-3);
    EXPECT_DOUBLE_EQ(last_digit({0.1 + 0.2}), 0.1);  // rounding of sums is no digit
    EXPECT_DOUBLE_EQ(last_digit({123456.789012}), 1e-6);
    EXPECT_EQ(last_digit({2.5, std::sqrt(2.0)}), 0);
    EXPECT_EQ(last_digit({}), 0);
    std::vector<double> rounded(40, 1.125);
    rounded.insert(rounded.end(), {std::sqrt(2.0), std::sqrt(3.0), std::sqrt(5.0), std::sqrt(7.0)});  // a line besides
    EXPECT_DOUBLE_EQ(last_digit(rounded), 1e-3);
    rounded.resize(20);
    rounded.insert(rounded.end(), {std::sqrt(2.0), std::sqrt(3.0), std::sqrt(5.0), std::sqrt(7.0)});
    EXPECT_EQ(last_digit(rounded), 0);
}

TEST(WrittenDigits, RoundingIsKnownFromMoreDigitsThanSizesHave) {
    const std::vector<Vec2> points{{12.345, 6.7}, {1, 0}};
    EXPECT_NEAR(written_rounding(points, 100), std::sqrt(0.5) * 1e-3, 1e-12);
    EXPECT_EQ(written_rounding(points, 1), 0);  // a size itself, of 1, may be given so
    EXPECT_EQ(written_rounding(std::vector<Vec2>{{10, 20}}, 100), 0);
    EXPECT_NEAR(written_rounding(std::vector<double>{4.02}, 100), 0.5e-2, 1e-12);
}

}  // namespace
}  // namespace abut::geometry
