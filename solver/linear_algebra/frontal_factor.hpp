// SPDX-License-Identifier: GPL-3.0-or-later
// Multifrontal Cholesky factor [Liu92].
#pragma once
#include <memory>

#include "solver/linear_algebra/fronts.hpp"
#include "solver/linear_algebra/large_pages.hpp"

namespace abut::solver {

/// P A P' = L L'. From below, each front takes in the updates of those below it, is factorised as a dense matrix, and leaves
/// its own: three calls of BLAS a front, where a left-looking factor makes two for every pair of them.
class FrontalFactor {
public:
    /// Subtrees side by side on `threads` threads at most; the factor is the same to the bit for any number.
    FrontalFactor(const SparseSymmetric& matrix, std::shared_ptr<const Fronts> fronts, int threads = 1);

    int failed_at() const { return failed_at_; }  ///< row of the matrix, -1: none
    Supernodes supernodes() const;

private:
    std::shared_ptr<const Fronts> fronts_;
    Numbers values_;
    int failed_at_ = -1;
};

}  // namespace abut::solver
