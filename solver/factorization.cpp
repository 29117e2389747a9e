// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/factorization.hpp"

#include <cholmod.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace abut::solver {

struct Factorization::Data {
    cholmod_common common;
    cholmod_factor* factor = nullptr;
    Eigen::VectorXd scale;
    int failed_at = -1;

    Data() {
        cholmod_start(&common);
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.final_ll = 1;
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_AMD;
        common.postorder = 1;
        common.print = 0;
        common.quick_return_if_not_posdef = 1;
    }
    Data(const Data&) = delete;
    Data& operator=(const Data&) = delete;
    ~Data() {
        if (factor != nullptr) cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }
};

namespace {

using Eigen::Index;

Eigen::VectorXd inverse_root_of_diagonal(const SparseSymmetric& m, int& bad_row) {
    Eigen::VectorXd scale(m.n);
    bad_row = -1;
    for (int c = 0; c < m.n; ++c) {
        // lower triangle by columns, rows ascending: the diagonal comes first
        const double d = m.value[static_cast<std::size_t>(m.first[static_cast<std::size_t>(c)])];
        if (!(d > 0) && bad_row < 0) bad_row = c;
        scale[c] = d > 0 ? 1 / std::sqrt(d) : 1;
    }
    return scale;
}

cholmod_dense dense_view(double* values, Index rows, Index columns) {
    cholmod_dense d{};
    d.nrow = static_cast<std::size_t>(rows);
    d.ncol = static_cast<std::size_t>(columns);
    d.nzmax = d.nrow * d.ncol;
    d.d = d.nrow;
    d.x = values;
    d.xtype = CHOLMOD_REAL;
    d.dtype = CHOLMOD_DOUBLE;
    return d;
}

}  // namespace

Factorization::Factorization() = default;
Factorization::Factorization(Factorization&&) noexcept = default;
Factorization& Factorization::operator=(Factorization&&) noexcept = default;
Factorization::~Factorization() = default;

Factorization::Factorization(const SparseSymmetric& matrix) : data_(std::make_unique<Data>()) {
    Data& d = *data_;
    d.scale = inverse_root_of_diagonal(matrix, d.failed_at);
    if (d.failed_at >= 0 || matrix.n == 0) return;
    std::vector<double> scaled(matrix.value);
    for (int c = 0; c < matrix.n; ++c)
        for (int k = matrix.first[static_cast<std::size_t>(c)]; k < matrix.first[static_cast<std::size_t>(c) + 1]; ++k)
            scaled[static_cast<std::size_t>(k)] *= d.scale[c] * d.scale[matrix.row[static_cast<std::size_t>(k)]];

    cholmod_sparse a{};
    a.nrow = a.ncol = static_cast<std::size_t>(matrix.n);
    a.nzmax = matrix.value.size();
    a.p = const_cast<int*>(matrix.first.data());
    a.i = const_cast<int*>(matrix.row.data());
    a.x = scaled.data();
    a.stype = -1;
    a.itype = CHOLMOD_INT;
    a.xtype = CHOLMOD_REAL;
    a.dtype = CHOLMOD_DOUBLE;
    a.sorted = 1;
    a.packed = 1;
    d.factor = cholmod_analyze(&a, &d.common);
    if (d.factor == nullptr) throw std::bad_alloc();
    cholmod_factorize(&a, d.factor, &d.common);
    if (d.common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    if (d.common.status != CHOLMOD_OK || d.factor->minor < d.factor->n) {
        const auto column = std::min(d.factor->minor, d.factor->n - 1);
        d.failed_at = static_cast<int*>(d.factor->Perm)[column];
    }
}

bool Factorization::ok() const {
    return data_ && data_->failed_at < 0;
}
int Factorization::failed_at() const {
    return data_ ? data_->failed_at : -1;
}

double Factorization::condition_estimate() const {
    if (data_->factor == nullptr) return 1;  // of an empty matrix
    return 1 / cholmod_rcond(data_->factor, &data_->common);
}

Eigen::VectorXd Factorization::solve(const Eigen::VectorXd& b) const {
    Eigen::VectorXd scaled = data_->scale.cwiseProduct(b);
    if (b.size() == 0) return scaled;
    cholmod_dense rhs = dense_view(scaled.data(), scaled.size(), 1);
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, data_->factor, &rhs, &data_->common);
    if (x == nullptr) throw std::bad_alloc();
    const Eigen::Map<const Eigen::VectorXd> solution(static_cast<double*>(x->x), b.size());
    Eigen::VectorXd result = data_->scale.cwiseProduct(solution);
    cholmod_free_dense(&x, &data_->common);
    return result;
}

Eigen::MatrixXd Factorization::solve_lower(const Eigen::MatrixXd& b) const {
    Eigen::MatrixXd scaled = data_->scale.asDiagonal() * b;
    if (b.size() == 0) return scaled;
    cholmod_dense rhs = dense_view(scaled.data(), scaled.rows(), scaled.cols());
    cholmod_dense* permuted = cholmod_solve(CHOLMOD_P, data_->factor, &rhs, &data_->common);
    if (permuted == nullptr) throw std::bad_alloc();
    cholmod_dense* y = cholmod_solve(CHOLMOD_L, data_->factor, permuted, &data_->common);
    cholmod_free_dense(&permuted, &data_->common);
    if (y == nullptr) throw std::bad_alloc();
    Eigen::MatrixXd result = Eigen::Map<const Eigen::MatrixXd>(static_cast<double*>(y->x), b.rows(), b.cols());
    cholmod_free_dense(&y, &data_->common);
    return result;
}

}  // namespace abut::solver
