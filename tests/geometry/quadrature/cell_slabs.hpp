// SPDX-License-Identifier: GPL-3.0-or-later
// The components of (cell and part) without any walk along the boundary: the cell in horizontal slabs, between whose bounds no
// piece of the boundary ends or passes a side of the cell. In each slab the material is intervals; two of slabs one above the
// other are connected where they overlap. Made for tests: O(pieces) for each slab of each cell.
#pragma once
#include <map>
#include <numeric>

#include "geometry/curves/gauss.hpp"
#include "tests/geometry/cells/random_grids.hpp"

namespace abut::geometry::test {

/// Material between two pieces (or sides of the cell), over one slab.
struct SlabInterval {
    std::size_t slab;
    int left, right;                              ///< pieces
    double low_from, low_to, high_from, high_to;  ///< x at the slab's bounds
    double area;
    int component = -1;
};

struct SlabbedCell {
    std::vector<MonotonePiece> pieces;  ///< at the cell's height
    std::vector<double> bounds;
    std::vector<SlabInterval> intervals;
    std::vector<double> fraction;  ///< by component, of the cell
};

inline double x_on(const MonotonePiece& piece, double y) {
    return x_at(piece, std::clamp(y, std::min(piece.from.y(), piece.to.y()), std::max(piece.from.y(), piece.to.y())));
}

inline std::vector<double> slab_bounds(const std::vector<MonotonePiece>& pieces, const Box2& cell) {
    std::vector<double> ys{cell.min.y(), cell.max.y()};
    for (const MonotonePiece& piece : pieces) {
        ys.push_back(piece.from.y());
        for (double x : {cell.min.x(), cell.max.x()})
            if ((piece.from.x() < x) != (piece.to.x() < x) && piece.from.y() != piece.to.y()) ys.push_back(y_at(piece, x));
    }
    std::erase_if(ys, [&](double y) { return y < cell.min.y() || y > cell.max.y(); });
    std::sort(ys.begin(), ys.end());
    ys.erase(std::unique(ys.begin(), ys.end()), ys.end());
    return ys;
}

/// What is between two bounds, wherever it is.
inline void append_intervals(SlabbedCell& slabs, const std::vector<MonotonePiece>& pieces, const Box2& cell, std::size_t slab) {
    const double low = slabs.bounds[slab], high = slabs.bounds[slab + 1], middle = 0.5 * (low + high);
    struct Wall {
        double x;
        int piece, turn;
    };
    std::vector<Wall> walls;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const double a = pieces[k].from.y(), b = pieces[k].to.y();
        if (std::min(a, b) <= low && std::max(a, b) >= high && a != b)
            walls.push_back({x_on(pieces[k], middle), static_cast<int>(k), b < a ? 1 : -1});  // material right of downward ones
    }
    std::stable_sort(walls.begin(), walls.end(), [](const Wall& a, const Wall& b) { return a.x < b.x; });
    const auto x = [&](int piece, double y) {
        return std::clamp(x_on(pieces[static_cast<std::size_t>(piece)], y), cell.min.x(), cell.max.x());
    };
    int winding = 0;
    for (std::size_t w = 0; w + 1 < walls.size(); ++w) {
        winding += walls[w].turn;
        if (winding <= 0) continue;
        const int p = walls[w].piece, q = walls[w + 1].piece;
        const auto width = [&](double y) { return x(q, y) - x(p, y); };
        const GaussRule& gauss = gauss_rule(12);
        double area = 0;
        for (std::size_t i = 0; i < gauss.points.size(); ++i)
            area += gauss.weights[i] * (high - low) * width(low + gauss.points[i] * (high - low));
        if (width(middle) > 0) slabs.intervals.push_back({slab, p, q, x(p, low), x(q, low), x(p, high), x(q, high), area});
    }
}

/// rounding: intervals that overlap by no more are not connected.
inline SlabbedCell slabbed_cell(const std::vector<MonotonePiece>& all, const Box2& cell, double rounding) {
    SlabbedCell slabs;
    std::vector<MonotonePiece>& pieces = slabs.pieces;
    for (const MonotonePiece& p : all)
        if (std::min(p.from.y(), p.to.y()) <= cell.max.y() && std::max(p.from.y(), p.to.y()) >= cell.min.y())
            pieces.push_back(p);
    slabs.bounds = slab_bounds(pieces, cell);
    for (std::size_t s = 0; s + 1 < slabs.bounds.size(); ++s) append_intervals(slabs, pieces, cell, s);
    std::vector<std::size_t> root(slabs.intervals.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](std::size_t k) {
        while (root[k] != k) k = root[k];
        return k;
    };
    for (std::size_t a = 0; a < root.size(); ++a)
        for (std::size_t b = a + 1; b < root.size() && slabs.intervals[b].slab <= slabs.intervals[a].slab + 1; ++b) {
            const SlabInterval &i = slabs.intervals[a], &j = slabs.intervals[b];
            if (j.slab == i.slab + 1 && std::min(i.high_to, j.low_to) - std::max(i.high_from, j.low_from) > rounding)
                root[find(b)] = find(a);
        }
    std::map<std::size_t, int> number;
    for (std::size_t k = 0; k < root.size(); ++k) {
        const int component = number.try_emplace(find(k), static_cast<int>(number.size())).first->second;
        slabs.intervals[k].component = component;
        slabs.fraction.resize(number.size(), 0.0);
        slabs.fraction[static_cast<std::size_t>(component)] += slabs.intervals[k].area / area_of(cell);
    }
    return slabs;
}

/// Component whose material holds p, but for rounding; -1 if none.
inline int component_at(const SlabbedCell& slabs, const Vec2& p) {
    const std::vector<MonotonePiece>& pieces = slabs.pieces;
    for (const SlabInterval& i : slabs.intervals)
        if (p.y() >= slabs.bounds[i.slab] && p.y() <= slabs.bounds[i.slab + 1] &&
            p.x() >= x_on(pieces[static_cast<std::size_t>(i.left)], p.y()) &&
            p.x() <= x_on(pieces[static_cast<std::size_t>(i.right)], p.y()))
            return i.component;
    return -1;
}

}  // namespace abut::geometry::test
