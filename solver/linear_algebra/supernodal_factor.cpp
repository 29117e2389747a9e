// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/supernodal_factor.hpp"

#include <cholmod.h>

#include <limits>
#include <new>

#include "solver/linear_algebra/blas.hpp"
#include "solver/linear_algebra/supernodal_form.hpp"

/// Of the OpenMP library that CHOLMOD was linked with; null where it was built without.
extern "C" void omp_set_max_active_levels(int levels) __attribute__((weak));

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Common {
    cholmod_common settings;

    Common() {
        cholmod_start(&settings);
        settings.supernodal = CHOLMOD_SUPERNODAL;
        settings.final_ll = 1;
        settings.nmethods = 1;
        settings.method[0].ordering = CHOLMOD_GIVEN;
        settings.postorder = 1;
        settings.print = 0;
        settings.quick_return_if_not_posdef = 1;
        // the program uses no OpenMP of its own; a smaller number of threads is overruled by CHOLMOD's own clause
        if (omp_set_max_active_levels != nullptr) omp_set_max_active_levels(0);
    }
    Common(const Common&) = delete;
    Common& operator=(const Common&) = delete;
    ~Common() { cholmod_finish(&settings); }
};

/// A view: nothing is copied, nothing owned. values may be null.
cholmod_sparse sparse_view(int n, const std::vector<int>& first, const std::vector<int>& row, const double* values) {
    cholmod_sparse a{};
    a.nrow = a.ncol = static_cast<std::size_t>(n);
    a.nzmax = row.size();
    a.p = const_cast<int*>(first.data());
    a.i = const_cast<int*>(row.data());
    a.x = const_cast<double*>(values);
    a.stype = -1;
    a.itype = CHOLMOD_INT;
    a.xtype = values != nullptr ? CHOLMOD_REAL : CHOLMOD_PATTERN;
    a.dtype = CHOLMOD_DOUBLE;
    a.sorted = 1;
    a.packed = 1;
    return a;
}

cholmod_dense dense_view(const double* values, Index rows, Index columns) {
    cholmod_dense d{};
    d.nrow = static_cast<std::size_t>(rows);
    d.ncol = static_cast<std::size_t>(columns);
    d.nzmax = d.nrow * d.ncol;
    d.d = d.nrow;
    d.x = const_cast<double*>(values);
    d.xtype = CHOLMOD_REAL;
    d.dtype = CHOLMOD_DOUBLE;
    return d;
}

template <class T>
T* allocated(T* pointer) {
    if (pointer == nullptr) throw std::bad_alloc();
    return pointer;
}

template <class T>
const T* array(void* values) {
    return static_cast<const T*>(values);
}

/// One supernode of L: columns begin to end, a dense matrix of `rows` rows whose numbers are at `row` (the first are its own
/// columns).
struct CholmodSupernode {
    int begin, width, rows;
    const int* row;
    const double* values;
};

template <class F>
void for_supernodes(const cholmod_factor& l, F f) {
    const int *super = array<int>(l.super), *pi = array<int>(l.pi), *px = array<int>(l.px);
    for (std::size_t s = 0; s < l.nsuper; ++s)
        f(CholmodSupernode{super[s], super[s + 1] - super[s], pi[s + 1] - pi[s], array<int>(l.s) + pi[s],
                           array<double>(l.x) + px[s]});
}

SupernodePattern pattern_of(const cholmod_factor& l) {
    return {{array<int>(l.super), l.nsuper + 1},
            {array<int>(l.pi), l.nsuper + 1},
            {array<int>(l.px), l.nsuper + 1},
            {array<int>(l.s), l.ssize},
            {array<int>(l.Perm), l.n}};
}

MatrixXd solved(int system, cholmod_factor* l, cholmod_common& common, const MatrixXd& b) {
    cholmod_dense rhs = dense_view(b.data(), b.rows(), b.cols());
    cholmod_dense* x = allocated(cholmod_solve(system, l, &rhs, &common));
    MatrixXd result = Eigen::Map<const MatrixXd>(array<double>(x->x), b.rows(), b.cols());
    cholmod_free_dense(&x, &common);
    return result;
}

}  // namespace

struct SupernodalStructure::Data {
    mutable Common common;  // CHOLMOD counts its memory there
    cholmod_factor* factor = nullptr;

    ~Data() { cholmod_free_factor(&factor, &common.settings); }
};

