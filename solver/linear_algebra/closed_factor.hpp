// SPDX-License-Identifier: GPL-3.0-or-later
// Cholesky factor of the compliance among the closed rows, kept from one active set to the next.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "solver/linear_algebra/sparse_closed_factor.hpp"

namespace abut::solver {

/// P C_cc P' = L L' for the closed rows c. Where C is dense, a new set keeps the factor up to the first row that has left, and
/// continues it with the others. Rows are taken in the order of falling pressure of the start, so that those likely to leave
/// come last. A sparse C is factorised anew (sparse_closed_factor.hpp).
class ClosedFactor {
public:
    /// pressure: by row, of the start.
    ClosedFactor(Compliance compliance, const Eigen::VectorXd& pressure);

    /// False: C is indefinite on the set. Rows that the others already close are left out: where an interface ends on a
    /// support, its pressures can have more coefficients than there are displacements to press on. Cost: a^3 / 3 of a first set
    /// of a rows, a^2 for each row that comes last.
    bool move_to(const std::vector<char>& closed);
    const std::vector<Eigen::Index>& left_out() const { return sparse_ ? sparse_->left_out() : left_out_; }

    /// The closed rows in the factor's order, without those left out.
    const std::vector<Eigen::Index>& rows() const { return sparse_ ? sparse_->rows() : rows_; }

    /// [G b]' C^-1 [G b] of the closed rows, with b = g + G a: of some columns G (m x n), which must be the same ones in every
    /// call, and vectors g (m) and a (n). Cost: that of the rows that are new since the last call.
    Eigen::MatrixXd inverse_form(const Eigen::MatrixXd& columns, const Eigen::VectorXd& g, const Eigen::VectorXd& a);
    /// C^-1 (b + G a) of the closed rows, in their order; columns: those of the last form, whose b it is.
    Eigen::VectorXd solve(const Eigen::MatrixXd& columns, const Eigen::VectorXd& a) const;

    /// L^-1 G of the rows of some columns G (m x n), which must be the same ones in every call; C must be dense.
    auto solved(const Eigen::MatrixXd& columns) {
        solve_new_rows(columns);
        return solved_.topRows(static_cast<Eigen::Index>(rows_.size()));
    }
    /// Solve in place, x = L^-1 x and x = L'^-1 x, with rows as in rows(); C must be dense.
    void solve_lower(Eigen::VectorXd& x) const;
    void solve_transposed(Eigen::VectorXd& x) const;

private:
    void solve_new_rows(const Eigen::MatrixXd& columns);
    bool append(const std::vector<Eigen::Index>& more);
    bool append_all(const std::vector<Eigen::Index>& more);  // false: no row is taken, some pivot is rounding or negative

    Compliance compliance_;
    std::optional<SparseClosedFactor> sparse_;  ///< in place of what follows
    std::vector<Eigen::Index> preferred_;       ///< all rows
    std::vector<Eigen::Index> rows_, left_out_;
    Eigen::MatrixXd solved_;    ///< of `solved`: (m x n)
    std::size_t n_solved_ = 0;  ///< its rows that are up to date
    Eigen::MatrixXd form_;      ///< L^-1 [G b] of the last form; of a sparse C: b of all rows
    Eigen::MatrixXd l_;         ///< (m x m) of which the leading rows().size() are used, the lower triangle
};

}  // namespace abut::solver
