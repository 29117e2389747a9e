// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/one_thread.hpp"

#include <time.h>

extern "C" {
void openblas_set_num_threads(int n) __attribute__((weak));
void omp_set_num_threads(int n) __attribute__((weak));
void omp_set_max_active_levels(int levels) __attribute__((weak));
}

namespace abut::benchmarks {

void use_one_thread() {
    if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
    if (omp_set_num_threads != nullptr) omp_set_num_threads(1);
    if (omp_set_max_active_levels != nullptr) omp_set_max_active_levels(0);
}

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace abut::benchmarks
