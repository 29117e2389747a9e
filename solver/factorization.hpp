// SPDX-License-Identifier: GPL-3.0-or-later
// Cholesky factorisation of a sparse symmetric positive definite matrix, scaled to a unit diagonal.
#pragma once
#include <Eigen/Core>
#include <memory>

#include "solver/block_matrix.hpp"

namespace abut::solver {

/// P S A S P' = L L', S the inverse root of the diagonal. Move-only. CHOLMOD, supernodal: its simplicial factor would be L D
/// L', and C = Y'Y from Y = solve_lower(B) silently wrong.
class Factorization {
public:
    Factorization();
    explicit Factorization(const SparseSymmetric& matrix);
    Factorization(Factorization&&) noexcept;
    Factorization& operator=(Factorization&&) noexcept;
    ~Factorization();

    /// False: the matrix is not positive definite to working precision; failed_at() tells the row, nothing else may be called.
    bool ok() const;
    int failed_at() const;
    /// Estimate of the condition number of S A S from the factor's diagonal: a lower bound, low by ten
    /// to a hundred times where Nitsche's terms are in the matrix (measured, degrees 2 to 4).
    double condition_estimate() const;

    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    /// Y = L^-1 P S B, so that B' A^-1 B = Y'Y.
    Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& b) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace abut::solver
