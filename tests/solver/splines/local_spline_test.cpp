// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/splines/local_spline.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::local_spline_test {
namespace {

/// Against the sum over the space's functions themselves, at points of every element that holds material.
void expect_sums(const PartInput& part) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Eigen::Matrix3Xd c(3, part.space.n_functions);
    for (double& v : c.reshaped()) v = uniform(random);
    int n = 0;
    test::for_points(part, test::ell_boxes(part), 2, [&](int element, const Vec2& x, double) {
        const LocalSpline<3> local(part.space, element, [&](int f) { return c.col(f); });
        const PointBasis b = evaluate(part.space, element, x);
        Eigen::Vector3d value = Eigen::Vector3d::Zero(), dx = value, dy = value;
        for (std::size_t i = 0; i < b.functions.size(); ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            value += b.value[k] * c.col(b.functions[i]);
            dx += b.dx[k] * c.col(b.functions[i]);
            dy += b.dy[k] * c.col(b.functions[i]);
        }
        const SplineAt<3> at = local.at(x);
        // extended functions of slivers have large coefficients, and their sums the rounding of those
        const double rounding = 1e-12 * (1 + b.value.cwiseAbs().sum()),
                     slope = 1e-12 * (b.dx.cwiseAbs() + b.dy.cwiseAbs()).sum();
        EXPECT_LT((at.value - value).norm(), rounding);
        EXPECT_LT((local.value(x) - value).norm(), rounding);
        EXPECT_LT((at.gradient.col(0) - dx).norm(), slope);
        EXPECT_LT((at.gradient.col(1) - dy).norm(), slope);
        ++n;
    });
    EXPECT_GT(n, 20);
}

class LocalSplines : public testing::TestWithParam<test::SpaceCase> {};

TEST_P(LocalSplines, SumTheFunctionsOfTheSpace) {
    expect_sums(test::ell(GetParam(), plane_strain(1000, 0.3)));
}

INSTANTIATE_TEST_SUITE_P(All, LocalSplines, testing::ValuesIn(test::all_space_cases()),
                         [](const auto& given) { return test::name_of(given.param); });

}  // namespace
}  // namespace abut::solver::local_spline_test
