// SPDX-License-Identifier: GPL-3.0-or-later
// Orders of rows that keep a factor small. All of them work on the merged pattern: the two displacement components of a
// function have the same neighbours, and one node for both makes the graph four times smaller.
#pragma once
#include <vector>

#include "solver/linear_algebra/block_matrix.hpp"

namespace abut::solver {

/// Rows of a symmetric matrix in groups (nodes): neighbouring columns whose rows are the same.
struct MergedPattern {
    std::vector<int> first_column;  ///< n_nodes + 1
    std::vector<int> first, row;    ///< lower triangle of the nodes by columns, rows ascending, the diagonal included

    int n_nodes() const { return static_cast<int>(first_column.size()) - 1; }
};
MergedPattern merged_pattern(const SparseSymmetric& matrix);

/// The rows of the matrix in the order of their nodes.
std::vector<int> expanded(const MergedPattern& pattern, const std::vector<int>& node_order);

/// The place of each row in an order.
std::vector<int> inverse_order(const std::vector<int>& order);

/// The neighbours of every node, without itself.
struct Neighbours {
    std::vector<int> first, node;
};
Neighbours neighbours(const MergedPattern& pattern);

/// The order by reverse Cuthill-McKee from a pseudo-peripheral node of each component [George81]: small bandwidth for long and
/// bent parts. Squares are better left in the order of their tensor functions. Cost: a few passes over the pattern.
std::vector<int> reverse_cuthill_mckee(const Neighbours& graph);

/// A bound that no order's bandwidth of the nodes is below: the largest component has no more than twice as many steps from end
/// to end as there are from one of its nodes to the farthest. Cost: one pass.
int least_bandwidth(const Neighbours& graph);

/// The largest distance from the diagonal of an entry of the reordered matrix.
int bandwidth(const SparseSymmetric& matrix, const std::vector<int>& position);

}  // namespace abut::solver
