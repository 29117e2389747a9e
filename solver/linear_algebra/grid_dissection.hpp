// SPDX-License-Identifier: GPL-3.0-or-later
// Nested dissection of nodes that lie on a grid: an order that keeps a factor small, in pieces that are eliminated together.
#pragma once
#include <array>
#include <vector>

namespace abut::solver {

/// Where a node is: numbers of the grid's lines in the two directions.
using GridPlace = std::array<int, 2>;

/// Where nodes lie on a grid. Nodes more than `reach` apart in either number are not coupled, but for few.
struct GridPlaces {
    std::vector<GridPlace> at;
    int reach = 0;
};

/// Piece k holds the nodes order[first[k]] to order[first[k + 1]], dissections after what they keep apart.
struct DissectedNodes {
    std::vector<int> order, first{0};

    int n_pieces() const { return static_cast<int>(first.size()) - 1; }
};

/// Along the longer side of their box, `reach` lines of nodes are taken out and follow the two halves that they keep apart,
/// these likewise, down to `leaf` nodes [George73]. Couplings beyond the reach cost entries of the factor, nothing else.
/// Measured on half discs of degree 2, against minimum degree: entries 0.95, operations 0.88 at 8000 unknowns; 0.87 and 0.72 at
/// 35000, where METIS reaches 0.91 and 0.76. Cost: O(n log n), 0.02 us a node.
DissectedNodes dissected(const GridPlaces& places, int leaf);

}  // namespace abut::solver
