// SPDX-License-Identifier: GPL-3.0-or-later
// Cholesky factor of a symmetric matrix whose entries lie close to the diagonal (LAPACK).
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "solver/linear_algebra/block_matrix.hpp"

namespace abut::solver {

/// Order of the rows and the bandwidth b that goes with it.
struct Band {
    std::vector<int> order, position;
    int width = 0;  ///< entries below the diagonal of a column

    double entries() const { return (width + 1.0) * static_cast<double>(order.size()); }
};

/// P A P' = L L'. Cost n b^2 to make, 2 n b for each solution; memory n (b + 1) numbers.
class BandedFactor {
public:
    BandedFactor(const SparseSymmetric& matrix, const Band& band);

    int failed_at() const { return failed_at_; }  ///< row of the matrix, -1: none
    double smallest_pivot(int& row) const;        ///< square of the smallest diagonal entry of L

    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& b) const;  ///< L^-1 P B
    Eigen::VectorXd product(const Eigen::VectorXd& x) const;      ///< A x
    /// B' A^-1 B: solve_lower's way with each column from its first row on, 2 b multiplications a row.
    Eigen::MatrixXd inverse_form(const Eigen::SparseMatrix<double>& b) const;

private:
    std::vector<int> order_;
    int n_ = 0, width_ = 0, failed_at_ = -1;
    Eigen::MatrixXd l_;  ///< (b + 1 x n), entry (i, j) of L at (i - j, j)
};

}  // namespace abut::solver
