// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/sparse_cholesky.hpp"

#include <cmath>

namespace abut::solver {

using Eigen::VectorXd;

int SparseCholesky::compute(SparseSymmetric matrix, double least_pivot) {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    scale_.resize(matrix.n);
    for (int j = 0; j < matrix.n; ++j) {
        const double diagonal = matrix.value[at(matrix.first[at(j)])];
        if (!(diagonal > 0)) return j;
        scale_[j] = 1 / std::sqrt(diagonal);
    }
    if (matrix.n == 0) return -1;
    for (int j = 0; j < matrix.n; ++j)
        for (int k = matrix.first[at(j)]; k < matrix.first[at(j + 1)]; ++k)
            matrix.value[at(k)] *= scale_[j] * scale_[matrix.row[at(k)]];
    if (!structure_ || pattern_.first != matrix.first || pattern_.row != matrix.row) {
        structure_.emplace(matrix, merged_pattern(matrix));
        pattern_ = {matrix.n, matrix.first, matrix.row, {}};
    }
    factor_ = std::make_shared<const SupernodalFactor>(matrix, *structure_);
    if (const int row = factor_->failed_at(); row >= 0) return row;
    int row = -1;
    return factor_->supernodes().smallest_pivot(row) > least_pivot ? -1 : row;
}

VectorXd SparseCholesky::solve(const VectorXd& b) const {
    if (b.size() == 0) return b;
    return scale_.cwiseProduct(factor_->supernodes().solve(scale_.cwiseProduct(b)));
}

Eigen::MatrixXd SparseCholesky::inverse_form(const Eigen::SparseMatrix<double>& b) const {
    if (b.rows() == 0) return Eigen::MatrixXd::Zero(b.cols(), b.cols());
    return factor_->supernodes().inverse_form(scale_.asDiagonal() * b);
}

}  // namespace abut::solver
