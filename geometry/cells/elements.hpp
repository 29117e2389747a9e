// SPDX-License-Identifier: GPL-3.0-or-later
// Elements: the connected components of (cell and part). Where a slot or a crack is thinner than a cell, one cell holds a piece
// of each of its arms, or two cells side by side hold one each with no material on the side that they share; functions that
// live on both must not tie the arms together.
//
//     +-------+-------+        The two cells above: left arm # and right arm @ in one cell, elements 0 and 4 of it; the right
//     |###  @@|@@@@@@@|        cell is one element and neighbours element 4 only. Below: the slot lies on the grid line, both
//     |###  @@|@@@@@@@|        cells are one element each, and not neighbours.
//     +-------+-------+
//     |###### | @@@@@@|
//     |###### | @@@@@@|
//     +-------+-------+
#pragma once
#include <map>
#include <vector>

#include "geometry/cells/cut_cells.hpp"

namespace abut::geometry {

/// The elements of a part on its grid. Elements 0 to n_cells - 1 are the cells themselves, or of cells in several pieces the
/// first one (the largest); the others follow from n_cells on, by cell. A part without slots has no further ones and no entry
/// in `neighbours`.
struct Elements {
    std::vector<double> fraction;    ///< filled fraction of the cell, by element; 0: no material
    std::vector<int> cell_of_extra;  ///< of elements n_cells, n_cells + 1, ...
    /// The elements on the other side of an element's four cell sides, through material; ascending. Only elements for which
    /// these are not simply the four cells around it that hold material have an entry.
    std::map<int, std::vector<int>> neighbours;
    std::vector<int> of_contour;  ///< parallel to CutCells::contours; -1 where it bounds nothing that counts
    std::vector<int> of_piece;    ///< parallel to CutCells::pieces; -1 where the piece has no cell
    int unclear = 0;              ///< cells whose components rounding does not tell apart: taken as one

    int cell_of(int element) const {
        const auto n = fraction.size() - cell_of_extra.size();
        const auto e = static_cast<std::size_t>(element);
        return e < n ? element : cell_of_extra[e - n];
    }
};

/// Finds the elements of all cells, and which of them are neighbours. Components below sliver_fraction of their cell do not
/// count, as for whole cells, nor do cracks whose area inside the cell is below that: the cell is then an inner one. Elements
/// are neighbours where their material on both sides of a side overlaps by more than crossing_fraction of the merge length
/// (cell_strands.hpp). What only passes a corner of a cell as a sliver connects nothing there. A point of the outside that just
/// reaches a cell's side parts the material beside it. Cost O(cells + contours log(contours of a cell)): 10 ms for a million
/// cells with a hundred thousand segments, 30 ms with as many cubic splines; 70 ms where 300 000 of the cells are cut.
Elements find_elements(const Part& part, const CutCells& cells);

/// The element that holds a point of the part (near its boundary, to rounding); for a point outside, the one of its cell (or
/// the cell nearest to it that holds material) whose material is nearest.
int element_at(const Part& part, const CutCells& cells, const Elements& elements, const Vec2& p);

}  // namespace abut::geometry
