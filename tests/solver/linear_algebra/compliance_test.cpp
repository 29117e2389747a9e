// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/compliance.hpp"

#include <gtest/gtest.h>

namespace abut::solver::compliance_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(Compliance, RowsOfAProductAreThoseOfAll) {
    const MatrixXd numbers = MatrixXd::Random(40, 40), symmetric = numbers + numbers.transpose();
    const std::vector<Index> rows = {0, 7, 8, 39};
    VectorXd x = VectorXd::Random(40);
    x.segment(5, 20).setZero();
    for (const Compliance& c : {Compliance(symmetric), Compliance(Eigen::SparseMatrix<double>(symmetric.sparseView()))}) {
        EXPECT_LT((c.product_at(rows, x) - (symmetric * x)(rows)).norm(), 1e-13);
        EXPECT_EQ(c.product_at({}, x).size(), 0);
    }
}

TEST(Compliance, CopiesShareTheirNumbers) {
    const Compliance one(MatrixXd(MatrixXd::Identity(3, 3))), other(MatrixXd(MatrixXd::Identity(3, 3)));
    const Compliance copy = one;
    EXPECT_TRUE(copy.shares(one));
    EXPECT_FALSE(other.shares(one));
}

}  // namespace
}  // namespace abut::solver::compliance_test
