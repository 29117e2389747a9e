// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/factorization.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>
#include <utility>

#include "tests/solver/test_spaces.hpp"

namespace abut::solver {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

SparseSymmetric sparse(const MatrixXd& m) {
    SparseSymmetric s;
    s.n = static_cast<int>(m.cols());
    s.first.push_back(0);
    for (int c = 0; c < s.n; ++c) {
        for (int r = c; r < s.n; ++r)
            if (r == c || m(r, c) != 0) {
                s.row.push_back(r);
                s.value.push_back(m(r, c));
            }
        s.first.push_back(static_cast<int>(s.row.size()));
    }
    return s;
}

/// Banded with a few far couplings, diagonally dominant, rows scaled over six decades.
MatrixXd positive_definite(int n) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    MatrixXd m = MatrixXd::Zero(n, n);
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < r; ++c)
            if (r - c <= 3 || (r + 5 * c) % 17 == 0) m(r, c) = m(c, r) = number(random);
    for (int k = 0; k < n; ++k) m(k, k) = 0.1 + m.row(k).cwiseAbs().sum();
    VectorXd scale(n);
    for (int k = 0; k < n; ++k) scale[k] = std::pow(10.0, 3 * number(random));
    return scale.asDiagonal() * m * scale.asDiagonal();
}

MatrixXd random_columns(int rows, int columns) {
    std::mt19937 random(11);
    std::normal_distribution<double> number;
    return MatrixXd::NullaryExpr(rows, columns, [&]() { return number(random); });
}

}  // namespace

TEST(Factorization, SolvesLikeADenseOne) {
    for (int n : {1, 2, 7, 60, 150}) {
        const MatrixXd a = positive_definite(n);
        const Factorization f(sparse(a));
        ASSERT_TRUE(f.ok());
        EXPECT_EQ(f.failed_at(), -1);
        const VectorXd b = a * random_columns(n, 1);  // so that rows of all scales matter
        const VectorXd x = f.solve(b), reference = a.llt().solve(b);
        const VectorXd scale = a.diagonal().cwiseSqrt();
        EXPECT_LT(test::relative_difference(VectorXd(scale.cwiseProduct(x)), VectorXd(scale.cwiseProduct(reference))), 1e-12);
    }
}

TEST(Factorization, ForwardSolvesGiveTheCompliance) {
    for (int n : {1, 9, 80}) {
        const MatrixXd a = positive_definite(n), b = a.diagonal().cwiseSqrt().asDiagonal() * random_columns(n, 5);
        const MatrixXd y = Factorization(sparse(a)).solve_lower(b);
        const MatrixXd reference = b.transpose() * a.llt().solve(b);
        EXPECT_LT(test::relative_difference(MatrixXd(y.transpose() * y), reference), 1e-12);
        EXPECT_GT(test::relative_difference(MatrixXd(1.0001 * y.transpose() * y), reference), 1e-12);
    }
}

TEST(Factorization, OfStiffnessesIsAsGoodAsTheDenseOne) {
    const PartInput part = test::rectangle(2, 1, 6, 4, 3);
    const BlockMatrix k = assemble_stiffness(part);
    std::vector<int> number(static_cast<std::size_t>(2 * k.n), -1), kept;
    for (int i = 7; i < 2 * k.n; ++i) {  // some coefficients held: no rigid motion left
        number[static_cast<std::size_t>(i)] = i - 7;
        kept.push_back(i);
    }
    const MatrixXd a = test::dense(k)(kept, kept);
    const Factorization f(restricted(k, number, 2 * k.n - 7));
    ASSERT_TRUE(f.ok());
    const MatrixXd b = random_columns(2 * k.n - 7, 4), reference = b.transpose() * a.llt().solve(b);
    const MatrixXd y = f.solve_lower(b);
    EXPECT_LT(test::relative_difference(MatrixXd(y.transpose() * y), reference), 1e-9);  // rounding times a condition of 1e5
    EXPECT_LT(test::relative_difference(MatrixXd(b.transpose() * f.solve(b.col(0))), MatrixXd(reference.col(0))), 1e-9);
}

TEST(Factorization, ReportsIndefiniteMatrices) {
    MatrixXd a = positive_definite(30);
    a(12, 12) = -a(12, 12);
    const Factorization negative(sparse(a));
    EXPECT_FALSE(negative.ok());
    EXPECT_EQ(negative.failed_at(), 12);
    a(12, 12) = 0;
    EXPECT_FALSE(Factorization(sparse(a)).ok());

    MatrixXd saddle = MatrixXd::Identity(40, 40);  // positive diagonal, one negative eigenvalue: found while factorising
    saddle(20, 30) = saddle(30, 20) = 1.5;
    const Factorization hidden(sparse(saddle));
    EXPECT_FALSE(hidden.ok());
    EXPECT_TRUE(hidden.failed_at() == 20 || hidden.failed_at() == 30) << hidden.failed_at();
}

TEST(Factorization, ReportsWhatIsNotANumber) {
    MatrixXd a = positive_definite(10);
    a(4, 4) = std::nan("");
    EXPECT_EQ(Factorization(sparse(a)).failed_at(), 4);
}

TEST(Factorization, EstimatesTheConditionOfTheScaledMatrix) {
    const MatrixXd diagonal = VectorXd::LinSpaced(20, 1, 1e6).asDiagonal();
    EXPECT_NEAR(Factorization(sparse(diagonal)).condition_estimate(), 1, 1e-12);
    for (double coupling : {0.5, 0.9, 0.999, 1 - 1e-6}) {
        MatrixXd pair = MatrixXd::Identity(2, 2);
        pair(0, 1) = pair(1, 0) = coupling;
        const double condition = (1 + coupling) / (1 - coupling);
        const double estimate = Factorization(sparse(pair)).condition_estimate();
        EXPECT_LE(estimate, condition * (1 + 1e-8));
        EXPECT_GE(estimate, 0.1 * condition);
    }
}

TEST(Factorization, CanBeMovedAndIsEmptyByDefault) {
    Factorization empty;
    EXPECT_FALSE(empty.ok());
    EXPECT_EQ(empty.failed_at(), -1);
    Factorization first(sparse(positive_definite(5)));
    empty = std::move(first);
    EXPECT_TRUE(empty.ok());
    EXPECT_EQ(empty.solve(VectorXd::Zero(5)), VectorXd::Zero(5));
}

TEST(Factorization, OfNothingSolvesNothing) {
    const Factorization f(sparse(MatrixXd(0, 0)));
    EXPECT_TRUE(f.ok());
    EXPECT_EQ(f.solve(VectorXd(0)).size(), 0);
    EXPECT_EQ(f.solve_lower(MatrixXd(0, 3)).cols(), 3);
    EXPECT_EQ(f.condition_estimate(), 1);
}

}  // namespace abut::solver
