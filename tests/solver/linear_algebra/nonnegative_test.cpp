// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/nonnegative.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <random>

namespace abut::solver::nonnegative_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The least residual over all choices of unknowns that are not zero, of those whose bounded unknowns come out non-negative.
double least_residual(const MatrixXd& a, const VectorXd& b, const std::vector<char>& bounded) {
    double least = std::numeric_limits<double>::infinity();
    for (unsigned set = 0; set < 1u << a.cols(); ++set) {
        std::vector<Index> columns;
        for (Index k = 0; k < a.cols(); ++k)
            if (set >> k & 1u) columns.push_back(k);
        VectorXd x = VectorXd::Zero(a.cols());
        if (!columns.empty())
            x(columns) = VectorXd(MatrixXd(a(Eigen::all, columns)).completeOrthogonalDecomposition().solve(b));
        bool feasible = true;
        for (Index k = 0; k < a.cols(); ++k) feasible = feasible && (!bounded[static_cast<std::size_t>(k)] || x[k] >= -1e-13);
        if (feasible) least = std::min(least, (b - a * x).norm());
    }
    return least;
}

/// What is wrong with a result: negative unknowns, wrong residual, columns along which the residual could still be reduced.
double optimality_error(const MatrixXd& a, const VectorXd& b, const std::vector<char>& bounded, const VectorXd& x,
                        const VectorXd& residual) {
    double worst = (b - a * x - residual).norm();
    const VectorXd slope = a.transpose() * residual;
    for (Index k = 0; k < a.cols(); ++k) {
        const bool is_bounded = bounded[static_cast<std::size_t>(k)];
        if (is_bounded) worst = std::max(worst, -x[k]);
        worst = std::max(worst, is_bounded && x[k] <= 0 ? slope[k] : std::abs(slope[k]));
    }
    return worst;
}

struct Problem {
    MatrixXd a;
    VectorXd b;
    std::vector<char> bounded;
};

/// Random entries of order 1; every third problem has whole numbers, so that ties and dependent columns occur.
std::vector<Problem> problems() {
    std::mt19937 random(5);
    std::normal_distribution<double> number;
    std::vector<Problem> all;
    for (int trial = 0; trial < 300; ++trial) {
        const int rows = 1 + trial % 4, columns = 1 + trial / 4 % 8;
        const auto entry = [&]() { return trial % 3 == 0 ? std::round(number(random)) : number(random); };
        Problem p{MatrixXd::NullaryExpr(rows, columns, entry), VectorXd::NullaryExpr(rows, entry), {}};
        for (int k = 0; k < columns; ++k) p.bounded.push_back(trial % 2 == 0 || number(random) > -0.5);
        all.push_back(p);
    }
    return all;
}

constexpr double bound = 1e-11;  // rounding of a few steps with well-conditioned columns; the stopping tolerance is 1e-12

}  // namespace

TEST(NonnegativeLeastSquares, FindsTheLeastResidualOfAllSubsets) {
    int n_positive = 0;
    for (const Problem& p : problems()) {
        const NonnegativeResult r = nonnegative_least_squares(p.a, p.b, p.bounded);
        const double least = least_residual(p.a, p.b, p.bounded);
        EXPECT_TRUE(r.converged);
        EXPECT_NEAR(r.residual.norm(), least, bound * (1 + p.b.norm()));
        n_positive += least > 1e-6;
    }
    EXPECT_GT(n_positive, 50);  // neither all nor none of the systems can be met
    EXPECT_LT(n_positive, 250);
}

TEST(NonnegativeLeastSquares, IsOptimal) {
    for (const Problem& p : problems()) {
        const NonnegativeResult r = nonnegative_least_squares(p.a, p.b, p.bounded);
        EXPECT_LT(optimality_error(p.a, p.b, p.bounded, r.x, r.residual), bound * (1 + p.a.norm() * p.b.norm()));
    }
}

TEST(NonnegativeLeastSquares, OptimalityCheckSeesAWrongResult) {
    const MatrixXd a = MatrixXd::Identity(2, 2);
    const VectorXd b = Eigen::Vector2d(1, -1);
    const std::vector<char> bounded{1, 1};
    const auto error = [&](double x, double y) {
        return optimality_error(a, b, bounded, Eigen::Vector2d(x, y), b - Eigen::Vector2d(x, y));
    };
    EXPECT_EQ(error(1, 0), 0);
    EXPECT_GT(error(1.001, 0), bound);
    EXPECT_GT(error(0, 0), bound);
    EXPECT_GT(error(1, -1), bound);
}

