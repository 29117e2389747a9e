// SPDX-License-Identifier: GPL-3.0-or-later
// Uniform grids and which of their cells a part fills: the inner, boundary and outer cells of the dissertation's contact search
// [Grishin10, section 4.5.1]. Cells for quadrature have another rule, which knows areas: cut_cells.hpp.
#pragma once
#include <vector>

#include "geometry/cells/cut_cells.hpp"

namespace abut::geometry {

/// A grid of square cells, numbered row by row from the lower left.
struct UniformGrid {
    Vec2 corner{0, 0};  ///< lower left
    double cell = 0;    ///< side of a cell
    int columns = 0, rows = 0;
    Vec2 in_cells(const Vec2& p) const { return (p - corner) / cell; }
    Vec2 point(double column, double row) const { return corner + cell * Vec2(column, row); }
    std::size_t n_cells() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

/// A box of a grid's cells.
struct CellRange {
    int column = 0, row = 0;    ///< of its lower left cell
    int columns = 0, rows = 0;  ///< none: 0
    bool holds(int c, int r) const { return c >= column && c < column + columns && r >= row && r < row + rows; }
    std::size_t n_cells() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
    std::size_t index(int c, int r) const {
        return static_cast<std::size_t>(r - row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c - column);
    }
};

/// The classes of the cells of a box, row by row; all other cells are outer ones.
struct CellClasses {
    CellRange box;
    std::vector<CellClass> cell_class;
    CellClass at(int column, int row) const {
        return box.holds(column, row) ? cell_class[box.index(column, row)] : CellClass::outer;
    }
};

/// A boundary this close to a grid line, in cells, runs along it and passes through neither cell.
inline constexpr double along_line_fraction = 1e-9;

/// Classes of the cells of the box: a boundary cell is one whose interior the boundary passes through, an inner cell is any
/// other one with its centre inside. Cost O(edges + cells of the box + n log n), n the crossings of the boundary with the lines
/// inside the box and with the middles of its rows; however long the boundary is outside the box.
CellClasses classify_cells(const Part& part, const UniformGrid& grid, const CellRange& box);

}  // namespace abut::geometry
