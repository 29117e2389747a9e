// SPDX-License-Identifier: GPL-3.0-or-later
// The factor that goes from set to set, against one made anew.
#include "solver/linear_algebra/closed_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <random>

namespace abut::solver::closed_factor_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_compliance(std::mt19937& random, Index m) {
    std::normal_distribution<double> number;
    const MatrixXd b = MatrixXd::NullaryExpr(m, m, [&] { return number(random); });
    return b * b.transpose() + MatrixXd::Identity(m, m);
}

VectorXd random_vector(std::mt19937& random, Index m) {
    std::normal_distribution<double> number;
    return VectorXd::NullaryExpr(m, [&] { return number(random); });
}

/// b'C^-1 b on the closed rows, and the solution C^-1 b there: the largest relative error against a new factor.
double error_of(const ClosedFactor& factor, const MatrixXd& compliance, const std::vector<char>& closed, const VectorXd& b) {
    const std::vector<Index>& rows = factor.rows();
    std::vector<Index> sorted = rows;
    std::sort(sorted.begin(), sorted.end());
    std::vector<Index> expected_rows;
    for (std::size_t k = 0; k < closed.size(); ++k)
        if (closed[k]) expected_rows.push_back(static_cast<Index>(k));
    EXPECT_EQ(sorted, expected_rows);
    if (rows.empty()) return 0;
    VectorXd y = b(rows);
    factor.solve_lower(y);
    factor.solve_transposed(y);
    const MatrixXd c = compliance(rows, rows);
    const VectorXd expected = c.llt().solve(b(rows));
    return (y - expected).norm() / expected.norm();
}

TEST(ClosedFactor, FollowsAnySequenceOfSets) {
    std::mt19937 random(11);
    for (Index m : {1, 2, 9, 40}) {
        const MatrixXd compliance = random_compliance(random, m);
        ClosedFactor factor(compliance, random_vector(random, m));
        const MatrixXd columns = MatrixXd::NullaryExpr(m, 3, [&] { return random_vector(random, 1)[0]; });
        std::vector<char> closed(static_cast<std::size_t>(m), 0);
        for (int step = 0; step < 60; ++step) {
            const unsigned changes = step % 10 == 0 ? 1000 : 1 + static_cast<unsigned>(step % 3);
            for (unsigned k = 0; k < changes; ++k) {
                char& row = closed[random() % closed.size()];
                row = !row;
            }
            ASSERT_TRUE(factor.move_to(closed));
            EXPECT_LT(error_of(factor, compliance, closed, random_vector(random, m)), 1e-12) << m << " " << step;
            if (step % 4 == 1) continue;  // what is solved skips sets
            MatrixXd expected = columns(factor.rows(), Eigen::all);
            for (Index j = 0; j < 3; ++j) {
                VectorXd x = expected.col(j);
                factor.solve_lower(x);
                expected.col(j) = x;
            }
            EXPECT_LE((factor.solved(columns) - expected).norm(), 1e-12 * expected.norm()) << m << " " << step;
        }
    }
}

TEST(ClosedFactor, TakesRowsByFallingPressure) {
    std::mt19937 random(3);
    const MatrixXd compliance = random_compliance(random, 5);
    ClosedFactor factor(compliance, (VectorXd(5) << 1, 5, 0, 3, 0).finished());
    ASSERT_TRUE(factor.move_to({1, 1, 1, 1, 0}));
    EXPECT_EQ(factor.rows(), (std::vector<Index>{1, 3, 0, 2}));
    ASSERT_TRUE(factor.move_to({0, 1, 1, 1, 1}));  // what came before the row that left stays
    EXPECT_EQ(factor.rows(), (std::vector<Index>{1, 3, 2, 4}));
}

TEST(ClosedFactor, TellsSingularSetsAndGoesOnFromThem) {
    std::mt19937 random(7);
    MatrixXd compliance = random_compliance(random, 6);
    compliance.row(4) = compliance.row(1);
    compliance.col(4) = compliance.col(1);
    compliance(4, 4) = 0.5 * compliance(1, 1);  // less than its share: indefinite with row 1
    ClosedFactor factor(compliance, VectorXd::LinSpaced(6, 6, 1));
    const std::vector<char> all(6, 1), some{1, 1, 1, 0, 0, 1};
    EXPECT_FALSE(factor.move_to(all));
    EXPECT_FALSE(factor.move_to(all));
    ASSERT_TRUE(factor.move_to(some));
    EXPECT_LT(error_of(factor, compliance, some, random_vector(random, 6)), 1e-12);
}

TEST(ClosedFactor, LeavesOutWhatTheOthersAlreadyClose) {
    std::mt19937 random(5);
    MatrixXd compliance = random_compliance(random, 7);
    // rows 2 and 6 are combinations of 0, 1 and 3
    MatrixXd combine = MatrixXd::Identity(7, 7);
    combine.row(2) << 0.3, 0.5, 0, 1, 0, 0, 0;
    combine.row(6) << 1, -2, 0, 0.1, 0, 0, 0;
    compliance = (combine * compliance * combine.transpose()).eval();
    ClosedFactor factor(compliance, VectorXd::LinSpaced(7, 7, 1));
    ASSERT_TRUE(factor.move_to(std::vector<char>(7, 1)));
    EXPECT_EQ(factor.rows().size(), 5u);
    EXPECT_EQ(factor.left_out().size(), 2u);
    const std::vector<Index>& rows = factor.rows();
    VectorXd y = compliance(rows, Eigen::all) * VectorXd::Ones(7);
    factor.solve_lower(y);
    factor.solve_transposed(y);
    // what closes these rows gives the others the gaps that they have, too
    const VectorXd all = compliance(Eigen::all, rows) * y;
    EXPECT_LT((all - compliance * VectorXd::Ones(7)).norm(), 1e-12 * all.norm());
    // and without the rows that they depend on they count
    ASSERT_TRUE(factor.move_to({0, 0, 1, 0, 0, 0, 1}));
    EXPECT_TRUE(factor.left_out().empty());
    EXPECT_EQ(factor.rows().size(), 2u);
}

}  // namespace
}  // namespace abut::solver::closed_factor_test
