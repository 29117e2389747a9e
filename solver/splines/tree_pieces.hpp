// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of a tree's nodes: the first half of make_tree_space.
#pragma once
#include <utility>
#include <vector>

#include "solver/splines/element_graph.hpp"

namespace abut::solver {

/// A connected component of (node and part).
struct TreePiece {
    int node;
    int parent = -1;   ///< the piece of the node's parent that holds it
    int element = -1;  ///< of leaves
};

/// All pieces of a tree, those of one level after those of the next finer one, and which hang together.
struct TreePieces {
    std::vector<TreePiece> pieces;
    std::vector<std::vector<int>> of_level;  ///< ascending by node
    std::vector<std::vector<int>> beside;    ///< by piece: those of its own level that it shares a side with
    std::vector<std::vector<int>> coarser;   ///< by piece: leaves of coarser levels that it shares a side with
    std::vector<int> of_element;             ///< -1: no material
};

/// Finds the pieces of all nodes. Cost O(nodes log(nodes)).
TreePieces find_pieces(const Quadtree& tree, const ElementGraph& graph);

}  // namespace abut::solver
