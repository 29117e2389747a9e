// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/friction_pivots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/contact/friction_states.hpp"

namespace abut::solver::friction_pivots_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int rows_of_a_face = 21;

/// A round face that a load presses into a foundation of springs along a line and pulls along it: motions are down, along and
/// a turn. As the load moves the zone of contact grows, and slips from its ends.
ContactQp roller(double friction, double down, double along, double turn) {
    const Index n = rows_of_a_face;
    ContactQp qp;
    qp.compliance = MatrixXd(MatrixXd::Identity(2 * n, 2 * n));
    qp.gap = VectorXd::Zero(2 * n);
    qp.modes = MatrixXd::Zero(2 * n, 3);
    qp.unilateral.assign(static_cast<std::size_t>(2 * n), 1);
    for (Index k = 0; k < n; ++k) {
        const double x = static_cast<double>(k - n / 2);
        qp.gap[2 * k] = 0.05 * x * x;
        qp.modes.row(2 * k) << -1, 0, x;
        qp.modes.row(2 * k + 1) << 0, 1, 1;
        qp.friction.push_back({static_cast<int>(2 * k), static_cast<int>(2 * k + 1), friction});
        qp.unilateral[static_cast<std::size_t>(2 * k + 1)] = 0;
    }
    qp.mode_load = VectorXd{{down, along, turn}};
    qp.drawn_gap = qp.gap;
    qp.foundation = VectorXd::Ones(2 * n);
    qp.load_scale = qp.mode_load.cwiseAbs().maxCoeff();
    return qp;
}

const Proximal& trifle() {
    static const Proximal term{1e-9 * MatrixXd::Identity(3, 3), VectorXd::Zero(3)};
    return term;
}
ContactState nothing(const ContactQp& qp) {
    return {VectorXd::Zero(qp.gap.size()), VectorXd::Zero(qp.modes.cols()), VectorXd::Zero(qp.gap.size())};
}

/// From nothing, over loads within the cone of friction and beside it; beyond, the term alone bears what friction does not.
TEST(FrictionPivots, FindAnyStateOfARoller) {
    for (const double friction : {1e-6, 0.1, 0.5, 2.0})
        for (const double share : {0.0, 0.3, -0.7, 0.95, 1.2})
            for (const double turn : {0.0, 1.0, -2.5}) {
                const ContactQp qp = roller(friction, 5, -5 * friction * share, turn - 5 * friction * share);
                ActiveSet states = bilateral_rows(qp);
                ContactState state = nothing(qp);
                int pivots = 0;
                ASSERT_TRUE(pivot_states({qp, qp.gap}, trifle(), states, state, pivots))
                    << friction << ' ' << share << ' ' << turn;
                EXPECT_EQ(next_states({qp, qp.gap}, states, state), states) << friction << ' ' << share << ' ' << turn;
                double along = 0, pressed = 0;
                for (const FrictionRow& f : qp.friction) {
                    EXPECT_LE(std::abs(state.multipliers[f.tangential]), friction * state.multipliers[f.normal] + 1e-12);
                    along += state.multipliers[f.tangential];
                    pressed += state.multipliers[f.normal];
                }
                EXPECT_NEAR(pressed, 5, 1e-6);
                EXPECT_NEAR(along, 5 * friction * std::min(share, 1.0), 1e-6);
            }
}

/// From the states under other loads: as many pivots as rows change their states, or little more.
TEST(FrictionPivots, AreFewFromStatesNearby) {
    const ContactQp first = roller(0.3, 5, -0.5, 0.5);
    ActiveSet states = bilateral_rows(first);
    ContactState state = nothing(first);
    int from_nothing = 0;
    ASSERT_TRUE(pivot_states({first, first.gap}, trifle(), states, state, from_nothing));
    for (int k = 1; k <= 40; ++k) {
        const double angle = std::numbers::pi * k / 20;
        const ContactQp qp = roller(0.3, 5 + 2 * std::sin(angle), -1.2 * std::sin(3 * angle), 1 - std::cos(angle));
        const ActiveSet before = states;
        int pivots = 0;
        ASSERT_TRUE(pivot_states({qp, qp.gap}, trifle(), states, state, pivots)) << k;
        int changed = 0;
        for (std::size_t row = 0; row < states.size(); ++row) changed += states[row] != before[row];
        EXPECT_LE(pivots, 2 * changed + 4) << k;
        EXPECT_EQ(next_states({qp, qp.gap}, states, state), states) << k;
        int none = 0;
        ASSERT_TRUE(pivot_states({qp, qp.gap}, trifle(), states, state, none)) << k;
        EXPECT_EQ(none, 0) << "what is a solution stays one";
    }
}

}  // namespace
}  // namespace abut::solver::friction_pivots_test
