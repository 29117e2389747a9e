// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/keep_heap.hpp"

#include <cstdint>
#include <cstdlib>  // says whose library this is

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace abut {

#ifdef __GLIBC__

namespace {

constexpr int own_mapping = 32 << 20;  // bytes, the most that the library takes
constexpr int kept_heap = 1 << 30;
constexpr int first_heap = 32 << 20, next_heap = 1 << 20;  // addresses: only what is used takes memory
constexpr std::uintptr_t page = 2 << 20;

std::uintptr_t end_of_heap() {
    return reinterpret_cast<std::uintptr_t>(sbrk(0));
}

/// Whole large pages of what the heap has grown by; nothing where another allocator takes its memory elsewhere.
void advise_large_pages(std::uintptr_t begin, std::uintptr_t end) {
    begin = (begin + page - 1) / page * page;
    end = end / page * page;
#ifdef MADV_HUGEPAGE
    if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // else pages are small
#endif
}

}  // namespace

void keep_heap() {
    mallopt(M_MMAP_THRESHOLD, own_mapping);
    mallopt(M_TRIM_THRESHOLD, kept_heap);
    mallopt(M_TOP_PAD, first_heap);
    const std::uintptr_t before = end_of_heap();
    void* volatile grown = std::malloc(page);  // volatile: the compiler would leave out both
    std::free(grown);
    mallopt(M_TOP_PAD, next_heap);
    advise_large_pages(before, end_of_heap());
}

#else

void keep_heap() {}

#endif

}  // namespace abut
