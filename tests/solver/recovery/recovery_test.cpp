// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/recovery/recovery.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::recovery_test {
namespace {

using Eigen::VectorXd;
using test::SpaceCase;

std::vector<SamplePoint> cut_samples(const PartInput& part) {
    std::vector<SamplePoint> samples;
    test::for_points(part, test::ell_boxes(part), 3, [&](int cell, const Vec2& x, double) {
        if (part.space.fraction[static_cast<std::size_t>(cell)] < 1) samples.push_back({cell, x});
    });
    return samples;
}

/// Largest difference between the fitted and the displacement's own stresses over the part, relative to the largest stress.
double fit_error(const PartInput& part, const VectorXd& u, double perturbation = 0) {
    StressField field = fit_stress(part, u, test::gauss(part.space.x.degree).points, cut_samples(part));
    if (!field.failure.empty()) return 1e300;
    field.coefficients *= 1 + perturbation;
    double worst = 0, largest = 0;
    test::for_points(part, test::ell_boxes(part), 2, [&](int cell, const Vec2& x, double) {
        const Eigen::Vector3d exact = stress_of(part.elasticity, displacement_at(part.space, u, cell, x).gradient);
        const Eigen::Vector4d fitted = stress_at(field, cell, x);
        Eigen::Vector4d expected;
        expected << exact, part.elasticity.out_of_plane * (exact[0] + exact[1]);
        worst = std::max(worst, (fitted - expected).cwiseAbs().maxCoeff());
        largest = std::max(largest, expected.cwiseAbs().maxCoeff());
    });
    return worst / largest;
}

class Recovery : public testing::TestWithParam<SpaceCase> {
protected:
    PartInput part = test::ell(GetParam(), plane_strain(1000, 0.3));
};

constexpr double bound = 1e-8;  // normal equations of degree 3 on slivers: condition 1e5, squared coefficients of the extension

}  // namespace

TEST_P(Recovery, ReproducesAConstantStress) {
    const VectorXd x = test::monomial(part.space, 1, 0), y = test::monomial(part.space, 0, 1);
    const VectorXd u = test::interleave(0.01 * x + 0.02 * y, -0.03 * y + 0.005 * x);
    EXPECT_LT(fit_error(part, u), bound);
    EXPECT_GT(fit_error(part, u, 1e-7), bound);
}

TEST_P(Recovery, IsTheSameWithWhatAnotherFitHasLeft) {
    const Once<StressFitFactor> common;
    for (double scale : {1.0, -3.0}) {
        const VectorXd x = test::monomial(part.space, GetParam().degree, 0), y = test::monomial(part.space, 0, 1);
        const VectorXd u = test::interleave(scale * x + 0.02 * y, -0.03 * y + 0.005 * x);
        const std::vector<double> inside = test::gauss(part.space.x.degree).points;
        const StressField shared = fit_stress(part, u, inside, cut_samples(part), &common),
                          alone = fit_stress(part, u, inside, cut_samples(part));
        EXPECT_EQ(shared.space, common([]() -> StressFitFactor { throw std::logic_error("made twice"); }).space);
        EXPECT_EQ(shared.failure, alone.failure);
        EXPECT_EQ(shared.coefficients, alone.coefficients) << scale;
    }
}

TEST_P(Recovery, ReproducesStressesOfOneDegreeLess) {
    // displacements of total degree p have stresses of total degree p - 1
    const int p = GetParam().degree;
    for (int a = 0; a <= p; ++a) {
        const VectorXd u = test::interleave(test::monomial(part.space, a, p - a), -0.7 * test::monomial(part.space, p - a, a));
        EXPECT_LT(fit_error(part, u), bound) << "x^" << a;
    }
}

TEST_P(Recovery, UsesTheSplineOfOneDegreeLessAndTheSameForLowDegrees) {
    const StressField field =
        fit_stress(part, VectorXd::Zero(2 * part.space.n_functions), test::gauss(GetParam().degree).points, cut_samples(part));
    EXPECT_EQ(field.failure, "");
    const int p = GetParam().degree;
    EXPECT_EQ(field.space->x.degree, p <= 2 ? p : p - 1);
    EXPECT_EQ(field.space->x.breakpoints, part.space.x.breakpoints);
    EXPECT_EQ(field.coefficients.rows(), field.space->n_functions);
    EXPECT_TRUE(field.coefficients.isZero(0));
    EXPECT_EQ(field.out_of_plane, 0.3);
}

INSTANTIATE_TEST_SUITE_P(All, Recovery, testing::ValuesIn(test::all_space_cases()),
                         [](const auto& given) { return test::name_of(given.param); });

/// Error inside and at the boundary of the stress of a displacement sin(2x) that is interpolated as a solution would be: with
/// derivatives that are best at the Gauss points.
double sine_error(int degree, int cells) {
    const PartInput part = test::rectangle(1, 1, cells, cells, degree);
    const double h = 1.0 / cells;
    VectorXd c(part.space.n_functions);
    for (int f = 0; f < part.space.n_functions; ++f) {
        const double x = greville_point(part.space, f).x();
        // the quadratic quasi-interpolant f - h^2 f'' / 8, whose second differences are right to fourth order
        c[f] = std::sin(2 * x) + h * h / 8 * 4 * std::sin(2 * x);
    }
    const StressField field = fit_stress(part, test::interleave(c, VectorXd::Zero(c.size())), test::gauss(degree).points, {});
    double worst = 0;
    for (double x = 0.3; x < 0.7; x += 0.0137) {
        const Vec2 at(x, 0.41);
        const double exact = part.elasticity.d11 * 2 * std::cos(2 * x);
        worst = std::max(worst, std::abs(stress_at(field, part.space.cell_at(at), at)[0] - exact) / part.elasticity.d11);
    }
    return worst;
}

/// The stresses of the displacement itself converge like h^2, those at its Gauss points like h^3 and better.
TEST(StressFit, KeepsTheOrderOfTheGaussPoints) {
    const double rate = std::log2(sine_error(2, 8) / sine_error(2, 16));
    EXPECT_GT(sine_error(2, 8), 1e-7) << "nothing to measure";
    EXPECT_GT(rate, 2.7);
}

/// One cell, where the Gauss points alone would not tell a quadratic stress.
TEST(StressFit, IsUniqueInASingleCell) {
    for (int degree : {1, 2, 3}) {
        const PartInput part = test::rectangle(1, 1, 1, 1, degree);
        const StressField field = fit_stress(part, VectorXd::Zero(2 * part.space.n_functions), test::gauss(degree).points, {});
        EXPECT_EQ(field.failure, "") << degree;
    }
}

TEST(StressFit, FailsWithoutAnInnerCell) {
    const PartInput part = test::part_of({{0, 0, 3, 0.2}}, {0, 1, 2, 3}, {0, 1, 2}, 2, Basis::plain);
    EXPECT_NE(fit_stress(part, VectorXd::Zero(2 * part.space.n_functions), test::gauss(2).points, {{0, {0.5, 0.1}}}).failure,
              "");
}

}  // namespace abut::solver::recovery_test
