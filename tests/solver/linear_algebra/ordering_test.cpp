// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/ordering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace abut::solver::ordering_test {
namespace {

/// Pattern of a symmetric matrix from the pairs (row, column) below its diagonal.
SparseSymmetric pattern(int n, std::vector<std::pair<int, int>> below) {
    for (int c = 0; c < n; ++c) below.emplace_back(c, c);
    std::sort(below.begin(), below.end(),
              [](auto a, auto b) { return std::pair(a.second, a.first) < std::pair(b.second, b.first); });
    below.erase(std::unique(below.begin(), below.end()), below.end());
    SparseSymmetric m{n, std::vector<int>(static_cast<std::size_t>(n) + 1, 0), {}, {}};
    for (auto [row, column] : below) {
        ++m.first[static_cast<std::size_t>(column) + 1];
        m.row.push_back(row);
        m.value.push_back(1);
    }
    std::partial_sum(m.first.begin(), m.first.end(), m.first.begin());
    return m;
}

/// width x height nodes of two rows each, all coupled that are neighbours; nodes numbered by a shuffle.
SparseSymmetric shuffled_grid(int width, int height, unsigned seed) {
    std::vector<int> number(static_cast<std::size_t>(width * height));
    std::iota(number.begin(), number.end(), 0);
    std::mt19937 random(seed);
    std::shuffle(number.begin(), number.end(), random);
    const auto node = [&](int x, int y) { return number[static_cast<std::size_t>(y * width + x)]; };
    std::vector<std::pair<int, int>> below;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    if (x + dx < 0 || x + dx >= width || y + dy < 0 || y + dy >= height) continue;
                    for (int i : {0, 1})
                        for (int j : {0, 1}) {
                            const int a = 2 * node(x, y) + i, b = 2 * node(x + dx, y + dy) + j;
                            if (a > b) below.emplace_back(a, b);
                        }
                }
    return pattern(2 * width * height, below);
}

bool is_permutation_of_rows(std::vector<int> order, int n) {
    std::sort(order.begin(), order.end());
    for (int k = 0; k < n; ++k)
        if (order[static_cast<std::size_t>(k)] != k) return false;
    return static_cast<int>(order.size()) == n;
}

}  // namespace

TEST(Ordering, MergesTheComponentsOfAFunction) {
    const SparseSymmetric m = shuffled_grid(5, 4, 1);
    const MergedPattern p = merged_pattern(m);
    ASSERT_EQ(p.n_nodes(), 20);
    for (int k = 0; k <= 20; ++k) EXPECT_EQ(p.first_column[static_cast<std::size_t>(k)], 2 * k);
    const Neighbours g = neighbours(p);
    EXPECT_EQ(g.node.size(), 2u * (4 * 4 + 5 * 3 + 2 * 4 * 3));  // both ways: horizontal, vertical and diagonal pairs
}

TEST(Ordering, KeepsRowsApartThatDiffer) {
    const MergedPattern p = merged_pattern(pattern(5, {{1, 0}, {3, 2}, {3, 1}, {4, 2}, {4, 3}}));
    EXPECT_EQ(p.first_column, (std::vector<int>{0, 1, 2, 3, 4, 5}));  // 3 and 4 differ to the left only
    EXPECT_EQ(p.row, (std::vector<int>{0, 1, 1, 3, 2, 3, 4, 3, 4, 4}));
}

/// The numbers of the columns left of 4 and 5 have the same sum.
TEST(Ordering, KeepsRowsApartWhoseColumnsAddUpAlike) {
    const MergedPattern p = merged_pattern(pattern(6, {{4, 0}, {4, 3}, {5, 1}, {5, 2}, {5, 4}}));
    EXPECT_EQ(p.n_nodes(), 6);
}

/// Rows are joined where they have the same neighbours, and nowhere else.
TEST(Ordering, NodesStandForTheirRowsExactly) {
    std::mt19937 random(7);
    std::size_t joined = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const int n = std::uniform_int_distribution<int>(2, 12)(random);
        std::vector<std::pair<int, int>> below;
        for (int r = 0; r < n; ++r)
            for (int c = 0; c < r; ++c)
                if (random() % 3 == 0) below.emplace_back(r, c);
        const SparseSymmetric m = pattern(n, below);
        std::vector<std::vector<char>> full(static_cast<std::size_t>(n), std::vector<char>(static_cast<std::size_t>(n), 0));
        for (int c = 0; c < n; ++c)
            for (int k = m.first[static_cast<std::size_t>(c)]; k < m.first[static_cast<std::size_t>(c) + 1]; ++k) {
                const auto row = static_cast<std::size_t>(m.row[static_cast<std::size_t>(k)]),
                           column = static_cast<std::size_t>(c);
                full[row][column] = full[column][row] = 1;
            }
        std::vector<int> first{0};
        for (int r = 1; r < n; ++r)
            if (full[static_cast<std::size_t>(r)] != full[static_cast<std::size_t>(r) - 1]) first.push_back(r);
        joined += static_cast<std::size_t>(n) - first.size();
        first.push_back(n);
        ASSERT_EQ(merged_pattern(m).first_column, first) << "trial " << trial;
    }
    EXPECT_GT(joined, 100U);
}

TEST(Ordering, CuthillMcKeeFindsTheNarrowWayThroughABar) {
    for (unsigned seed = 0; seed < 20; ++seed)
        for (int height : {1, 2, 4}) {
            const SparseSymmetric m = shuffled_grid(40, height, seed);
            const MergedPattern p = merged_pattern(m);
            const std::vector<int> order = expanded(p, reverse_cuthill_mckee(neighbours(p)));
            ASSERT_TRUE(is_permutation_of_rows(order, m.n));
            const int width = bandwidth(m, inverse_order(order));
            EXPECT_LE(width, 2 * (3 * height) + 1);  // three columns of nodes: it may begin in a corner
            EXPECT_LE(least_bandwidth(neighbours(p)), width);
            EXPECT_GE(least_bandwidth(neighbours(p)), height / 2);
        }
}

TEST(Ordering, TakesPartsThatAreNotConnected) {
    const SparseSymmetric m = pattern(7, {{6, 0}, {5, 1}, {3, 5 - 3}});
    const MergedPattern p = merged_pattern(m);
    const std::vector<int> order = expanded(p, reverse_cuthill_mckee(neighbours(p)));
    EXPECT_TRUE(is_permutation_of_rows(order, 7));
    EXPECT_EQ(bandwidth(m, inverse_order(order)), 1);
    EXPECT_EQ(least_bandwidth(neighbours(p)), 1);
}

TEST(Ordering, OfNothingIsNothing) {
    const MergedPattern p = merged_pattern(pattern(0, {}));
    EXPECT_EQ(p.n_nodes(), 0);
    EXPECT_TRUE(reverse_cuthill_mckee(neighbours(p)).empty());
    EXPECT_EQ(least_bandwidth(neighbours(p)), 0);
}

}  // namespace abut::solver::ordering_test
