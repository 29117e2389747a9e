// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/block_matrix.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::block_matrix_test {
namespace {

using Eigen::MatrixXi;

FunctionSets sets(std::initializer_list<std::vector<int>> lists) {
    FunctionSets all;
    for (const std::vector<int>& list : lists) all.add(list);
    return all;
}

/// A matrix of 5 functions in three coupled sets, function 4 alone, filled with fixed random numbers.
BlockMatrix random_blocks() {
    BlockMatrix m = make_block_matrix(5, sets({{2, 0}, {1, 2, 3}, {3, 1}, {4}}));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int r = 0; r < m.n; ++r)
        for (int k = m.first[static_cast<std::size_t>(r)]; k < m.first[static_cast<std::size_t>(r) + 1]; ++k) {
            Eigen::Matrix2d& b = m.block[static_cast<std::size_t>(k)];
            b << number(random), number(random), number(random), number(random);
            if (m.column[static_cast<std::size_t>(k)] == r) b(0, 1) = b(1, 0);
        }
    return m;
}

/// The same by single entries.
Eigen::MatrixXd by_entries(BlockMatrix m) {
    Eigen::MatrixXd d = Eigen::MatrixXd::Zero(10, 10);
    for (auto [row, column] : {std::pair{0, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}, {3, 1}, {3, 2}, {3, 3}, {4, 4}}) {
        d.block<2, 2>(2 * row, 2 * column) = m.at(row, column);
        d.block<2, 2>(2 * column, 2 * row) = m.at(row, column).transpose();
    }
    return d;
}

}  // namespace

TEST(BlockMatrix, HoldsThePairsOfEverySetOnce) {
    const BlockMatrix m = random_blocks();
    EXPECT_EQ(m.first, (std::vector<int>{0, 1, 2, 5, 8, 9}));
    EXPECT_EQ(m.column, (std::vector<int>{0, 1, 0, 1, 2, 1, 2, 3, 4}));
}

TEST(BlockMatrix, StartsAtZero) {
    for (const Eigen::Matrix2d& b : make_block_matrix(3, sets({{0, 2}})).block) EXPECT_TRUE(b.isZero(0));
}

TEST(BlockMatrix, HasTheSamePatternHoweverTheSetsAreOrdered) {
    std::mt19937 random(8);
    for (int run = 0; run < 50; ++run) {
        std::vector<std::vector<int>> lists(12);
        MatrixXi expected = MatrixXi::Zero(20, 20);
        for (auto& list : lists) {
            for (int f = 0; f < 20; ++f)
                if (random() % 4 == 0) list.push_back(f);
            std::shuffle(list.begin(), list.end(), random);
            for (int a : list)
                for (int b : list)
                    if (b <= a) expected(a, b) = 1;
        }
        FunctionSets all;
        for (const auto& list : lists) all.add(list);
        const BlockMatrix m = make_block_matrix(20, all);
        MatrixXi found = MatrixXi::Zero(20, 20);
        for (int r = 0; r < m.n; ++r)
            for (int k = m.first[static_cast<std::size_t>(r)]; k < m.first[static_cast<std::size_t>(r) + 1]; ++k)
                ++found(r, m.column[static_cast<std::size_t>(k)]);
        EXPECT_EQ(found, expected);
        EXPECT_EQ(m.first.back(), expected.sum());
    }
}

TEST(BlockMatrix, ScattersAsABinarySearchWould) {
    const std::vector<std::vector<int>> lists{{4, 0, 2}, {1, 2, 3}, {3}, {0, 4, 3, 1}};
    FunctionSets all;
    for (const auto& list : lists) all.add(list);
    BlockMatrix m = make_block_matrix(5, all), expected = m;
    BlockScatter scatter(m);
    std::mt19937 random(5);
    for (const auto& list : lists) {
        std::vector<Eigen::Matrix2d> blocks(list.size() * list.size());
        for (Eigen::Matrix2d& b : blocks)
            for (double& x : b.reshaped()) x = static_cast<double>(random() % 9);
        scatter.add(list, blocks);
        for (std::size_t j = 0; j < list.size(); ++j)
            for (std::size_t i = 0; i < list.size(); ++i)
                if (list[i] >= list[j]) expected.at(list[i], list[j]) += blocks[j * list.size() + i];
    }
    EXPECT_EQ(m.block, expected.block);  // whole numbers: exact
}

TEST(BlockMatrix, MultipliesAsADenseMatrix) {
    const BlockMatrix m = random_blocks();
    const Eigen::MatrixXd d = by_entries(m);
    EXPECT_TRUE(d.isApprox(d.transpose(), 0));
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(10, -1, 2).array().cube();
    EXPECT_LT(test::relative_difference(multiply(m, x), d * x), 1e-15 * 10);
    EXPECT_EQ(test::dense(m), d);
}

TEST(BlockMatrix, RestrictsToTheRowsAndColumnsThatAreKept) {
    const BlockMatrix m = random_blocks();
    const Eigen::MatrixXd d = by_entries(m);
    const std::vector<int> kept{0, 3, 4, 5, 7, 9};
    std::vector<int> number(10, -1);
    for (std::size_t k = 0; k < kept.size(); ++k) number[static_cast<std::size_t>(kept[k])] = static_cast<int>(k);
    const SparseSymmetric s = restricted(m, number, 6);
    ASSERT_EQ(s.n, 6);
    Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(6, 6);
    for (int c = 0; c < s.n; ++c)
        for (int k = s.first[static_cast<std::size_t>(c)]; k < s.first[static_cast<std::size_t>(c) + 1]; ++k) {
            const auto at = static_cast<std::size_t>(k);
            if (k == s.first[static_cast<std::size_t>(c)])
                EXPECT_EQ(s.row[at], c) << "the diagonal comes first";
            else
                EXPECT_GT(s.row[at], s.row[at - 1]);
            lower(s.row[at], c) += s.value[at];
        }
    const Eigen::MatrixXd expected = d(kept, kept).triangularView<Eigen::Lower>();
    EXPECT_EQ(lower, expected);
}

TEST(BlockMatrix, MayKeepNothing) {
    const SparseSymmetric s = restricted(random_blocks(), std::vector<int>(10, -1), 0);
    EXPECT_EQ(s.n, 0);
    EXPECT_TRUE(s.value.empty());
}

TEST(BlockMatrix, RefusesVectorsOfOtherSizes) {
    const BlockMatrix m = random_blocks();
    EXPECT_THROW(multiply(m, Eigen::VectorXd::Ones(9)), std::logic_error);
    EXPECT_THROW(restricted(m, std::vector<int>(5, -1), 0), std::logic_error);
}

}  // namespace abut::solver::block_matrix_test
