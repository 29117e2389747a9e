// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/free_strain.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "solver/recovery/recovery.hpp"
#include "solver/terms/stress.hpp"
#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::free_strain_test {
namespace {

using Eigen::VectorXd;

constexpr double E = 1000, strain = 1e-3;

struct Law {
    const char* name;
    Elasticity elasticity;
    double in_plane;  ///< strain of a free part in the plane, over the free strain
    double zz;        ///< stress across it, restrained there alone, over E times strain
    bool is_projected;
};
const Law laws[] = {{"plane_stress", plane_stress(E, 0.3), 1, 0, false},
                    {"plane_strain", plane_strain(E, 0.3), 1.3, -1, false},
                    {"no_poisson", plane_strain(E, 0), 1, -1, false},
                    {"incompressible", plane_strain(E, 0.4999), 1.4999, -1, true}};

class FreeStrain : public testing::TestWithParam<std::tuple<int, int, int>> {
protected:
    const Law& law = laws[static_cast<std::size_t>(std::get<0>(GetParam()))];
    PartInput part = test::ell({std::get<1>(GetParam()), std::get<2>(GetParam()) == 1, Basis::web}, law.elasticity, 0.8);
    void SetUp() override {
        part.is_projected = law.is_projected;
        part.free_strain = [](const Vec2&) { return strain; };
    }
    double tolerance() const { return law.is_projected ? 1e-6 : 1e-9; }
};

TEST_P(FreeStrain, LoadsNoRigidMotion) {
    const VectorXd load = free_strain_load(part);
    for (const RigidMotion& motion : {RigidMotion{{1, 0}, 0, {0, 0}}, {{0, 1}, 0, {0, 0}}, {{0, 0}, 1, {0.3, 0.8}}})
        EXPECT_NEAR(load.dot(coefficients_of(part.space, motion)), 0, 1e-12 * load.cwiseAbs().sum());
    EXPECT_GT(load.cwiseAbs().sum(), 0);
}

TEST_P(FreeStrain, LeavesAFreePartWithoutStressInThePlane) {
    const PartSystem s = test::system_of(part, {}, VectorXd::Zero(2 * part.space.n_functions));
    ASSERT_EQ(s.failure, "");
    const VectorXd u = solve(s, s.load);
    const StressOf stress(s.input, u);
    for (const CellRule& rule : part.cut_rules) {
        const Vec2& x = rule.points.front();
        EXPECT_LT(stress(rule.element, x).norm(), tolerance() * E * strain);
        const Eigen::Matrix2d g = displacement_at(part, u, rule.element, x).gradient;
        EXPECT_NEAR(g(0, 0), law.in_plane * strain, tolerance() * strain);
        EXPECT_NEAR(g(1, 1), law.in_plane * strain, tolerance() * strain);
        if (law.elasticity.expansion_zz == 0) continue;
        EXPECT_NEAR(stress.zz(rule.element, x), law.zz * E * strain, tolerance() * E * strain);
    }
    const double area = test::ell_boxes(part)[0].area() + test::ell_boxes(part)[1].area();
    const double energy = 0.5 * law.zz * law.zz * E * strain * strain * area * part.thickness;
    EXPECT_NEAR(strain_energy(s, u), energy, tolerance() * E * strain * strain);
}

/// An uneven free strain: the load's work on a displacement is that of the stresses that are taken off.
TEST_P(FreeStrain, StressAndLoadAgree) {
    part.free_strain = [](const Vec2& x) { return strain * (1 + x.x() - 0.5 * x.y() * x.x()); };
    if (law.is_projected) return;  // its volume strain is projected: tested by the free and the held part
    const VectorXd load = free_strain_load(part), zero = VectorXd::Zero(2 * part.space.n_functions);
    const StressOf stress(part, zero);
    // work of the stresses at no displacement on the strains of v = (x^2 / 2, x y)
    const VectorXd v = test::interleave(0.5 * test::monomial(part.space, 2, 0), test::monomial(part.space, 1, 1));
    double work = 0;
    test::for_points(part, test::ell_boxes(part), 6, [&](int cell, const Vec2& x, double w) {
        const Eigen::Vector3d s = stress(cell, x);
        work += part.thickness * w * (s[0] * x.x() + s[1] * x.x() + s[2] * x.y());
    });
    EXPECT_NEAR(load.dot(v), -work, 1e-11 * std::abs(work));
}

std::string name_of(const testing::TestParamInfo<std::tuple<int, int, int>>& info) {
    return std::string(laws[static_cast<std::size_t>(std::get<0>(info.param))].name) + "_degree" +
           std::to_string(std::get<1>(info.param)) + (std::get<2>(info.param) == 1 ? "_uniform" : "_graded");
}
INSTANTIATE_TEST_SUITE_P(Laws, FreeStrain,
                         testing::Combine(testing::Values(0, 1, 2, 3), testing::Values(2, 3), testing::Values(0, 1)), name_of);

TEST(NoFreeStrain, LeavesEveryBitAsItIs) {
    PartInput part = test::ell({2, false, Basis::web});
    const PartSystem without = test::system_of(part, {}, VectorXd::Zero(2 * part.space.n_functions));
    part.free_strain = [](const Vec2&) { return strain; };
    const PartSystem with = test::system_of(part, {}, VectorXd::Zero(2 * part.space.n_functions));
    EXPECT_TRUE(without.load.isZero(0));
    EXPECT_FALSE(with.load.isZero(0));
    for (std::size_t k = 0; k < without.stiffness.block.size(); ++k)
        EXPECT_EQ(without.stiffness.block[k], with.stiffness.block[k]) << "the stiffness knows no temperature";
}

}  // namespace
}  // namespace abut::solver::free_strain_test