SupernodalStructure::SupernodalStructure(const SparseSymmetric& matrix, const MergedPattern& pattern,
                                         std::vector<int> separators) {
    auto data = std::make_shared<Data>();
    data_ = data;
    if (matrix.n == 0) return;
    cholmod_common* common = &data->common.settings;
    std::vector<int> node_order(static_cast<std::size_t>(pattern.n_nodes()));
    cholmod_sparse nodes = sparse_view(pattern.n_nodes(), pattern.first, pattern.row, nullptr);
    const int ordered = separators.empty() ? cholmod_amd(&nodes, nullptr, 0, node_order.data(), common)
                                           : cholmod_camd(&nodes, nullptr, 0, separators.data(), node_order.data(), common);
    if (ordered == 0) throw std::bad_alloc();
    std::vector<int> order = expanded(pattern, node_order);
    cholmod_sparse a = sparse_view(matrix.n, matrix.first, matrix.row, nullptr);
    data->factor = allocated(cholmod_analyze_p(&a, order.data(), nullptr, 0, common));
}

double SupernodalStructure::entries() const {
    return data_->factor != nullptr ? static_cast<double>(data_->factor->xsize) : 0;
}

SupernodePattern SupernodalStructure::supernodes() const {
    if (data_->factor == nullptr) return {};
    return pattern_of(*data_->factor);
}

struct SupernodalFactor::Data {
    Common common;
    cholmod_factor* factor = nullptr;

    int row(int position) const { return array<int>(factor->Perm)[position]; }
    VectorXd permuted(const VectorXd& x) const {
        return x(Eigen::Map<const Eigen::VectorXi>(array<int>(factor->Perm), x.size()));
    }
};

void SupernodalFactor::Free::operator()(Data* data) const {
    cholmod_free_factor(&data->factor, &data->common.settings);
    delete data;
}

SupernodalFactor::SupernodalFactor(const SparseSymmetric& matrix, const SupernodalStructure& structure) : data_(new Data) {
    cholmod_common* common = &data_->common.settings;
    data_->factor = allocated(cholmod_copy_factor(structure.data_->factor, common));
    cholmod_sparse a = sparse_view(matrix.n, matrix.first, matrix.row, matrix.value.data());
    cholmod_factorize(&a, data_->factor, common);
    if (common->status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
}

int SupernodalFactor::failed_at() const {
    const cholmod_factor& l = *data_->factor;
    return l.minor < l.n ? data_->row(static_cast<int>(l.minor)) : -1;
}

double SupernodalFactor::smallest_pivot(int& row) const {
    double least = std::numeric_limits<double>::infinity();
    for_supernodes(*data_->factor, [&](const CholmodSupernode& s) {
        for (int k = 0; k < s.width; ++k) {
            const double pivot = s.values[k * (s.rows + 1)];
            if (pivot >= least) continue;
            least = pivot;
            row = data_->row(s.begin + k);
        }
    });
    return least * least;
}

VectorXd SupernodalFactor::solve(const VectorXd& b) const {
    return solved(CHOLMOD_A, data_->factor, data_->common.settings, b);
}

MatrixXd SupernodalFactor::solve_lower(const MatrixXd& b) const {
    const Eigen::Map<const Eigen::VectorXi> order(array<int>(data_->factor->Perm), b.rows());
    return solved(CHOLMOD_L, data_->factor, data_->common.settings, b(order, Eigen::all));
}

MatrixXd SupernodalFactor::inverse_form(const Eigen::SparseMatrix<double>& b) const {
    return solver::inverse_form(pattern_of(*data_->factor), array<double>(data_->factor->x), nullptr, b);
}

VectorXd SupernodalFactor::product(const VectorXd& x) const {
    const Eigen::Map<const Eigen::VectorXi> order(array<int>(data_->factor->Perm), x.size());
    const VectorXd px = x(order);
    VectorXd y = VectorXd::Zero(x.size()), below, part;
    for_supernodes(*data_->factor, [&](const CholmodSupernode& s) {
        // y += L_s (L_s' x): the whole columns of one supernode, L L' being the sum over all of them
        const Eigen::Map<const Eigen::VectorXi> rows(s.row, s.rows);
        const int one = 1, under = s.rows - s.width;
        const double unit = 1, zero = 0;
        part = px.segment(s.begin, s.width);
        below = px(rows.tail(under));
        dtrmv_("L", "T", "N", &s.width, s.values, &s.rows, part.data(), &one);
        dgemv_("T", &under, &s.width, &unit, s.values + s.width, &s.rows, below.data(), &one, &unit, part.data(), &one);
        dgemv_("N", &under, &s.width, &unit, s.values + s.width, &s.rows, part.data(), &one, &zero, below.data(), &one);
        dtrmv_("L", "N", "N", &s.width, s.values, &s.rows, part.data(), &one);
        y.segment(s.begin, s.width) += part;
        y(rows.tail(under)) += below;
    });
    VectorXd result(x.size());
    result(order) = y;
    return result;
}

}  // namespace abut::solver
