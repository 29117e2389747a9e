// SPDX-License-Identifier: GPL-3.0-or-later
// Factor of a sparse symmetric quasi-definite matrix: positive definite in some rows, negative definite in the others. Every
// symmetric permutation of such a matrix has a factor L S L' without pivoting, S the known signs [Vanderbei95]; it costs what a
// Cholesky factor costs.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "solver/linear_algebra/supernodal_factor.hpp"

namespace abut::solver {

/// P A P' = L S L', left-looking by supernodes. The structure is kept.
class SignedFactor {
public:
    /// sign: +1 or -1 by row of the matrix.
    SignedFactor(const SparseSymmetric& matrix, const SupernodalStructure& structure, const std::vector<double>& sign);

    int failed_at() const { return failed_at_; }  ///< row of the matrix whose pivot has the wrong sign, or is none; -1: none
    Supernodes supernodes() const;

private:
    SupernodalStructure structure_;
    Eigen::VectorXd sign_;  ///< by position
    std::vector<double> values_;
    int failed_at_ = -1;
};

}  // namespace abut::solver
