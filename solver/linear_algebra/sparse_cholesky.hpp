// SPDX-License-Identifier: GPL-3.0-or-later
// Cholesky factors of sparse matrices that share a pattern, one after the other.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <optional>

#include "solver/linear_algebra/supernodal_factor.hpp"

namespace abut::solver {

/// P S A S P' = L L' by CHOLMOD, S the inverse root of the diagonal. The analysis is kept for matrices of the same pattern.
class SparseCholesky {
public:
    /// Factorises the matrix, in place of the one before. A row whose pivot is not positive, or less than `least_pivot` of its
    /// diagonal (the others before it leave so little of it), is told, and nothing else may be called; -1: there is none.
    int compute(SparseSymmetric matrix, double least_pivot = 0);

    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    /// B' A^-1 B for columns of few entries.
    Eigen::MatrixXd inverse_form(const Eigen::SparseMatrix<double>& b) const;

private:
    SparseSymmetric pattern_;  ///< without values
    std::optional<SupernodalStructure> structure_;
    Eigen::VectorXd scale_;
    std::shared_ptr<const SupernodalFactor> factor_;
};

}  // namespace abut::solver
