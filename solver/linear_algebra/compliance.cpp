// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/compliance.hpp"

#include "solver/linear_algebra/blas.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr int least_rows_for_blas = 16;  // of a product: below, the call costs more than it saves

using CouplingEntry = Eigen::SparseMatrix<double>::InnerIterator;

}  // namespace

const MatrixXd& Compliance::dense() const {
    ENSURE(dense_, "a dense compliance is asked for its matrix");
    return *dense_;
}

VectorXd Compliance::diagonal() const {
    return sparse_ ? VectorXd(sparse_->diagonal()) : VectorXd(dense_->diagonal());
}

VectorXd Compliance::operator*(const VectorXd& x) const {
    if (sparse_) return *sparse_ * x;
    const int m = static_cast<int>(x.size()), step = 1;
    if (m < least_rows_for_blas) return *dense_ * x;
    const double one = 1;
    VectorXd product = VectorXd::Zero(m);
    for (int begin = 0, end = 0; begin < m; begin = end) {  // most multipliers are zero, side by side
        const bool is_zero = x[begin] == 0;
        while (end < m && (x[end] == 0) == is_zero) ++end;
        const int n = end - begin;
        if (!is_zero)
            dgemv_("N", &m, &n, &one, dense_->data() + static_cast<Index>(begin) * m, &m, x.data() + begin, &step, &one,
                   product.data(), &step);
    }
    return product;
}

VectorXd Compliance::product_at(const std::vector<Index>& rows, const VectorXd& x) const {
    if (sparse_) return (*sparse_ * x)(rows);
    VectorXd product = VectorXd::Zero(static_cast<Index>(rows.size()));
    for (Index j = 0; j < x.size(); ++j) {
        if (x[j] == 0) continue;
        const double* column = dense_->data() + j * dense_->rows();
        for (std::size_t i = 0; i < rows.size(); ++i) product[static_cast<Index>(i)] += x[j] * column[rows[i]];
    }
    return product;
}

Compliance Compliance::scaled(const VectorXd& s) const {
    if (!sparse_) return MatrixXd(s.asDiagonal() * *dense_ * s.asDiagonal());
    Eigen::SparseMatrix<double> scaled = *sparse_;
    for (int j = 0; j < scaled.outerSize(); ++j)
        for (CouplingEntry e(scaled, j); e; ++e) e.valueRef() *= s[e.row()] * s[j];
    return scaled;
}

SparseSymmetric Compliance::among(const std::vector<Index>& rows) const {
    ENSURE(sparse_, "a dense compliance has no sparse part");
    std::vector<int> number(static_cast<std::size_t>(sparse_->rows()), -1);
    for (std::size_t k = 0; k < rows.size(); ++k) number[static_cast<std::size_t>(rows[k])] = static_cast<int>(k);
    SparseSymmetric lower;
    lower.n = static_cast<int>(rows.size());
    lower.first.push_back(0);
    for (Index j : rows) {
        for (CouplingEntry e(*sparse_, j); e; ++e)
            if (const int row = number[static_cast<std::size_t>(e.row())]; e.row() >= j && row >= 0) {
                lower.row.push_back(row);
                lower.value.push_back(e.value());
            }
        lower.first.push_back(static_cast<int>(lower.row.size()));
    }
    return lower;
}

}  // namespace abut::solver
