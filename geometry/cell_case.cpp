// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cell_case.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/monotone.hpp"

namespace abut::geometry {

namespace {

enum class Cell : std::uint8_t { outer, boundary, inner };

/// A boundary this close to a grid line, in cells, runs along it and passes through neither cell.
constexpr double on_the_line = 1e-9;

/// The cells of the common grid around the common part of both boxes; coordinates below are counted in cells from its corner.
struct Window {
    Vec2 corner;
    double cell;
    int columns, rows;
    Vec2 in_cells(const Vec2& p) const { return (p - corner) / cell; }
    bool holds(int column, int row) const { return column >= 0 && column < columns && row >= 0 && row < rows; }
    std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * columns + column); }
};

Window window_of(const Box2& box1, const Box2& box2, double cell) {
    const Vec2 origin = box1.min.cwiseMin(box2.min);
    const Vec2 low = (box1.min.cwiseMax(box2.min) - origin) / cell, high = (box1.max.cwiseMin(box2.max) - origin) / cell;
    const auto first = [](double v) { return static_cast<int>(std::floor(v)) - 2; };  // neighbours of neighbours
    const auto last = [](double v) { return static_cast<int>(std::ceil(v)) + 2; };
    const int i0 = first(low.x()), i1 = last(high.x()), k0 = first(low.y()), k1 = last(high.y());
    return {origin + cell * Vec2(i0, k0), cell, std::max(0, i1 - i0), std::max(0, k1 - k0)};
}

/// Integers strictly between two numbers.
std::vector<double> lines_between(double a, double b) {
    std::vector<double> lines;
    for (double v = std::floor(std::min(a, b)) + 1; v < std::max(a, b); ++v) lines.push_back(v);
    return lines;
}

/// Points where the piece crosses grid lines, with its ends, in the order of travel; in cells.
std::vector<Vec2> walk(const MonotonePiece& piece, const Window& window) {
    const Vec2 from = window.in_cells(piece.from), to = window.in_cells(piece.to);
    std::vector<Vec2> points{from, to};
    for (const double x : lines_between(from.x(), to.x()))
        points.emplace_back(x, (y_at(piece, window.corner.x() + x * window.cell) - window.corner.y()) / window.cell);
    for (const double y : lines_between(from.y(), to.y()))
        points.emplace_back((x_at(piece, window.corner.y() + y * window.cell) - window.corner.x()) / window.cell, y);
    const auto travelled = [&](const Vec2& p) { return (p - from).lpNorm<1>(); };
    std::sort(points.begin(), points.end(), [&](const Vec2& a, const Vec2& b) { return travelled(a) < travelled(b); });
    return points;
}

std::vector<Cell> classify(const Part& part, const Window& window) {
    std::vector<Cell> cells(static_cast<std::size_t>(window.columns * window.rows), Cell::outer);
    Box2 reach;
    reach.extend(window.corner);
    reach.extend(Vec2(window.corner + window.cell * Vec2(window.columns, window.rows)));
    const std::vector<MonotonePiece> pieces = monotone_pieces(part);
    for (const MonotonePiece& piece : pieces) {
        Box2 box;
        box.extend(piece.from);
        box.extend(piece.to);
        if (!box.overlaps(reach, 0)) continue;
        const std::vector<Vec2> points = walk(piece, window);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Vec2 middle = 0.5 * (points[i] + points[i + 1]);
            const Vec2 off_line = (middle - middle.array().round().matrix()).cwiseAbs();
            const int column = static_cast<int>(std::floor(middle.x())), row = static_cast<int>(std::floor(middle.y()));
            if (off_line.minCoeff() > on_the_line && window.holds(column, row))
                cells[window.index(column, row)] = Cell::boundary;
        }
    }
    for (int row = 0; row < window.rows; ++row)
        for (int column = 0; column < window.columns; ++column) {
            Cell& cell = cells[window.index(column, row)];
            const Vec2 center = window.corner + window.cell * Vec2(column + 0.5, row + 0.5);
            if (cell == Cell::outer && contains(pieces, center)) cell = Cell::inner;
        }
    return cells;
}

/// How closely a cell of one part and one of the other, the same or side by side, belong together: the case's letter.
char case_of(Cell one, Cell other, bool same) {
    if (one == Cell::outer || other == Cell::outer) return 'e';
    if (one == Cell::boundary && other == Cell::boundary) return same ? 'a' : 'b';
    return one == Cell::inner && other == Cell::inner ? 'd' : 'c';
}

}  // namespace

char cell_case(const Part& part1, const Part& part2, double cell_size) {
    const Window window = window_of(bounding_box(part1), bounding_box(part2), cell_size);
    char best = 'e';
    if (window.columns == 0 || window.rows == 0) return best;
    const std::vector<Cell> cells1 = classify(part1, window), cells2 = classify(part2, window);
    for (int row = 0; row < window.rows; ++row)
        for (int column = 0; column < window.columns; ++column) {
            const Cell own = cells1[window.index(column, row)];
            const auto compare = [&](int dx, int dy) {
                if (!window.holds(column + dx, row + dy)) return;
                best = std::min(best, case_of(own, cells2[window.index(column + dx, row + dy)], dx == 0 && dy == 0));
            };
            compare(0, 0);
            compare(1, 0);
            compare(-1, 0);
            compare(0, 1);
            compare(0, -1);
        }
    return best;
}

}  // namespace abut::geometry
