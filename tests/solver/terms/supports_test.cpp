// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/supports.hpp"

#include <gtest/gtest.h>

#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::supports_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const Elasticity material = plane_stress(1000, 0.3);

/// A bar [0, 2] x [0, 1] whose sides all cut the grid's cells (by `sliver` of a cell), pulled by 1 % along x between rollers on
/// its left and right ends and one on its lower side: uniform stress (10, 0, 0).
struct Bar {
    PartInput part;
    std::vector<SupportSet> supports;
    VectorXd exact;
};

constexpr double strain = 0.01;

Bar pulled_bar(int degree, bool uniform, double sliver) {
    const double h = 0.35;
    const auto x = test::grid_lines(-h * (1 - sliver), 2 + h * (1 - sliver), 8, uniform);
    const auto y = test::grid_lines(-h * (1 - sliver), 1 + h * (1 - sliver), 5, uniform);
    Bar bar{test::part_of({{0, 0, 2, 1}}, x, y, degree, Basis::web, material, 0.8), {}, {}};
    const SplineSpace& s = bar.part.space;
    bar.supports.push_back(test::support_on(s, {0, 0}, {0, 1}, {-1, 0}, {1, 0}));
    bar.supports.push_back(test::support_on(s, {2, 0}, {2, 1}, {1, 0}, {1, 0}, [](const Vec2&) { return 2 * strain; }));
    bar.supports.push_back(test::support_on(s, {0, 0}, {2, 0}, {0, -1}, {0, 1}));
    bar.exact = test::interleave(strain * test::monomial(s, 1, 0), -0.3 * strain * test::monomial(s, 0, 1));
    return bar;
}

/// A square held on its left side, pulled down on its right.
struct Cantilever {
    PartInput part = test::rectangle(1, 1, 10, 10, 2);
    VectorXd load =
        boundary_load(part, test::traction_on(part.space, {1, 0}, {1, 1}, {1, 0}, [](const Vec2&) { return Vec2(0, -1); }));
    SupportSet x = test::side_support(part.space, GridSide::left, 0), y = test::side_support(part.space, GridSide::left, 1);
    double tip(const PartSystem& s) const {
        return displacement_at(s.input.space, solve(s, s.load), s.input.space.cell_at({1, 0.5}), {1, 0.5}).value.y();
    }
};

/// Condition number of a matrix scaled to a unit diagonal; negative where the matrix is indefinite.
double scaled_condition(MatrixXd m) {
    const VectorXd s = m.diagonal().cwiseSqrt().cwiseInverse();
    m = s.asDiagonal() * m * s.asDiagonal();
    const VectorXd e = Eigen::SelfAdjointEigenSolver<MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues();
    return e[e.size() - 1] / e[0];
}

class Nitsche : public testing::TestWithParam<std::tuple<int, bool, double>> {
protected:
    Bar bar = pulled_bar(std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam()));
};

}  // namespace

TEST_P(Nitsche, IsConsistent) {
    BlockMatrix k = assemble_stiffness(bar.part);
    VectorXd load = VectorXd::Zero(2 * bar.part.space.n_functions);
    for (const SupportSet& set : bar.supports) add_nitsche(bar.part, set, k, load);
    const double scale = load.cwiseAbs().maxCoeff();
    EXPECT_LT((multiply(k, bar.exact) - load).cwiseAbs().maxCoeff(), 1e-11 * scale);
    EXPECT_GT((multiply(k, 1.0001 * bar.exact) - load).cwiseAbs().maxCoeff(), 1e-11 * scale);
}

TEST_P(Nitsche, IsSymmetricAndPositiveDefinite) {
    BlockMatrix k = assemble_stiffness(bar.part);
    VectorXd load = VectorXd::Zero(2 * bar.part.space.n_functions);
    for (const SupportSet& set : bar.supports) add_nitsche(bar.part, set, k, load);
    const MatrixXd m = test::dense(k);
    for (int f = 0; f < k.n; ++f) EXPECT_NEAR(m(2 * f, 2 * f + 1), m(2 * f + 1, 2 * f), 1e-14 * m.cwiseAbs().maxCoeff());
    EXPECT_GT(scaled_condition(m), 1);
    EXPECT_LT(scaled_condition(m), 2e7);  // 1e2 at degree 1 to 1e7 at degree 4, for any cut
}

