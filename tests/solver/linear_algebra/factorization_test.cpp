// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/factorization.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>

#include "tests/solver/linear_algebra/sparse_of.hpp"
#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::factorization_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Banded with a few far couplings, diagonally dominant, rows scaled over six decades.
MatrixXd positive_definite(int n) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    MatrixXd m = MatrixXd::Zero(n, n);
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < r; ++c)
            if (r - c <= 3 || (r + 5 * c) % 17 == 0) m(r, c) = m(c, r) = number(random);
    for (int k = 0; k < n; ++k) m(k, k) = 0.1 + m.row(k).cwiseAbs().sum();
    VectorXd scale(n);
    for (int k = 0; k < n; ++k) scale[k] = std::pow(10.0, 3 * number(random));
    return scale.asDiagonal() * m * scale.asDiagonal();
}

MatrixXd random_columns(int rows, int columns) {
    std::mt19937 random(11);
    std::normal_distribution<double> number;
    return MatrixXd::NullaryExpr(rows, columns, [&]() { return number(random); });
}

constexpr FactorMethod both_methods[] = {FactorMethod::banded, FactorMethod::supernodal};

Factorization factor_by(FactorMethod method, const MatrixXd& m) {
    return Factorization(sparse(m), {.method = method});
}

/// Stiffness of a part without its first coefficients: no rigid motion is left.
MatrixXd held_stiffness(const PartInput& part, SparseSymmetric& matrix) {
    const BlockMatrix k = assemble_stiffness(part);
    std::vector<int> number(static_cast<std::size_t>(2 * k.n), -1), kept;
    for (int i = 7; i < 2 * k.n; ++i) {
        number[static_cast<std::size_t>(i)] = i - 7;
        kept.push_back(i);
    }
    matrix = restricted(k, number, 2 * k.n - 7);
    return test::dense(k)(kept, kept);
}

/// 2-norm condition number.
double condition_of(const MatrixXd& m) {
    const VectorXd e = Eigen::SelfAdjointEigenSolver<MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues();
    return e[e.size() - 1] / e[0];
}
MatrixXd scaled_to_unit_diagonal(const MatrixXd& m) {
    const VectorXd s = m.diagonal().cwiseSqrt().cwiseInverse();
    return s.asDiagonal() * m * s.asDiagonal();
}

}  // namespace

TEST(Factorization, SolvesLikeADenseOne) {
    for (FactorMethod method : both_methods)
        for (int n : {1, 2, 7, 60, 150, 301}) {
            const MatrixXd a = positive_definite(n);
            const Factorization f = factor_by(method, a);
            ASSERT_TRUE(f.ok());
            EXPECT_EQ(f.failed_at(), -1);
            EXPECT_EQ(f.method(), method);
            const VectorXd b = a * random_columns(n, 1);  // so that rows of all scales matter
            const VectorXd x = f.solve(b), reference = a.llt().solve(b);
            const VectorXd scale = a.diagonal().cwiseSqrt();
            EXPECT_LT(test::relative_difference(VectorXd(scale.cwiseProduct(x)), VectorXd(scale.cwiseProduct(reference))),
                      1e-12);
        }
}

TEST(Factorization, ForwardSolvesGiveTheCompliance) {
    for (FactorMethod method : both_methods)
        for (int n : {1, 9, 80, 301}) {
            const MatrixXd a = positive_definite(n), b = a.diagonal().cwiseSqrt().asDiagonal() * random_columns(n, 5);
            const MatrixXd y = factor_by(method, a).solve_lower(b);
            const MatrixXd reference = b.transpose() * a.llt().solve(b);
            EXPECT_LT(test::relative_difference(MatrixXd(y.transpose() * y), reference), 1e-12);
            EXPECT_GT(test::relative_difference(MatrixXd(1.0001 * y.transpose() * y), reference), 1e-12);
        }
}

