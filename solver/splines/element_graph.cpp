// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/splines/element_graph.hpp"

namespace abut::solver {

ElementGraph::ElementGraph(int columns, int rows, const std::vector<double>& fraction, const Splits& splits,
                           const Quadtree* tree)
    : columns_(columns),
      rows_(rows),
      n_cells_(tree ? tree->n_leaves() : columns * rows),
      tree_(tree),
      fraction_(fraction),
      splits_(splits) {
    const int n_cells = n_cells_;
    if (!splits.neighbours.empty() || !splits.cell_of_extra.empty()) special_.assign(static_cast<std::size_t>(n_cells), 0);
    for (const auto& own : splits.neighbours) special_[static_cast<std::size_t>(cell_of(own.first))] = 1;
    for (int cell : splits.cell_of_extra) special_[static_cast<std::size_t>(cell)] = 1;
    if (splits.cell_of_extra.empty()) return;
    first_extra_.assign(static_cast<std::size_t>(n_cells) + 1, 0);
    for (int cell : splits.cell_of_extra) ++first_extra_[static_cast<std::size_t>(cell) + 1];
    for (std::size_t c = 0; c < static_cast<std::size_t>(n_cells); ++c) first_extra_[c + 1] += first_extra_[c];
    std::vector<int> next = first_extra_;
    extra_.resize(splits.cell_of_extra.size());
    for (std::size_t k = 0; k < extra_.size(); ++k)
        extra_[static_cast<std::size_t>(next[static_cast<std::size_t>(splits.cell_of_extra[k])]++)] =
            n_cells + static_cast<int>(k);
}

}  // namespace abut::solver
