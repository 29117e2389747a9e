// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/edge_tree.hpp"

#include <gtest/gtest.h>

#include <random>

namespace abut::geometry::edge_tree_test {
namespace {

std::vector<int> all_near(const std::vector<Box2>& boxes, const Box2& box, double margin) {
    std::vector<int> found;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (boxes[i].overlaps(box, margin)) found.push_back(static_cast<int>(i));
    return found;
}

/// Coordinates and margins are tenths: boxes meet exactly at the margin, up to rounding, and some are points or empty.
TEST(EdgeTree, FindsWhatTryingAllBoxesFinds) {
    std::mt19937 random(1);
    const auto tenths = [&] { return 0.1 * (static_cast<double>(random() % 40) - 20); };
    std::size_t n_found = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<Box2> boxes(random() % 60);
        for (Box2& box : boxes)
            for (auto n = random() % 3; n > 0; --n) box.extend(Vec2(tenths(), tenths()));
        const EdgeTree tree(boxes);
        for (int k = 0; k < 30; ++k) {
            Box2 box;
            for (int n = k == 0 ? 0 : 2; n > 0; --n) box.extend(Vec2(tenths(), tenths()));
            const double margin = 0.1 * static_cast<double>(random() % 10);
            const std::vector<int> found = tree.near(box, margin);
            EXPECT_EQ(found, all_near(boxes, box, margin));
            n_found += found.size();
        }
    }
    EXPECT_GT(n_found, 10000U);
}

}  // namespace
}  // namespace abut::geometry::edge_tree_test
