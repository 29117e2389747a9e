// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/interfaces/cell_case.hpp"

#include <algorithm>
#include <cmath>

namespace abut::geometry {

namespace {

/// The cells of the common grid around the common part of both boxes.
UniformGrid window_of(const Box2& box1, const Box2& box2, double cell) {
    const Vec2 origin = box1.min.cwiseMin(box2.min);
    const Vec2 low = (box1.min.cwiseMax(box2.min) - origin) / cell, high = (box1.max.cwiseMin(box2.max) - origin) / cell;
    const auto first = [](double v) { return std::floor(v) - 2; };  // neighbours of neighbours
    const auto last = [](double v) { return std::ceil(v) + 2; };
    const double i0 = first(low.x()), i1 = last(high.x()), k0 = first(low.y()), k1 = last(high.y());
    return {origin + cell * Vec2(i0, k0), cell, static_cast<int>(std::max(0.0, i1 - i0)),
            static_cast<int>(std::max(0.0, k1 - k0))};
}

/// How closely a cell of one part and one of the other, the same or side by side, belong together: the case's letter.
char case_of(CellClass one, CellClass other, bool same) {
    if (one == CellClass::outer || other == CellClass::outer) return 'e';
    if (one == CellClass::boundary && other == CellClass::boundary) return same ? 'a' : 'b';
    return one == CellClass::inner && other == CellClass::inner ? 'd' : 'c';
}

void sort_out(std::vector<int>& cells) {
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
}

/// Keeps the pair of cells if its case is as good as those so far, and drops those if it is better.
void take(char letter, int cell1, int cell2, CaseCells& best) {
    if (letter == 'e' || letter > best.letter) return;
    if (letter < best.letter) best = {letter, {}};
    best.cells[0].push_back(cell1);
    best.cells[1].push_back(cell2);
}

/// Tells visit(letter, cell1, cell2) of every pair of cells, the same or side by side, in which the first part has material.
template <class Visit>
void for_pairs(const CellClasses& part1, const CellClasses& part2, int grid_columns, Visit visit) {
    constexpr std::array<std::array<int, 2>, 5> beside{{{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    const CellRange &box1 = part1.box, &box2 = part2.box;
    const int first_column = std::max(box1.column, box2.column - 1), first_row = std::max(box1.row, box2.row - 1);
    const int end_column = std::min(box1.column + box1.columns, box2.column + box2.columns + 1);
    const int end_row = std::min(box1.row + box1.rows, box2.row + box2.rows + 1);
    for (int row = first_row; row < end_row; ++row)
        for (int column = first_column; column < end_column; ++column) {
            const CellClass own = part1.at(column, row);
            if (own == CellClass::outer) continue;
            for (const auto& [dx, dy] : beside)
                visit(case_of(own, part2.at(column + dx, row + dy), dx == 0 && dy == 0), row * grid_columns + column,
                      (row + dy) * grid_columns + column + dx);
        }
}

}  // namespace

CaseCells case_cells(const CellClasses& part1, const CellClasses& part2, int grid_columns) {
    CaseCells best;
    for_pairs(part1, part2, grid_columns, [&](char letter, int cell1, int cell2) { take(letter, cell1, cell2, best); });
    for (std::vector<int>& cells : best.cells) sort_out(cells);
    return best;
}

std::vector<int> cells_beside(const CellClasses& part1, const CellClasses& part2, int grid_columns) {
    std::vector<int> cells;
    for_pairs(part1, part2, grid_columns, [&](char letter, int cell1, int) {
        if (letter != 'e') cells.push_back(cell1);
    });
    sort_out(cells);
    return cells;
}

char cell_case(const Part& part1, const Part& part2, double cell_size) {
    const UniformGrid window = window_of(bounding_box(part1), bounding_box(part2), cell_size);
    if (window.columns == 0 || window.rows == 0) return 'e';
    const CellRange all{0, 0, window.columns, window.rows};
    return case_cells(classify_cells(part1, window, all), classify_cells(part2, window, all), window.columns).letter;
}

}  // namespace abut::geometry
