// SPDX-License-Identifier: GPL-3.0-or-later
// B' A^-1 B with the columns that the supernodes carry only where they reach, against dense algebra.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "solver/linear_algebra/factorization.hpp"
#include "tests/solver/linear_algebra/sparse_of.hpp"

namespace abut::solver::inverse_form_test {
namespace {

using Eigen::MatrixXd;

/// A Laplacian of a grid of points, n to a side, with a constant added: sparse, no narrow band.
MatrixXd grid_matrix(int n) {
    MatrixXd m = 0.3 * MatrixXd::Identity(n * n, n * n);
    const auto couple = [&](int a, int b) {
        m(a, a) += 1;
        m(b, b) += 1;
        m(a, b) -= 1;
        m(b, a) -= 1;
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            if (i + 1 < n) couple(i * n + j, (i + 1) * n + j);
            if (j + 1 < n) couple(i * n + j, i * n + j + 1);
        }
    return m;
}

TEST(InverseForm, AgreesWithDenseAlgebra) {
    std::mt19937 random(5);
    std::normal_distribution<double> number;
    for (FactorMethod method : {FactorMethod::banded, FactorMethod::supernodal})
        for (int n : {1, 2, 7, 19})
            for (int columns : {1, 3, 40}) {
                const MatrixXd a = grid_matrix(n);
                Eigen::SparseMatrix<double> b(a.rows(), columns);
                for (int c = 0; c < columns; ++c)
                    for (int k = 0; k < 4; ++k)  // an entry may come twice, a column of zeros may remain
                        if (c != 1)
                            b.coeffRef(static_cast<int>(random() % static_cast<unsigned>(a.rows())), c) += number(random);
                const Factorization factor(sparse(a), {.method = method});
                ASSERT_TRUE(factor.ok());
                const MatrixXd dense(b), expected = dense.transpose() * a.llt().solve(dense);
                const MatrixXd form = factor.inverse_form(b);
                EXPECT_LT((form - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff())
                    << n << " " << columns;
                EXPECT_EQ(form, form.transpose().eval());
            }
}

/// Rows of a grid of n x n points, and late ones along one of its sides.
RowHints hints_of(int n, bool first_side) {
    RowHints hints;
    for (int i = 0; i < n * n; ++i) hints.place.push_back({i % n, i / n});
    for (int k = 0; k < n; ++k) hints.late.push_back(first_side ? k : n * n - 1 - k);
    return hints;
}

/// Columns with few entries along that side, one that is full, in no order.
Eigen::SparseMatrix<double> side_columns(std::mt19937& random, int n, bool first_side) {
    std::normal_distribution<double> number;
    Eigen::SparseMatrix<double> b(n * n, n + 1);
    for (int c = 0; c < n; ++c)
        for (int k = 0; k < 3; ++k) {
            const int place = (7 * c + k) % n;
            b.coeffRef(first_side ? place : n * n - 1 - place, c == n / 2 ? n : c) += number(random);
        }
    for (int i = 0; i < n * n; ++i) b.coeffRef(i, n / 2) = number(random);
    return b;
}

TEST(InverseForm, IsTheSameWithAnyOrderOfTheRows) {
    std::mt19937 random(8);
    for (int n : {3, 12, 48})  // the last is cut in pieces
        for (bool first_side : {false, true}) {
            const MatrixXd a = grid_matrix(n);
            const Eigen::LLT<MatrixXd> dense(a);
            const Eigen::SparseMatrix<double> b = side_columns(random, n, first_side);
            const MatrixXd columns(b), expected = columns.transpose() * dense.solve(columns);
            const Eigen::VectorXd load = columns.col(n / 2), x = dense.solve(load);
            for (FactorMethod method : {FactorMethod::banded, FactorMethod::supernodal}) {
                RowHints hints = hints_of(n, first_side);
                hints.method = method;
                const Factorization factor(sparse(a), hints);
                ASSERT_TRUE(factor.ok());
                EXPECT_LT((factor.inverse_form(b) - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
                EXPECT_LT((factor.solve(load) - x).norm(), 1e-12 * x.norm());
            }
        }
}

/// The order of the rows is what makes columns along a side cheap: fewer entries than a full column at every step.
TEST(InverseForm, TurnsTheBandTowardsLateRows) {
    for (bool first_side : {false, true}) {
        RowHints hints = hints_of(20, first_side);
        hints.method = FactorMethod::banded;
        const Factorization factor(sparse(grid_matrix(20)), hints);
        // L^-1 P e_i is zero before the position of i
        MatrixXd unit = MatrixXd::Zero(400, 1);
        unit(hints.late[10], 0) = 1;
        const MatrixXd y = factor.solve_lower(unit);
        EXPECT_TRUE(y.topRows(300).isZero(0));
        EXPECT_FALSE(y.bottomRows(100).isZero(0));
    }
}

TEST(InverseForm, OfNothing) {
    const Factorization factor(sparse(grid_matrix(3)));
    EXPECT_EQ(factor.inverse_form(Eigen::SparseMatrix<double>(9, 0)).size(), 0);
    EXPECT_TRUE(factor.inverse_form(Eigen::SparseMatrix<double>(9, 2)).isZero(0));
}

}  // namespace
}  // namespace abut::solver::inverse_form_test