TEST(NonnegativeLeastSquares, TakesFreeUnknownsOfEitherSign) {
    const MatrixXd a = MatrixXd::Identity(3, 3);
    const NonnegativeResult r = nonnegative_least_squares(a, Eigen::Vector3d(-1, -2, 3), {0, 1, 1});
    EXPECT_TRUE(r.x.isApprox(Eigen::Vector3d(-1, 0, 3), 1e-14));
    EXPECT_TRUE(r.residual.isApprox(Eigen::Vector3d(0, -2, 0), 1e-14));
}

TEST(NonnegativeLeastSquares, OfNothingLeavesTheRightSide) {
    const NonnegativeResult none = nonnegative_least_squares(MatrixXd(2, 0), Eigen::Vector2d(1, 2), {});
    EXPECT_TRUE(none.converged);
    EXPECT_EQ(none.x.size(), 0);
    EXPECT_EQ(none.residual, Eigen::Vector2d(1, 2));
    const NonnegativeResult zero = nonnegative_least_squares(MatrixXd::Identity(2, 2), Eigen::Vector2d(0, 0), {1, 1});
    EXPECT_TRUE(zero.converged);
    EXPECT_TRUE(zero.x.isZero(0));
    EXPECT_TRUE(nonnegative_least_squares(MatrixXd::Zero(2, 3), Eigen::Vector2d(1, 2), {1, 0, 1}).converged);
}

TEST(NonnegativeLeastSquares, BalancesManyRowsAtOnce) {
    // equilibrium of a beam on 400 equal springs: force and moment, whose resultant lies inside
    MatrixXd a(2, 400);
    for (Index k = 0; k < 400; ++k) a.col(k) << 1, (static_cast<double>(k) - 199.5) / 200;
    const NonnegativeResult inside = nonnegative_least_squares(a, Eigen::Vector2d(10, 9.9), std::vector<char>(400, 1));
    EXPECT_TRUE(inside.converged);
    EXPECT_LT(inside.residual.norm(), 1e-11);
    const NonnegativeResult outside = nonnegative_least_squares(a, Eigen::Vector2d(10, 10.1), std::vector<char>(400, 1));
    EXPECT_TRUE(outside.converged);
    EXPECT_NEAR(outside.residual.norm(), (10.1 - 10 * 0.9975) / std::hypot(1, 0.9975),
                1e-10);  // distance from the cone's last ray
}

TEST(NonnegativeLeastSquares, RefusesOtherSizes) {
    const MatrixXd a = MatrixXd::Identity(2, 2);
    EXPECT_THROW(nonnegative_least_squares(a, Eigen::Vector3d(1, 2, 3), {1, 1}), std::logic_error);
    EXPECT_THROW(nonnegative_least_squares(a, Eigen::Vector2d(1, 2), {1}), std::logic_error);
}

TEST(LeastDistance, IsThatOfTheNearestPlaceInAHalfPlaneOrAWedge) {
    MatrixXd rows(2, 2);
    rows << 3, 4, 1, 0;
    const auto side = least_distance(rows, Eigen::Vector2d(10, -100));  // 3 x + 4 y >= 10
    ASSERT_TRUE(side.has_value());
    EXPECT_LT((*side - Eigen::Vector2d(1.2, 1.6)).norm(), 1e-12);
    const auto corner = least_distance(rows, Eigen::Vector2d(10, 2));
    ASSERT_TRUE(corner.has_value());
    EXPECT_LT((*corner - Eigen::Vector2d(2, 1)).norm(), 1e-12);
    EXPECT_TRUE(least_distance(rows, Eigen::Vector2d(-1, 0)).value().isZero(0)) << "nothing is asked for";
    EXPECT_TRUE(least_distance(MatrixXd(0, 2), VectorXd(0)).value().isZero(0));
}

TEST(LeastDistance, ThereIsNoneBetweenWallsThatOverlap) {
    const MatrixXd walls = Eigen::Vector2d(1, -1);
    EXPECT_FALSE(least_distance(walls, Eigen::Vector2d(1, 1)).has_value());
    EXPECT_FALSE(least_distance(MatrixXd::Zero(1, 2), VectorXd::Ones(1)).has_value());
    EXPECT_NEAR(least_distance(walls, Eigen::Vector2d(1, -1.5)).value()[0], 1, 1e-12);
}

}  // namespace abut::solver::nonnegative_test
