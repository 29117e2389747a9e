// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/dilatation.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>

#include "solver/recovery/recovery.hpp"
#include "solver/terms/stress.hpp"
#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::dilatation_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double E = 1000, nu = 0.4999, strain = 0.01, thickness = 0.8;

/// A bar of 2 by 1, pulled along x, in plane strain; its grid overhangs it so that sides cut cells, or fits it.
struct PulledBar {
    PartInput part;
    std::vector<SupportSet> supports;
    VectorXd exact;
    double stress = E / (1 - nu * nu) * strain;

    PulledBar(int degree, bool uniform, Basis basis, double overhang) {
        const auto x = test::grid_lines(-overhang, 2 + overhang, 8, uniform),
                   y = test::grid_lines(-overhang, 1 + overhang, 5, uniform);
        part = test::part_of({{0, 0, 2, 1}}, x, y, degree, basis, plane_strain(E, nu), thickness);
        part.is_projected = true;
        const SplineSpace& s = part.space;
        if (overhang > 0) {
            supports.push_back(test::support_on(s, {0, 0}, {0, 1}, {-1, 0}, {1, 0}));
            supports.push_back(test::support_on(s, {2, 0}, {2, 1}, {1, 0}, {1, 0}, [](const Vec2&) { return 2 * strain; }));
            supports.push_back(test::support_on(s, {0, 0}, {2, 0}, {0, -1}, {0, 1}));
        } else {
            supports = {test::side_support(s, GridSide::left, 0), test::side_support(s, GridSide::right, 0, 2 * strain),
                        test::side_support(s, GridSide::bottom, 1)};
        }
        exact = test::interleave(strain * test::monomial(s, 1, 0), -nu / (1 - nu) * strain * test::monomial(s, 0, 1));
    }
};

class ProjectedDilatation : public testing::TestWithParam<std::tuple<int, bool, double>> {
protected:
    PulledBar bar{std::get<0>(GetParam()), std::get<1>(GetParam()), Basis::web, std::get<2>(GetParam())};
};

/// Rounding grows with the condition number (1e5 to 1e8 here, of degree 6 with slivers 1e11); that of stresses with lambda over
/// mu, 5e3, the terms of the sums, a few hundred, and the coefficients of extended functions, up to 1e3: 1e-6. (Measured 1e-7;
/// a term left out is seen from 1e-3 on.)
double rounding_of(const PartSystem& s) {
    return 1e-6 + 100 * std::numeric_limits<double>::epsilon() * s.factor.condition_estimate();
}

TEST_P(ProjectedDilatation, PassesThePatchTest) {
    const PartSystem s = test::system_of(bar.part, bar.supports, VectorXd::Zero(2 * bar.part.space.n_functions));
    ASSERT_EQ(s.failure, "");
    const double rounding = rounding_of(s);
    const VectorXd u = solve(s, s.load);
    EXPECT_LT(test::relative_difference(u, bar.exact), rounding);
    const StressOf stress(s.input, u);
    const Eigen::Vector3d pulled(bar.stress, 0, 0);
    for (const CellRule& rule : s.input.cut_rules)
        EXPECT_LT((stress(rule.element, rule.points[0]) - pulled).norm(), rounding * bar.stress);
    const StressField field = fit_stress(s.input, u, test::gauss(3).points, {});
    ASSERT_EQ(field.failure, "");
    for (int element = 0; element < s.input.space.n_cells(); ++element)
        if (s.input.space.fraction[static_cast<std::size_t>(element)] == 1) {
            const Vec2 x(s.input.space.x.breakpoints[static_cast<std::size_t>(s.input.space.column_of(element))],
                         s.input.space.y.breakpoints[static_cast<std::size_t>(s.input.space.row_of(element))]);
            const Eigen::Vector4d t = stress_at(field, element, x);
            EXPECT_LT((t.head<3>() - pulled).norm(), rounding * bar.stress);
            EXPECT_NEAR(t[3], nu * bar.stress, rounding * bar.stress);
        }
    const std::vector<Resultant> reactions = support_reactions(s, u, s.load);
    EXPECT_NEAR(reactions[0].force.x(), -thickness * bar.stress, rounding * bar.stress);
    EXPECT_NEAR(reactions[1].force.x(), thickness * bar.stress, rounding * bar.stress);
    EXPECT_NEAR(reactions[2].force.y(), 0, rounding * bar.stress);
    EXPECT_NEAR(strain_energy(s, u), thickness * bar.stress * strain, rounding * bar.stress * strain);
}

/// K u by products is what the factor inverts.
TEST_P(ProjectedDilatation, ProductsAndSolutionsAgree) {
    const PartSystem s = test::system_of(bar.part, bar.supports, VectorXd::Zero(2 * bar.part.space.n_functions));
    VectorXd u = VectorXd::Random(s.prescribed.size());
    for (std::size_t i = 0; i < s.number.size(); ++i)
        if (s.number[i] < 0) u[static_cast<Eigen::Index>(i)] = s.prescribed[static_cast<Eigen::Index>(i)];
    EXPECT_LT(test::relative_difference(solve(s, stiffness_times(s, u)), u), rounding_of(s));
}

INSTANTIATE_TEST_SUITE_P(All, ProjectedDilatation,
                         testing::Combine(testing::Values(1, 2, 3, 4, 6), testing::Bool(), testing::Values(0.0, 0.03, 0.2)));

TEST(Dilatation, OtherBasesPassThePatchTest) {
    const PulledBar bar(2, false, Basis::plain, 0.1);
    const PartSystem s = test::system_of(bar.part, bar.supports, VectorXd::Zero(2 * bar.part.space.n_functions));
    ASSERT_EQ(s.failure, "");
    EXPECT_LT(test::relative_difference(solve(s, s.load), bar.exact), rounding_of(s));
}

TEST(Dilatation, WeightFunctionsAreRefused) {
    PulledBar bar(2, true, Basis::web, 0);
    bar.part.structure = std::make_shared<const SolutionStructure>();
    EXPECT_NE(test::system_of(bar.part, bar.supports, VectorXd::Zero(2 * bar.part.space.n_functions)).failure, "");
}

TEST(Dilatation, StressesAskForTheSystem) {
    const PulledBar bar(2, true, Basis::web, 0);
    EXPECT_THROW(StressOf(bar.part, bar.exact), std::logic_error);
}

}  // namespace
}  // namespace abut::solver::dilatation_test
