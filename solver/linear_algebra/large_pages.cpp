// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/large_pages.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace abut::solver {

namespace {

constexpr std::size_t page = std::size_t{2} << 20;  // bytes
constexpr std::size_t least_pages = 2;              // below, what is lost to rounding up would count

Numbers mapped(std::size_t n) {
    const std::size_t bytes = (n * sizeof(double) + page - 1) / page * page;
    void* numbers = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (numbers == MAP_FAILED) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    madvise(numbers, bytes, MADV_HUGEPAGE);  // advice: where it is not taken, the pages are small ones
#endif
    return Numbers(static_cast<double*>(numbers), {bytes});
}

Numbers on_heap(void* numbers) {
    if (numbers == nullptr) throw std::bad_alloc();
    return Numbers(static_cast<double*>(numbers), {});
}

}  // namespace

void GiveBack::operator()(double* numbers) const {
    if (bytes > 0)
        munmap(numbers, bytes);
    else
        std::free(numbers);
}

Numbers zeros(std::size_t n) {
    if (n * sizeof(double) >= least_pages * page) return mapped(n);
    return on_heap(std::calloc(std::max<std::size_t>(n, 1), sizeof(double)));
}

Numbers unset(std::size_t n) {
    if (n * sizeof(double) >= least_pages * page) return mapped(n);
    return on_heap(std::malloc(std::max<std::size_t>(n, 1) * sizeof(double)));
}

}  // namespace abut::solver
