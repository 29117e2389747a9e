// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cells/uniform_cells.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/brep/monotone.hpp"

namespace abut::geometry {

namespace {

/// The box as a grid of its own: coordinates below are counted in cells from its corner.
UniformGrid window_of(const UniformGrid& grid, const CellRange& box) {
    return {grid.point(box.column, box.row), grid.cell, box.columns, box.rows};
}

/// Integers strictly between two numbers, of those from 0 to n.
std::vector<double> lines_between(double a, double b, int n) {
    std::vector<double> lines;
    const double end = std::min(std::max(a, b), n + 0.5);
    for (double v = std::max(std::floor(std::min(a, b)) + 1, 0.0); v < end; ++v) lines.push_back(v);
    return lines;
}

/// Points where the piece crosses the window's lines, with its ends, in the order of travel; in cells.
std::vector<Vec2> walk(const MonotonePiece& piece, const UniformGrid& window) {
    const Vec2 from = window.in_cells(piece.from), to = window.in_cells(piece.to);
    std::vector<Vec2> points{from, to};
    for (const double x : lines_between(from.x(), to.x(), window.columns))
        points.emplace_back(x, (y_at(piece, window.corner.x() + x * window.cell) - window.corner.y()) / window.cell);
    for (const double y : lines_between(from.y(), to.y(), window.rows))
        points.emplace_back((x_at(piece, window.corner.y() + y * window.cell) - window.corner.x()) / window.cell, y);
    const auto travelled = [&](const Vec2& p) { return (p - from).lpNorm<1>(); };
    std::sort(points.begin(), points.end(), [&](const Vec2& a, const Vec2& b) { return travelled(a) < travelled(b); });
    return points;
}

/// Between two crossings the piece is in one cell, that of the middle of their chord.
void mark_boundary(const MonotonePiece& piece, const UniformGrid& window, std::vector<CellClass>& cells) {
    const std::vector<Vec2> points = walk(piece, window);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2 middle = 0.5 * (points[i] + points[i + 1]);
        const Vec2 off_line = (middle - middle.array().round().matrix()).cwiseAbs();
        const bool is_inside = middle.minCoeff() >= 0 && middle.x() < window.columns && middle.y() < window.rows;
        if (!is_inside || off_line.minCoeff() <= along_line_fraction) continue;
        const auto column = static_cast<std::size_t>(middle.x()), row = static_cast<std::size_t>(middle.y());
        cells[row * static_cast<std::size_t>(window.columns) + column] = CellClass::boundary;
    }
}

/// Where the boundary crosses the line through the centres of a row. On its left there is one turn more.
struct RowCrossing {
    int row;
    double x;
    int turn;  ///< +1 upwards, -1 downwards
};

/// Ends count by the half-open rule of `contains`: every vertex once.
void add_crossings(const MonotonePiece& piece, const UniformGrid& window, std::vector<RowCrossing>& crossings) {
    const double low = std::min(piece.from.y(), piece.to.y()), high = std::max(piece.from.y(), piece.to.y());
    const auto row_near = [&](double y) {
        return static_cast<int>(std::clamp(std::floor((y - window.corner.y()) / window.cell), -1.0, window.rows + 0.0));
    };
    const int first = std::max(0, row_near(low) - 1), last = std::min(window.rows - 1, row_near(high) + 1);
    for (int row = first; row <= last; ++row) {
        const double y = window.point(0.5, row + 0.5).y();
        if ((piece.from.y() < y) != (piece.to.y() < y))
            crossings.push_back({row, x_at(piece, y), piece.to.y() > piece.from.y() ? 1 : -1});
    }
}

/// Cells that are not boundary ones are inner where the turns of the crossings on their right add up to more than none.
void fill_inner(std::vector<RowCrossing> crossings, const UniformGrid& window, std::vector<CellClass>& cells) {
    std::sort(crossings.begin(), crossings.end(), [](const RowCrossing& a, const RowCrossing& b) {
        return a.row != b.row ? a.row < b.row : a.x != b.x ? a.x > b.x : a.turn > b.turn;
    });
    std::size_t next = 0;
    for (int row = 0; row < window.rows; ++row) {
        int winding = 0;
        for (int column = window.columns - 1; column >= 0; --column) {
            const double x = window.point(column + 0.5, row + 0.5).x();
            for (; next < crossings.size() && crossings[next].row == row && crossings[next].x > x; ++next)
                winding += crossings[next].turn;
            CellClass& cell = cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(window.columns) +
                                    static_cast<std::size_t>(column)];
            if (cell == CellClass::outer && winding > 0) cell = CellClass::inner;
        }
        while (next < crossings.size() && crossings[next].row == row) ++next;  // those on the left of all centres
    }
}

}  // namespace

CellClasses classify_cells(const Part& part, const UniformGrid& grid, const CellRange& box) {
    CellClasses classes{box, std::vector<CellClass>(box.n_cells(), CellClass::outer)};
    const UniformGrid window = window_of(grid, box);
    Box2 reach;
    reach.extend(window.corner);
    reach.extend(window.point(box.columns, box.rows));
    std::vector<RowCrossing> crossings;
    for (const MonotonePiece& piece : monotone_pieces(part)) {
        Box2 extent;
        extent.extend(piece.from);
        extent.extend(piece.to);
        if (extent.overlaps(reach, 0)) mark_boundary(piece, window, classes.cell_class);
        add_crossings(piece, window, crossings);
    }
    fill_inner(std::move(crossings), window, classes.cell_class);
    return classes;
}

}  // namespace abut::geometry
