// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/blas_threads.hpp"

#include <algorithm>
#include <thread>

// Of OpenBLAS; null where the program runs with another library. Those of other makers have no shared memory between calls.
extern "C" {
int openblas_get_parallel() __attribute__((weak));
void openblas_set_num_threads(int n) __attribute__((weak));
}

namespace abut::solver {

namespace {

/// What openblas_get_parallel() says of a library built with threads of its own, whose memory is then behind a lock.
constexpr int with_pthreads = 1;

}  // namespace

int usable_threads(int wanted) {
    if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
    if (openblas_get_parallel != nullptr && openblas_get_parallel() != with_pthreads) return 1;
    if (wanted > 0) return wanted;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace abut::solver
