// SPDX-License-Identifier: GPL-3.0-or-later
// Parts around an axis: stiffness, the axis itself, rigid motions, stresses.
#include "solver/assembly/ring.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "solver/parts/hold_axis.hpp"
#include "solver/recovery/recovery.hpp"
#include "solver/terms/free_strain.hpp"
#include "solver/terms/solution_structure.hpp"
#include "solver/terms/stress.hpp"
#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::ring_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double E = 1000, nu = 0.3;

/// The part around the axis at x = `axis`: the radius goes into its rules' weights.
PartInput around(PartInput part, double axis, bool touches = false) {
    part.axis = axis;
    part.touches_axis = touches;
    part.thickness = 2 * std::numbers::pi;
    part.elasticity = plane_strain(E, nu);
    for (CellRule& rule : part.cut_rules)
        for (std::size_t k = 0; k < rule.points.size(); ++k) rule.weights[k] *= radius(part, rule.points[k]);
    return part;
}

SupportSet around(const PartInput& part, SupportSet set) {
    for (SupportPoint& p : set.points) p.weight *= radius(part, p.x);
    return set;
}

/// Twice the energy by the strains at Gauss points of high order.
double twice_energy(const PartInput& part, const std::vector<test::Box>& boxes, const VectorXd& u) {
    const Elasticity& d = part.elasticity;
    double twice = 0;
    test::for_points(part, boxes, 14, [&](int cell, const Vec2& x, double w) {
        const DisplacementAt at = displacement_at(part, u, cell, x);
        const double rr = at.gradient(0, 0), yy = at.gradient(1, 1), hh = at.value.x() / radius(part, x);
        const double ry = at.gradient(0, 1) + at.gradient(1, 0);
        twice += 2 * std::numbers::pi * radius(part, x) * w *
                 (d.d11 * (rr * rr + yy * yy + hh * hh) + 2 * d.d12 * (rr * yy + yy * hh + hh * rr) + d.d33 * ry * ry);
    });
    return twice;
}

VectorXd random_displacement(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    return VectorXd::NullaryExpr(n, [&] { return uniform(random); });
}

class Ring : public testing::TestWithParam<test::SpaceCase> {
protected:
    static PartInput ell_part(const test::SpaceCase& c) {
        const std::vector<double> x = test::grid_lines(-0.4, 1.7, 5, c.uniform), y = test::grid_lines(0.3, 1.9, 4, c.uniform);
        return around(test::part_of(test::ell_boxes(x, y), x, y, c.degree, c.basis, plane_strain(E, nu), 1, 12), -0.7);
    }
    PartInput part = ell_part(GetParam());
};

TEST_P(Ring, StiffnessHasTheEnergyOfTheStrainsAndTheHoops) {
    const BlockMatrix k = assemble_stiffness(part);
    for (unsigned seed : {1u, 2u, 3u}) {
        const VectorXd u = random_displacement(2 * part.space.n_functions, seed);
        const double exact = twice_energy(part, test::ell_boxes(part), u);
        EXPECT_NEAR(u.dot(multiply(k, u)), exact, 1e-10 * exact);
        EXPECT_NEAR(elastic_energy(part, u), 0.5 * exact, 1e-10 * exact);
    }
}

TEST_P(Ring, MovesFreelyAlongItsAxisAlone) {
    const BlockMatrix k = assemble_stiffness(part);
    const double scale = test::dense(k).cwiseAbs().maxCoeff();
    const VectorXd along = coefficients_of(part.space, {{0, 1}, 0, {0, 0}});
    EXPECT_LT(multiply(k, along).cwiseAbs().maxCoeff(), 1e-12 * scale);
    for (const RigidMotion& held : {RigidMotion{{1, 0}, 0, {0, 0}}, {{0, 0}, 1, {0.3, 0.8}}}) {
        const VectorXd u = coefficients_of(part.space, held);
        EXPECT_GT(u.dot(multiply(k, u)), 1e-3 * E) << "hoops stretch";
    }
    const PartSystem s = test::system_of(part, {}, VectorXd::Zero(2 * part.space.n_functions));
    ASSERT_EQ(s.failure, "");
    ASSERT_EQ(s.free_motions.size(), 1U);
    EXPECT_EQ(s.free_motions[0].translation, Vec2(0, 1));
    EXPECT_EQ(s.free_motions[0].rotation, 0);
}

INSTANTIATE_TEST_SUITE_P(Spaces, Ring, testing::ValuesIn(test::all_space_cases()),
                         [](const auto& c) { return test::name_of(c.param); });

/// u = (c r, d y) in a block that touches its axis, the outer sides prescribed by Nitsche's method or dropped functions.
struct Block {
    PartInput part;
    std::vector<SupportSet> supports;
    VectorXd exact;

