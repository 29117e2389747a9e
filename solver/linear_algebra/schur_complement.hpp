// SPDX-License-Identifier: GPL-3.0-or-later
// Products with K = A + B' M^-1 B, which is full, from the sparse matrix [A B'; B -M].
#pragma once
#include <Eigen/Core>
#include <functional>

#include "solver/linear_algebra/block_matrix.hpp"

namespace abut::solver {

/// The matrix K, which is never made: products with it, and its scale. The last `n_eliminated` rows are those of M.
class SchurComplement {
public:
    SchurComplement(SparseSymmetric matrix, int n_eliminated);

    int n() const { return matrix_.n - n_eliminated_; }
    SparseSymmetric eliminated() const;  ///< M
    /// The product K x; solve(b) gives M^-1 b.
    Eigen::VectorXd product(const Eigen::VectorXd& x,
                            const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve) const;
    /// The inverse root of K's diagonal, M taken for its diagonal in it: off by about the same factor everywhere.
    const Eigen::VectorXd& scale() const { return scale_; }

private:
    SparseSymmetric matrix_;
    int n_eliminated_;
    Eigen::VectorXd scale_;
};

}  // namespace abut::solver
