// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid bodies: what conditions hold, what they leave free, what they exert.
#include "solver/parts/rigid_body.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

namespace abut::solver::rigid_body_test {
namespace {

/// A unit square of four bilinear functions about its centre.
PartSystem square(std::vector<MotionCondition> conditions, const Eigen::VectorXd& load = Eigen::VectorXd::Zero(8)) {
    PartInput input;
    input.space = make_space({-0.5, 0.5}, {-0.5, 0.5}, 1, 1, {1.0}, Basis::plain);
    return make_rigid_system(std::move(input), std::move(conditions), load, {0, 0}, 2.0);
}

TEST(RigidBody, OfNoConditionIsFree) {
    const PartSystem s = square({});
    EXPECT_EQ(s.free_motions.size(), 3U);
    EXPECT_EQ(s.n_kept, 0);
    EXPECT_TRUE(s.prescribed.isZero(0));
    EXPECT_EQ(s.modes.fullPivLu().rank(), 3);
}

TEST(RigidBody, LosesAMotionByEachIndependentCondition) {
    const auto at = [](double x, double y, double dx, double dy) { return held_point(0, {x, y}, {0, 0}, {dx, dy}, 0, 1); };
    EXPECT_EQ(square({at(0.5, 0.5, 0, 1)}).free_motions.size(), 2U);
    EXPECT_EQ(square({at(0.5, 0.5, 0, 1), at(0.5, -0.5, 0, 1)}).free_motions.size(), 2U);  // along one line
    EXPECT_EQ(square({at(0.5, 0.5, 0, 1), at(-0.5, 0.5, 0, 1)}).free_motions.size(), 1U);
    EXPECT_EQ(square({at(0.5, 0.5, 0, 1), at(-0.5, 0.5, 0, 1), at(0, 0, 1, 0)}).free_motions.size(), 0U);
    EXPECT_EQ(square({at(0, 0, 0, 1), at(0, 0, 1, 0), at(0, 0, 1, 1)}).free_motions.size(), 1U);  // through one point
}

TEST(RigidBody, TakesAnyPrescribedMotion) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int k = 0; k < 50; ++k) {
        const RigidMotion motion{{any(random), any(random)}, any(random), {0, 0}};
        std::vector<MotionCondition> conditions;
        for (int i = 0; i < 6; ++i) {
            const Vec2 x(any(random), any(random)), d = Vec2(any(random), any(random)).normalized();
            conditions.push_back(held_point(i, x, {0, 0}, d, d.dot(motion.at(x)), 1.1 + any(random)));
        }
        const PartSystem s = square(conditions);
        ASSERT_TRUE(s.free_motions.empty());
        EXPECT_TRUE(is_consistent(*s.body));
        const Eigen::VectorXd expected = coefficients_of(s.input.space, motion);
        EXPECT_LT((s.prescribed - expected).norm(), 1e-9 * expected.norm());
        conditions[3].value += 0.01;
        EXPECT_FALSE(is_consistent(*square(conditions).body));
    }
}

TEST(RigidBody, ItsSupportsBalanceWhatActsInWhatTheyHold) {
    Eigen::VectorXd load(8);
    load << 1, 2, -3, 4, 0.5, -6, 7, 1;
    const auto at = [](int tag, double x, double y, double dx, double dy) {
        return held_point(tag, {x, y}, {0, 0}, {dx, dy}, 0, 1);
    };
    const PartSystem s = square({at(0, -0.5, -0.5, 1, 0), at(0, -0.5, -0.5, 0, 1), at(1, 0.5, -0.5, 0, 1)}, load);
    const Resultant applied = resultant_of(s.input.space, load);
    const auto reactions = rigid_reactions(s, load);
    ASSERT_EQ(reactions.size(), 2U);
    EXPECT_LT((reactions[0].force.force + reactions[1].force.force + applied.force).norm(), 1e-12);
    EXPECT_NEAR(reactions[0].force.moment + reactions[1].force.moment + applied.moment, 0, 1e-12);
    EXPECT_NEAR(reactions[1].force.force.x(), 0, 1e-14);  // a roller
    EXPECT_EQ(strain_energy(s, s.prescribed), 0);
}

}  // namespace
}  // namespace abut::solver::rigid_body_test
