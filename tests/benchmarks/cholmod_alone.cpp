// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/cholmod_alone.hpp"

#include <cholmod.h>

#include <stdexcept>

#include "tests/benchmarks/one_thread.hpp"

namespace abut::benchmarks {
namespace {

/// Nothing is copied: CHOLMOD only reads it.
cholmod_sparse view(const solver::SparseSymmetric& a) {
    cholmod_sparse s{};
    s.nrow = s.ncol = static_cast<std::size_t>(a.n);
    s.nzmax = a.row.size();
    s.p = const_cast<int*>(a.first.data());
    s.i = const_cast<int*>(a.row.data());
    s.x = const_cast<double*>(a.value.data());
    s.stype = -1;
    s.itype = CHOLMOD_INT;
    s.xtype = CHOLMOD_REAL;
    s.dtype = CHOLMOD_DOUBLE;
    s.sorted = s.packed = 1;
    return s;
}

void choose(cholmod_common& common, CholmodSettings settings) {
    common.print = 0;
    if (settings == CholmodSettings::defaults) return;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
}

}  // namespace

double seconds_of_cholmod(const solver::SparseSymmetric& matrix, CholmodSettings settings) {
    cholmod_common common;
    cholmod_start(&common);
    choose(common, settings);
    cholmod_sparse a = view(matrix);
    cholmod_factor* factor = nullptr;
    const double seconds = thread_seconds_of([&] {
        factor = cholmod_analyze(&a, &common);
        if (factor != nullptr) cholmod_factorize(&a, factor, &common);
    });
    const bool is_factor = factor != nullptr && common.status == CHOLMOD_OK && factor->minor == factor->n;
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
    if (!is_factor) throw std::runtime_error("CHOLMOD: not positive definite");
    return seconds;
}

}  // namespace abut::benchmarks
