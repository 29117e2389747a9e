// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/interior_point.hpp"

#include <gtest/gtest.h>

#include <random>

#include "solver/contact/rigid_settle.hpp"

namespace abut::solver::interior_point_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Random compliance, gaps and modes, some rows bilateral, under loads that some pressures balance.
ContactQp random_problem(unsigned seed, Index m, Index n) {
    std::mt19937 random(seed);
    std::normal_distribution<double> number;
    const auto matrix = [&](Index rows, Index columns) -> MatrixXd {
        return MatrixXd::NullaryExpr(rows, columns, [&]() { return number(random); });
    };
    const MatrixXd b = matrix(m, m);
    ContactQp qp;
    qp.compliance = b * b.transpose() + 0.05 * MatrixXd::Identity(m, m);
    qp.gap = qp.drawn_gap = matrix(m, 1);
    qp.modes = matrix(m, n);
    for (Index k = 0; k < m; ++k) qp.unilateral.push_back(random() % 5 != 0);
    qp.mode_load = -qp.modes.transpose() * matrix(m, 1).cwiseAbs();
    qp.load_scale = n > 0 ? qp.mode_load.cwiseAbs().maxCoeff() : 0;
    qp.foundation = qp.compliance.diagonal().cwiseInverse();
    return qp;
}

/// The conditions of contact, each over its own scale.
double violation(const ContactQp& qp, const ContactState& s) {
    const VectorXd gap = gap_of({qp, qp.gap}, s), imbalance = qp.modes.transpose() * s.multipliers + qp.mode_load;
    return contact_residual(qp, {s.multipliers, gap, imbalance});
}

TEST(InteriorPoint, MeetsTheConditionsOfContact) {
    // compliances of these have condition numbers up to 1e5: what is left of products of 1e-11 is that much more of gaps
    int steps = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Index m = 5 + 7 * (seed % 10), n = seed % 6;
        const ContactQp qp = random_problem(seed, m, n);
        const InteriorPoint found = interior_point({qp, qp.gap}, VectorXd::Ones(m));
        ASSERT_TRUE(found.converged) << seed;
        EXPECT_LT(violation(qp, found.state), 1e-5) << seed;
        steps = std::max(steps, found.iterations);
    }
    EXPECT_LE(steps, 40);
    const ContactQp qp = random_problem(3, 26, 3);
    ContactState off = interior_point({qp, qp.gap}, VectorXd::Ones(26)).state;
    off.multipliers *= 1.01;
    off.closing *= 1.01;
    EXPECT_GT(violation(qp, off), 1e-3);  // a wrong answer shows
}

TEST(InteriorPoint, ClosesTheRowsOfTheExactAnswer) {
    for (unsigned seed = 100; seed < 120; ++seed) {
        const ContactQp qp = random_problem(seed, 40, 3);
        const InteriorPoint found = interior_point({qp, qp.gap}, VectorXd::Ones(40));
        const ContactQpResult exact = solve_contact_qp(qp);
        ASSERT_TRUE(found.converged && exact.converged);
        EXPECT_EQ(found.active, exact.active) << seed;
        EXPECT_LT((found.state.multipliers - exact.multipliers).norm(), 1e-4 * exact.multipliers.norm());
    }
}

TEST(InteriorPoint, EndsByTheClosingOfAllRowsNotOfOneAlone) {
    // as a thin part does, these rows give way to one's force by 10^6 of what all close by together
    const Index m = 40;
    const VectorXd bent = VectorXd::NullaryExpr(m, [](Index k) { return k % 2 == 0 ? 1.0 : -1.0; });
    ContactQp qp = random_problem(11, m, 0);
    qp.unilateral.assign(static_cast<std::size_t>(m), 1);
    qp.compliance = MatrixXd(1e6 * bent * bent.transpose() + MatrixXd::Identity(m, m));
    qp.gap = qp.drawn_gap = VectorXd::NullaryExpr(m, [](Index k) { return 1e-3 * static_cast<double>((k - 17) * (k - 17)); });
    qp.modes = VectorXd::Ones(m);
    qp.mode_load = VectorXd::Constant(1, -1.0);
    const InteriorPoint found = interior_point({qp, qp.gap}, VectorXd::Ones(m));
    ASSERT_TRUE(found.converged);
    EXPECT_LT(violation(qp, found.state), 1e-6);
}

TEST(InteriorPoint, SaysWhereNothingBalancesTheLoads) {
    ContactQp qp = random_problem(7, 10, 2);
    qp.unilateral.assign(10, 1);
    qp.modes.col(0).setOnes();
    qp.mode_load[0] = 1;  // pulls all rows open
    EXPECT_FALSE(interior_point({qp, qp.gap}, VectorXd::Ones(10)).converged);
}

}  // namespace
}  // namespace abut::solver::interior_point_test
