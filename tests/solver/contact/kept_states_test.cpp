// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/kept_states.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "solver/contact/friction_states.hpp"

namespace abut::solver::kept_states_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index pairs = 30, motions = 3;

ContactQp problem(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> number;
    const auto matrix = [&](Index rows, Index columns) {
        return MatrixXd(MatrixXd::NullaryExpr(rows, columns, [&]() { return number(random); }));
    };
    const Index m = 2 * pairs;
    const MatrixXd b = matrix(m, m);
    ContactQp qp;
    qp.compliance = MatrixXd(b * b.transpose() + 0.05 * MatrixXd::Identity(m, m));
    qp.gap = matrix(m, 1);
    qp.modes = matrix(m, motions);
    qp.mode_load = matrix(motions, 1);
    qp.unilateral.assign(static_cast<std::size_t>(m), 1);
    for (int k = 0; k < pairs; ++k) {
        qp.friction.push_back({2 * k, 2 * k + 1, 0.3});
        qp.unilateral[static_cast<std::size_t>(2 * k + 1)] = 0;
    }
    return qp;
}

Proximal none() {
    return {MatrixXd::Zero(motions, motions), VectorXd::Zero(motions)};
}

/// Sets that differ by a few rows, by many, and problems that differ by gaps, loads and coefficients.
TEST(KeptStates, AnswerAsIfFactoredAnew) {
    std::mt19937 random(7);
    std::normal_distribution<double> number;
    ContactQp qp = problem(1);
    qp.kept = std::make_shared<KeptStates>();
    ActiveSet states(qp.unilateral.size(), row_state::closed);
    for (int step = 0; step < 200; ++step) {
        for (int changes = step % 20 == 0 ? 20 : 1; changes > 0; --changes) {
            const FrictionRow& f = qp.friction[random() % qp.friction.size()];
            const auto n = static_cast<std::size_t>(f.normal), t = static_cast<std::size_t>(f.tangential);
            const auto state = static_cast<char>(random() % 4);
            states[n] = state == row_state::open ? row_state::open : row_state::closed;
            states[t] = state;
        }
        if (step % 3 == 0) qp.gap[static_cast<Index>(random() % 60)] += number(random);
        if (step % 5 == 0) qp.mode_load[0] += number(random);
        if (step % 50 == 49) qp.friction[0].coefficient += 0.1;
        if (step % 70 == 69) qp.modes(0, 0) += 1;
        ContactQp anew = qp;
        anew.kept = nullptr;
        ContactState kept, expected;
        ASSERT_TRUE(solve_states({qp, qp.gap}, none(), states, kept)) << step;
        ASSERT_TRUE(solve_states({anew, qp.gap}, none(), states, expected)) << step;
        const double largest = expected.multipliers.cwiseAbs().maxCoeff();
        EXPECT_LT((kept.multipliers - expected.multipliers).cwiseAbs().maxCoeff(), 1e-9 * largest) << step;
        EXPECT_LT((kept.amplitudes - expected.amplitudes).norm(), 1e-9 * (1 + expected.amplitudes.norm())) << step;
        EXPECT_LT((kept.closing - expected.closing).norm(), 1e-9 * (1 + expected.closing.norm())) << step;
    }
}

/// Of sets that leave a motion free there is no factor; what was kept is not touched, and answers others.
TEST(KeptStates, ThatLeaveAMotionFreeAreNotAnswered) {
    ContactQp qp = problem(2);
    KeptStates kept;
    ContactState state;
    const ActiveSet closed(qp.unilateral.size(), row_state::closed), open(qp.unilateral.size(), row_state::open);
    ASSERT_TRUE(kept.solve({qp, qp.gap}, closed, state));
    const VectorXd before = state.multipliers;
    EXPECT_FALSE(kept.solve({qp, qp.gap}, open, state));
    ActiveSet two_held = open;
    two_held[0] = two_held[1] = row_state::closed;
    EXPECT_FALSE(kept.solve({qp, qp.gap}, two_held, state));
    EXPECT_EQ(state.multipliers, before);
    ASSERT_TRUE(kept.solve({qp, qp.gap}, closed, state));
    EXPECT_LT((state.multipliers - before).norm(), 1e-12 * before.norm());
}

}  // namespace
}  // namespace abut::solver::kept_states_test
