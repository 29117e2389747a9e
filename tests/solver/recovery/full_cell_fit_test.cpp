// SPDX-License-Identifier: GPL-3.0-or-later
// The products of a full cell's columns and rows are the sums over its samples.
#include "solver/recovery/full_cell_fit.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::full_cell_fit_test {
namespace {

/// Sample by sample: a column of functions' values for each.
FullCellEquations by_samples(const SplineSpace& fit, const StressOf& stress, int element, const FullCellRule& rule) {
    const Eigen::Index n = (fit.x.degree + 1) * (fit.y.degree + 1);
    FullCellEquations sum{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixX3d::Zero(n, 3)};
    const int column = fit.column_of(element), row = fit.row_of(element);
    const auto place = [](const KnotVector& k, int i, double u) {
        const auto at = static_cast<std::size_t>(i);
        return k.breakpoints[at] + u * (k.breakpoints[at + 1] - k.breakpoints[at]);
    };
    const auto add = [&](const std::vector<double>& abscissas, double weight) {
        for (double v : abscissas)
            for (double u : abscissas) {
                const Vec2 x(place(fit.x, column, u), place(fit.y, row, v));
                LocalValues along_x, along_y;
                evaluate(fit.x, column, x.x(), along_x);
                evaluate(fit.y, row, x.y(), along_y);
                Eigen::VectorXd b(n);
                for (Eigen::Index k = 0; k < n; ++k)
                    b[k] = along_x[static_cast<std::size_t>(k % (fit.x.degree + 1))] *
                           along_y[static_cast<std::size_t>(k / (fit.x.degree + 1))];
                sum.matrix += weight * b * b.transpose();
                sum.rhs += weight * b * stress(element, x).transpose();
            }
    };
    add(rule.inside, 1);
    add(rule.between, rule.between_weight);
    return sum;
}

TEST(FullCellFit, IsTheSumOverTheSamples) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int degree : {1, 2, 3})
        for (int fit_degree : {1, degree}) {
            const PartInput part = test::ell({degree, false, Basis::web}, plane_strain(1000, 0.3));
            const SplineSpace fit = make_space({clamped_knots(part.space.x.breakpoints, fit_degree),
                                                clamped_knots(part.space.y.breakpoints, fit_degree),
                                                part.space.fraction,
                                                part.space.splits,
                                                Basis::web,
                                                {}});
            const Eigen::VectorXd u = Eigen::VectorXd::NullaryExpr(2 * part.space.n_functions, [&] { return number(random); });
            const StressOf stress(part, u);
            const FullCellRule rule{test::gauss(degree).points, {0, 0.5, 1}, 0.01};
            const FullCellFit full(part.space, fit, rule);
            int cells = 0;
            for (std::size_t k = 0; k < part.space.fraction.size(); ++k) {
                if (part.space.fraction[k] != 1) continue;
                const int element = static_cast<int>(k);
                FullCellEquations cell;
                full.equations({stress, element}, element, cell);
                const FullCellEquations expected = by_samples(fit, stress, element, rule);
                EXPECT_LT((cell.matrix - expected.matrix).norm(), 1e-13 * expected.matrix.norm());
                EXPECT_LT((cell.rhs - expected.rhs).norm(), 1e-12 * expected.rhs.norm());
                ++cells;
            }
            EXPECT_GT(cells, 3);
        }
}

}  // namespace
}  // namespace abut::solver::full_cell_fit_test
