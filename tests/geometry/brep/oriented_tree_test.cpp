// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/oriented_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/brep/closest_points.hpp"

namespace abut::geometry::oriented_tree_test {
namespace {

constexpr double pi = std::numbers::pi;

/// Lines, arcs of any sweep and ellipses, long and short, some points, many with ends in common.
Curve random_curve(std::mt19937& random) {
    const auto tenths = [&] { return 0.1 * (static_cast<double>(random() % 60) - 30); };
    const double sweep = pi / 6 * (static_cast<double>(random() % 25) - 12), start = tenths();
    const Vec2 p(tenths(), tenths()), q(tenths(), tenths());
    switch (random() % 4) {
        case 0:
            return Arc{p, 0.1 + std::abs(tenths()), start, sweep == 0 ? 1 : sweep};
        case 1:
            return EllipticArc{p, {0.6, 0.8}, {-0.4, 0.3}, start, sweep == 0 ? 1 : sweep};
        default:
            return Segment{p, q};
    }
}

/// All that is near is found, and nothing whose box is not.
TEST(OrientedTree, FindsWhatTryingAllPairsFinds) {
    std::mt19937 random(1);
    std::size_t n_near = 0, n_left_out = 0;
    for (int round = 0; round < 60; ++round) {
        Part part;
        for (std::size_t n = random() % 50; n > 0; --n) part.edges.push_back({random_curve(random), "", "", true, 0});
        const OrientedTree tree(part);
        const double margin = 0.05 * static_cast<double>(random() % 4);
        for (std::size_t i = 0; i < part.edges.size(); ++i) {
            const std::vector<int> found = tree.near_after(i, margin);
            EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
            std::vector<int> boxes;
            for (std::size_t j = i + 1; j < part.edges.size(); ++j)
                if (bounding_box(part.edges[j].curve).overlaps(bounding_box(part.edges[i].curve), margin))
                    boxes.push_back(static_cast<int>(j));
            EXPECT_TRUE(std::includes(boxes.begin(), boxes.end(), found.begin(), found.end()));
            for (const int j : boxes) {
                if (std::binary_search(found.begin(), found.end(), j)) continue;
                ++n_left_out;
                const auto k = static_cast<std::size_t>(j);
                EXPECT_GT(closest_points(part.edges[i].curve, part.edges[k].curve).distance, 2 * margin) << i << " " << j;
            }
            n_near += found.size();
        }
    }
    EXPECT_GT(n_near, 3000U);
    EXPECT_GT(n_left_out, 1000U);
}

/// Spikes as deep as half the radius: each edge's box along the axes meets some hundred others, and two edges are its
/// neighbours.
TEST(OrientedTree, TellsSpikesOfAStarApart) {
    constexpr int n = 2000;
    Part star;
    const auto corner = [](int i) {
        const double r = i % 2 == 0 ? 1 : 0.5, angle = 2 * pi * i / n;
        return Vec2(r * std::cos(angle), r * std::sin(angle));
    };
    for (int i = 0; i < n; ++i) star.edges.push_back({Segment{corner(i), corner((i + 1) % n)}, "", "", true, 0});
    const OrientedTree tree(star);
    std::size_t n_near = 0;
    for (std::size_t i = 0; i < n; ++i) n_near += tree.near_after(i, 1e-9).size();
    EXPECT_GE(n_near, std::size_t{n});
    EXPECT_LE(n_near, std::size_t{2 * n});
}

TEST(OrientedTree, OfNothing) {
    EXPECT_NO_THROW(OrientedTree(Part{}));
}

/// The box of a piece's hull holds its corners.
TEST(OrientedBoxes, HoldTheirCorners) {
    std::mt19937 random(2);
    const auto number = [&] { return static_cast<double>(random() % 1000) / 100; };
    for (int round = 0; round < 200; ++round) {
        std::vector<Box2> corners(1 + random() % 4);
        for (Box2& corner : corners) {
            const Vec2 p(number(), number());
            corner = {p, p + 0.1 * Vec2(number(), number())};
        }
        const OrientedBox box = oriented_box(corners);
        EXPECT_NEAR(box.along.norm(), 1, 1e-15);
        for (const Box2& corner : corners)
            for (const Vec2& p : {corner.min, corner.max}) {
                EXPECT_LE(std::abs(box.along.dot(p - box.center)), box.half.x() + 1e-13);
                EXPECT_LE(std::abs(cross(box.along, p - box.center)), box.half.y() + 1e-13);
            }
    }
}

}  // namespace
}  // namespace abut::geometry::oriented_tree_test
