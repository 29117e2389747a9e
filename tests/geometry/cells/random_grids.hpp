// SPDX-License-Identifier: GPL-3.0-or-later
// Random grids that go through whatever is special about a part, and the small things that tests of cells share.
#pragma once
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "geometry/brep/monotone.hpp"
#include "geometry/cells/tree_grid.hpp"

namespace abut::geometry::test {

using Corners = std::vector<Vec2>;
using Random = std::mt19937;

inline void add_loop(Part& part, const std::vector<Curve>& curves) {
    part.loops.emplace_back();
    for (const Curve& curve : curves) {
        part.loops.back().edges.push_back(static_cast<int>(part.edges.size()));
        part.edges.push_back({curve, "", ""});
    }
}

inline std::vector<Curve> closed(const Corners& points) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < points.size(); ++i) curves.push_back(Segment{points[i], points[(i + 1) % points.size()]});
    return curves;
}

inline Box2 box_of(const Grid& grid, int cell) {
    return grid.box(cell);
}

inline double area_of(const Box2& b) {
    return b.size().prod();
}

inline int n_cells(const Grid& grid) {
    return grid.n_cells();
}

/// Coordinates where something happens: vertices, extreme points and knots, along one axis.
inline std::vector<double> special_values(const Part& part, int axis) {
    std::vector<double> values;
    for (const MonotonePiece& piece : monotone_pieces(part)) values.push_back(piece.from[axis]);
    return values;
}

/// From box side to box side, exactly on it, beyond it by a sliver, or well beyond; between them, lines through special values,
/// or a sliver of 1e-1 to 1e-14 of the extent beside them, and lines anywhere. No two lines closer than `least_width` of the
/// extent: narrower cells would only test the rounding of their own width. No line farther beyond the box than `most_beyond` of
/// the extent.
struct GridLimits {
    double least_width = 0.02, most_beyond = 1;
};
inline std::vector<double> random_lines(const Part& part, int axis, Random& random, const GridLimits& limits) {
    const Box2 extent = bounding_box(part);
    const double low = extent.min[axis], high = extent.max[axis], size = high - low;
    std::uniform_real_distribution<double> unit(0, 1);
    const auto sliver = [&] { return size * std::pow(10.0, -1 - std::floor(14 * unit(random))); };
    const auto beyond = [&] {
        const double choice = unit(random);
        return choice < 0.4 ? 0.0 : choice < 0.7 ? sliver() : limits.most_beyond * size * unit(random);
    };
    std::vector<double> wanted;
    for (double v : special_values(part, axis)) {
        const double choice = unit(random);
        if (choice < 0.4)
            wanted.push_back(v);
        else if (choice < 0.6)
            wanted.push_back(v + sliver());
        else if (choice < 0.8)
            wanted.push_back(v - sliver());
    }
    std::shuffle(wanted.begin(), wanted.end(), random);
    const int n_free = static_cast<int>(6 * unit(random));
    for (int i = 0; i < n_free; ++i) wanted.push_back(low + size * unit(random));

    std::vector<double> lines{low - beyond(), high + beyond()};
    for (double v : wanted) {
        const bool free =
            std::none_of(lines.begin(), lines.end(), [&](double x) { return std::abs(x - v) < limits.least_width * size; });
        if (free && v > lines[0] && v < lines[1]) lines.push_back(v);
    }
    std::sort(lines.begin(), lines.end());
    return lines;
}

inline Grid random_grid(const Part& part, Random& random, const GridLimits& limits = {}) {
    Grid grid;
    grid.x = random_lines(part, 0, random, limits);
    grid.y = random_lines(part, 1, random, limits);
    return grid;
}

/// A random grid with a tree: every third cell is halved, towards a point of the boundary more of them, at most five times.
inline Grid random_tree(const Part& part, Random& random) {
    const Grid base = random_grid(part, random, {0.1, 0.3});
    const auto edge = std::uniform_int_distribution<std::size_t>(0, part.edges.size() - 1)(random);
    const Vec2 place = point(part.edges[edge].curve, std::uniform_real_distribution<double>(0, 1)(random));
    std::uniform_real_distribution<double> unit(0, 1);
    return tree_grid(part, base, [&](const Box2& cell, int level) {
        return level < 5 && (cell.overlaps({place, place}, 0) || unit(random) < (level < 2 ? 0.3 : 0.05));
    });
}

/// Empty, or what is wrong with classes and fractions taken by themselves.
inline std::string partition_problem(const CutCells& cells) {
    for (int c = 0; c < n_cells(cells.grid); ++c) {
        const CellClass kind = cells.cell_class[static_cast<std::size_t>(c)];
        const double f = cells.fraction[static_cast<std::size_t>(c)];
        const bool fits = kind == CellClass::outer ? f == 0 : kind == CellClass::inner ? f == 1 : f > 0 && f < 1;
        if (!fits) return "cell " + std::to_string(c) + " has fraction " + std::to_string(f);
    }
    return "";
}

/// Empty, or where the pieces fail to cover their edge from 0 to 1, each beginning where the one before it ended.
inline std::string cover_problem(const Part& part, const CutCells& cells) {
    for (std::size_t e = 0; e < part.edges.size(); ++e) {
        double t = 0;
        for (int k = cells.first_piece[e]; k < cells.first_piece[e + 1]; ++k) {
            const BoundaryPiece& piece = cells.pieces[static_cast<std::size_t>(k)];
            if (piece.edge != static_cast<int>(e) || piece.t0 != t || piece.t1 <= t)
                return "edge " + std::to_string(e) + " at " + std::to_string(t);
            t = piece.t1;
        }
        if (t != 1) return "edge " + std::to_string(e) + " ends at " + std::to_string(t);
    }
    return "";
}

/// How far a piece of the boundary may lie outside its cell. Where a grid line cuts off a tip of less than sliver_fraction of a
/// cell, the neighbour takes the piece: with the 16 degrees of the sharpest corner here the tip is at most sqrt(2e-13 / tan 16)
/// = 8e-7 of a cell long, and cells are at most 4 long.
inline constexpr double piece_reach = 1e-5;

/// Empty, or the first piece whose cell is outer or elsewhere.
inline std::string location_problem(const Part& part, const CutCells& cells) {
    for (const BoundaryPiece& piece : cells.pieces) {
        const std::string name = "piece " + std::to_string(piece.edge) + " from " + std::to_string(piece.t0);
        if (piece.cell < 0 || piece.cell >= n_cells(cells.grid)) return name + " has no cell";
        if (cells.cell_class[static_cast<std::size_t>(piece.cell)] == CellClass::outer) return name + " has an outer cell";
        const Vec2 p = point(part.edges[static_cast<std::size_t>(piece.edge)].curve, 0.5 * (piece.t0 + piece.t1));
        if (!box_of(cells.grid, piece.cell).overlaps({p, p}, piece_reach)) return name + " is far from its cell";
    }
    return "";
}

inline double distance_to_boundary(const Part& part, const Vec2& p) {
    double least = 1e300;
    for (const Edge& e : part.edges) least = std::min(least, (point(e.curve, closest_parameter(e.curve, p)) - p).norm());
    return least;
}

}  // namespace abut::geometry::test
