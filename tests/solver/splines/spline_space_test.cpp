// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/splines/spline_space.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::spline_space_test {
namespace {

using test::SpaceCase;

/// Points of every cell that the part fills, slivers included: f(cell, point).
template <class F>
void for_cells(const PartInput& part, F f) {
    test::for_points(part, test::ell_boxes(part), 2, [&](int cell, const Vec2& x, double) { f(cell, x); });
}

double monomial_error(const PartInput& part, int a, int b, double perturbation = 0) {
    const Eigen::VectorXd c = test::monomial(part.space, a, b) * (1 + perturbation);
    double worst = 0;
    for_cells(part, [&](int cell, const Vec2& x) {
        worst = std::max(worst, std::abs(test::value_at(part.space, c, cell, x) - std::pow(x.x(), a) * std::pow(x.y(), b)));
    });
    return worst;
}

class Spaces : public testing::TestWithParam<SpaceCase> {
protected:
    PartInput part = test::ell(GetParam());
};

}  // namespace

TEST_P(Spaces, AreMadeWithoutFailure) {
    const SplineSpace& s = part.space;
    EXPECT_EQ(s.failure, "");
    EXPECT_EQ(s.tensor_of.size(), static_cast<std::size_t>(s.n_functions));
    EXPECT_EQ(s.first.size(), static_cast<std::size_t>(s.x.n_functions() * s.y.n_functions() + 1));
    if (GetParam().basis == Basis::plain)
        EXPECT_EQ(s.n_extended, 0);
    else
        EXPECT_GT(s.n_extended, 0);
}

TEST_P(Spaces, SumToOneWithZeroGradient) {
    // the extension's coefficients reach 1e3 at degree 4, one or two cells beyond their interval
    for_cells(part, [&](int cell, const Vec2& x) {
        const PointBasis b = evaluate(part.space, cell, x);
        EXPECT_NEAR(b.value.sum(), 1, 1e-12);
        EXPECT_NEAR(b.dx.sum(), 0, 1e-10);
        EXPECT_NEAR(b.dy.sum(), 0, 1e-10);
    });
}

TEST_P(Spaces, GradientsAreThoseOfTheValues) {
    constexpr double d = 1e-5;
    double worst = 0, largest = 0;
    for_cells(part, [&](int cell, const Vec2& x) {
        const PointBasis b = evaluate(part.space, cell, x);
        const auto value = [&](double dx, double dy) { return evaluate(part.space, cell, x + Vec2(dx, dy)).value; };
        worst = std::max(worst, (b.dx - (value(d, 0) - value(-d, 0)) / (2 * d)).cwiseAbs().maxCoeff());
        worst = std::max(worst, (b.dy - (value(0, d) - value(0, -d)) / (2 * d)).cwiseAbs().maxCoeff());
        largest = std::max({largest, b.dx.cwiseAbs().maxCoeff(), b.dy.cwiseAbs().maxCoeff()});
    });
    EXPECT_LT(worst, 1e-7 * largest);  // d^2/6 of a third derivative that is at most 1e3 of the first
}

TEST_P(Spaces, ReproduceAllPolynomialsUpToTheDegree) {
    constexpr double bound = 1e-9;  // rounding 1e-16 times coefficients up to 1e3 in each direction, values up to 30
    for (int a = 0; a <= GetParam().degree; ++a)
        for (int b = 0; b <= GetParam().degree; ++b) EXPECT_LT(monomial_error(part, a, b), bound) << "x^" << a << " y^" << b;
    EXPECT_GT(monomial_error(part, 1, 1, 1e-7), bound);
}

TEST_P(Spaces, HoldALinearFunctionByItsGrevilleValues) {
    Eigen::VectorXd c(part.space.n_functions);
    for (int f = 0; f < part.space.n_functions; ++f) c[f] = Vec2(2, -3).dot(greville_point(part.space, f)) + 0.5;
    for_cells(part, [&](int cell, const Vec2& x) {
        EXPECT_NEAR(test::value_at(part.space, c, cell, x), 2 * x.x() - 3 * x.y() + 0.5, 1e-10);
    });
}

TEST_P(Spaces, GiveARowToEveryTensorFunctionThatMeetsThePart) {
    const SplineSpace& s = part.space;
    std::set<int> needed;
    for (int cell = 0; cell < s.columns() * s.rows(); ++cell)
        if (s.fraction[static_cast<std::size_t>(cell)] > 0)
            for (int t : tensor_functions(s, cell)) needed.insert(t);
    for (int t = 0; t < s.x.n_functions() * s.y.n_functions(); ++t) {
        const auto k = static_cast<std::size_t>(t);
        EXPECT_EQ(s.first[k] < s.first[k + 1], needed.count(t) == 1) << t;
    }
    EXPECT_EQ(needed.size(), static_cast<std::size_t>(s.n_functions + s.n_extended));
}

