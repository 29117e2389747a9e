// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/supernodal_factor.hpp"

#include <cholmod.h>

#include <new>
#include <vector>

/// Of the OpenMP library that CHOLMOD was linked with; null where it was built without.
extern "C" void omp_set_max_active_levels(int levels) __attribute__((weak));

namespace abut::solver {

namespace {

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

template <class T>
T* allocated(T* pointer) {
    if (pointer == nullptr) throw std::bad_alloc();
    return pointer;
}

template <class T>
const T* array(void* values) {
    return static_cast<const T*>(values);
}

SupernodePattern pattern_of(const cholmod_factor& l) {
    return {{array<int>(l.super), l.nsuper + 1},
            {array<int>(l.pi), l.nsuper + 1},
            {array<int>(l.px), l.nsuper + 1},
            {array<int>(l.s), l.ssize},
            {array<int>(l.Perm), l.n}};
}

}  // namespace

struct SupernodalStructure::Data {
    mutable Common common;  // CHOLMOD counts its memory there
    cholmod_factor* factor = nullptr;

    ~Data() { cholmod_free_factor(&factor, &common.settings); }
};

SupernodalStructure::SupernodalStructure(const SparseSymmetric& matrix, const MergedPattern& pattern) {
    auto data = std::make_shared<Data>();
    data_ = data;
    if (matrix.n == 0) return;
    cholmod_common* common = &data->common.settings;
    std::vector<int> node_order(static_cast<std::size_t>(pattern.n_nodes()));
    cholmod_sparse nodes = sparse_view(pattern.n_nodes(), pattern.first, pattern.row, nullptr);
    if (cholmod_amd(&nodes, nullptr, 0, node_order.data(), common) == 0) throw std::bad_alloc();
    std::vector<int> order = expanded(pattern, node_order);
    cholmod_sparse a = sparse_view(matrix.n, matrix.first, matrix.row, nullptr);
    data->factor = allocated(cholmod_analyze_p(&a, order.data(), nullptr, 0, common));
}

double SupernodalStructure::entries() const {
    return data_->factor != nullptr ? static_cast<double>(data_->factor->xsize) : 0;
}

SupernodePattern SupernodalStructure::pattern() const {
    if (data_->factor == nullptr) return {};
    return pattern_of(*data_->factor);
}

struct SupernodalFactor::Data {
    Common common;
    cholmod_factor* factor = nullptr;
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
    return l.minor < l.n ? array<int>(l.Perm)[l.minor] : -1;
}

Supernodes SupernodalFactor::supernodes() const {
    return {pattern_of(*data_->factor), array<double>(data_->factor->x)};
}

}  // namespace abut::solver
