// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cut_cells.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/monotone.hpp"

namespace abut::geometry {

namespace {

/// Where the boundary passes from one side of a vertical grid line to the other. Material lies above a crossing to the right.
struct Crossing {
    double y;
    int turn;  // +1: to the right (material begins above), -1: to the left (material ends)
};

/// One step of the walk along a monotone piece: the point where it enters the next column or row.
struct Step {
    Vec2 at;
    int d_column, d_row;
    double progress;  // from the start of the piece: grows along it, since it is monotone in x and in y
};

struct Walk {
    const Part& part;
    const Grid& grid;
    std::vector<std::vector<Crossing>> crossings;  // by vertical line
    std::vector<ContourPiece> contours;
    std::vector<BoundaryPiece> pieces;
};

template <class At>
void append_steps(std::vector<Step>& steps, const std::vector<double>& lines, double from, double to, const Vec2& start,
                  At at) {
    const int a = interval_of(lines, from), b = interval_of(lines, to);
    for (int i = a; i != b; i += b > a ? 1 : -1) {
        const int line = b > a ? i + 1 : i;
        const auto [p, dc, dr] = at(lines[static_cast<std::size_t>(line)], b > a ? 1 : -1);
        steps.push_back({p, dc, dr, (p - start).cwiseAbs().sum()});
    }
}

std::vector<Step> steps_along(const MonotonePiece& piece, const Grid& grid) {
    struct To {
        Vec2 p;
        int dc, dr;
    };
    std::vector<Step> steps;
    append_steps(steps, grid.x, piece.from.x(), piece.to.x(), piece.from, [&](double x, int d) {
        return To{Vec2(x, y_at(piece, x)), d, 0};
    });
    append_steps(steps, grid.y, piece.from.y(), piece.to.y(), piece.from, [&](double y, int d) {
        return To{Vec2(x_at(piece, y), y), 0, d};
    });
    std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.progress < b.progress; });
    return steps;
}

bool inside(const Grid& grid, int column, int row) {
    return column >= 0 && column < grid.columns() && row >= 0 && row < grid.rows();
}

void walk_piece(Walk& walk, const MonotonePiece& piece) {
    const Curve& curve = walk.part.edges[static_cast<std::size_t>(piece.edge)].curve;
    int column = interval_of(walk.grid.x, piece.from.x()), row = interval_of(walk.grid.y, piece.from.y());
    double t = piece.t0;
    const auto record = [&](double until) {
        if (until <= t) return;
        if (inside(walk.grid, column, row)) walk.contours.push_back({walk.grid.cell(column, row), piece.edge, t, until});
        walk.pieces.push_back({piece.edge, t, until, -1});
        t = until;
    };
    for (const Step& step : steps_along(piece, walk.grid)) {
        record(parameter_at(piece, step.at, curve));
        if (step.d_column != 0) {
            const int line = step.d_column > 0 ? column + 1 : column;
            walk.crossings[static_cast<std::size_t>(line)].push_back({step.at.y(), step.d_column});
        }
        column += step.d_column;
        row += step.d_row;
    }
    record(piece.t1);
}

/// Intervals of one vertical line just left of which there is material, handed out cell side by cell side.
template <class OnSide>
void right_sides(std::vector<Crossing>& crossings, const Grid& grid, OnSide on_side) {
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.y < b.y; });
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += crossings[i].turn;
        const double low = crossings[i].y, high = crossings[i + 1].y;
        if (winding <= 0 || high <= low) continue;
        for (int row = std::max(0, interval_of(grid.y, low)); row < grid.rows(); ++row) {
            const double a = std::max(low, grid.y[static_cast<std::size_t>(row)]);
            const double b = std::min(high, grid.y[static_cast<std::size_t>(row) + 1]);
            if (b > a) on_side(row, a, b);
            if (high <= grid.y[static_cast<std::size_t>(row) + 1]) break;
        }
    }
}

/// Contribution of a contour piece to the area of its cell: the integral of (x - x0) dy, x0 the cell's left side.
double area_share(const Part& part, const Grid& grid, const ContourPiece& c) {
    const double x0 = grid.x[static_cast<std::size_t>(grid.column_of(c.cell))];
    if (c.edge < 0) return (grid.x[static_cast<std::size_t>(grid.column_of(c.cell)) + 1] - x0) * (c.t1 - c.t0);
    const Curve& curve = part.edges[static_cast<std::size_t>(c.edge)].curve;
    const Vec2 a = point(curve, c.t0), b = point(curve, c.t1);
    double share = (0.5 * (a.x() + b.x()) - x0) * (b.y() - a.y());
    if (const auto* arc = std::get_if<Arc>(&curve)) {
        const double half = 0.5 * (c.t1 - c.t0) * arc->sweep;
        share += arc->radius * arc->radius * (half - std::sin(half) * std::cos(half));
    }
    return share;
}

void sort_contours(CutCells& cells, std::size_t n_cells) {
    std::stable_sort(cells.contours.begin(), cells.contours.end(),
                     [](const ContourPiece& a, const ContourPiece& b) { return a.cell < b.cell; });
    cells.first_contour.assign(n_cells + 1, 0);
    for (const ContourPiece& c : cells.contours) ++cells.first_contour[static_cast<std::size_t>(c.cell) + 1];
    for (std::size_t i = 0; i < n_cells; ++i) cells.first_contour[i + 1] += cells.first_contour[i];
}

