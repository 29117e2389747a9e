// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/box_qp.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace abut::solver::box_qp_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();

Semidefinite of(const MatrixXd& a) {
    return {[a](const VectorXd& x) -> VectorXd { return a * x; },
            [a](const std::vector<Index>& rows) -> MatrixXd { return a(rows, rows); }, a.diagonal()};
}

/// How far a step along the steepest descent, cut at the bounds, leads: zero at the answer alone.
double violation(const MatrixXd& a, const VectorXd& b, const VectorXd& lower, const VectorXd& upper, const VectorXd& x) {
    return (x - (x - (a * x + b)).cwiseMax(lower).cwiseMin(upper)).cwiseAbs().maxCoeff();
}

TEST(BoxQp, IsSolvedFromAnyStart) {
    std::mt19937 random(3);
    std::normal_distribution<double> number;
    const auto vector = [&](Index n) { return VectorXd(VectorXd::NullaryExpr(n, [&]() { return number(random); })); };
    for (const Index n : {1, 2, 7, 40, 120})
        for (int repeat = 0; repeat < 20; ++repeat) {
            const MatrixXd half = MatrixXd::NullaryExpr(n, n, [&]() { return number(random); });
            const MatrixXd a = half * half.transpose() + 0.01 * MatrixXd::Identity(n, n);
            const VectorXd b = 3 * vector(n);
            VectorXd lower = -vector(n).cwiseAbs(), upper = vector(n).cwiseAbs();
            for (Index k = 0; k < n; ++k) {
                if (k % 5 == 1) lower[k] = -infinity;
                if (k % 5 < 3) upper[k] = infinity;
                if (k % 7 == 3) lower[k] = upper[k] = 0;
            }
            int steps = 0;
            const auto x = minimize_in_box(of(a), b, lower, upper, 2 * vector(n), steps);
            ASSERT_TRUE(x) << n;
            EXPECT_LT(violation(a, b, lower, upper, *x), 1e-9 * (1 + x->norm()) * a.norm()) << n;
            EXPECT_GE((*x - lower).minCoeff(), 0);
            EXPECT_GE((upper - *x).minCoeff(), 0);
            int again = 0;
            EXPECT_LT((*minimize_in_box(of(a), b, lower, upper, *x, again) - *x).norm(), 1e-9 * (1 + x->norm())) << n;
            EXPECT_LE(again, 1);
        }
}

/// A stretched string over a floor: where it lies follows from where it does not, so that single entries take a step each.
TEST(BoxQp, OfManyEntriesIsSolvedInFewSteps) {
    constexpr Index n = 200;
    MatrixXd a = 2 * MatrixXd::Identity(n, n);
    for (Index k = 1; k < n; ++k) a(k, k - 1) = a(k - 1, k) = -1;
    const VectorXd lower = VectorXd::LinSpaced(n, -1, 1).array().square() - 0.5, upper = VectorXd::Constant(n, infinity),
                   b = VectorXd::Constant(n, 1e-4);
    int steps = 0;
    const auto x = minimize_in_box(of(a), b, lower, upper, lower, steps);
    ASSERT_TRUE(x);
    EXPECT_LT(violation(a, b, lower, upper, *x), 1e-12);
    EXPECT_LT(steps, n / 4);
}

TEST(BoxQp, OfWhatIsSingularHasAnAnswerWithinItsBounds) {
    const MatrixXd a = MatrixXd{{1, -1}, {-1, 1}};
    int steps = 0;
    const VectorXd b{{-1, 1}}, lower{{0, 0}}, upper{{5, 5}};
    const auto x = minimize_in_box(of(a), b, lower, upper, VectorXd::Zero(2), steps);
    ASSERT_TRUE(x);
    EXPECT_LT(violation(a, b, lower, upper, *x), 1e-14);
}

}  // namespace
}  // namespace abut::solver::box_qp_test
