// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/closed_factor.hpp"

#include <algorithm>
#include <numeric>

#include "solver/linear_algebra/blas.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A'A.
MatrixXd gram(const MatrixXd& a) {
    const int n = static_cast<int>(a.cols()), k = static_cast<int>(a.rows());
    const double one = 1, zero = 0;
    MatrixXd product(n, n);
    const int lda = std::max(k, 1);
    dsyrk_("L", "T", &n, &k, &one, a.data(), &lda, &zero, product.data(), &n);
    product.triangularView<Eigen::StrictlyUpper>() = product.transpose();
    return product;
}

std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}

}  // namespace

ClosedFactor::ClosedFactor(Compliance compliance, const VectorXd& pressure) : compliance_(std::move(compliance)) {
    if (compliance_.is_sparse()) {
        sparse_.emplace(compliance_);
        return;
    }
    preferred_.resize(at(compliance_.rows()));
    l_.resize(compliance_.rows(), compliance_.rows());
    std::iota(preferred_.begin(), preferred_.end(), Index{0});
    const auto open = std::stable_partition(preferred_.begin(), preferred_.end(), [&](Index a) { return pressure[a] != 0; });
    std::stable_sort(preferred_.begin(), open, [&](Index a, Index b) { return pressure[a] > pressure[b]; });
}

bool ClosedFactor::move_to(const std::vector<char>& closed) {
    if (sparse_) {
        sparse_->move_to(closed);
        return true;
    }
    const auto left = std::find_if(rows_.begin(), rows_.end(), [&](Index row) { return !closed[at(row)]; });
    rows_.erase(left, rows_.end());
    n_solved_ = std::min(n_solved_, rows_.size());
    std::vector<char> kept(closed.size(), 0);
    for (Index row : rows_) kept[at(row)] = 1;
    std::vector<Index> more;
    for (Index row : preferred_)
        if (closed[at(row)] && !kept[at(row)]) more.push_back(row);
    left_out_.clear();
    return more.empty() || append(more);
}

bool ClosedFactor::append(const std::vector<Index>& more) {
    if (append_all(more)) return true;
    for (Index row : more) {
        if (append_all({row})) continue;
        const auto n = static_cast<Index>(rows_.size());
        if (l_(n, n) < -redundant_fraction * compliance_.dense()(row, row)) return false;
        left_out_.push_back(row);
    }
    return true;
}

/// [C11 C21'; C21 C22]: L21 = C21 L11'^-1, L22 L22' = C22 - L21 L21'.
bool ClosedFactor::append_all(const std::vector<Index>& more) {
    const int n = static_cast<int>(rows_.size()), k = static_cast<int>(more.size()), ld = static_cast<int>(l_.rows());
    double *below = l_.data() + n, *corner = below + static_cast<Index>(n) * ld;
    const MatrixXd& c = compliance_.dense();
    for (int i = 0; i < k; ++i) {
        for (int j = 0; j < n; ++j) l_(n + i, j) = c(more[at(i)], rows_[at(j)]);
        for (int j = 0; j <= i; ++j) l_(n + i, n + j) = c(more[at(i)], more[at(j)]);
    }
    const double one = 1, minus = -1;
    if (n > 0) {
        dtrsm_("R", "L", "T", "N", &k, &n, &one, l_.data(), &ld, below, &ld);
        dsyrk_("L", "N", &k, &n, &minus, below, &ld, &one, corner, &ld);
    }
    int info = 0;
    dpotrf_("L", &k, corner, &ld, &info);
    if (info != 0) return false;
    for (int i = 0; i < k; ++i) {
        const double pivot = l_(n + i, n + i) * l_(n + i, n + i);
        if (pivot <= redundant_fraction * c(more[at(i)], more[at(i)])) return false;
    }
    rows_.insert(rows_.end(), more.begin(), more.end());
    return true;
}

/// [y1; y2] = L^-1 [g1; g2]: y2 = L22^-1 (g2 - L21 y1).
void ClosedFactor::solve_new_rows(const MatrixXd& columns) {
    if (solved_.rows() != l_.rows() || solved_.cols() != columns.cols()) solved_.resize(l_.rows(), columns.cols());
    const int n = static_cast<int>(n_solved_), more = static_cast<int>(rows_.size()) - n, ld = static_cast<int>(l_.rows()),
              width = static_cast<int>(columns.cols());
    n_solved_ = rows_.size();
    if (more == 0 || width == 0) return;
    for (int j = 0; j < width; ++j)
        for (int i = n; i < n + more; ++i) solved_(i, j) = columns(rows_[at(i)], j);
    const double one = 1, minus = -1;
    double* below = solved_.data() + n;
    if (n > 0) dgemm_("N", "N", &more, &width, &n, &minus, l_.data() + n, &ld, solved_.data(), &ld, &one, below, &ld);
    dtrsm_("L", "L", "N", "N", &more, &width, &one, l_.data() + n + static_cast<Index>(n) * ld, &ld, below, &ld);
}

MatrixXd ClosedFactor::inverse_form(const MatrixXd& columns, const VectorXd& g, const VectorXd& a) {
    const Index n = columns.cols();
    if (sparse_) {
        form_ = n > 0 ? VectorXd(g + columns * a) : g;
        return sparse_->inverse_form(columns, form_.col(0));
    }
    form_.resize(static_cast<Index>(rows_.size()), n + 1);
    form_.leftCols(n) = solved(columns);
    VectorXd b = g(rows_);
    solve_lower(b);
    form_.col(n) = b + form_.leftCols(n) * a;
    return gram(form_);
}

VectorXd ClosedFactor::solve(const MatrixXd& columns, const VectorXd& a) const {
    if (sparse_) {
        const VectorXd b = a.size() > 0 ? VectorXd(form_.col(0) + columns * a) : VectorXd(form_.col(0));
        return sparse_->solve(b(sparse_->rows()));
    }
    VectorXd forces = form_.col(a.size()) + form_.leftCols(a.size()) * a;
    solve_transposed(forces);
    return forces;
}

void ClosedFactor::solve_lower(VectorXd& x) const {
    const int n = static_cast<int>(rows_.size()), ldl = static_cast<int>(l_.rows()), step = 1;
    if (n > 0) dtrsv_("L", "N", "N", &n, l_.data(), &ldl, x.data(), &step);
}

void ClosedFactor::solve_transposed(VectorXd& x) const {
    const int n = static_cast<int>(rows_.size()), ldl = static_cast<int>(l_.rows()), step = 1;
    if (n > 0) dtrsv_("L", "T", "N", &n, l_.data(), &ldl, x.data(), &step);
}

}  // namespace abut::solver
