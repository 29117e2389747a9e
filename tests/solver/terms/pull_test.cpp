// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/pull.hpp"

#include <gtest/gtest.h>

#include "solver/terms/stress.hpp"
#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::pull_test {
namespace {

using Eigen::VectorXd;

constexpr double E = 1000, delta = 1e-3;

/// An L whose part beyond a place along x is drawn back by a unit.
struct Pulled : testing::TestWithParam<int> {
    PartInput part = test::ell({GetParam(), false, Basis::web}, plane_stress(E, 0.3), 0.8);
    double cut = 0.5 * (part.space.x.breakpoints.front() + part.space.x.breakpoints.back());
    void SetUp() override {
        VectorXd pull = VectorXd::Zero(2 * part.space.n_functions);
        for (int f = 0; f < part.space.n_functions; ++f)
            if (greville_point(part.space, f).x() > cut) pull[2 * f] = -1;
        part.pulls = {pull};
    }
    PartSystem shortened(double by) const {
        PartSystem s = test::system_of(part, {}, VectorXd::Zero(2 * part.space.n_functions));
        set_shortening(s, VectorXd::Constant(1, by));
        return s;
    }
};

/// A free part follows: its far side comes nearer by the shortening, without any stress. (At higher degrees the step from side
/// to side is as wide as this part.)
TEST_P(Pulled, FreePartIsShortenedWithoutStress) {
    const PartSystem s = shortened(delta);
    ASSERT_EQ(s.failure, "");
    const VectorXd u = solve(s, s.load);
    const StressOf stress(s.input, u);
    for (const CellRule& rule : part.cut_rules) EXPECT_LT(stress(rule.element, rule.points.front()).norm(), 1e-9 * E * delta);
    EXPECT_NEAR(force_across(s.pulls[0], u), 0, 1e-10 * s.pulls[0].stiffness * delta);
    EXPECT_NEAR(strain_energy(s, u), 0, 1e-10 * s.pulls[0].stiffness * delta * delta);
    const auto moved = [&](double x, double y) {
        const int cell = part.space.cell_at({x, y});
        return displacement_at(part, u, cell, {x, y}).value.x();
    };
    const double x0 = part.space.x.breakpoints.front(), x1 = part.space.x.breakpoints.back(),
                 y = part.space.y.breakpoints.front();
    const double near_x0 = moved(x0 + 1e-3, y + 1e-3), near_x1 = moved(x1 - 1e-3, y + 1e-3);
    EXPECT_NEAR(near_x0 - near_x1, delta, 1e-9 * delta);
}

/// What is taken back leaves the part as it was.
TEST_P(Pulled, ShorteningReplacesTheOneBefore) {
    PartSystem s = shortened(delta);
    set_shortening(s, VectorXd::Constant(1, 3 * delta));
    EXPECT_LT((s.load - shortened(3 * delta).load).norm(), 1e-12 * s.load.norm());
    set_shortening(s, VectorXd::Zero(1));
    EXPECT_LT(s.load.norm(), 1e-12 * shortened(delta).load.norm());
    EXPECT_TRUE(s.input.stress_free.isZero(0));
}

INSTANTIATE_TEST_SUITE_P(Degrees, Pulled, testing::Values(1, 2));

}  // namespace
}  // namespace abut::solver::pull_test