TEST(Factorization, GivesFormsThatItKeepsForTheSameColumnsAlone) {
    for (FactorMethod method : both_methods) {
        const Factorization fresh = factor_by(method, positive_definite(80));
        Factorization keeping = fresh;
        keeping.keep_forms();
        const Factorization copy = keeping;
        for (int round = 0; round < 2; ++round)
            for (int k = 0; k < 20; ++k) {  // more than are kept
                MatrixXd b = random_columns(80, 3);
                b(k, 1) += 1e-9;
                const Eigen::SparseMatrix<double> columns = b.sparseView();
                EXPECT_EQ(keeping.inverse_form(columns), fresh.inverse_form(columns));
                EXPECT_EQ(copy.inverse_form(columns), fresh.inverse_form(columns));
            }
        const Eigen::SparseMatrix<double> fewer = random_columns(80, 3).leftCols(2).sparseView();
        EXPECT_EQ(keeping.inverse_form(fewer), fresh.inverse_form(fewer));
    }
}

/// Every bandwidth from a diagonal matrix to a full one, on both sides of the panels' width and its multiples; right-hand sides
/// that begin anywhere.
TEST(Factorization, BandsOfAllWidthsSolveForward) {
    std::mt19937 random(13);
    for (int n : {5, 64, 65, 140, 200})
        for (int width = 0; width < n; width += width < 4 || (width > 60 && width < 68) ? 1 : 9) {
            MatrixXd a = MatrixXd::Identity(n, n);
            for (int c = 0; c < n; ++c)
                for (int r = c + 1; r <= std::min(c + width, n - 1); ++r)
                    a(r, c) = a(c, r) = (static_cast<double>(random()) * 0x1p-32 - 0.5) / (width + 1.0);
            MatrixXd b = random_columns(n, 3);
            b.topRows(n / 3).setZero();
            const Factorization f = factor_by(FactorMethod::banded, a);
            ASSERT_TRUE(f.ok());
            ASSERT_LE(f.bandwidth(), width);
            const MatrixXd y = f.solve_lower(b), reference = b.transpose() * a.llt().solve(b);
            EXPECT_LT(test::relative_difference(MatrixXd(y.transpose() * y), reference), 1e-13) << n << " " << width;
        }
}

TEST(Factorization, PicksTheBandForNarrowMatricesAndTheNarrowerOrder) {
    SparseSymmetric bar, square;
    held_stiffness(test::rectangle(40, 1, 40, 2, 2), bar);  // numbered along its long side: 4 functions wide across
    held_stiffness(test::rectangle(1, 1, 4, 4, 1), square);
    const Factorization of_bar(bar);
    EXPECT_EQ(of_bar.method(), FactorMethod::banded);
    EXPECT_LE(of_bar.bandwidth(), 2 * (3 * 4 + 2));
    EXPECT_EQ(of_bar.entries(), (of_bar.bandwidth() + 1.0) * bar.n);
    EXPECT_EQ(of_bar.bytes(), 8 * of_bar.entries());

    SparseSymmetric far{400, {0}, {}, {}};  // coupled with rows all over: no order is narrow
    std::mt19937 random(2);
    for (int c = 0; c < far.n; ++c) {
        far.row.push_back(c);
        far.value.push_back(10);
        if (c + 1 < far.n) {
            far.row.push_back(c + 1 + static_cast<int>(random() % static_cast<unsigned>(far.n - c - 1)));
            far.value.push_back(1);
        }
        far.first.push_back(static_cast<int>(far.row.size()));
    }
    const Factorization of_far(far);
    EXPECT_EQ(of_far.method(), FactorMethod::supernodal);
    EXPECT_TRUE(of_far.ok());
}

TEST(Factorization, GivesTheSameBitsEveryTime) {
    for (FactorMethod method : both_methods) {
        SparseSymmetric m;
        held_stiffness(test::ell({3, false, Basis::web}), m);
        const MatrixXd b = random_columns(m.n, 7);
        const Factorization first(m, {.method = method}), second(m, {.method = method});
        EXPECT_EQ(first.solve_lower(b), second.solve_lower(b));
        EXPECT_EQ(first.solve(b.col(0)), second.solve(b.col(0)));
        EXPECT_EQ(first.condition_estimate(), second.condition_estimate());
    }
}

