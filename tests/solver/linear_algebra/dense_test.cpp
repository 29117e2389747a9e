// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/dense.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace abut::solver::dense_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double rounding = 1e-14;

/// Of rank 2: the last column is the sum of the others.
const MatrixXd tall = (MatrixXd(4, 3) << 1, 2, 3, 0, 1, 1, 2, -1, 1, 1, 1, 2).finished();

TEST(Dense, EigenvaluesAscend) {
    const MatrixXd a = (MatrixXd(2, 2) << 2, 1, 1, 2).finished();
    const SymmetricEigen eigen = symmetric_eigen(a);
    EXPECT_NEAR(eigen.values[0], 1, rounding);
    EXPECT_NEAR(eigen.values[1], 3, rounding);
    EXPECT_LT((a * eigen.vectors - eigen.vectors * eigen.values.asDiagonal()).norm(), rounding);
    EXPECT_LT((symmetric_eigenvalues(a) - eigen.values).norm(), rounding);
}

TEST(Dense, TheNullSpaceComesLast) {
    const SingularVectors right = right_singular_vectors(tall), left = left_singular_vectors(tall);
    ASSERT_EQ(right.vectors.cols(), 3);
    ASSERT_EQ(left.vectors.rows(), 4);
    ASSERT_EQ(left.vectors.cols(), 3);
    EXPECT_LT((tall * right.vectors.col(2)).norm(), 10 * rounding);
    EXPECT_GT((tall * right.vectors.col(1)).norm(), 1);
    EXPECT_LT((left.values - right.values).norm(), 10 * rounding);
    EXPECT_LT((left.vectors.leftCols(2) * left.vectors.leftCols(2).transpose() * tall - tall).norm(), 10 * rounding);
}

/// The residual is orthogonal to all columns, the solution to the null space.
TEST(Dense, LeastSquaresAreShortest) {
    const VectorXd b = VectorXd::LinSpaced(4, 1, 4), x = least_squares(tall, b);
    EXPECT_LT((tall.transpose() * (tall * x - b)).norm(), 100 * rounding);
    EXPECT_NEAR(x.dot(Eigen::Vector3d(1, 1, -1)), 0, 10 * rounding);
}

TEST(Dense, FactorsSolve) {
    const MatrixXd a = tall.transpose() * tall + MatrixXd::Identity(3, 3);
    const VectorXd b = VectorXd::LinSpaced(3, 1, 3);
    const Cholesky factor(a);
    ASSERT_TRUE(factor.succeeded());
    EXPECT_LT((a * factor.solve(b) - b).norm(), 100 * rounding);
    EXPECT_LT((factor.solve_columns(a) - MatrixXd::Identity(3, 3)).norm(), 100 * rounding);
    EXPECT_NEAR(factor.solve_lower(b).squaredNorm(), b.dot(factor.solve(b)), 100 * rounding);
    EXPECT_NEAR(factor.diagonal()[0], std::sqrt(a(0, 0)), rounding);
    EXPECT_FALSE(Cholesky(-a).succeeded());
    const PivotedCholesky pivoted(a);
    ASSERT_TRUE(pivoted.succeeded());
    EXPECT_LT((a * pivoted.solve(b) - b).norm(), 100 * rounding);
    EXPECT_LT((pivoted.solve_columns(b) - pivoted.solve(b)).norm(), rounding);
    const VectorXd pivots = PivotedCholesky(tall.transpose() * tall).pivots();
    EXPECT_LT(std::abs(pivots[2]), 1e-12 * pivots[0]);
}

TEST(Dense, RefusesOtherSizes) {
    const VectorXd three = VectorXd::Ones(3);
    EXPECT_THROW(least_squares(tall, three), std::logic_error);
    EXPECT_THROW(Cholesky{tall}, std::logic_error);
    const MatrixXd a = MatrixXd::Identity(4, 4);
    EXPECT_THROW(Cholesky(a).solve(three), std::logic_error);
    EXPECT_THROW(Cholesky(a).solve_columns(three), std::logic_error);
    EXPECT_THROW(Cholesky(a).solve_lower(three), std::logic_error);
    EXPECT_THROW(PivotedCholesky(a).solve(three), std::logic_error);
    EXPECT_THROW(PivotedCholesky(a).solve_columns(three), std::logic_error);
}

TEST(Dense, SquareFactorsSolveAndTellHowWell) {
    const MatrixXd a = (MatrixXd(3, 3) << 0, 2, 1, 1, 0, 3, 2, 1, 0).finished();
    const SquareFactor factor(a);
    ASSERT_TRUE(factor.succeeded());
    const VectorXd b{{1, -2, 0.5}};
    EXPECT_LT((a * factor.solve(b) - b).norm(), 10 * rounding);
    EXPECT_LT((a * factor.solve_columns(MatrixXd::Identity(3, 3)) - MatrixXd::Identity(3, 3)).norm(), 10 * rounding);
    EXPECT_GT(factor.reciprocal_condition(), 0.05);
    EXPECT_FALSE(SquareFactor(MatrixXd::Zero(2, 2)).succeeded());
    MatrixXd nearly = MatrixXd::Ones(2, 2);
    nearly(0, 0) += 1e-12;
    EXPECT_LT(SquareFactor(nearly).reciprocal_condition(), 1e-12);
    EXPECT_EQ(SquareFactor(MatrixXd(0, 0)).reciprocal_condition(), 1);
}

/// Whatever the sizes of rows and columns; of a matrix whose rows depend on each other there are two.
TEST(Dense, TheKernelIsWhatAMatrixMapsToNothing) {
    const MatrixXd a = (MatrixXd(2, 3) << 1e9, 2, 3e-6, 2e3, 1e-6, -1e-12).finished();
    const auto kernel = kernel_of(a);
    ASSERT_TRUE(kernel);
    EXPECT_GT(kernel->norm(), 0);
    EXPECT_LT((a * *kernel).cwiseAbs().cwiseQuotient(a.cwiseAbs() * kernel->cwiseAbs()).maxCoeff(), 10 * rounding);
    EXPECT_FALSE(kernel_of((MatrixXd(2, 3) << 1, 2, 3, 2, 4, 6).finished()));
    EXPECT_TRUE(kernel_of(MatrixXd(0, 1)));
}

}  // namespace
}  // namespace abut::solver::dense_test
