// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/complementarity.hpp"

#include <gtest/gtest.h>

#include <random>

namespace abut::solver::complementarity_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double violation(const MatrixXd& m, const VectorXd& q, const VectorXd& z) {
    const VectorXd w = m * z + q;
    return std::max({-z.minCoeff(), -w.minCoeff(), z.cwiseMin(w).maxCoeff()});
}

TEST(Complementarity, OfPositiveDefiniteMatricesIsFound) {
    std::mt19937 random(1);
    std::normal_distribution<double> number;
    for (Index n : {1, 2, 5, 20, 60}) {
        const MatrixXd b = MatrixXd::NullaryExpr(n, n, [&]() { return number(random); });
        const MatrixXd skew = MatrixXd::NullaryExpr(n, n, [&]() { return number(random); });
        const MatrixXd m = b * b.transpose() + 0.1 * MatrixXd::Identity(n, n) + skew - skew.transpose();
        const VectorXd q = VectorXd::NullaryExpr(n, [&]() { return number(random); });
        const auto z = complementary(m, q);
        ASSERT_TRUE(z) << n;
        EXPECT_LT(violation(m, q, *z), 1e-8) << n;
    }
}

TEST(Complementarity, IsFoundFromAnyExpectation) {
    std::mt19937 random(2);
    std::normal_distribution<double> number;
    for (const Index n : {1, 3, 40, 90}) {
        const MatrixXd b = MatrixXd::NullaryExpr(n, n, [&]() { return number(random); });
        const MatrixXd m = b * b.transpose() + 0.1 * MatrixXd::Identity(n, n);
        const VectorXd q = VectorXd::NullaryExpr(n, [&]() { return number(random); });
        const VectorXd z = complementary(m, q).value();
        const auto expects = [&](const std::vector<char>& positive) {
            const auto again = complementary(m, q, positive);
            ASSERT_TRUE(again) << n;
            EXPECT_LT((*again - z).norm(), 1e-8 * (1 + z.norm())) << n;
        };
        std::vector<char> positive(static_cast<std::size_t>(n));
        expects(positive);
        for (Index i = 0; i < n; ++i) positive[static_cast<std::size_t>(i)] = z[i] > 0;
        expects(positive);
        for (char& p : positive) p = static_cast<char>(!p);
        expects(positive);
        for (char& p : positive) p = number(random) > 0;
        expects(positive);
    }
}

TEST(Complementarity, WhatIsExpectedMayBeSingular) {
    const MatrixXd m = MatrixXd{{0, 1}, {-1, 0}};
    const auto z = complementary(m, VectorXd{{-1, 2}}, {1, 0});  // m(0, 0) = 0: no dictionary has this basis
    ASSERT_TRUE(z);
    EXPECT_LT(violation(m, VectorXd{{-1, 2}}, *z), 1e-8);
}

TEST(Complementarity, WithoutAnswerIsTold) {
    EXPECT_FALSE(complementary(MatrixXd::Zero(1, 1), VectorXd::Constant(1, -1)));
    const auto nothing_to_do = complementary(MatrixXd::Zero(1, 1), VectorXd::Constant(1, 1));
    ASSERT_TRUE(nothing_to_do);
    EXPECT_EQ((*nothing_to_do)[0], 0);
}

}  // namespace
}  // namespace abut::solver::complementarity_test
