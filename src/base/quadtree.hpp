// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of a tensor grid, halved in both directions wherever somebody asks for it: which cells there are, and what is beside
// them. Where they lie is a matter of the grid's lines (level_line).
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "src/base/index.hpp"

namespace abut {

/// A cell of the grid whose base cells are halved `level` times in each direction.
struct TreeCell {
    int level, column, row;
};

/// Line `index` of a grid whose intervals are halved `level` times: the same number bit for bit on every level that has it.
inline double level_line(const std::vector<double>& lines, int level, int index) {
    const int base = index >> level, part = index - (base << level);
    if (part == 0) return lines[at(base)];
    return lines[at(base)] + (lines[at(base) + 1] - lines[at(base)]) * std::ldexp(part, -level);
}

/// A quadtree under each cell of a grid. Nodes 0 to columns x rows - 1 are the grid's own cells, row by row; the four children
/// of a node follow each other, x fastest. Leaves are numbered base cell by base cell, a node's children in their order: where
/// nothing is halved, leaves, nodes and cells have the same numbers.
class Quadtree {
public:
    Quadtree(int columns, int rows) : columns_(columns), rows_(rows) {
        for (int r = 0; r < rows; ++r)
            for (int c = 0; c < columns; ++c) nodes_.push_back({{0, c, r}, -1});
    }

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    int n_nodes() const { return static_cast<int>(nodes_.size()); }
    const TreeCell& cell(int node) const { return nodes_[at(node)].cell; }
    bool is_leaf(int node) const { return nodes_[at(node)].first_child < 0; }
    /// The first of the four children; -1: a leaf.
    int first_child(int node) const { return nodes_[at(node)].first_child; }
    int levels() const { return levels_; }  ///< levels below the grid's own

    /// The node that is a cell, or else the leaf that covers it; -1 outside the grid.
    int node_at(const TreeCell& c) const {
        const int column = c.column >> c.level, row = c.row >> c.level;
        if (column < 0 || column >= columns_ || row < 0 || row >= rows_) return -1;
        int node = row * columns_ + column;
        for (int up = c.level - 1; up >= 0 && !is_leaf(node); --up)
            node = first_child(node) + ((c.column >> up) & 1) + 2 * ((c.row >> up) & 1);
        return node;
    }

    /// Halves a leaf. Leaves have no numbers until number_leaves().
    void halve(int node) {
        const TreeCell c = cell(node);
        nodes_[at(node)].first_child = n_nodes();
        for (int k = 0; k < 4; ++k) nodes_.push_back({{c.level + 1, 2 * c.column + k % 2, 2 * c.row + k / 2}, -1});
        levels_ = std::max(levels_, c.level + 1);
    }
    void number_leaves() {
        leaves_.clear();
        leaf_of_.assign(nodes_.size(), -1);
        for (int node = 0; node < columns_ * rows_; ++node) append_leaves(node);
    }

    int n_leaves() const { return static_cast<int>(leaves_.size()); }
    int node_of(int leaf) const { return leaves_[at(leaf)]; }
    int leaf_of(int node) const { return leaf_of_[at(node)]; }  ///< -1: the node has children
    const TreeCell& leaf(int number) const { return cell(node_of(number)); }

    /// Calls f(node) for every leaf across a side of a node; the side is where (dx, dy), a unit step, points to.
    template <class F>
    void for_leaves_across(int node, int dx, int dy, F f) const {
        const TreeCell& c = cell(node);
        const int other = node_at({c.level, c.column + dx, c.row + dy});
        if (other >= 0) for_leaves_at_side(other, -dx, -dy, f);
    }

private:
    struct Node {
        TreeCell cell;
        int first_child;
    };

    void append_leaves(int node) {
        if (is_leaf(node)) {
            leaf_of_[at(node)] = n_leaves();
            leaves_.push_back(node);
            return;
        }
        for (int k = 0; k < 4; ++k) append_leaves(first_child(node) + k);
    }
    /// The leaves of a node along the side where (dx, dy) points to.
    template <class F>
    void for_leaves_at_side(int node, int dx, int dy, F f) const {
        if (is_leaf(node)) return f(node);
        for (int k = 0; k < 4; ++k)
            if ((dx == 0 || k % 2 == (dx > 0)) && (dy == 0 || k / 2 == (dy > 0)))
                for_leaves_at_side(first_child(node) + k, dx, dy, f);
    }

    int columns_, rows_, levels_ = 0;
    std::vector<Node> nodes_;
    std::vector<int> leaves_, leaf_of_;
};

}  // namespace abut
