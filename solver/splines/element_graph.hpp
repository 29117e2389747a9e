// SPDX-License-Identifier: GPL-3.0-or-later
// Which elements of a grid hang together through the part's material.
#pragma once
#include "solver/splines/spline_space.hpp"

namespace abut::solver {

/// The graph of a grid's elements; keeps references to what it was made from.
class ElementGraph {
public:
    ElementGraph(int columns, int rows, const std::vector<double>& fraction, const Splits& splits,
                 const Quadtree* tree = nullptr);

    int n_elements() const { return static_cast<int>(fraction_.size()); }
    int cell_of(int element) const {
        return element < n_cells_ ? element : splits_.cell_of_extra[static_cast<std::size_t>(element - n_cells_)];
    }
    bool has_material(int element) const { return fraction_[static_cast<std::size_t>(element)] > 0; }
    /// Does a cell hold material in one piece that hangs together with all cells around it that do, too?
    bool is_plain(int cell) const {
        return has_material(cell) && (special_.empty() || !special_[static_cast<std::size_t>(cell)]);
    }
    /// Calls f(element) for the components of a cell that hold material.
    template <class F>
    void for_elements_of(int cell, F f) const {
        if (has_material(cell)) f(cell);
        for (int k = first_extra(cell); k < first_extra(cell + 1); ++k) f(extra_[static_cast<std::size_t>(k)]);
    }
    /// Calls f(element) for the neighbours through the four sides.
    template <class F>
    void for_neighbours(int element, F f) const {
        const auto own = splits_.neighbours.empty() ? splits_.neighbours.end() : splits_.neighbours.find(element);
        if (own != splits_.neighbours.end()) {
            for (int other : own->second) f(other);
            return;
        }
        if (tree_) return for_leaves_around(element, f);
        const int cell = cell_of(element), c = cell % columns_, r = cell / columns_;
        if (r > 0 && has_material(cell - columns_)) f(cell - columns_);
        if (c > 0 && has_material(cell - 1)) f(cell - 1);
        if (c + 1 < columns_ && has_material(cell + 1)) f(cell + 1);
        if (r + 1 < rows_ && has_material(cell + columns_)) f(cell + columns_);
    }

private:
    int first_extra(int cell) const { return first_extra_.empty() ? 0 : first_extra_[static_cast<std::size_t>(cell)]; }

    template <class F>
    void for_leaves_around(int element, F f) const {
        const int node = tree_->node_of(cell_of(element));
        const auto take = [&](int other) {
            if (const int leaf = tree_->leaf_of(other); has_material(leaf)) f(leaf);
        };
        tree_->for_leaves_across(node, 0, -1, take);
        tree_->for_leaves_across(node, -1, 0, take);
        tree_->for_leaves_across(node, 1, 0, take);
        tree_->for_leaves_across(node, 0, 1, take);
    }

    int columns_, rows_, n_cells_;
    const Quadtree* tree_;
    const std::vector<double>& fraction_;
    const Splits& splits_;
    std::vector<int> first_extra_, extra_;  // by cell; empty without splits
    std::vector<char> special_;             // by cell: split, or with neighbours of its own; empty without any
};

}  // namespace abut::solver
