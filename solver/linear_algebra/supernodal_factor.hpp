// SPDX-License-Identifier: GPL-3.0-or-later
// Cholesky factor of a sparse symmetric matrix by CHOLMOD.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <span>
#include <vector>

#include "solver/linear_algebra/block_matrix.hpp"
#include "solver/linear_algebra/ordering.hpp"

namespace abut::solver {

/// Columns of a factor in groups: supernode s holds the columns first_column[s] to first_column[s + 1], as a dense matrix by
/// columns whose rows are at row[first_row[s]] to row[first_row[s + 1]] (the first of them its own columns) and whose values
/// begin at first_value[s]. Views into the structure that it was taken from.
struct SupernodePattern {
    std::span<const int> first_column, first_row, first_value, row;
    std::span<const int> order;  ///< row of the matrix at each position
};

/// Order (minimum degree, of the merged pattern) and structure of the factor; immutable, copies share it.
class SupernodalStructure {
public:
    /// separators: by node, as dissect() gives them: nodes come in the order of these numbers, those of one by minimum degree;
    /// empty: none.
    SupernodalStructure(const SparseSymmetric& matrix, const MergedPattern& pattern, std::vector<int> separators = {});
    double entries() const;  ///< stored ones of the factor
    SupernodePattern supernodes() const;

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

    int failed_at() const;                  ///< row of the matrix, -1: none
    double smallest_pivot(int& row) const;  ///< square of the smallest diagonal entry of L

    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& b) const;  ///< L^-1 P B
    Eigen::VectorXd product(const Eigen::VectorXd& x) const;      ///< A x
    /// B' A^-1 B, see supernodal_form.hpp: for the rows of a contact four to six times faster than by solve_lower.
    Eigen::MatrixXd inverse_form(const Eigen::SparseMatrix<double>& b) const;

private:
    struct Data;
    struct Free {
        void operator()(Data*) const;
    };
    std::unique_ptr<Data, Free> data_;
};

}  // namespace abut::solver
