// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/extent.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace abut::geometry::extent_test {

namespace {

Part polygon(const std::vector<Vec2>& corners) {
    Part part;
    part.loops.emplace_back();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        part.loops[0].edges.push_back(static_cast<int>(k));
        part.edges.push_back({Segment{corners[k], corners[(k + 1) % corners.size()]}, "e", {}});
    }
    return part;
}

}  // namespace

TEST(Extent, IsTheDiagonalOfARectangleHoweverItLies) {
    const Part part = polygon({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    for (double angle = 0; angle < 3.2; angle += 0.1)
        EXPECT_NEAR(extent(transformed(part, std::cos(angle), std::sin(angle), {7, -5})), 5, 1e-13);
}

TEST(Extent, IsTheDiameterOfADiscHoweverItLies) {
    Part part;
    part.loops.push_back({{0}});
    part.edges.push_back({Arc{{1, 2}, 3, 0.4, 2 * std::numbers::pi}, "e", {}});
    const double size = extent(part);
    EXPECT_NEAR(size, 6, 0.005 * 6);
    for (double angle = 0; angle < 3.2; angle += 0.1)
        EXPECT_NEAR(extent(transformed(part, std::cos(angle), std::sin(angle), {7, -5})), size, 1e-13);
}

TEST(Extent, OfAConcavePartIsThatOfItsHull) {
    EXPECT_NEAR(extent(polygon({{0, 0}, {2, 1}, {4, 0}, {2, 5}})), std::sqrt(29), 1e-13);
}

}  // namespace abut::geometry::extent_test