void classify(CutCells& cells, const Part& part) {
    const Grid& grid = cells.grid;
    for (std::size_t c = 0; c < cells.cell_class.size(); ++c) {
        const auto column = static_cast<std::size_t>(grid.column_of(static_cast<int>(c)));
        const auto row = static_cast<std::size_t>(grid.row_of(static_cast<int>(c)));
        const double full = (grid.x[column + 1] - grid.x[column]) * (grid.y[row + 1] - grid.y[row]);
        double sum = 0;
        for (int k = cells.first_contour[c]; k < cells.first_contour[c + 1]; ++k)
            sum += area_share(part, grid, cells.contours[static_cast<std::size_t>(k)]);
        const double fraction = sum / full;
        if (fraction < sliver_fraction)
            cells.cell_class[c] = CellClass::outer;
        else if (fraction > 1 - sliver_fraction)
            cells.cell_class[c] = CellClass::inner;
        else
            cells.cell_class[c] = CellClass::boundary;
        cells.fraction[c] = cells.cell_class[c] == CellClass::boundary ? fraction : (fraction > 0.5 ? 1.0 : 0.0);
        cells.area += cells.fraction[c] * full;
    }
}

double distance(const Grid& grid, int column, int row, const Vec2& p) {
    const auto i = static_cast<std::size_t>(column), j = static_cast<std::size_t>(row);
    return (p - p.cwiseMax(Vec2(grid.x[i], grid.y[j])).cwiseMin(Vec2(grid.x[i + 1], grid.y[j + 1]))).norm();
}

/// The cell that holds the point just inside the part; where that is an outer one (a tip cut off by a grid line, rounding), the
/// nearest of the cells around it that is not.
int cell_inside(const CutCells& cells, const Curve& curve, double t, double merge) {
    const Grid& grid = cells.grid;
    const Vec2 p = point(curve, t), q = p - merge * outward_normal(curve, t);
    const int column = std::clamp(interval_of(grid.x, q.x()), 0, grid.columns() - 1);
    const int row = std::clamp(interval_of(grid.y, q.y()), 0, grid.rows() - 1);
    int nearest = -1;
    for (int ring = 0; nearest < 0 && ring < std::max(grid.columns(), grid.rows()); ++ring) {
        double least = std::numeric_limits<double>::infinity();
        for (int j = std::max(row - ring, 0); j <= std::min(row + ring, grid.rows() - 1); ++j)
            for (int i = std::max(column - ring, 0); i <= std::min(column + ring, grid.columns() - 1); ++i) {
                const int cell = grid.cell(i, j);
                if (cells.cell_class[static_cast<std::size_t>(cell)] == CellClass::outer) continue;
                const double d = distance(grid, i, j, q);
                if (d < least) {
                    least = d;
                    nearest = cell;
                }
            }
    }
    return nearest;
}

void locate_pieces(CutCells& cells, const Part& part) {
    const double merge = merge_length(part);
    std::stable_sort(cells.pieces.begin(), cells.pieces.end(), [](const BoundaryPiece& a, const BoundaryPiece& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.t0 < b.t0;
    });
    cells.first_piece.assign(part.edges.size() + 1, 0);
    for (BoundaryPiece& piece : cells.pieces) {
        piece.cell =
            cell_inside(cells, part.edges[static_cast<std::size_t>(piece.edge)].curve, 0.5 * (piece.t0 + piece.t1), merge);
        ++cells.first_piece[static_cast<std::size_t>(piece.edge) + 1];
    }
    for (std::size_t e = 0; e < part.edges.size(); ++e) cells.first_piece[e + 1] += cells.first_piece[e];
}

}  // namespace

int interval_of(const std::vector<double>& lines, double v) {
    return static_cast<int>(std::upper_bound(lines.begin(), lines.end(), v) - lines.begin()) - 1;
}

CutCells cut_cells(const Part& part, const Grid& grid) {
    Walk walk{part, grid, std::vector<std::vector<Crossing>>(grid.x.size()), {}, {}};
    for (const MonotonePiece& piece : monotone_pieces(part)) walk_piece(walk, piece);
    for (int line = 1; line <= grid.columns(); ++line)
        right_sides(walk.crossings[static_cast<std::size_t>(line)], grid, [&](int row, double a, double b) {
            walk.contours.push_back({grid.cell(line - 1, row), -1, a, b});
        });

    CutCells cells;
    cells.grid = grid;
    const auto n_cells = static_cast<std::size_t>(grid.columns()) * static_cast<std::size_t>(grid.rows());
    cells.cell_class.assign(n_cells, CellClass::outer);
    cells.fraction.assign(n_cells, 0.0);
    cells.contours = std::move(walk.contours);
    cells.pieces = std::move(walk.pieces);
    sort_contours(cells, n_cells);
    classify(cells, part);
    locate_pieces(cells, part);
    return cells;
}

const BoundaryPiece& piece_at(const CutCells& cells, int edge, double t) {
    const auto begin = cells.pieces.begin() + cells.first_piece[static_cast<std::size_t>(edge)];
    const auto end = cells.pieces.begin() + cells.first_piece[static_cast<std::size_t>(edge) + 1];
    const auto after = std::upper_bound(begin, end, t, [](double v, const BoundaryPiece& p) { return v < p.t0; });
    return after == begin ? *begin : *(after - 1);
}

}  // namespace abut::geometry
