// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/place_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/geometry/cells/random_parts.hpp"

namespace place_tree_test {

namespace {

using namespace abut;
using geometry::Box2;
using geometry::test::between;
using geometry::test::Random;

bool is_too_large(const Box2& cell, const SizeFeature& place) {
    return PlaceTree({place}).is_too_large(cell);
}

TEST(PlaceTree, MeasuresAlongLinesNotFromTheirPoints) {
    const SizeFeature line{{{0, 0}, {1, 1}}, 0.1, 1, {{0, 0}, {1, 1}}};
    EXPECT_TRUE(is_too_large({{0.4, 0.4}, {0.52, 0.52}}, line));   // on it
    EXPECT_FALSE(is_too_large({{0.4, 0.4}, {0.49, 0.49}}, line));  // small enough
    EXPECT_FALSE(is_too_large({{0.7, 0.1}, {0.8, 0.2}}, line));    // small enough, away from it
    // from (0.5, 0.3) to the line 0.2 / sqrt(2)
    EXPECT_TRUE(is_too_large({{0.5, 0.06}, {0.74, 0.3}}, {line.box, 0.09, 1, line.line}));
    EXPECT_FALSE(is_too_large({{0.5, 0.06}, {0.74, 0.3}}, {line.box, 0.11, 1, line.line}));
}

TEST(PlaceTree, NoPlacesWantNothing) {
    EXPECT_FALSE(PlaceTree({}).is_too_large({{0, 0}, {1, 1}}));
}

/// Points, lines and boxes of all sizes: a tree of all says what one of them says alone.
TEST(PlaceTree, FindsWhatAnyPlaceWants) {
    Random random(1);
    const auto somewhere = [&] { return Vec2(between(0, 1, random), between(0, 1, random)); };
    std::vector<SizeFeature> places;
    for (int k = 0; k < 500; ++k) {
        SizeFeature place{{}, std::pow(10, between(-4, -1, random)), between(0.2, 0.7, random)};
        const Vec2 a = somewhere(), b = a + 0.1 * (somewhere() - Vec2(0.5, 0.5));
        place.box.extend(a);
        if (k % 3 > 0) place.box.extend(b);
        if (k % 3 == 1) place.line = {a, b};
        places.push_back(place);
    }
    const PlaceTree tree(places);
    int n_too_large = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec2 low = somewhere();
        const double side = std::pow(10, between(-4, -1, random));
        const Box2 cell{low, low + Vec2(side, side * between(0.3, 1, random))};
        const bool expected =
            std::any_of(places.begin(), places.end(), [&](const SizeFeature& place) { return is_too_large(cell, place); });
        EXPECT_EQ(tree.is_too_large(cell), expected) << k;
        n_too_large += expected;
    }
    EXPECT_GT(n_too_large, 500);
    EXPECT_LT(n_too_large, 1500);
}

}  // namespace

}  // namespace place_tree_test
