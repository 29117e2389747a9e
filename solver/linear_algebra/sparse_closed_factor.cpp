// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/sparse_closed_factor.hpp"

namespace abut::solver {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Eigen::SparseMatrix<double> entries_of(const MatrixXd& columns, const VectorXd& b) {
    Eigen::SparseMatrix<double> entries(b.size(), columns.cols() + 1);
    for (Index j = 0; j <= columns.cols(); ++j) {
        entries.startVec(j);
        for (Index i = 0; i < b.size(); ++i)
            if (const double value = j < columns.cols() ? columns(i, j) : b[i]; value != 0) entries.insertBack(i, j) = value;
    }
    entries.finalize();
    return entries;
}

void SparseClosedFactor::move_to(const std::vector<char>& closed) {
    rows_.clear();
    left_out_.clear();
    for (std::size_t k = 0; k < closed.size(); ++k)
        if (closed[k]) rows_.push_back(static_cast<Index>(k));
    while (!rows_.empty()) {
        const int row = factor_.compute(compliance_.among(rows_), redundant_fraction);
        if (row < 0) return;
        left_out_.push_back(rows_[static_cast<std::size_t>(row)]);
        rows_.erase(rows_.begin() + row);
    }
}

MatrixXd SparseClosedFactor::inverse_form(const MatrixXd& columns, const VectorXd& b) const {
    if (rows_.empty()) return MatrixXd::Zero(columns.cols() + 1, columns.cols() + 1);
    return factor_.inverse_form(entries_of(columns(rows_, Eigen::all), b(rows_)));
}

VectorXd SparseClosedFactor::solve(const VectorXd& b) const {
    return factor_.solve(b);
}

}  // namespace abut::solver
