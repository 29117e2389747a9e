// SPDX-License-Identifier: GPL-3.0-or-later
// B' A^-1 B with the columns that the supernodes carry only where they reach, against dense algebra.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "solver/factorization.hpp"
#include "tests/solver/sparse_of.hpp"

namespace abut::solver {
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
                SparseSymmetric s = sparse(a);
                SymbolicFactorization symbolic(s, method);
                const Factorization factor(std::move(s), std::move(symbolic));
                ASSERT_TRUE(factor.ok());
                const MatrixXd dense(b), expected = dense.transpose() * a.llt().solve(dense);
                const MatrixXd form = factor.inverse_form(b);
                EXPECT_LT((form - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff())
                    << n << " " << columns;
                EXPECT_EQ(form, form.transpose().eval());
            }
}

TEST(InverseForm, OfNothing) {
    const Factorization factor(sparse(grid_matrix(3)));
    EXPECT_EQ(factor.inverse_form(Eigen::SparseMatrix<double>(9, 0)).size(), 0);
    EXPECT_TRUE(factor.inverse_form(Eigen::SparseMatrix<double>(9, 2)).isZero(0));
}

}  // namespace
}  // namespace abut::solver
