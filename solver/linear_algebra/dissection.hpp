// SPDX-License-Identifier: GPL-3.0-or-later
// Separators of a graph whose nodes lie on a grid, for elimination by nested dissection [George73].
#pragma once
#include <array>
#include <vector>

#include "solver/linear_algebra/ordering.hpp"

namespace abut::solver {

/// Where a node is: numbers of the grid's lines in the two directions.
using GridPlace = std::array<int, 2>;

/// Cuts the nodes in two at the grid line in their middle that meets the fewest of them, and each half again, until a piece has
/// fewer than `least` nodes. A cut's separator are the nodes from the line on that have neighbours before it, however far: no
/// edge joins the two halves without it. Result, by node: 0 in the pieces that are left, for separators a number that grows
/// from the last cuts to the first: rows of a factor in ascending order. Cost: a pass over the edges for every level of cuts.
std::vector<int> dissect(const Neighbours& graph, const std::vector<GridPlace>& place, int least);

}  // namespace abut::solver
