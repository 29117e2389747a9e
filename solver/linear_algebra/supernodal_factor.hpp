// SPDX-License-Identifier: GPL-3.0-or-later
// Cholesky factor of a sparse symmetric matrix by CHOLMOD.
#pragma once
#include <memory>

#include "solver/linear_algebra/block_matrix.hpp"
#include "solver/linear_algebra/ordering.hpp"
#include "solver/linear_algebra/supernodes.hpp"

namespace abut::solver {

/// Order (minimum degree, of the merged pattern) and structure of the factor; immutable, copies share it.
class SupernodalStructure {
public:
    SupernodalStructure(const SparseSymmetric& matrix, const MergedPattern& pattern);
    double entries() const;  ///< numbers that the factor stores
    SupernodePattern pattern() const;

private:
    friend class SupernodalFactor;
    struct Data;
    std::shared_ptr<const Data> data_;
};

/// P A P' = L L'. Always supernodal: CHOLMOD's simplicial factor would be L D L', and C = Y'Y from Y = solve_lower(B) silently
/// wrong. One thread: CHOLMOD's own would wait for each other actively (half of the time on a busy machine of two cores).
class SupernodalFactor {
public:
    SupernodalFactor(const SparseSymmetric& matrix, const SupernodalStructure& structure);

    int failed_at() const;  ///< row of the matrix, -1: none
    Supernodes supernodes() const;

private:
    struct Data;
    struct Free {
        void operator()(Data*) const;
    };
    std::unique_ptr<Data, Free> data_;
};

}  // namespace abut::solver
