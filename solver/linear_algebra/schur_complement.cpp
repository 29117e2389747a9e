// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/schur_complement.hpp"

#include <utility>

#include "src/base/index.hpp"

namespace abut::solver {

namespace {

using Eigen::VectorXd;

/// Calls f(row, column, value) for the entries of the lower triangle.
template <class F>
void for_entries(const SparseSymmetric& m, F f) {
    for (int c = 0; c < m.n; ++c)
        for (int k = m.first[at(c)]; k < m.first[at(c) + 1]; ++k) f(m.row[at(k)], c, m.value[at(k)]);
}

}  // namespace

SchurComplement::SchurComplement(SparseSymmetric matrix, int n_eliminated)
    : matrix_(std::move(matrix)), n_eliminated_(n_eliminated), scale_(VectorXd::Zero(n())) {
    VectorXd mass = VectorXd::Zero(matrix_.n);
    for_entries(matrix_, [&](int r, int c, double v) {
        if (r == c) (r < n() ? scale_[r] : mass[r]) = r < n() ? v : -v;
    });
    for_entries(matrix_, [&](int r, int c, double v) {
        if (r >= n() && c < n()) scale_[c] += v * v / mass[r];
    });
    scale_ = scale_.cwiseSqrt().cwiseInverse();
}

SparseSymmetric SchurComplement::eliminated() const {
    SparseSymmetric m{n_eliminated_, {0}, {}, {}};
    for (int c = n(); c < matrix_.n; ++c) {
        for (int k = matrix_.first[at(c)]; k < matrix_.first[at(c) + 1]; ++k) {
            m.row.push_back(matrix_.row[at(k)] - n());
            m.value.push_back(-matrix_.value[at(k)]);
        }
        m.first.push_back(static_cast<int>(m.row.size()));
    }
    return m;
}

VectorXd SchurComplement::product(const VectorXd& x, const std::function<VectorXd(const VectorXd&)>& solve) const {
    VectorXd y = VectorXd::Zero(n()), coupled = VectorXd::Zero(n_eliminated_);
    for_entries(matrix_, [&](int r, int c, double v) {
        if (c >= n()) return;
        if (r >= n()) {
            coupled[r - n()] += v * x[c];
            return;
        }
        y[r] += v * x[c];
        if (r != c) y[c] += v * x[r];
    });
    const VectorXd p = solve(coupled);
    for_entries(matrix_, [&](int r, int c, double v) {
        if (c < n() && r >= n()) y[c] += v * p[r - n()];
    });
    return y;
}

}  // namespace abut::solver
