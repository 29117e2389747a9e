// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/signed_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "solver/linear_algebra/factorization.hpp"

namespace abut::solver::signed_factor_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// [A B'; B -M], A and M positive definite, of a random sparse pattern.
struct QuasiDefinite {
    MatrixXd a, b, m;

    QuasiDefinite(int n, int n_eliminated, unsigned seed)
        : a(MatrixXd::Zero(n, n)), b(MatrixXd::Zero(n_eliminated, n)), m(MatrixXd::Zero(n_eliminated, n_eliminated)) {
        std::mt19937 random(seed);
        const auto number = [&] { return static_cast<double>(random()) * 0x1p-31 - 1; };
        const auto fill = [&](MatrixXd& x, int times) {
            for (int k = 0; k < times; ++k)
                x(static_cast<Index>(random() % static_cast<unsigned>(x.rows())),
                  static_cast<Index>(random() % static_cast<unsigned>(x.cols()))) = number();
        };
        MatrixXd ra = a, rm = m;
        fill(ra, 2 * n);
        fill(rm, n_eliminated);
        fill(b, 3 * n_eliminated);
        a = ra * ra.transpose() + 0.5 * MatrixXd::Identity(n, n);
        m = 1e-3 * (rm * rm.transpose() + 0.5 * MatrixXd::Identity(n_eliminated, n_eliminated));
    }

    MatrixXd whole() const {
        MatrixXd w(a.rows() + m.rows(), a.rows() + m.rows());
        w << a, b.transpose(), b, -m;
        return w;
    }
    MatrixXd schur_complement() const { return a + b.transpose() * m.ldlt().solve(b); }
};

SparseSymmetric sparse(const MatrixXd& a) {
    SparseSymmetric s{static_cast<int>(a.rows()), {0}, {}, {}};
    for (Index c = 0; c < a.cols(); ++c) {
        for (Index r = c; r < a.rows(); ++r)
            if (r == c || a(r, c) != 0) {
                s.row.push_back(static_cast<int>(r));
                s.value.push_back(a(r, c));
            }
        s.first.push_back(static_cast<int>(s.row.size()));
    }
    return s;
}

constexpr int sizes[][2] = {{1, 1}, {2, 1}, {7, 3}, {40, 17}, {150, 80}, {400, 200}};

TEST(SignedFactor, StandsForTheSchurComplement) {
    unsigned seed = 1;
    for (const auto& [n, n_eliminated] : sizes) {
        const QuasiDefinite q(n, n_eliminated, seed++);
        const Factorization factor(sparse(q.whole()), n_eliminated);
        ASSERT_TRUE(factor.ok()) << n;
        const MatrixXd k = q.schur_complement(), rhs = MatrixXd::Random(n, 5), inverse = k.ldlt().solve(rhs);
        const double scale = inverse.cwiseAbs().maxCoeff();
        for (Index c = 0; c < rhs.cols(); ++c)
            EXPECT_LT((factor.solve(rhs.col(c)) - inverse.col(c)).cwiseAbs().maxCoeff(), 1e-9 * scale) << n;
        const MatrixXd form = rhs.transpose() * inverse;
        EXPECT_LT((factor.inverse_form(rhs.sparseView()) - form).cwiseAbs().maxCoeff(), 1e-9 * form.cwiseAbs().maxCoeff()) << n;
        EXPECT_THROW(factor.solve_lower(rhs), std::logic_error);
    }
}

TEST(SignedFactor, KnowsTheConditionOfTheSchurComplement) {
    const QuasiDefinite q(150, 80, 5);
    const Factorization factor(sparse(q.whole()), 80);
    const MatrixXd k = q.schur_complement();
    const double condition = k.colwise().lpNorm<1>().maxCoeff() * k.inverse().colwise().lpNorm<1>().maxCoeff();
    EXPECT_LT(factor.unscaled_condition_one(), 1.0001 * condition);
    EXPECT_GT(factor.unscaled_condition_one(), condition / 3);
    EXPECT_GT(factor.condition_estimate(), 1);
}

/// A direction in which A is negative, however little, is noticed, and so is one of -M that is positive.
TEST(SignedFactor, TellsWrongSigns) {
    for (unsigned seed = 1; seed <= 20; ++seed)
        for (bool in_a : {true, false}) {
            QuasiDefinite q(60, 30, seed);
            q.b.setZero();  // it would make up for what A lacks
            MatrixXd& block = in_a ? q.a : q.m;
            const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(block);
            const VectorXd v = eigen.eigenvectors().col(0);
            const double most = eigen.eigenvalues()[block.rows() - 1];
            block -= (eigen.eigenvalues()[0] + 1e-9 * most) * v * v.transpose();
            EXPECT_FALSE(Factorization(sparse(q.whole()), 30).ok()) << seed << " " << in_a;
            block += 2e-9 * most * v * v.transpose();
            EXPECT_TRUE(Factorization(sparse(q.whole()), 30).ok()) << seed << " " << in_a;
        }
}

TEST(SignedFactor, TheSameInputGivesTheSameBits) {
    const QuasiDefinite q(400, 200, 3);
    const VectorXd b = VectorXd::LinSpaced(400, -1, 2);
    const Factorization first(sparse(q.whole()), 200), second(sparse(q.whole()), 200);
    EXPECT_EQ(first.solve(b), second.solve(b));
}

}  // namespace
}  // namespace abut::solver::signed_factor_test