TEST_P(Spaces, ExtractFromRowsThatSumToOne) {
    const SplineSpace& s = part.space;
    for_cells(part, [&](int cell, const Vec2&) {
        const Extraction e = extraction(s, cell);
        EXPECT_TRUE(std::is_sorted(e.functions.begin(), e.functions.end()));
        if (e.identity) {
            ASSERT_EQ(e.functions.size(), tensor_functions(s, cell).size());
            for (std::size_t k = 0; k < e.functions.size(); ++k)
                EXPECT_EQ(s.tensor_of[static_cast<std::size_t>(e.functions[k])], tensor_functions(s, cell)[k]);
        } else
            EXPECT_LT((e.matrix.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-11);
        EXPECT_TRUE(e.identity || GetParam().basis == Basis::web);
    });
}

INSTANTIATE_TEST_SUITE_P(All, Spaces, testing::ValuesIn(test::all_space_cases()),
                         [](const auto& given) { return test::name_of(given.param); });

TEST(SplineSpace, OfFullCellsIsTheTensorProduct) {
    for (Basis basis : {Basis::plain, Basis::web}) {
        const SplineSpace s = make_space({0, 1, 2, 3}, {0, 1, 3}, 2, 3, std::vector<double>(6, 1.0), basis);
        EXPECT_EQ(s.n_functions, 5 * 5);
        EXPECT_EQ(s.n_extended, 0);
        for (int cell = 0; cell < 6; ++cell) EXPECT_TRUE(extraction(s, cell).identity);
        EXPECT_EQ(tensor_functions(s, 4), (std::vector<int>{6, 7, 8, 11, 12, 13, 16, 17, 18, 21, 22, 23}));
        EXPECT_EQ(s.cell_at({1.5, 0.2}), 1);
        EXPECT_EQ(s.cell_at({3, 3}), 5);
    }
}

TEST(SplineSpace, CellsCountAsInnerFromAQuarterOn) {
    const auto extended = [](double fraction) {
        return make_space({0, 1, 2}, {0, 1}, 1, 1, {1, fraction}, Basis::web).n_extended;
    };
    EXPECT_EQ(extended(0.25), 0);
    EXPECT_EQ(extended(0.2499), 2);
    EXPECT_EQ(extended(0), 0);  // the outer cell's own functions are absent, not extended
    EXPECT_EQ(make_space({0, 1, 2}, {0, 1}, 1, 1, {1, 0}, Basis::web).n_functions, 4);
    EXPECT_EQ(make_space({0, 1, 2}, {0, 1}, 1, 1, {1, 1e-9}, Basis::plain).n_functions, 6);
}

TEST(SplineSpace, WithoutAnInnerCellFails) {
    EXPECT_NE(make_space({0, 1, 2}, {0, 1}, 2, 2, {0.2, 0.1}, Basis::web).failure, "");
    EXPECT_EQ(make_space({0, 1, 2}, {0, 1}, 2, 2, {0.2, 0.1}, Basis::plain).failure, "");
    // an inner cell that the sliver is not connected to does not help
    EXPECT_NE(make_space({0, 1, 2, 3, 4}, {0, 1}, 1, 1, {1, 0, 0, 0.1}, Basis::web).failure, "");
    EXPECT_EQ(make_space({0, 1, 2, 3, 4}, {0, 1}, 1, 1, {1, 0.1, 0.1, 0.1}, Basis::web).failure, "");
}

TEST(SplineSpace, DoesNotExtendAcrossASlot) {
    // two arms on a common foot; the left one is thin from the second row on, the right one, nearer by distance, is full
    const std::vector<double> fraction{1,   1, 1,  // foot
                                       0.1, 0, 1,  // arms
                                       0.1, 0, 1, 0.1, 0, 1, 0.1, 0, 1};
    const SplineSpace s = make_space({0, 1, 2, 3}, {0, 1, 2, 3, 4, 5}, 1, 1, fraction, Basis::web);
    ASSERT_EQ(s.failure, "");
    for (int f : extraction(s, 12).functions) EXPECT_LE(greville_point(s, f).y(), 1) << "cell 12 is made from function " << f;
}

TEST(SplineSpace, RefusesFractionsOfOtherCells) {
    EXPECT_THROW(make_space({0, 1, 2}, {0, 1}, 1, 1, {1}, Basis::web), std::logic_error);
}

}  // namespace abut::solver::spline_space_test
