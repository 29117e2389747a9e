// SPDX-License-Identifier: GPL-3.0-or-later
// Factor of a sparse symmetric quasi-definite matrix: positive definite in some rows, negative definite in the others. Every
// symmetric permutation of such a matrix has a factor L S L' without pivoting, S the known signs [Vanderbei95]; it costs what a
// Cholesky factor costs.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "solver/linear_algebra/supernodal_factor.hpp"

namespace abut::solver {

/// P A P' = L S L', left-looking by supernodes. The structure is kept.
class SignedFactor {
public:
    /// sign: +1 or -1 by row of the matrix.
    SignedFactor(const SparseSymmetric& matrix, const SupernodalStructure& structure, const std::vector<double>& sign);

    int failed_at() const { return failed_at_; }  ///< row of the matrix whose pivot has the wrong sign, or is none; -1: none
    double smallest_pivot(int& row) const;        ///< square of the smallest diagonal entry of L

    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    Eigen::MatrixXd inverse_form(const Eigen::SparseMatrix<double>& b) const;  ///< B' A^-1 B, see supernodal_form.hpp

private:
    Eigen::MatrixXd permuted(const Eigen::MatrixXd& b) const;
    void solve_lower(Eigen::MatrixXd& x) const;       ///< L^-1 x, in place
    void solve_transposed(Eigen::MatrixXd& x) const;  ///< L'^-1 x

    SupernodalStructure structure_;
    Eigen::VectorXd sign_;  ///< by position
    std::vector<double> values_;
    int failed_at_ = -1;
};

}  // namespace abut::solver
