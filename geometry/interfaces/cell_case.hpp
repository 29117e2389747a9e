// SPDX-License-Identifier: GPL-3.0-or-later
// The dissertation's mesh-free contact search [Grishin10, section 4.5.1]: one grid over both parts, and which cells of the two
// come together. For all parts of an assembly at once: common_grid.hpp.
#pragma once
#include <array>

#include "geometry/cells/uniform_cells.hpp"

namespace abut::geometry {

/// Cell size as a fraction of the smaller part's diagonal.
inline constexpr double case_cell_fraction = 1.0 / 20;

/// The case of two parts by their cells on one grid, the first that applies of
///   'a' the parts share boundary cells,
///   'b' a boundary cell of one shares a side with a boundary cell of the other,
///   'c' a boundary cell of one shares a side with, or is, an inner cell of the other,
///   'd' an inner cell of one shares a side with, or is, an inner cell of the other,
///   'e' nothing of the kind.
/// Boundary and inner cells are those of `classify_cells`. The grid starts at the lower left corner of the box around both
/// parts. Only the cells around the common part of both boxes are looked at: the others cannot take part. Cost O(edges + cells
/// looked at).
char cell_case(const Part& part1, const Part& part2, double cell_size);

/// The cells that make the case: the pairs of the case's kind, and none of the later kinds.
struct CaseCells {
    char letter = 'e';
    std::array<std::vector<int>, 2> cells;  ///< of each part: cell numbers, ascending, each once; case 'a': the same twice
};

/// The cells that make the case of two parts, on a grid with so many columns. Cost O(cells in the boxes of both, and one
/// around).
CaseCells case_cells(const CellClasses& part1, const CellClasses& part2, int grid_columns);

/// The cells of the first part, boundary and inner ones, that are, or share a side with, a cell of the second: those of all
/// four kinds, ascending, which is what a contact needs that is of one kind here and of another there.
std::vector<int> cells_beside(const CellClasses& part1, const CellClasses& part2, int grid_columns);

}  // namespace abut::geometry
