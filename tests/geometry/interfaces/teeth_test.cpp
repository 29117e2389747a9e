// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/interfaces/teeth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/interfaces/interface_kind.hpp"

namespace abut::geometry::teeth_test {
namespace {

constexpr double pi = std::numbers::pi;

void add_loop(Part& part, const std::vector<Vec2>& corners) {
    part.loops.emplace_back();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        part.loops.back().edges.push_back(static_cast<int>(part.edges.size()));
        part.edges.push_back({Segment{corners[k], corners[(k + 1) % corners.size()]}, "", ""});
    }
}

Vec2 polar(double r, double angle, const Vec2& center = {0, 0}) {
    return center + r * Vec2(std::cos(angle), std::sin(angle));
}

/// n trapezoidal teeth; `last`: how much wider the last pitch is.
std::vector<Vec2> gear(int n, double root, double tip, double last = 1, const Vec2& center = {0, 0}) {
    std::vector<Vec2> corners;
    const double pitch = 2 * pi / (n - 1 + last);
    for (int k = 0; k < n; ++k) {
        const double wide = k == n - 1 ? last : 1.0;
        for (const auto& [r, at] : {std::pair{root, 0.0}, {root, 0.4}, {tip, 0.45}, {tip, 0.95}})
            corners.push_back(polar(r, pitch * (k + wide * at), center));
    }
    return corners;
}

Part alone(const std::vector<Vec2>& corners) {
    Part part;
    add_loop(part, corners);
    return part;
}

}  // namespace

TEST(Teeth, AreCountedOfEveryGear) {
    for (int n : {6, 7, 17, 40, 200})
        for (double root : {0.5, 0.8, 0.95})
            for (double angle : {0.0, 1.3}) {
                const Part part = transformed(alone(gear(n, 10 * root, 10)), std::cos(angle), std::sin(angle), {100, -7});
                for (int edge : {0, 1, 5}) EXPECT_EQ(count_teeth(part, edge), n) << root;
            }
}

TEST(Teeth, OfARingGearAreInItsHole) {
    Part ring = alone({{-20, -20}, {20, -20}, {20, 20}, {-20, 20}});
    std::vector<Vec2> hole = gear(30, 9, 10);
    std::reverse(hole.begin(), hole.end());
    add_loop(ring, hole);
    EXPECT_EQ(count_teeth(ring, 0), 0);
    EXPECT_EQ(count_teeth(ring, 10), 30);
}

TEST(Teeth, AreNotTheCornersOfAPolygon) {
    for (int n : {3, 4, 6, 8, 12}) {
        std::vector<Vec2> corners;
        for (int k = 0; k < n; ++k) corners.push_back(polar(5, 2 * pi * k / n));
        EXPECT_EQ(count_teeth(alone(corners), 0), 0) << n;
    }
}

TEST(Teeth, AreNeitherFewNorUnevenNorTheTextureOfACircle) {
    EXPECT_EQ(count_teeth(alone(gear(5, 8, 10)), 0), 0);
    EXPECT_EQ(count_teeth(alone(gear(12, 8, 10, 1.5)), 0), 0);
    EXPECT_EQ(count_teeth(alone(gear(12, 9.95, 10)), 0), 0);
    EXPECT_EQ(count_teeth(alone(gear(12, 3, 10)), 0), 0);  // a star
    Part disc;
    disc.loops.push_back({{0}});
    disc.edges.push_back({Arc{{1, 2}, 3, 0.4, 2 * pi}, "", ""});
    EXPECT_EQ(count_teeth(disc, 0), 0);
}

TEST(Teeth, MakeAToothOnToothInterface) {
    const Part a = alone(gear(20, 8, 10)), b = alone(gear(30, 13, 15, 1, {24.1, 0}));
    EXPECT_EQ(interface_kind(a, 1, b, 1), "tooth-on-tooth");
    EXPECT_EQ(corner_interface(a, 1, 1, b, 1, 0.5), "tooth-on-tooth");
    const Part block = alone({{10.1, -5}, {20, -5}, {20, 5}, {10.1, 5}});
    EXPECT_EQ(interface_kind(a, 2, block, 3), "flat-on-flat");
}

}  // namespace abut::geometry::teeth_test
