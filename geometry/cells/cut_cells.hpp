// SPDX-License-Identifier: GPL-3.0-or-later
// A part on its grid: cells inside, outside and cut, and the boundary clipped to cells.
//
// One rule for whatever lies on a grid line: cells are half open, [x_i, x_i+1) x [y_j, y_j+1), so that a boundary that runs
// along a line belongs, as a contour, to the cell on its right or above, where it bounds no area; the cell on its left sees the
// material up to the line through the line's own intervals "just left of it". Vertices and tangencies need no further rule: a
// piece crosses a line if and only if its two ends are on different sides in this sense. Rounding can then only move a contour
// by rounding, never lose a cell. With the material drawn as #:
//
//      edge on a line       vertex on a crossing     touching from the left    touching from the right
//             |                    |  /#                       |                         |
//         ####|                    | /##                    --.|                         |.--
//         #A##|  B            -----v####-----              ####)                         (####
//         ####|                    |\###                    --'|                         |'--
//             |                    | \##                       |                         |
//
//   - The edge up the line is a contour of B, where x - x_left = 0; A has its right side, from where the boundary passes to the
//     right of the line to where it comes back. Edges along horizontal lines have dy = 0 in whatever cell.
//   - v is right of the one line and above the other: the lower edge crosses the horizontal line, in v, and nothing crosses the
//     vertical one. Were the edges on the left, both would cross it, in v: an interval of no length.
//   - An extreme point is an end of two pieces, on the right of the line that it touches. From the left, the boundary crosses
//     to the right and back in one point, an interval of no length; from the right, nothing crosses.
//
// Which of two pieces crosses a line first is known up to rounding of the crossing's other coordinate; where two swap, an
// interval of a rounding is lost or won.
//
// For integrals along the boundary (loads, supports, contact) the cell of a piece is another matter: it is the one that holds
// the point just inside the part; where the part's area in that one is rounding, the nearest of its neighbours that is not
// outer; where all are (a needle), the one of the nearest piece along the boundary.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/brep/part.hpp"
#include "src/base/quadtree.hpp"

namespace abut::geometry {

/// Grid lines in the part's own frame, ascending, at least two each way. With a tree (tree_grid.hpp) its leaves are the cells,
/// and the lines those of its base; columns, rows and cell() are then the base's.
struct Grid {
    std::vector<double> x, y;
    std::shared_ptr<const Quadtree> tree{};

