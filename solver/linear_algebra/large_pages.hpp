// SPDX-License-Identifier: GPL-3.0-or-later
// Room for many numbers, in large pages of memory where the system gives them: the first touch of ordinary ones took a fifth of
// the time of a factorisation (65 MB, 15000 pages).
#pragma once
#include <cstddef>
#include <memory>

namespace abut::solver {

struct GiveBack {
    std::size_t bytes = 0;  ///< mapped; 0: from the heap
    void operator()(double* numbers) const;
};
using Numbers = std::unique_ptr<double[], GiveBack>;

/// Room for n numbers, all zero.
Numbers zeros(std::size_t n);
/// Room for n numbers that have to be written before they are read.
Numbers unset(std::size_t n);

}  // namespace abut::solver