TEST(Factorization, OfStiffnessesIsAsGoodAsTheDenseOne) {
    for (FactorMethod method : both_methods)
        for (int degree = 1; degree <= 4; ++degree) {
            SparseSymmetric m;
            const MatrixXd a = held_stiffness(test::rectangle(2, 1, 6, 4, degree), m);
            const Factorization f(m, {.method = method});
            ASSERT_TRUE(f.ok());
            const MatrixXd b = random_columns(m.n, 4), reference = b.transpose() * a.llt().solve(b);
            const MatrixXd y = f.solve_lower(b);
            // rounding times a condition of 1e5
            EXPECT_LT(test::relative_difference(MatrixXd(y.transpose() * y), reference), 1e-9);
            EXPECT_LT(test::relative_difference(MatrixXd(b.transpose() * f.solve(b.col(0))), MatrixXd(reference.col(0))), 1e-9);
        }
}

TEST(Factorization, ReportsIndefiniteMatrices) {
    for (FactorMethod method : both_methods) {
        MatrixXd a = positive_definite(30);
        a(12, 12) = -a(12, 12);
        EXPECT_FALSE(factor_by(method, a).ok());
        EXPECT_EQ(factor_by(method, a).failed_at(), 12);
        a(12, 12) = 0;
        EXPECT_EQ(factor_by(method, a).failed_at(), 12);

        MatrixXd saddle = MatrixXd::Identity(40, 40);  // positive diagonal, one negative eigenvalue: found while factorising
        saddle(20, 30) = saddle(30, 20) = 1.5;
        const Factorization hidden = factor_by(method, saddle);
        EXPECT_FALSE(hidden.ok());
        EXPECT_TRUE(hidden.failed_at() == 20 || hidden.failed_at() == 30) << hidden.failed_at();
    }
}

/// Pivots that are rounding only, of either sign: a floating part, and one that hangs on nothing but a factor of 1e-17.
TEST(Factorization, ReportsSingularMatrices) {
    for (FactorMethod method : both_methods) {
        MatrixXd chain = MatrixXd::Zero(50, 50);
        for (int k = 0; k + 1 < 50; ++k) {
            chain.diagonal().segment<2>(k).array() += 1;
            chain(k, k + 1) = chain(k + 1, k) = -1;
        }
        EXPECT_FALSE(factor_by(method, chain).ok());
        chain(31, 31) += 1e-17;
        EXPECT_FALSE(factor_by(method, chain).ok());
        EXPECT_GE(factor_by(method, chain).failed_at(), 0);
        chain(31, 31) += 1e-6;
        EXPECT_TRUE(factor_by(method, chain).ok());
    }
}

TEST(Factorization, ReportsWhatIsNotANumber) {
    for (FactorMethod method : both_methods) {
        MatrixXd a = positive_definite(10);
        a(4, 4) = std::nan("");
        EXPECT_EQ(factor_by(method, a).failed_at(), 4);
        a = positive_definite(10);
        a(6, 4) = a(4, 6) = std::nan("");
        EXPECT_EQ(factor_by(method, a).failed_at(), 6);
        a(6, 4) = a(4, 6) = INFINITY;
        EXPECT_EQ(factor_by(method, a).failed_at(), 6);
    }
}

TEST(Factorization, KnowsTheConditionOfTheScaledMatrix) {
    const MatrixXd diagonal = VectorXd::LinSpaced(20, 1, 1e6).asDiagonal();
    EXPECT_NEAR(Factorization(sparse(diagonal)).condition_estimate(), 1, 1e-12);
    for (double coupling : {0.5, 0.9, 0.999, 1 - 1e-6}) {
        MatrixXd pair = MatrixXd::Identity(2, 2);
        pair(0, 1) = pair(1, 0) = coupling;
        const double condition = (1 + coupling) / (1 - coupling);
        EXPECT_NEAR(Factorization(sparse(pair)).condition_estimate(), condition, 1e-8 * condition);
    }
}

