// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetric sparse matrix of 2 x 2 blocks: one block for each pair of functions, rows and columns ordered (function,
// component).
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace abut::solver {

/// Sets of functions, one after the other.
struct FunctionSets {
    std::vector<int> first{0};  ///< size() + 1 offsets
    std::vector<int> function;

    std::size_t size() const { return first.size() - 1; }
    std::span<const int> operator[](std::size_t set) const;
    void add(std::span<const int> functions);
};

/// Blocks of the lower triangle (row >= column); diagonal blocks are stored whole.
struct BlockMatrix {
    int n = 0;                ///< functions; the matrix is 2n x 2n
    std::vector<int> first;   ///< n + 1 offsets by row
    std::vector<int> column;  ///< ascending in each row, up to and with the diagonal
    std::vector<Eigen::Matrix2d> block;

    /// The block of (row, column), row >= column; it must be in the pattern.
    Eigen::Matrix2d& at(int row, int column_index);
};

/// Zero matrix whose pattern couples all functions of each given set. Cost: sum of the sets' sizes squared.
BlockMatrix make_block_matrix(int n, const FunctionSets& coupled);

/// Adds the blocks of sets of functions to a matrix whose pattern couples them. Without a search: each row's columns are looked
/// up in a table of n numbers.
class BlockScatter {
public:
    explicit BlockScatter(BlockMatrix& matrix) : BlockScatter(matrix, 0, matrix.n) {}
    /// A scatter to the rows of functions begin to end only: several, of rows that do not meet, may add at the same time.
    BlockScatter(BlockMatrix& matrix, int begin, int end);

    bool reaches(std::span<const int> functions) const;  ///< has any of them a row here?

    /// Adds blocks, by columns: block (i, j) of functions[i] and functions[j] at j * size + i; those of the upper triangle are
    /// not read. Functions in any order, each once.
    void add(std::span<const int> functions, const std::vector<Eigen::Matrix2d>& blocks);

private:
    bool has(int row) const { return row >= begin_ && row < end_; }

    BlockMatrix& matrix_;
    int begin_, end_;
    std::vector<int> place_;  ///< of a function in the set at hand; -1: not in it
};

/// The product A x (2n), x of size 2n.
Eigen::VectorXd multiply(const BlockMatrix& a, const Eigen::VectorXd& x);

/// Symmetric sparse matrix, lower triangle by columns, rows ascending.
struct SparseSymmetric {
    int n = 0;
    std::vector<int> first, row;
    std::vector<double> value;
};

/// The rows and columns of A whose number[] is not negative, renumbered by it (monotone).
SparseSymmetric restricted(const BlockMatrix& a, const std::vector<int>& number, int n_kept);

}  // namespace abut::solver
