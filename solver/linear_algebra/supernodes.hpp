// SPDX-License-Identifier: GPL-3.0-or-later
// A factor by supernodes, whoever computed it: P A P' = L S L', S = diag(sign). What every such factor answers is here once;
// CHOLMOD (supernodal_factor.hpp), the fronts (frontal_factor.hpp) and the quasi-definite factor (signed_factor.hpp) differ in
// how L comes about.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>

namespace abut::solver {

/// Neighbouring columns of L that are stored as one dense matrix (rows x width, by columns), the first rows of which are its
/// own columns.
struct Supernode {
    int begin, width, rows;
    const int* row;   ///< (rows) positions, ascending
    int first_value;  ///< of its matrix among the values of L

    int under() const { return rows - width; }
    Eigen::Map<const Eigen::VectorXi> rows_below() const { return {row + width, under()}; }
};

/// Where the numbers of L stand: supernode s has the columns first_column[s] to first_column[s + 1], the rows
/// row[first_row[s]] to row[first_row[s + 1]], and values from first_value[s] on. Views into the structure that it was taken
/// from.
struct SupernodePattern {
    std::span<const int> first_column, first_row, first_value, row;
    std::span<const int> order;  ///< row of the matrix at each position

    int count() const { return first_column.empty() ? 0 : static_cast<int>(first_column.size()) - 1; }
    Supernode operator[](int s) const;
    Eigen::Map<const Eigen::VectorXi> permutation() const { return {order.data(), static_cast<Eigen::Index>(order.size())}; }
};

/// L and what it answers. Right-hand sides and solutions (n x columns) are in the order of the matrix's rows.
struct Supernodes {
    SupernodePattern pattern;
    const double* values;
    const double* sign = nullptr;  ///< (n) by position; null: all 1

    /// Square of the smallest diagonal entry of L, and the row of the matrix that it belongs to.
    double smallest_pivot(int& row) const;
    /// A^-1 b.
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    /// L^-1 P B.
    Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& b) const;
    /// A x.
    Eigen::VectorXd product(const Eigen::VectorXd& x) const;
    /// B' A^-1 B for right-hand sides of few entries, by the forward solution only: every supernode carries the columns of B
    /// that reach it from below and no others, its share of the form is added at once, and its numbers are freed. For the rows
    /// of a contact four to six times faster than solve_lower(). Cost: twice the sum over the supernodes of (entries of L +
    /// columns * width) * columns.
    Eigen::MatrixXd inverse_form(const Eigen::SparseMatrix<double>& b) const;
};

}  // namespace abut::solver
