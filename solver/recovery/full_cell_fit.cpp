// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/recovery/full_cell_fit.hpp"

#include <array>

#include "src/base/index.hpp"

namespace abut::solver {

FullCellFit::Samples FullCellFit::samples_on(const IntervalKnots& displacement, const IntervalKnots& fit,
                                             const std::vector<double>& abscissas) {
    const double begin = fit.low(), length = fit.high() - begin;
    Samples samples{{}, Eigen::MatrixXd::Zero(fit.degree + 1, fit.degree + 1)};
    for (double u : abscissas) {
        Abscissa p;
        p.at = begin + u * length;
        evaluate(displacement, p.at, p.displacement.value, p.displacement.slope);
        evaluate(fit, p.at, p.fit);
        for (int j = 0; j <= fit.degree; ++j)
            for (int i = 0; i <= fit.degree; ++i) samples.products(i, j) += p.fit[at(i)] * p.fit[at(j)];
        samples.points.push_back(p);
    }
    return samples;
}

std::vector<FullCellFit::Line> FullCellFit::lines_of(const SplineSpace& displacement, const SplineSpace& fit, int axis,
                                                     const FullCellRule& rule) {
    std::vector<Line> lines;
    for (int k = 0; k < fit.n_intervals(axis); ++k) {
        const IntervalKnots u = displacement.interval(axis, k), s = fit.interval(axis, k);
        lines.push_back({samples_on(u, s, rule.inside), samples_on(u, s, rule.between)});
    }
    return lines;
}

FullCellFit::FullCellFit(const SplineSpace& displacement, const SplineSpace& fit, const FullCellRule& rule)
    : space_(fit),
      between_weight_(rule.between_weight),
      columns_(lines_of(displacement, fit, 0, rule)),
      rows_(lines_of(displacement, fit, 1, rule)) {}

void FullCellFit::equations(const StressOf::OnElement& stress, int element, FullCellEquations& result) const {
    const Line &column = columns_[at(space_.column_of(element))], &row = rows_[at(space_.row_of(element))];
    const Eigen::Index n = (space_.x.degree + 1) * (space_.y.degree + 1);
    result.matrix.setZero(n, n);
    result.rhs.setZero(n, 3);
    add(stress, column.inside, row.inside, 1, result);
    add(stress, column.between, row.between, between_weight_, result);
}

/// The functions in rows of B-splines along x, one row after the other.
void FullCellFit::add(const StressOf::OnElement& stress, const Samples& x, const Samples& y, double weight,
                      FullCellEquations& result) const {
    const Eigen::Index nx = space_.x.degree + 1, ny = space_.y.degree + 1;
    for (Eigen::Index j = 0; j < ny; ++j)
        for (Eigen::Index i = 0; i < ny; ++i)
            result.matrix.block(i * nx, j * nx, nx, nx) += weight * y.products(i, j) * x.products;
    for (const Abscissa& q : y.points) {
        std::array<Eigen::Vector3d, max_degree + 1> along{};
        for (Eigen::Index a = 0; a < nx; ++a) along[static_cast<std::size_t>(a)].setZero();
        for (const Abscissa& p : x.points) {
            const Eigen::Vector3d s = stress({p.at, q.at}, p.displacement, q.displacement);
            for (Eigen::Index a = 0; a < nx; ++a) along[static_cast<std::size_t>(a)] += p.fit[static_cast<std::size_t>(a)] * s;
        }
        for (Eigen::Index b = 0; b < ny; ++b)
            for (Eigen::Index a = 0; a < nx; ++a)
                result.rhs.row(b * nx + a) +=
                    weight * q.fit[static_cast<std::size_t>(b)] * along[static_cast<std::size_t>(a)].transpose();
    }
}

}  // namespace abut::solver
