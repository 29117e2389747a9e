// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/assembly_solve.hpp"

#include <gtest/gtest.h>

#include "solver/contact/assembly_rows.hpp"
#include "tests/solver/contact/two_blocks.hpp"

namespace abut::solver::assembly_solve_test {
namespace {

using Eigen::VectorXd;
using test::TwoBlocks;

Vec2 displacement(const AssemblyProblem& p, const AssemblySolution& s, std::size_t part, const Vec2& x) {
    const SplineSpace& space = p.parts[part].input.space;
    return displacement_at(space, s.displacement[part], space.cell_at(x), x).value;
}

Eigen::Vector3d stress(const AssemblyProblem& p, const AssemblySolution& s, std::size_t part, const Vec2& x) {
    const PartInput& input = p.parts[part].input;
    return stress_of(input.elasticity, displacement_at(input.space, s.displacement[part], input.space.cell_at(x), x).gradient);
}

/// Largest deviation of the contact pressures from `expected`.
double pressure_error(const AssemblySolution& s, double expected) {
    double worst = 0;
    for (const VectorXd& pressure : s.pressure) worst = std::max(worst, (pressure.array() - expected).abs().maxCoeff());
    return worst;
}

/// Contact loads equal and opposite, forces of every part in balance: the largest error, forces and moments.
double balance_error(const AssemblyProblem& p, const AssemblySolution& s) {
    Resultant contact;
    double worst = 0;
    const auto add = [](Resultant& sum, const Resultant& r) {
        sum.force += r.force;
        sum.moment += r.moment;
    };
    for (std::size_t i = 0; i < p.parts.size(); ++i) {
        add(contact, resultant_of(p.parts[i].input.space, s.contact_load[i]));
        Resultant part = resultant_of(p.parts[i].input.space, p.parts[i].applied);
        add(part, resultant_of(p.parts[i].input.space, s.contact_load[i]));
        for (const Resultant& r : support_reactions(p.parts[i], s.displacement[i], s.load[i])) add(part, r);
        worst = std::max({worst, part.force.norm(), std::abs(part.moment)});
    }
    return std::max({worst, 1e3 * contact.force.norm(), 1e3 * std::abs(contact.moment)});
}
/// Of loads of order 1: parts balance to 1e-9, contact loads are equal and opposite to 1e-12.
constexpr double balance_bound = 1e-9;

/// Two blocks whose uniform state is exact: over degrees, cut cells, thicknesses.
struct Pressed {
    int degree;
    double lower_overhang, upper_overhang, thickness, gap;
};
std::ostream& operator<<(std::ostream& out, const Pressed& c) {
    return out << "degree " << c.degree << ", overhangs " << c.lower_overhang << " " << c.upper_overhang << ", gap " << c.gap;
}

class PressedBlocks : public testing::TestWithParam<Pressed> {
protected:
    static TwoBlocks blocks() {
        const Pressed& c = GetParam();
        TwoBlocks b;
        b.degree = c.degree;
        b.lower.overhang = c.lower_overhang;
        b.upper.overhang = c.upper_overhang;
        b.lower.thickness = b.upper.thickness = c.thickness;
        b.upper.box.y0 += c.gap;
        b.upper.box.y1 += c.gap;
        b.gap = c.gap;
        return b;
    }
};

/// Bodies between two faces whose pressures have levers of one: they are made to balance where that takes a trifle of what
/// these are, or of the largest.
TEST(Balanced, ChangesPressuresByTrifles) {
    ContactQp qp;
    qp.modes = Eigen::MatrixXd(3, 0);
    const Eigen::MatrixXd levers = Eigen::Vector3d(0, 1, -1);
    const auto of = [&](double one, double other) { return balanced(qp, levers, Eigen::Vector3d(1, one, other)); };
    for (const auto& [one, other] : {std::pair{0.1, 0.1005}, std::pair{1e-8, 2e-8}}) {
        const std::optional<Eigen::VectorXd> forces = of(one, other);
        ASSERT_TRUE(forces) << one;
        EXPECT_EQ((*forces)[0], 1);
        EXPECT_NEAR((*forces)[1], (*forces)[2], 1e-14 * one);
        EXPECT_GT((*forces)[1], one);
        EXPECT_LT((*forces)[1], other);
    }
    EXPECT_FALSE(of(0.1, 0.2));
}

}  // namespace

TEST_P(PressedBlocks, CarryAUniformPressure) {
    const AssemblyProblem p = blocks().problem();
    const AssemblySolution s = solve_assembly(p);
    ASSERT_TRUE(s.mechanism.empty());
    EXPECT_TRUE(s.converged);
    EXPECT_EQ(s.n_multipliers, 4 + 2);
    EXPECT_LT(pressure_error(s, 1), 1e-10);
    EXPECT_GT(pressure_error(s, 1 + 1e-9), 1e-10);
    for (const Vec2& x : {Vec2(0.2, 0.3), Vec2(0.9, 0.9)}) {
        EXPECT_LT((stress(p, s, 0, x) - Eigen::Vector3d(0, -1, 0)).norm(), 1e-8);
        EXPECT_LT((stress(p, s, 1, x + Vec2(0, 1 + GetParam().gap)) - Eigen::Vector3d(0, -1, 0)).norm(), 1e-8);
    }
    EXPECT_LT(balance_error(p, s), balance_bound * GetParam().thickness);
}

TEST_P(PressedBlocks, CloseTheirGap) {
    const TwoBlocks b = blocks();
    const AssemblyProblem p = b.problem();
    const AssemblySolution s = solve_assembly(p);
    // the lower block shortens by 1/1000, the upper one's lower side follows through the gap
    for (double x : {0.05, 0.5, 0.95}) {
        EXPECT_NEAR(displacement(p, s, 0, {x, 1}).y(), -1e-3, 1e-10);
        EXPECT_NEAR(displacement(p, s, 1, {x, 1 + b.gap}).y(), -1e-3 - b.gap, 1e-10);
        EXPECT_NEAR(displacement(p, s, 1, {x, 2 + b.gap}).y(), -1e-3 - b.gap - 1 / 2500.0, 1e-10);
    }
}

TEST_P(PressedBlocks, ReportThatTheUpperOneMaySlide) {
    const AssemblyProblem p = blocks().problem();
    const AssemblySolution s = solve_assembly(p);
    ASSERT_EQ(s.neutral.size(), 1u);
    EXPECT_EQ(s.neutral[0].part, 1);
    const RigidMotion m = s.neutral[0].motion;
    EXPECT_NEAR(std::abs(m.translation.x()), 1, 1e-9);
    EXPECT_NEAR(m.translation.y(), 0, 1e-9);
    EXPECT_NEAR(m.rotation, 0, 1e-9);
    // the solution of least motion, in the mean over the part
    const Eigen::VectorXd mean = body_load(p.parts[1].input, [](const Vec2&) { return Vec2(1, 0); });
    const double size = mean.cwiseAbs().dot(s.displacement[1].cwiseAbs());
    EXPECT_GT(size, 1e-6);
    EXPECT_LT(std::abs(mean.dot(s.displacement[1])), 1e-9 * size);
}

INSTANTIATE_TEST_SUITE_P(All, PressedBlocks,
                         testing::Values(Pressed{1, 0, 0, 1, 0}, Pressed{2, 0, 0, 1, 0}, Pressed{3, 0, 0, 1, 0},
                                         Pressed{4, 0, 0, 1, 0}, Pressed{2, 0.5, 0.3, 1, 0}, Pressed{2, 0.99, 0.98, 2.5, 0},
                                         Pressed{3, 0.2, 0.9, 1, 0}, Pressed{2, 0, 0.4, 1, 1e-3}, Pressed{2, 0, 0, 1, 0.1}));

TEST(AssemblySolve, PushedSidewaysIsAMechanism) {
    TwoBlocks b;
    b.traction = {0.2, -1};
    const AssemblySolution s = solve_assembly(b.problem());
    ASSERT_EQ(s.mechanism.size(), 1u);
    EXPECT_EQ(s.mechanism[0].part, 1);
    const RigidMotion m = s.mechanism[0].motion;
    EXPECT_GT(m.translation.x(), 0);
    EXPECT_LT(std::abs(m.translation.y()), 1e-6 * m.translation.x());
    EXPECT_TRUE(s.displacement.empty());
}

TEST(AssemblySolve, PulledUpIsAMechanism) {
    TwoBlocks b;
    b.traction = {0, 1};
    const AssemblySolution s = solve_assembly(b.problem());
    ASSERT_EQ(s.mechanism.size(), 1u);
    EXPECT_EQ(s.mechanism[0].part, 1);
    EXPECT_GT(s.mechanism[0].motion.translation.y(), 0);
    EXPECT_TRUE(s.displacement.empty());
}

TEST(AssemblySolve, TippedOverTheEdgeIsAMechanism) {
    TwoBlocks b;
    b.upper.box.x1 = 2;
    b.upper.nx = 6;
    b.load_from = 1.4;
    b.load_to = 1.8;
    const AssemblySolution s = solve_assembly(b.problem());
    ASSERT_EQ(s.mechanism.size(), 1u);
    const RigidMotion m = s.mechanism[0].motion;
    EXPECT_LT(m.rotation, 0);  // clockwise
    EXPECT_LT(m.at({1.6, 2}).y(), 0);
    // no mean gap under a pressure function closes: the outermost ones' are those at a quarter of an interval from the ends
    for (double x : {0.0625, 0.5, 0.9375}) EXPECT_GT(m.at({x, 1}).y(), -1e-9);
    // the same load over the support is carried
    b.load_from = 0.4;
    b.load_to = 0.8;
    const AssemblyProblem p = b.problem();
    const AssemblySolution carried = solve_assembly(p);
    EXPECT_TRUE(carried.mechanism.empty());
    EXPECT_TRUE(carried.converged);
    EXPECT_LT(balance_error(p, carried), balance_bound);
}

TEST(AssemblySolve, ContactOpensWhereTheLoadDoesNotReach) {
    // eccentric by 0.3 of the width: the right end lifts off, and no pressure is negative
    TwoBlocks b;
    b.load_to = 0.4;
    b.n_intervals = 8;
    const AssemblyProblem p = b.problem();
    const AssemblySolution s = solve_assembly(p);
    ASSERT_TRUE(s.mechanism.empty());
    EXPECT_TRUE(s.converged);
    EXPECT_GE(s.pressure[0].minCoeff(), 0);
    EXPECT_EQ(s.pressure[0][9], 0);
    EXPECT_GT(s.pressure[0].maxCoeff(), 0.5);
    EXPECT_GT(displacement(p, s, 1, {1, 1}).y() - displacement(p, s, 0, {1, 1}).y(), 1e-5);
    EXPECT_LT(balance_error(p, s), balance_bound);
}

TEST(AssemblySolve, BalanceCheckSeesAWrongSolution) {
    const AssemblyProblem p = TwoBlocks().problem();
    AssemblySolution s = solve_assembly(p);
    EXPECT_LT(balance_error(p, s), balance_bound);
    const VectorXd good = s.contact_load[1];
    s.contact_load[1] *= 1 + 1e-11;
    EXPECT_GT(balance_error(p, s), balance_bound);
    s.contact_load[1] = good;
    s.displacement[0] *= 1 + 1e-8;
    EXPECT_GT(balance_error(p, s), balance_bound);
}

TEST(AssemblySolve, GapsThatStayOpenCarryNothing) {
    TwoBlocks b;
    b.gap = 0.5;
    b.upper.box = {0, 1.5, 1, 2.5};
    b.traction = {0, 0};
    const PartInput above = test::part_of(b.upper, b.degree);
    b.upper_supports = {test::side_support(above.space, GridSide::top, 1, -0.1),
                        test::side_support(above.space, GridSide::left, 0)};
    const AssemblyProblem p = b.problem();
    const AssemblySolution s = solve_assembly(p);
    EXPECT_TRUE(s.converged);
    EXPECT_TRUE(s.pressure[0].isZero(0));
    EXPECT_TRUE(s.neutral.empty());
    EXPECT_NEAR(displacement(p, s, 1, {0.5, 1.5}).y(), -0.1, 1e-12);
}

TEST(AssemblySolve, AWeakMeanConstraintHoldsTheBlockSideways) {
    // mean sideways displacement prescribed: no neutral motion left, its force balances the push
    TwoBlocks b;
    b.traction = {0.05, -1};
    AssemblyProblem p = b.problem();
    p.constraints.push_back({0, 1, {1, 0, 0}, 0.01, 1, std::sqrt(2), integrate_functions(p.parts[1].input)});
    const AssemblySolution s = solve_assembly(p);
    ASSERT_TRUE(s.mechanism.empty());
    EXPECT_TRUE(s.neutral.empty());
    EXPECT_TRUE(s.converged);
    ASSERT_EQ(s.constraint_force.size(), 1u);
    EXPECT_NEAR(s.constraint_force[0], -0.05, 1e-10);
    const FunctionIntegrals f = integrate_functions(p.parts[1].input);
    double mean = 0;
    for (int k = 0; k < p.parts[1].n(); ++k) mean += f.value[k] * s.displacement[1][2 * k];
    EXPECT_NEAR(mean, 0.01, 1e-11);
    EXPECT_NEAR(resultant_of(p.parts[0].input.space, s.contact_load[0]).force.y(), -1, 1e-11);
}

TEST(AssemblySolve, WithoutInterfacesEveryPartIsSolvedAlone) {
    const test::Block block{{0, 0, 2, 1}, 4, 3, 0, plane_stress(1000, 0.3), 1};
    const PartInput part = test::part_of(block, 2);
    AssemblyProblem p;
    p.parts.push_back(
        test::system_of(block, part, test::corner_rollers(part, block), test::top_load(part, block, 0.5, 1.5, {0.3, -1})));
    p.load_scale = 1;
    const AssemblySolution s = solve_assembly(p);
    EXPECT_TRUE(s.mechanism.empty());
    EXPECT_EQ(s.n_multipliers, 0);
    EXPECT_EQ(s.displacement[0], solve(p.parts[0], p.parts[0].load));
    EXPECT_TRUE(s.contact_load[0].isZero(0));
    EXPECT_LT(balance_error(p, s), balance_bound);
}

TEST(AssemblySolve, AFreePartWithoutLoadIsNeutralAndWithLoadAMechanism) {
    const test::Block block{{0, 0, 2, 1}, 4, 3, 0, plane_stress(1000, 0.3), 1};
    const PartInput part = test::part_of(block, 2);
    for (bool loaded : {false, true}) {
        AssemblyProblem p;
        p.parts.push_back(test::system_of(block, part, {}, test::top_load(part, block, 0, 2, {0, loaded ? -1.0 : 0.0})));
        p.load_scale = 2;
        const AssemblySolution s = solve_assembly(p);
        EXPECT_EQ(s.neutral.size(), loaded ? 0u : 3u);
        ASSERT_EQ(s.mechanism.size(), loaded ? 1u : 0u);
        if (loaded) {
            EXPECT_LT(s.mechanism[0].motion.at({1, 0.5}).y(), 0);
        } else {
            EXPECT_LT(s.displacement[0].norm(), 1e-14);
        }
    }
}

TEST(AssemblySolve, AFloatingBlockBetweenTwoMovedOnesIsPressedWithoutAnyLoad) {
    // a stack of three: the lowest on rollers, the highest moved down by 0.006, the one between floating; one stiffness
    const std::vector<test::Block> blocks{{{0, 0, 1, 1}, 4, 3, 0, plane_stress(1000, 0.3), 1},
                                          {{0, 1, 1, 2}, 3, 4, 0, plane_stress(1000, 0.3), 1},
                                          {{0, 2, 1, 3}, 5, 3, 0, plane_stress(1000, 0.3), 1}};
    AssemblyProblem p;
    for (std::size_t k = 0; k < 3; ++k) {
        const PartInput part = test::part_of(blocks[k], 2);
        std::vector<SupportSet> supports;
        if (k == 0) supports = test::corner_rollers(part, blocks[k]);
        if (k == 2)
            supports = {test::side_support(part.space, GridSide::top, 1, -0.006),
                        test::side_support(part.space, GridSide::left, 0)};
        p.parts.push_back(test::system_of(blocks[k], part, supports, VectorXd::Zero(2 * part.space.n_functions)));
    }
    for (int k = 0; k < 2; ++k)
        test::add_interface(p, test::horizontal_interface(p.parts, k, k + 1, 0, 1, k + 1, 4, [](double) { return 0.0; }));
    const AssemblySolution s = solve_assembly(p);
    ASSERT_TRUE(s.mechanism.empty());
    EXPECT_TRUE(s.converged);
    EXPECT_EQ(s.neutral.size(), 1u);
    EXPECT_LT(pressure_error(s, 2), 1e-9);  // 0.006 / 3 of 1000
    EXPECT_NEAR(displacement(p, s, 1, {0.5, 1.5}).y(), -0.003, 1e-11);
    EXPECT_LT(balance_error(p, s), balance_bound);
}

}  // namespace abut::solver::assembly_solve_test
