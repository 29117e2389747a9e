// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cells/cut_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/cells/contour_area.hpp"
#include "geometry/cells/grid_walk.hpp"
#include "geometry/cells/tree_grid.hpp"

namespace abut::geometry {

namespace {

/// Items sorted by a key in 0 ... n_keys - 1, those of one key in the order they came in. Returns n_keys + 1 offsets. Linear.
template <class Item, class Key>
std::vector<int> sort_by_counting(std::vector<Item>& items, std::size_t n_keys, Key key) {
    std::vector<int> first(n_keys + 1, 0);
    for (const Item& item : items) ++first[static_cast<std::size_t>(key(item)) + 1];
    for (std::size_t k = 0; k < n_keys; ++k) first[k + 1] += first[k];
    if (std::is_sorted(items.begin(), items.end(), [&](const Item& a, const Item& b) { return key(a) < key(b); })) return first;
    std::vector<Item> sorted(items.size());
    std::vector<int> next = first;
    for (const Item& item : items) sorted[static_cast<std::size_t>(next[static_cast<std::size_t>(key(item))]++)] = item;
    items = std::move(sorted);
    return first;
}

/// Intervals of one vertical line just left of which there is material, handed out cell side by cell side. `begin` to `end`:
/// the line's crossings.
template <class It, class OnSide>
void right_sides(It begin, It end, const Grid& grid, OnSide on_side) {
    std::sort(begin, end, [](const LineCrossing& a, const LineCrossing& b) { return a.y < b.y; });
    int winding = 0;
    for (It it = begin; it != end && it + 1 != end; ++it) {
        winding += it->turn;
        const double low = it->y, high = (it + 1)->y;
        if (winding <= 0 || high <= low) continue;
        for (int row = std::max(0, interval_of(grid.y, low)); row < grid.rows(); ++row) {
            const double a = std::max(low, grid.y[static_cast<std::size_t>(row)]);
            const double b = std::min(high, grid.y[static_cast<std::size_t>(row) + 1]);
            if (b > a) on_side(row, a, b);
            if (high <= grid.y[static_cast<std::size_t>(row) + 1]) break;
        }
    }
}

/// The cells' right sides as contours. A cell that no edge enters has all of its side or nothing of it: full ones become inner
/// cells at once and need no contour, which keeps memory and time of large grids small.
void append_right_sides(CutCells& cells, std::vector<LineCrossing>& crossings) {
    const Grid& grid = cells.grid;
    std::vector<bool> has_edges(cells.cell_class.size(), false);
    for (const ContourPiece& c : cells.contours) has_edges[static_cast<std::size_t>(c.cell)] = true;
    std::erase_if(crossings, [&](const LineCrossing& c) { return c.line < 1 || c.line > grid.columns(); });
    const std::vector<int> first = sort_by_counting(crossings, grid.x.size(), [](const LineCrossing& c) { return c.line; });
    for (int line = 1; line <= grid.columns(); ++line) {
        const auto k = static_cast<std::size_t>(line);
        right_sides(crossings.begin() + first[k], crossings.begin() + first[k + 1], grid, [&](int row, double a, double b) {
            const int cell = grid.cell(line - 1, row);
            const auto c = static_cast<std::size_t>(cell), j = static_cast<std::size_t>(row);
            if (!has_edges[c] && a == grid.y[j] && b == grid.y[j + 1])
                cells.cell_class[c] = CellClass::inner;
            else
                cells.contours.push_back({cell, -1, a, b});
        });
    }
}

/// Sum that loses nothing to the number of terms [Neumaier 1974]: a million equal cells added one by one would drift by 1e-11.
class CompensatedSum {
public:
    void add(double v) {
        const double next = sum_ + v;
        lost_ += std::abs(sum_) >= std::abs(v) ? (sum_ - next) + v : (v - next) + sum_;
        sum_ = next;
    }
    double value() const { return sum_ + lost_; }

private:
    double sum_ = 0, lost_ = 0;
};

void classify(CutCells& cells, const Part& part) {
    CompensatedSum area;
    for (std::size_t c = 0; c < cells.cell_class.size(); ++c) {
        const Box2 box = cells.grid.box(static_cast<int>(c));
        const double full = box.size().x() * box.size().y();
        if (cells.first_contour[c] < cells.first_contour[c + 1]) {
            double sum = 0;
            for (int k = cells.first_contour[c]; k < cells.first_contour[c + 1]; ++k)
                sum += area_share(part, cells.contours[static_cast<std::size_t>(k)], box.min.x(), box.max.x());
            cells.fraction[c] = sum / full;
            cells.cell_class[c] = class_by(cells.fraction[c]);
        }
        if (cells.cell_class[c] != CellClass::boundary) cells.fraction[c] = cells.cell_class[c] == CellClass::inner;
        area.add(cells.fraction[c] * full);
    }
    cells.area = area.value();
}

double distance(const Box2& box, const Vec2& p) {
    return (p - p.cwiseMax(box.min).cwiseMin(box.max)).norm();
}

/// The cell that holds p; where that is an outer one (a tip cut off by a grid line, rounding), the nearest of those around it
/// that is not; -1 where all are.
int cell_near(const CutCells& cells, const Vec2& p) {
    const Grid& grid = cells.grid;
    const auto has_material = [&](int cell) { return cells.cell_class[static_cast<std::size_t>(cell)] != CellClass::outer; };
    const int own = grid.cell_at(p);
    if (has_material(own)) return own;
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    grid.for_cells_in(grid.box(own), [&](int cell) {
        if (!has_material(cell)) return;
        const double away = distance(grid.box(cell), p);
        if (away >= least) return;
        least = away;
        nearest = cell;
    });
    return nearest;
}

/// Pieces without a cell take the one of their nearest neighbour along the boundary that has the same key. Pieces are in the
/// order of the walk.
template <class Key>
void inherit_cells(std::vector<BoundaryPiece>& pieces, Key key) {
    const std::size_t n = pieces.size();
    constexpr std::size_t far = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> distance(n, far);
    std::vector<int> found(n, -1);
    const auto sweep = [&](auto at) {
        std::size_t last = far;  // the number in the sweep, and the piece, that had a cell last
        int cell = -1;
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t i = at(k);
            if (k > 0 && key(pieces[i]) != key(pieces[at(k - 1)])) last = far;
            if (pieces[i].cell >= 0) {
                last = k;
                cell = pieces[i].cell;
            }
            if (last == far || k - last >= distance[i]) continue;
            distance[i] = k - last;
            found[i] = cell;
        }
    };
    sweep([](std::size_t k) { return k; });
    sweep([n](std::size_t k) { return n - 1 - k; });
    for (std::size_t i = 0; i < n; ++i) pieces[i].cell = found[i];
}

/// For needles whose area is a rounding in cell after cell: within their loop, or else (a loop of no area) in the whole part.
void inherit_cells(std::vector<BoundaryPiece>& pieces, const Part& part) {
    const std::vector<int> loop_of = loops_of_edges(part);
    inherit_cells(pieces, [&](const BoundaryPiece& p) { return loop_of[static_cast<std::size_t>(p.edge)]; });
    inherit_cells(pieces, [](const BoundaryPiece&) { return 0; });
}

void locate_pieces(CutCells& cells, const Part& part) {
    cells.merge = merge_length(part);
    bool all_found = true;
    for (BoundaryPiece& piece : cells.pieces) {
        const Curve& curve = part.edges[static_cast<std::size_t>(piece.edge)].curve;
        const double middle = 0.5 * (piece.t0 + piece.t1);
        piece.cell = cell_near(cells, point(curve, middle) - cells.merge * outward_normal(curve, middle));
        all_found = all_found && piece.cell >= 0;
    }
    if (!all_found) inherit_cells(cells.pieces, part);
    cells.first_piece = sort_by_counting(cells.pieces, part.edges.size(), [](const BoundaryPiece& p) { return p.edge; });
}

}  // namespace