    int columns() const { return static_cast<int>(x.size()) - 1; }
    int rows() const { return static_cast<int>(y.size()) - 1; }
    int n_cells() const { return tree ? tree->n_leaves() : columns() * rows(); }
    int cell(int column, int row) const { return row * columns() + column; }
    int column_of(int cell) const { return cell % columns(); }
    int row_of(int cell) const { return cell / columns(); }
    Box2 box(int cell) const {
        const TreeCell c = tree ? tree->leaf(cell) : TreeCell{0, column_of(cell), row_of(cell)};
        return {{level_line(x, c.level, c.column), level_line(y, c.level, c.row)},
                {level_line(x, c.level, c.column + 1), level_line(y, c.level, c.row + 1)}};
    }
    /// The box of all cells.
    Box2 box() const { return {{x.front(), y.front()}, {x.back(), y.back()}}; }
    /// The cell that holds a point; of points outside the nearest.
    int cell_at(const Vec2& p) const;
    /// Calls f(cell) for every cell that a box overlaps or touches: as they are numbered.
    template <class F>
    void for_cells_in(const Box2& box, F f) const;
    /// Calls f(cell) for every cell across a side of a cell; the side is where (dx, dy), a unit step, points to.
    template <class F>
    void for_cells_across(int cell, int dx, int dy, F f) const;
};

/// Interval [lines[i], lines[i+1]) that holds v: -1 below the first line, size - 1 from the last on.
int interval_of(const std::vector<double>& lines, double v);
/// The interval of v, or the nearest.
int nearest_interval(const std::vector<double>& lines, double v);

enum class CellClass : std::uint8_t { outer, boundary, inner };

/// A cell whose filled fraction is below this (above 1 minus this) counts as outer (inner): the rounding of the fraction.
inline constexpr double sliver_fraction = 1e-13;

/// The piece of an edge inside one cell.
struct BoundaryPiece {
    int edge;
    double t0, t1;
    int cell;  ///< the cell that holds the point just inside the part; never an outer one (-1 where there is no other)
};

enum class CellSide : std::uint8_t { bottom, right, top, left, none };
inline CellSide opposite(CellSide side) {
    return side == CellSide::none ? side : static_cast<CellSide>((static_cast<int>(side) + 2) % 4);
}

/// A piece of the boundary of (cell and part): of an edge, or of the cell's right side (edge = -1, t the y coordinate).
struct ContourPiece {
    int cell;
    int edge;
    double t0, t1;
    /// Sides through which the boundary comes into the cell and leaves it; none: it goes on, to the loop's neighbouring piece.
    CellSide enters = CellSide::none, leaves = CellSide::none;
    /// Ends of a piece of an edge as the walk met them: on grid lines exactly, at corners bit for bit those of the next piece.
    Vec2 from{0, 0}, to{0, 0};
};

/// A part on a grid: the class and filled fraction of every cell, and the boundary by cells, as pieces and as contours.
struct CutCells {
    Grid grid;
    std::vector<CellClass> cell_class;   ///< by cell
    std::vector<double> fraction;        ///< filled fraction by cell
    std::vector<BoundaryPiece> pieces;   ///< by edge, then t
    std::vector<int> first_piece;        ///< n_edges + 1 offsets into pieces
    std::vector<ContourPiece> contours;  ///< of all cells that an edge enters, and of no inner ones besides, by cell
    std::vector<int> first_contour;      ///< n_cells + 1 offsets into contours
    double merge = 0;                    ///< the part's merge length: finding it takes as long as the rest
    double area = 0;                     ///< sum over the cells: equals the part's area where the grid covers it
};

/// Classifies the cells of a grid and clips the part's boundary to them. With a tree the cells of its base are halved as it is,
/// at a cost of what it holds (contours of all levels log(contours of a cell)). Without: cost O(cells + contours log(contours
/// of a grid line)), memory O(cells + contours + edges): a million cells with a hundred thousand segments take 30 ms, with as
/// many cubic splines 0.4 s. The grid must cover the part; where it does not, `area` falls short of the part's.
CutCells cut_cells(const Part& part, const Grid& grid);

/// Fractions, classes, and the area of all cells from their contours; and the cells of the pieces, which are in the order of
/// the walk. The last step of cut_cells.
void finish_cells(CutCells& cells, const Part& part);

/// The class of a cell that is filled to a fraction.
inline CellClass class_by(double fraction) {
    if (fraction < sliver_fraction) return CellClass::outer;
    return fraction > 1 - sliver_fraction ? CellClass::inner : CellClass::boundary;
}

/// The piece of `edge` that holds parameter t.
const BoundaryPiece& piece_at(const CutCells& cells, int edge, double t);

template <class F>
void Grid::for_cells_in(const Box2& wanted, F f) const {
    const auto visit = [&](const auto& self, int node) -> void {
        if (tree->is_leaf(node)) return f(tree->leaf_of(node));
        const TreeCell c = tree->cell(node);
        const Vec2 middle(level_line(x, c.level + 1, 2 * c.column + 1), level_line(y, c.level + 1, 2 * c.row + 1));
        for (int k = 0; k < 4; ++k) {
            const bool right = k % 2 == 1, upper = k / 2 == 1;
            if ((right ? wanted.max.x() >= middle.x() : wanted.min.x() <= middle.x()) &&
                (upper ? wanted.max.y() >= middle.y() : wanted.min.y() <= middle.y()))
                self(self, tree->first_child(node) + k);
        }
    };
    // a box that begins on a line touches the interval before, too
    const auto first = [](const std::vector<double>& lines, double v) {
        const int i = nearest_interval(lines, v);
        return i > 0 && lines[at(i)] >= v ? i - 1 : i;
    };
    const int i0 = first(x, wanted.min.x()), i1 = nearest_interval(x, wanted.max.x());
    const int j0 = first(y, wanted.min.y()), j1 = nearest_interval(y, wanted.max.y());
    for (int j = j0; j <= j1; ++j)
        for (int i = i0; i <= i1; ++i) {
            if (tree)
                visit(visit, cell(i, j));
            else
                f(cell(i, j));
        }
}

template <class F>
void Grid::for_cells_across(int cell_number, int dx, int dy, F f) const {
    if (tree) return tree->for_leaves_across(tree->node_of(cell_number), dx, dy, [&](int node) { f(tree->leaf_of(node)); });
    const int column = column_of(cell_number) + dx, row = row_of(cell_number) + dy;
    if (column >= 0 && column < columns() && row >= 0 && row < rows()) f(cell(column, row));
}

}  // namespace abut::geometry
