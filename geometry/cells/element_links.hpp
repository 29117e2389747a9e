// SPDX-License-Identifier: GPL-3.0-or-later
// Which elements share material across the sides of cells: the second half of find_elements.
#pragma once
#include <map>
#include <vector>

#include "geometry/cells/cell_trace.hpp"

namespace abut::geometry {

/// The stretches of all boundary cells' sides that hold material; SideStretch::component is the element.
struct ElementSides {
    std::vector<SideStretch> stretches;  ///< by cell, side, then ascending
    std::vector<int> boundary_cells;     ///< ascending
    std::vector<int> first;              ///< by boundary cell: offsets into stretches, one more than cells
};

/// Makes Elements::neighbours. n_elements: how many elements each boundary cell has. crossing_length: an overlap of stretches
/// that is no more connects nothing. Cost O(cells + stretches).
std::map<int, std::vector<int>> element_links(const CutCells& cells, const ElementSides& sides,
                                              const std::vector<int>& n_elements, double crossing_length);

}  // namespace abut::geometry
