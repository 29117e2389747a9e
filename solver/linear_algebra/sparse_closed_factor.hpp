// SPDX-License-Identifier: GPL-3.0-or-later
// Cholesky factor of a sparse compliance among the closed rows.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "solver/linear_algebra/compliance.hpp"
#include "solver/linear_algebra/sparse_cholesky.hpp"

namespace abut::solver {

/// Rows that keep less than this of their own compliance, once the rows before are closed, are redundant: what is left is
/// rounding, or (the splines' own coupling) a hundredth and more.
inline constexpr double redundant_fraction = 1e-11;

/// The factor of C among the closed rows, made anew for every set: in the plane it costs little more than what changes where
/// sets change everywhere a little.
class SparseClosedFactor {
public:
    explicit SparseClosedFactor(Compliance compliance) : compliance_(std::move(compliance)) {}

    /// Rows that the others already close are left out. Cost: a factorisation, and one more for each row left out.
    void move_to(const std::vector<char>& closed);
    const std::vector<Eigen::Index>& rows() const { return rows_; }  ///< ascending, without those left out
    const std::vector<Eigen::Index>& left_out() const { return left_out_; }

    /// [G b]' C^-1 [G b] of the closed rows of columns G (m x n), of which each has few entries, and of a vector b (m).
    Eigen::MatrixXd inverse_form(const Eigen::MatrixXd& columns, const Eigen::VectorXd& b) const;
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;  ///< C^-1 b; rows as in rows()

private:
    Compliance compliance_;
    std::vector<Eigen::Index> rows_, left_out_;
    SparseCholesky factor_;
};

/// The entries of some columns G, and of b after them.
Eigen::SparseMatrix<double> entries_of(const Eigen::MatrixXd& columns, const Eigen::VectorXd& b);

}  // namespace abut::solver
