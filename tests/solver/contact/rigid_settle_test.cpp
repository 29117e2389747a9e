// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid bodies come to rest wherever pressures can balance their loads, to the last digit: energies alone cannot tell the last
// half of the digits.
#include "solver/contact/rigid_settle.hpp"

#include <gtest/gtest.h>

#include <random>

namespace abut::solver::rigid_settle_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A flat body over m supports in a row, free to sink and to tilt, under a force between the supports.
ContactQp table(std::mt19937& random, Index m, bool tilts, double gap, double roughness, double load) {
    std::uniform_real_distribution<double> number(0, 1);
    ContactQp qp;
    qp.compliance = MatrixXd::Identity(m, m);
    qp.modes = MatrixXd::Ones(m, tilts ? 2 : 1);
    if (tilts) qp.modes.col(1) = VectorXd::LinSpaced(m, -1, 1);
    qp.drawn_gap = gap + roughness * VectorXd::NullaryExpr(m, [&] { return number(random); }).array();
    qp.gap = qp.drawn_gap;
    qp.mode_load = VectorXd::Constant(1, -load);
    if (tilts) qp.mode_load = load * Eigen::Vector2d(-1, 0.6 * (number(random) - 0.5));
    qp.unilateral.assign(static_cast<std::size_t>(m), 1);
    qp.foundation = VectorXd::NullaryExpr(m, [&] { return 1 + number(random); });
    qp.load_scale = load;
    return qp;
}

TEST(RigidSettle, BalancesTablesOfAnyLoadAndGap) {
    std::mt19937 random(2);
    int cases = 0;
    for (Index m : {2, 5, 40})
        for (bool tilts : {false, true})
            for (double gap : {0.0, 1e-6, 0.1, 1e3})
                for (double roughness : {0.0, 1e-9, 1e-3})
                    for (double load : {1e-9, 1e-3, 1.0, 1e6}) {
                        const ContactQp qp = table(random, m, tilts, gap, roughness, load);
                        const Settled s = settle_rigidly(qp);
                        const VectorXd imbalance = qp.modes.transpose() * s.multipliers + qp.mode_load;
                        // gaps far wider than the penetration leave it fewer digits
                        const double digits = 1e-12 + 1e-15 * (gap + roughness) * qp.foundation.sum() / load;
                        EXPECT_LE(imbalance.norm(), digits * load) << m << " " << tilts << " " << gap << " " << load;
                        EXPECT_GE(s.multipliers.minCoeff(), 0);
                        ++cases;
                    }
    EXPECT_EQ(cases, 288);
}

TEST(RigidSettle, TellsWhatNothingBalances) {
    std::mt19937 random(4);
    ContactQp qp = table(random, 5, false, 0, 0, 1);
    qp.mode_load[0] = 1;  // lifted
    EXPECT_FALSE(settle_rigidly(qp).balanced);
}

TEST(RigidSettle, SettlesAtOnceOnTheRowsThatEndUpPressed) {
    std::mt19937 random(9);
    int settled = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const ContactQp qp = table(random, 2 + trial % 30, trial % 2 != 0, 0.01, 1e-3, 1);
        const Settled s = settle_rigidly(qp);
        ASSERT_TRUE(s.balanced);
        std::vector<char> pressed;
        for (double l : s.multipliers) pressed.push_back(l > 0);
        if (const std::optional<VectorXd> found = settle_on(qp, pressed)) {
            EXPECT_LT((*found - s.amplitudes).norm(), 1e-9 * s.amplitudes.norm()) << trial;
            ++settled;
        }
        EXPECT_FALSE(settle_on(qp, std::vector<char>(pressed.size(), 0)).has_value());
    }
    EXPECT_GT(settled, 150);
}

/// A hundred blocks in a row between a wall and a force: soft as a whole, as far as any one of them is stiff, and held. Of
/// as many springs as there are blocks the last one moves so many times as far as the first.
TEST(RigidSettle, SettlesARowOfManyBodiesAtOnce) {
    constexpr Index n = 100;
    ContactQp qp;
    qp.compliance = MatrixXd::Identity(n, n);
    qp.modes = MatrixXd::Identity(n, n);
    for (Index k = 1; k < n; ++k) qp.modes(k, k - 1) = -1;
    qp.gap = qp.drawn_gap = VectorXd::Zero(n);
    qp.mode_load = VectorXd::Zero(n);
    qp.mode_load[n - 1] = -1;
    qp.unilateral.assign(n, 1);
    qp.foundation = VectorXd::Ones(n);
    qp.load_scale = 1;
    // the same bodies by motions of all of them
    const MatrixXd turned = MatrixXd::Identity(n, n) - 2.0 / n * MatrixXd::Ones(n, n);
    for (const bool of_all : {false, true}) {
        ContactQp by = qp;
        if (of_all) {
            by.modes = qp.modes * turned;
            by.mode_load = turned.transpose() * qp.mode_load;
        }
        const std::optional<VectorXd> found = settle_on(by, std::vector<char>(n, 1));
        ASSERT_TRUE(found.has_value());
        const VectorXd bodies = of_all ? VectorXd(turned * *found) : *found;
        for (Index k = 0; k < n; ++k) EXPECT_NEAR(bodies[k], -static_cast<double>(k + 1), 1e-9);
        const Settled settled = settle_rigidly(by);
        EXPECT_TRUE(settled.balanced);
        EXPECT_LT((settled.multipliers - VectorXd::Ones(n)).norm(), 1e-9);
    }
}

}  // namespace
}  // namespace abut::solver::rigid_settle_test
