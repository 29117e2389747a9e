// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/gauss.hpp"

namespace abut::geometry {

namespace {

/// Angle by which a portion of a curve turns.
double turn(const Curve& curve, double t0, double t1) {
    const auto* arc = std::get_if<Arc>(&curve);
    return arc ? std::abs(arc->sweep) * (t1 - t0) : 0.0;
}

/// The integrand along an arc is a trigonometric polynomial of degree `frequency`: Gauss points needed beyond the straight case
/// so that the patch test on discs holds to 1e-9.
int extra_points(int frequency, double angle) {
    return angle > 0 ? 2 + static_cast<int>(std::ceil(0.5 * frequency * angle)) : 0;
}

void add_row(CellRule& rule, double x0, const Vec2& end, double dy, const GaussRule& inner) {
    const double width = end.x() - x0;
    for (std::size_t k = 0; k < inner.points.size(); ++k) {
        rule.points.emplace_back(x0 + inner.points[k] * width, end.y());
        rule.weights.push_back(inner.weights[k] * width * dy);
    }
}

void add_contour(CellRule& rule, const Part& part, const Grid& grid, const ContourPiece& c, int degree) {
    const auto column = static_cast<std::size_t>(grid.column_of(c.cell));
    const double x0 = grid.x[column];
    const GaussRule& inner = gauss_rule(degree + 1);
    if (c.edge < 0) {
        const GaussRule& outer = gauss_rule(degree + 1);
        for (std::size_t i = 0; i < outer.points.size(); ++i)
            add_row(rule, x0, {grid.x[column + 1], c.t0 + outer.points[i] * (c.t1 - c.t0)}, outer.weights[i] * (c.t1 - c.t0),
                    inner);
        return;
    }
    const Curve& curve = part.edges[static_cast<std::size_t>(c.edge)].curve;
    const int n = std::min(2 * degree + 1 + extra_points(4 * degree + 2, turn(curve, c.t0, c.t1)), 128);
    const GaussRule& outer = gauss_rule(n);
    for (std::size_t i = 0; i < outer.points.size(); ++i) {
        const double t = c.t0 + outer.points[i] * (c.t1 - c.t0);
        const double dy = outer.weights[i] * (c.t1 - c.t0) * derivative(curve, t).y();
        if (dy != 0) add_row(rule, x0, point(curve, t), dy, inner);
    }
}

}  // namespace

std::vector<CellRule> cell_rules(const Part& part, const CutCells& cells, int degree) {
    std::vector<CellRule> rules;
    for (std::size_t c = 0; c < cells.cell_class.size(); ++c) {
        if (cells.cell_class[c] != CellClass::boundary) continue;
        CellRule rule{static_cast<int>(c), {}, {}};
        for (int k = cells.first_contour[c]; k < cells.first_contour[c + 1]; ++k)
            add_contour(rule, part, cells.grid, cells.contours[static_cast<std::size_t>(k)], degree);
        rules.push_back(std::move(rule));
    }
    return rules;
}

std::vector<BoundaryPoint> boundary_rule(const Part& part, const CutCells& cells, int edge, double t0, double t1, int n) {
    std::vector<BoundaryPoint> points;
    const auto e = static_cast<std::size_t>(edge);
    const Curve& curve = part.edges[e].curve;
    for (int k = cells.first_piece[e]; k < cells.first_piece[e + 1]; ++k) {
        const BoundaryPiece& piece = cells.pieces[static_cast<std::size_t>(k)];
        const double a = std::max(t0, piece.t0), b = std::min(t1, piece.t1);
        if (b <= a) continue;
        const GaussRule& rule = gauss_rule(std::min(n + extra_points(2 * n, turn(curve, a, b)), 128));
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            const double t = a + rule.points[i] * (b - a);
            points.push_back({piece.cell, edge, t, point(curve, t), outward_normal(curve, t),
                              rule.weights[i] * (b - a) * derivative(curve, t).norm()});
        }
    }
    return points;
}

}  // namespace abut::geometry