    Block(int degree, bool projected, bool cut) {
        const double over = cut ? 0.07 : 0;
        const auto x = test::grid_lines(0, 1 + over, 4, true), y = test::grid_lines(-over, 1.3 + over, 5, false);
        part = around(test::part_of({{0, 0, 1, 1.3}}, x, y, degree, Basis::web, plane_strain(E, nu), 1, degree + 3), 0, true);
        if (projected) {
            part.elasticity = plane_strain(E, 0.4999);
            part.is_projected = true;
        }
        const SplineSpace& s = part.space;
        supports.push_back(
            around(part, test::support_on(s, {1, 0}, {1, 1.3}, {1, 0}, {1, 0}, [](const Vec2&) { return 2e-3; })));
        supports.push_back(around(part, test::support_on(s, {0, 0}, {1, 0}, {0, -1}, {0, 1})));
        supports.push_back(
            around(part, test::support_on(s, {0, 1.3}, {1, 1.3}, {0, 1}, {0, 1}, [](const Vec2&) { return -1.3e-3; })));
        exact = test::interleave(2e-3 * test::monomial(s, 1, 0), -1e-3 * test::monomial(s, 0, 1));
    }
};

TEST(RingAxis, UniformStrainIsExactUpToTheAxis) {
    for (int degree : {1, 2, 3})
        for (bool projected : {false, true})
            for (bool cut : {false, true}) {
                if (projected && degree == 1) continue;
                const Block b(degree, projected, cut);
                const PartSystem s = test::system_of(b.part, b.supports, VectorXd::Zero(2 * b.part.space.n_functions));
                ASSERT_EQ(s.failure, "");
                EXPECT_NE(s.axis_hold.find("dropped"), std::string::npos);
                EXPECT_TRUE(s.free_motions.empty());
                const VectorXd u = solve(s, s.load);
                EXPECT_LT(test::relative_difference(u, b.exact), 1e-8) << degree << projected << cut;
                const Elasticity d = s.input.elasticity;
                const double hoop = d.d11 * 2e-3 + d.d12 * (2e-3 - 1e-3);
                const StressField field = fit_stress(s.input, u, test::gauss(std::max(1, degree - 1)).points, {});
                for (const Vec2& x : {Vec2(0, 0.5), Vec2(1e-12, 0.5), Vec2(0.4, 0.9)}) {
                    const int cell = b.part.space.cell_at(x);
                    EXPECT_NEAR(StressOf(s.input, u).zz(cell, x), hoop, 1e-6 * hoop) << x.transpose();
                    if (cut) continue;
                    ASSERT_EQ(field.failure, "");
                    EXPECT_NEAR(stress_at(field, cell, x)[3], hoop, 1e-6 * hoop);
                }
            }
}

/// One row of cells whose first is filled too little to have functions of its own: those of the second reach the axis.
TEST(RingAxis, IsHeldByAPenaltyWhereFunctionsCannotBeDropped) {
    const std::vector<double> x{0, 1, 2, 3}, y{0, 1};
    for (int degree : {1, 2, 3}) {
        PartInput part = around(
            test::part_of({{0, 0.4, 1, 0.6}, {1, 0, 3, 1}}, x, y, degree, Basis::web, plane_strain(E, nu), 1, degree + 3), 0,
            true);
        const auto stretched = [](const Vec2& p) { return 1e-3 * p.x(); };
        const std::vector<SupportSet> supports{
            around(part, test::support_on(part.space, {1, 0}, {1, 0.4}, {-1, 0}, {1, 0}, stretched)),
            around(part, test::support_on(part.space, {1, 0.6}, {1, 1}, {-1, 0}, {1, 0}, stretched)),
            around(part, test::support_on(part.space, {3, 0}, {3, 1}, {1, 0}, {1, 0}, stretched)),
            around(part, test::support_on(part.space, {1, 0}, {3, 0}, {0, -1}, {0, 1}))};
        const PartSystem s = test::system_of(part, supports, VectorXd::Zero(2 * part.space.n_functions));
        ASSERT_EQ(s.failure, "");
        EXPECT_NE(s.axis_hold.find("penalty"), std::string::npos);
        const VectorXd u = solve(s, s.load);
        const double at_axis = displacement_at(s.input, u, 0, {0, 0.5}).value.x();
        EXPECT_LT(std::abs(at_axis), 1e-10) << "uniform strain meets the penalty exactly";
        EXPECT_NEAR(displacement_at(s.input, u, 1, {1.5, 0.5}).value.x(), 1.5e-3, 1e-9);
        EXPECT_NEAR(displacement_at(s.input, u, 1, {1.5, 0.5}).value.y(), -0.5 * 2 * nu / (1 - nu) * 1e-3, 1e-9);
    }
}

TEST(RingAxis, DoesNotMoveSideways) {
    Block b(2, false, false);
    b.supports.push_back(test::side_support(b.part.space, GridSide::left, 0, 0.1));
    const PartSystem s = test::system_of(b.part, b.supports, VectorXd::Zero(2 * b.part.space.n_functions));
    EXPECT_NE(s.failure.find("axis"), std::string::npos);
}

}  // namespace
}  // namespace abut::solver::ring_test