/// Largest distance of an entry that is not zero from the diagonal.
double bandwidth(const MatrixXd& m) {
    Eigen::Index widest = 0;
    for (Eigen::Index i = 0; i < m.rows(); ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            if (m(i, j) != 0) widest = std::max(widest, i - j);
    return static_cast<double>(widest);
}

TEST_P(Nitsche, PassesThePatchTest) {
    const PartSystem s = test::system_of(bar.part, bar.supports, VectorXd::Zero(2 * bar.part.space.n_functions));
    ASSERT_EQ(s.failure, "");
    EXPECT_TRUE(s.free_motions.empty());
    const VectorXd u = solve(s, s.load);
    // Cholesky's backward error, bandwidth + 1 roundings [Higham, Accuracy and Stability, 2002, theorem 10.3], times the
    // condition number
    const double bound = (bandwidth(test::dense(s.stiffness)) + 1) * 2.2e-16 * scaled_condition(test::dense(s.stiffness));
    EXPECT_LT(bound, 1e-6);
    EXPECT_LT((u - bar.exact).cwiseAbs().maxCoeff(), bound * bar.exact.cwiseAbs().maxCoeff());
    const std::vector<Resultant> r = support_reactions(s, u, s.load);
    ASSERT_EQ(r.size(), 3u);
    const double force = 1000 * strain * 0.8;
    EXPECT_NEAR(r[0].force.x(), -force, 1e-8 * force);
    EXPECT_NEAR(r[1].force.x(), force, 1e-8 * force);
    EXPECT_NEAR(r[1].moment, -0.5 * force, 1e-8 * force);
    EXPECT_NEAR(r[2].force.y(), 0, 1e-8 * force);
    EXPECT_NEAR(strain_energy(s, u), 0.5 * 1000 * strain * strain * 2 * 0.8, 1e-9);  // energy 0.08
}

INSTANTIATE_TEST_SUITE_P(All, Nitsche,
                         testing::Combine(testing::Values(1, 2, 3, 4), testing::Bool(), testing::Values(1e-6, 0.02, 0.6)));

TEST(Supports, NitscheAgreesWithDroppedFunctions) {
    // not a polynomial: the two discretisations differ by what the grid resolves of the corners' singularities
    const Cantilever c;
    const PartSystem dropped = test::system_of(c.part, {c.x, c.y}, c.load);
    const PartSystem weak = test::system_of(c.part, {test::by_nitsche(c.x), test::by_nitsche(c.y)}, c.load);
    EXPECT_EQ(dropped.supports[0].method, SupportMethod::aligned);
    EXPECT_EQ(weak.supports[0].method, SupportMethod::nitsche);
    const double reference = c.tip(dropped);
    EXPECT_LT(reference, -0.003);
    EXPECT_NEAR(c.tip(weak), reference, 2e-3 * std::abs(reference));
    EXPECT_NE(c.tip(weak), reference);
}

TEST(Supports, ReactionsBalanceTheLoadBothWays) {
    const Cantilever c;
    const Resultant applied = resultant_of(c.part.space, c.load);
    EXPECT_NEAR(applied.force.y(), -1, 1e-13);
    for (bool weak_x : {false, true})
        for (bool weak_y : {false, true}) {
            const PartSystem s =
                test::system_of(c.part, {weak_x ? test::by_nitsche(c.x) : c.x, weak_y ? test::by_nitsche(c.y) : c.y}, c.load);
            Resultant sum = applied;
            for (const Resultant& r : support_reactions(s, solve(s, s.load), s.load)) {
                sum.force += r.force;
                sum.moment += r.moment;
                EXPECT_GT(std::abs(r.force.y()) + std::abs(r.moment), 0.1);
            }
            EXPECT_LT(sum.force.norm(), 1e-10);
            EXPECT_LT(std::abs(sum.moment), 1e-10);
        }
}

TEST(Supports, NitscheEnergyIsItsShareOfTheQuadraticForm) {
    const Cantilever c;
    const SupportSet set = test::by_nitsche(c.x);
    const BlockMatrix plain = assemble_stiffness(c.part);
    BlockMatrix with = plain;
    VectorXd load = VectorXd::Zero(c.load.size());
    add_nitsche(c.part, set, with, load);
    const VectorXd u = test::interleave(test::monomial(c.part.space, 2, 1) + test::monomial(c.part.space, 0, 1),
                                        test::monomial(c.part.space, 1, 2));
    const double share = u.dot(multiply(with, u)) - u.dot(multiply(plain, u));
    EXPECT_NEAR(nitsche_energy(c.part, set, u), share, 1e-10 * std::abs(share));
    EXPECT_GT(std::abs(share), 1e-3);
    EXPECT_TRUE(load.isZero(0));  // no prescribed value
}

TEST(Supports, FunctionsOnASideAreTheOutermostRow) {
    const SplineSpace s = test::rectangle(3, 2, 3, 2, 2).space;  // 5 x 4 functions
    using List = std::vector<int>;
    EXPECT_EQ(functions_on_side(s, GridSide::bottom, {{0, 3}}), (List{0, 1, 2, 3, 4}));
    EXPECT_EQ(functions_on_side(s, GridSide::top, {{0, 3}}), (List{15, 16, 17, 18, 19}));
    EXPECT_EQ(functions_on_side(s, GridSide::left, {{0, 2}}), (List{0, 5, 10, 15}));
    EXPECT_EQ(functions_on_side(s, GridSide::right, {{0, 2}}), (List{4, 9, 14, 19}));
    EXPECT_EQ(functions_on_side(s, GridSide::bottom, {{0, 1.3}, {1.3, 3}}), (List{0, 1, 2, 3, 4}));
}

TEST(Supports, DroppedRowsVanishOnTheSide) {
    const SplineSpace s = test::rectangle(3, 2, 4, 3, 3, false).space;
    VectorXd c = VectorXd::LinSpaced(s.n_functions, 1, 2);
    const auto dropped = functions_on_side(s, GridSide::right, {{0, 2}});
    ASSERT_TRUE(dropped.has_value());
    for (int f : *dropped) c[f] = 0;
    for (double y : {0.0, 0.3, 1.1, 2.0}) {
        EXPECT_EQ(test::value_at(s, c, s.cell_at({3, y}), {3, y}), 0);
        EXPECT_NE(test::value_at(s, c, s.cell_at({2.9, y}), {2.9, y}), 0);
    }
}

TEST(Supports, FunctionsThatReachUnheldMaterialMayNotBeDropped) {
    const auto x = test::grid_lines(0, 5, 5, true), y = test::grid_lines(0, 3, 3, true);
    const auto bottom = [&](const std::vector<test::Box>& boxes, const std::vector<Stretch>& stretches, int degree) {
        return functions_on_side(test::part_of(boxes, x, y, degree, Basis::web).space, GridSide::bottom, stretches);
    };
    EXPECT_FALSE(bottom({{0, 0, 5, 3}}, {{0, 2}}, 1).has_value());
    // two feet, an empty cell and a half-filled one (a recess) between them
    EXPECT_TRUE(bottom({{0, 0, 2, 1}, {3, 0, 5, 1}, {0, 1, 5, 3}}, {{0, 2}, {3, 5}}, 1).has_value());
    EXPECT_FALSE(bottom({{0, 0, 2, 1}, {3, 0, 5, 1}, {2, 0.5, 3, 1}, {0, 1, 5, 3}}, {{0, 2}, {3, 5}}, 1).has_value());
    // one foot alone is held; that of the other side keeps its functions at degree 1, shares them at degree 2
    EXPECT_EQ(bottom({{0, 0, 2, 1}, {3, 0, 5, 1}, {0, 1, 5, 3}}, {{0, 2}}, 1)->size(), 3u);
    EXPECT_FALSE(bottom({{0, 0, 2, 1}, {3, 0, 5, 1}, {0, 1, 5, 3}}, {{0, 2}}, 2).has_value());
}

TEST(Supports, AnExtendedRowMayNotBeDropped) {
    // the bottom row of cells is a sliver: its functions are extended from those above, which do not live on the side
    const auto x = test::grid_lines(0, 3, 3, true), y = test::grid_lines(0, 3, 3, true);
    const PartInput part = test::part_of({{0, 0.9, 3, 3}}, x, y, 2, Basis::web);
    EXPECT_FALSE(functions_on_side(part.space, GridSide::bottom, {{0, 3}}).has_value());
    EXPECT_TRUE(functions_on_side(part.space, GridSide::top, {{0, 3}}).has_value());
}

TEST(Supports, ASideThatCannotBeDroppedIsHeldByNitsche) {
    const PartInput part = test::rectangle(3, 3, 3, 3, 1);
    const SupportSet bottom = test::side_support(part.space, GridSide::bottom, 1);
    const VectorXd none = VectorXd::Zero(2 * part.space.n_functions);
    EXPECT_EQ(test::system_of(part, {bottom}, none).supports[0].method, SupportMethod::aligned);
    // two sets that disagree on a corner's value: the second one is imposed weakly
    const SupportSet left = test::side_support(part.space, GridSide::left, 1, 0.2);
    const PartSystem s = test::system_of(part, {bottom, left}, none);
    EXPECT_EQ(s.supports[1].method, SupportMethod::nitsche);
    EXPECT_TRUE(s.supports[1].dropped.empty());
}

TEST(Supports, ResultantsAddForcesAndTheirMoments) {
    Resultant r;
    r.add({2, 1}, {0, 3});
    r.add({0, 2}, {1, 0});
    EXPECT_EQ(r.force, Vec2(1, 3));
    EXPECT_EQ(r.moment, 4);
}

}  // namespace abut::solver::supports_test
