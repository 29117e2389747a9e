// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/csg/csg.hpp"

namespace abut::geometry {
namespace {

const double of_point = std::sqrt(0.5) * 1e-3, of_length = 0.5e-3;

TEST(CsgWritten, TheDigitsOfEveryNumberCountWhereTheyMoveTheOutline) {
    EXPECT_NEAR(written_rounding({Circle{{12.345, 6.789}, 5}}, 100), of_point, 1e-12);
    EXPECT_NEAR(written_rounding({Circle{{12, 7}, 4.987}}, 100), of_length, 1e-12);
    EXPECT_NEAR(written_rounding({Circle{{12.345, 6.789}, 4.987}}, 100), of_point + of_length, 1e-12);
    EXPECT_NEAR(written_rounding({Polygon{{{0, 0}, {10.001, 0}, {10, 10}}}}, 100), of_point, 1e-12);
    EXPECT_EQ(written_rounding({Rectangle{{0, 0}, {10, 20}}}, 100), 0);
    EXPECT_EQ(written_rounding({Circle{{std::sqrt(2.0), 0}, 5}}, 100), 0);
}

TEST(CsgWritten, TreesHaveTheMostOfTheirShapesAndWhatMovesThem) {
    const CsgNode fine{Circle{{12.345, 6.789}, 5}}, whole{Rectangle{{0, 0}, {10, 20}}};
    EXPECT_NEAR(written_rounding({Difference{{whole, fine}}}, 100), of_point, 1e-12);
    Placed placed{{fine}};
    placed.translate = {0.002, 0};
    EXPECT_NEAR(written_rounding({placed}, 100), 2 * of_point, 1e-12);
    placed.scale = 3;
    EXPECT_NEAR(written_rounding({placed}, 100), 4 * of_point, 1e-12);
    placed.rotate = 17;  // is taken as it is
    EXPECT_NEAR(written_rounding({placed}, 100), 4 * of_point, 1e-12);
    EXPECT_NEAR(written_rounding({Imported{{}, 0.01}}, 100), 0.01, 1e-12);
}

}  // namespace
}  // namespace abut::geometry