int interval_of(const std::vector<double>& lines, double v) {
    return static_cast<int>(std::upper_bound(lines.begin(), lines.end(), v) - lines.begin()) - 1;
}

int nearest_interval(const std::vector<double>& lines, double v) {
    return std::clamp(interval_of(lines, v), 0, static_cast<int>(lines.size()) - 2);
}

int Grid::cell_at(const Vec2& p) const {
    const int base = cell(nearest_interval(x, p.x()), nearest_interval(y, p.y()));
    if (!tree) return base;
    int node = base;
    while (!tree->is_leaf(node)) {
        const TreeCell c = tree->cell(node);
        node = tree->first_child(node) + (p.x() >= level_line(x, c.level + 1, 2 * c.column + 1)) +
               2 * (p.y() >= level_line(y, c.level + 1, 2 * c.row + 1));
    }
    return tree->leaf_of(node);
}

void finish_cells(CutCells& cells, const Part& part) {
    cells.first_contour =
        sort_by_counting(cells.contours, cells.cell_class.size(), [](const ContourPiece& c) { return c.cell; });
    classify(cells, part);
    locate_pieces(cells, part);
}

CutCells cut_cells(const Part& part, const Grid& grid) {
    if (grid.tree) return cut_tree(part, grid);
    GridWalk walk = walk_boundary(part, grid);
    CutCells cells;
    cells.grid = grid;
    const auto n_cells = static_cast<std::size_t>(grid.columns()) * static_cast<std::size_t>(grid.rows());
    cells.cell_class.assign(n_cells, CellClass::outer);
    cells.fraction.assign(n_cells, 0.0);
    cells.contours = std::move(walk.contours);
    cells.pieces = std::move(walk.pieces);
    append_right_sides(cells, walk.crossings);
    finish_cells(cells, part);
    return cells;
}

const BoundaryPiece& piece_at(const CutCells& cells, int edge, double t) {
    const auto begin = cells.pieces.begin() + cells.first_piece[static_cast<std::size_t>(edge)];
    const auto end = cells.pieces.begin() + cells.first_piece[static_cast<std::size_t>(edge) + 1];
    const auto after = std::upper_bound(begin, end, t, [](double v, const BoundaryPiece& p) { return v < p.t0; });
    return after == begin ? *begin : *(after - 1);
}

}  // namespace abut::geometry