/// Bound: a factor of 3 is what is asked for, of 1.2 what Lanczos' method gives. Supported by Nitsche's method, where the
/// diagonal of the factor is up to a hundred times too low.
TEST(Factorization, KnowsTheConditionsOfStiffnesses) {
    for (FactorMethod method : both_methods)
        for (const test::SpaceCase& c : test::all_space_cases()) {
            const PartInput part = test::ell(c);
            const SplineSpace& s = part.space;
            BlockMatrix k = assemble_stiffness(part);
            VectorXd load = VectorXd::Zero(2 * k.n);
            for (int component : {0, 1})
                add_nitsche(part, test::by_nitsche(test::side_support(s, GridSide::bottom, component)), k, load);
            std::vector<int> number(static_cast<std::size_t>(2 * k.n));
            std::iota(number.begin(), number.end(), 0);
            const SparseSymmetric m = restricted(k, number, 2 * k.n);
            const Factorization f(m, {.method = method});
            const MatrixXd a = test::dense(k);
            const double scaled = condition_of(scaled_to_unit_diagonal(a)), unscaled = condition_of(a);
            ASSERT_EQ(f.ok(), scaled > 0) << test::name_of(c) << scaled;  // the plain basis is not stable for each sliver
            if (!f.ok()) continue;
            // a few roundings of the largest eigenvalue are in the smallest: the reference must be surer than what is asked
            // below
            EXPECT_LT(8 * std::numeric_limits<double>::epsilon() * unscaled, 1e-3) << test::name_of(c);
            EXPECT_GT(f.condition_estimate(), scaled / 1.2) << test::name_of(c);
            EXPECT_LT(f.condition_estimate(), scaled * 1.001) << test::name_of(c);
            const MatrixXd inverse = a.llt().solve(MatrixXd::Identity(a.rows(), a.cols()));
            const double one = a.colwise().lpNorm<1>().maxCoeff() * inverse.colwise().lpNorm<1>().maxCoeff();
            EXPECT_GT(f.unscaled_condition_one(), one / 3) << test::name_of(c);
            EXPECT_LT(f.unscaled_condition_one(), one * 1.001) << test::name_of(c);
        }
}

TEST(Factorization, CanBeMovedAndIsEmptyByDefault) {
    Factorization empty;
    EXPECT_FALSE(empty.ok());
    EXPECT_EQ(empty.failed_at(), -1);
    Factorization first(sparse(positive_definite(5)));
    empty = std::move(first);
    EXPECT_TRUE(empty.ok());
    EXPECT_EQ(empty.solve(VectorXd::Zero(5)), VectorXd::Zero(5));
}

TEST(Factorization, OfNothingSolvesNothing) {
    for (FactorMethod method : both_methods) EXPECT_TRUE(factor_by(method, MatrixXd(0, 0)).ok());
    const Factorization f(sparse(MatrixXd(0, 0)));
    EXPECT_TRUE(f.ok());
    EXPECT_EQ(f.solve(VectorXd(0)).size(), 0);
    EXPECT_EQ(f.solve_lower(MatrixXd(0, 3)).cols(), 3);
    EXPECT_EQ(f.condition_estimate(), 1);
    EXPECT_EQ(f.unscaled_condition_one(), 1);
}

TEST(Factorization, RefusesRightHandSidesOfOtherSizes) {
    const Factorization f(sparse(positive_definite(5)));
    EXPECT_THROW(f.solve(VectorXd::Ones(4)), std::logic_error);
    EXPECT_THROW(f.solve(VectorXd::Ones(6)), std::logic_error);
    EXPECT_THROW(f.solve_lower(MatrixXd::Ones(4, 2)), std::logic_error);
    EXPECT_THROW(f.inverse_form(MatrixXd::Ones(4, 2).sparseView()), std::logic_error);
}

}  // namespace abut::solver::factorization_test
