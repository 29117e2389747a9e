// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/banded_factor.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "solver/linear_algebra/blas.hpp"
#include "solver/linear_algebra/ordering.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Columns of L that are applied to all right-hand sides at once.
constexpr int panel = 64;

/// One panel of a forward solution of the first m columns of y, columns j to j + w of L, w <= max(b, 1). Entries (i, j) of the
/// band are one number less than its leading dimension apart from (i, j + 1), so that pieces of it are ordinary matrices:
///
///     \        triangle of w rows: solved
///     |\ \     rectangle of the rows that all its columns reach: a product
///     |  |     triangle of w - 1 rows below, upper: the last columns only
///      \ |     (below the matrix's end the band holds zeros)
///        \|
void solve_panel(const MatrixXd& l, int j, int w, MatrixXd& y, int m) {
    const int b = static_cast<int>(l.rows()) - 1, n = static_cast<int>(l.cols());
    const int step = std::max(b, 1), ldy = static_cast<int>(y.rows());
    const double one = 1, minus = -1;
    const double* a = &l(0, j);
    dtrsm_("L", "L", "N", "N", &w, &m, &one, a, &step, &y(j, 0), &ldy);
    const int full = std::min(j + b + 1, n) - (j + w);
    if (full > 0) dgemm_("N", "N", &full, &m, &w, &minus, a + w, &step, &y(j, 0), &ldy, &one, &y(j + w, 0), &ldy);
    const int below = std::min(j + b + w, n) - (j + b + 1), last = w - 1;
    if (below <= 0) return;
    MatrixXd part = y.block(j + 1, 0, last, m);
    dtrmm_("L", "U", "N", "N", &last, &m, &one, &l(b, j + 1), &step, part.data(), &last);
    y.block(j + b + 1, 0, below, m) -= part.topRows(below);
}

/// The first row in which some column is not zero; n: none.
Index first_row_of(const MatrixXd& b) {
    for (Index i = 0; i < b.rows(); ++i)
        if ((b.row(i).array() != 0).any()) return i;
    return b.rows();
}

/// The columns of a sparse matrix by where they begin among positions.
struct Staircase {
    std::vector<int> position;       // of each row
    std::vector<int> column, begin;  // in their order; begin: the first position with an entry, n: none
};
Staircase staircase_of(const Eigen::SparseMatrix<double>& b, std::vector<int> position) {
    Staircase stairs{std::move(position), std::vector<int>(static_cast<std::size_t>(b.cols())), {}};
    std::vector<int> begin(stairs.column.size(), static_cast<int>(b.rows()));
    for (int c = 0; c < b.cols(); ++c)
        for (Eigen::SparseMatrix<double>::InnerIterator e(b, c); e; ++e) {
            int& first = begin[static_cast<std::size_t>(c)];
            first = std::min(first, stairs.position[static_cast<std::size_t>(e.row())]);
        }
    const auto begin_of = [&](int c) { return begin[static_cast<std::size_t>(c)]; };
    std::iota(stairs.column.begin(), stairs.column.end(), 0);
    std::stable_sort(stairs.column.begin(), stairs.column.end(), [&](int c, int d) { return begin_of(c) < begin_of(d); });
    std::transform(stairs.column.begin(), stairs.column.end(), std::back_inserter(stairs.begin), begin_of);
    return stairs;
}

}  // namespace

BandedFactor::BandedFactor(const SparseSymmetric& matrix, const Band& band)
    : order_(band.order), n_(matrix.n), width_(band.width), l_(MatrixXd::Zero(band.width + 1, matrix.n)) {
    for (int c = 0; c < n_; ++c)
        for (int k = matrix.first[static_cast<std::size_t>(c)]; k < matrix.first[static_cast<std::size_t>(c) + 1]; ++k) {
            const int i = band.position[static_cast<std::size_t>(c)];
            const int j = band.position[static_cast<std::size_t>(matrix.row[static_cast<std::size_t>(k)])];
            l_(std::abs(i - j), std::min(i, j)) = matrix.value[static_cast<std::size_t>(k)];
        }
    const int rows = width_ + 1;
    int info = 0;
    dpbtrf_("L", &n_, &width_, l_.data(), &rows, &info);
    if (info > 0) failed_at_ = order_[static_cast<std::size_t>(info) - 1];
}

double BandedFactor::smallest_pivot(int& row) const {
    Index at = 0;
    const double least = l_.row(0).minCoeff(&at);
    row = order_[static_cast<std::size_t>(at)];
    return least * least;
}

VectorXd BandedFactor::solve(const VectorXd& b) const {
    VectorXd x = b(order_);
    const int rows = width_ + 1, one = 1;
    int info = 0;
    dpbtrs_("L", &n_, &width_, &one, l_.data(), &rows, x.data(), &n_, &info);
    VectorXd result(n_);
    result(order_) = x;
    return result;
}

MatrixXd BandedFactor::solve_lower(const MatrixXd& b) const {
    MatrixXd y = b(order_, Eigen::all);
    const int w = std::clamp(width_, 1, panel);
    for (int j = static_cast<int>(first_row_of(y)); j < n_; j += w)
        solve_panel(l_, j, std::min(w, n_ - j), y, static_cast<int>(y.cols()));
    return y;
}

MatrixXd BandedFactor::inverse_form(const Eigen::SparseMatrix<double>& b) const {
    const int m = static_cast<int>(b.cols()), w = std::clamp(width_, 1, panel);
    const double one = 1;
    const Staircase stairs = staircase_of(b, inverse_order(order_));
    MatrixXd y = MatrixXd::Zero(n_, m), form = MatrixXd::Zero(m, m);
    for (int k = 0; k < m; ++k)
        for (Eigen::SparseMatrix<double>::InnerIterator e(b, stairs.column[static_cast<std::size_t>(k)]); e; ++e)
            y(stairs.position[static_cast<std::size_t>(e.row())], k) += e.value();
    int begun = 0;
    for (int j = m > 0 ? stairs.begin.front() : n_; j < n_; j += w) {
        const int rows = std::min(w, n_ - j);
        while (begun < m && stairs.begin[static_cast<std::size_t>(begun)] < j + rows) ++begun;
        solve_panel(l_, j, rows, y, begun);
        dsyrk_("L", "T", &begun, &rows, &one, &y(j, 0), &n_, &one, form.data(), &m);
    }
    form.triangularView<Eigen::StrictlyUpper>() = form.transpose();
    return form(inverse_order(stairs.column), inverse_order(stairs.column));
}

VectorXd BandedFactor::product(const VectorXd& x) const {
    VectorXd y = x(order_);
    const int rows = width_ + 1, one = 1;
    dtbmv_("L", "T", "N", &n_, &width_, l_.data(), &rows, y.data(), &one);
    dtbmv_("L", "N", "N", &n_, &width_, l_.data(), &rows, y.data(), &one);
    VectorXd result(n_);
    result(order_) = y;
    return result;
}

}  // namespace abut::solver
