// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/finite_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::finite_motion_test {
namespace {

using Eigen::Matrix2d;
using Eigen::VectorXd;

const Elasticity law = plane_stress(1000, 0.3);
constexpr double thickness = 0.8;

PartInput part() {
    return test::ell({2, true, Basis::web}, law, thickness);
}

/// The coefficients of the displacement G x: two rigid motions and their kin, of which all splines hold any.
VectorXd linear(const PartInput& input, const Matrix2d& G) {
    const VectorXd turned = coefficients_of(input.space, RigidMotion{{0, 0}, 1, {0, 0}});  // (-y, x)
    VectorXd u(turned.size());
    for (Eigen::Index f = 0; f + 1 < u.size(); f += 2) u.segment<2>(f) = G * Eigen::Vector2d(turned[f + 1], -turned[f]);
    return u;
}

Matrix2d stress(const Matrix2d& strain) {
    const Eigen::Vector3d s = stress_of(law, strain);
    Matrix2d m;
    m << s[0], s[2], s[2], s[1];
    return m;
}

double volume(const PartInput& input) {
    return integrate_functions(input).value.sum() * input.thickness;
}

/// The energy of the Green-Lagrange strain of a gradient, per volume.
double green_energy(const Matrix2d& G) {
    const Matrix2d strain = 0.5 * (G + G.transpose() + G.transpose() * G);
    return 0.5 * stress(strain).cwiseProduct(strain).sum();
}

Matrix2d gradient(double a, double b, double c, double d) {
    Matrix2d G;
    G << a, b, c, d;
    return G;
}

TEST(FiniteMotion, IsTheSecondOrderOfTheEnergysDerivative) {
    const PartInput input = part();
    const Matrix2d G = gradient(0.03, -0.05, 0.08, 0.01), H = gradient(-0.2, 0.7, 0.4, 0.9);
    const double small = 1e-2, step = 1e-4;
    const auto derivative = [&](const Matrix2d& at) {
        return (green_energy(at + step * H) - green_energy(at - step * H)) / (2 * step);
    };
    // the even part of the derivative: the cubes are odd; less what the difference's step makes of H alone
    const double even = 0.5 * (derivative(small * G) + derivative(-small * G)) - derivative(0 * G),
                 second = even / (small * small) * volume(input);
    EXPECT_NEAR(finite_motion_load(input, linear(input, G)).dot(linear(input, H)), -second, 1e-5 * std::abs(second));
}

TEST(FiniteMotion, TurnsAPartWithoutStress) {
    // what finite_motion_load answers to takes back by what a rotation taken for a displacement makes a part larger
    const PartInput input = part();
    const double angle = 0.02;
    const VectorXd turned = linear(input, gradient(0, -angle, angle, 0)),
                   shrink = linear(input, -0.5 * angle * angle * Matrix2d::Identity());
    const PartSystem system = test::system_of(input, {}, VectorXd::Zero(2 * input.space.n_functions));
    const VectorXd load = finite_motion_load(input, turned);
    EXPECT_LT((stiffness_times(system, shrink) - load).norm(), 1e-9 * load.norm());
    EXPECT_NEAR(stretching_work(input, turned, shrink), 0, 1e-12 * volume(input) * 1000 * std::pow(angle, 4));
}

TEST(FiniteMotion, WorksOfUniformGradients) {
    const PartInput input = part();
    const Matrix2d G = gradient(0.03, -0.05, 0.08, 0.01), added = gradient(-0.2, 0.7, 0.4, 0.9);
    const VectorXd u = linear(input, G);
    EXPECT_LT((stress_integral(input, u) - volume(input) * stress(0.5 * (G + G.transpose()))).norm(),
              1e-9 * volume(input) * 1000);
    const Matrix2d tension = stress(0.5 * G.transpose() * G) + stress(0.5 * (added + added.transpose()));
    const double work = (G * tension * G.transpose()).trace() * volume(input);
    EXPECT_NEAR(stretching_work(input, u, linear(input, added)), work, 1e-9 * std::abs(work));
}

/// Sharp corners have strains of any size: what a displacement leaves out there would move the corner by far more than the
/// part. What all of a part is strained by stays, however large.
TEST(FiniteMotion, LeavesOutStrainsOfCorners) {
    const PartInput input = test::rectangle(1, 1, 30, 30, 2);
    const VectorXd even = linear(input, gradient(0.3, 0.5, -0.5, 0.3));
    EXPECT_GT(finite_motion_load(input, even).norm(), 0);
    VectorXd peaked = VectorXd::Zero(even.size());
    for (const double displacement : {1e-3, 1.0, 1e3}) {  // cells are of a thirtieth
        peaked[0] = displacement;
        const double load = finite_motion_load(input, peaked).norm() / (input.elasticity.d11 * displacement * displacement);
        if (displacement < 1.0 / 30)
            EXPECT_GT(load, 1e-3) << displacement;
        else
            EXPECT_LT(load, 1e-3) << displacement;
    }
}

}  // namespace
}  // namespace abut::solver::finite_motion_test
