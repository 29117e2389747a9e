// SPDX-License-Identifier: GPL-3.0-or-later
// The dissertation's four steps from n parts to n grids and the cells that may come into contact [Grishin10, section 4.5.1,
// Figures 4.7 to 4.9]:
//   1. one uniform grid over the box around all parts,
//   2. the inner, boundary and outer cells of every part,
//   3. for every pair of parts its case, a to e (cell_case.hpp), and the cells that make it,
//   4. the grid split into the boxes of the parts' cells: one grid for every part.
#pragma once
#include <string>

#include "geometry/interfaces/cell_case.hpp"

namespace abut::geometry {

/// Two parts that come together on the grid, and where.
struct ContactCells {
    std::array<int, 2> part{0, 0};  ///< the first is the earlier one
    CaseCells its_case;             ///< case 'a' to 'd'; numbers of the common grid's cells
};

/// The common grid of parts: the outcome of the four steps.
struct CommonGrid {
    UniformGrid grid;                    ///< step 1
    std::vector<CellClasses> parts;      ///< step 2, by part: the cells of the box around it
    std::vector<ContactCells> contacts;  ///< step 3, by parts; pairs that are not listed are case 'e'
    std::vector<CellRange> split;        ///< step 4, by part: the smallest box of all its inner and boundary cells
    std::string refusal;                 ///< why there is no grid, one sentence; empty where there is one
};

/// The most cells that a common grid may have, in the grid or in the boxes around the parts together; more are refused.
inline constexpr int most_common_cells = 4'000'000;

/// Makes step 1 alone: the grid starts at the lower left corner of the box, and covers it but for what lies along a line
/// (along_line_fraction). Its numbers are zero where it would have more than `most_common_cells` cells, where the box is empty
/// or where the cell size is not positive.
UniformGrid uniform_grid(const Box2& box, double cell_size);

/// Makes all four steps. Refused are sizes that are not positive, no parts, and more cells than `most_common_cells`. The case
/// of two parts is that of `cell_case` but for boundaries that rounding puts on either side of a line. Cost O(edges + cells of
/// the boxes around the parts + n log n), n the cells that boundaries pass through, and O(parts^2) comparisons of boxes.
CommonGrid common_grid(const std::vector<const Part*>& parts, double cell_size);

/// The letter of the case of two parts, in either order.
char case_of_parts(const CommonGrid& common, int part1, int part2);

/// One of the n grids of step 4, as `cut_cells` takes it. Empty (no lines) for a part without cells: thinner than
/// `along_line_fraction` cells.
Grid split_grid(const CommonGrid& common, int part);

}  // namespace abut::geometry
