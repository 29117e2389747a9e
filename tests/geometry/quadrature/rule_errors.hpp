// SPDX-License-Identifier: GPL-3.0-or-later
// How wrong the rules of a part's cells and edges are, against integrals that owe nothing to them, and what is tolerated.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/curves/gauss.hpp"
#include "tests/geometry/cells/clipped_polygon.hpp"
#include "tests/geometry/quadrature/quadrature_oracles.hpp"

namespace abut::geometry::test {

/// Coordinates of 1 over cells of 0.05: roundings of 2e-15 to the power of 2 x degree <= 8 in each direction.
inline constexpr double straight_tolerance = 1e-12;
/// The header promises exactness on straight edges only; along arcs the Gauss points are chosen for less than this.
inline constexpr double arc_tolerance = 1e-10;

/// Largest error of the moments of a straight part's boundary cells, against each cell cut out of the polygons.
inline double straight_error(const Part& part, const CutCells& cells, const std::vector<CellRule>& rules, int degree) {
    double worst = 0;
    for (const CellRule& rule : rules) {
        const LocalFrame frame = unit_frame(cells.grid, rule.element);
        Moments expected = Moments::Zero(2 * degree + 1, 2 * degree + 1);
        for (const Loop& loop : part.loops) {
            Corners polygon;
            for (int e : loop.edges) polygon.push_back(frame(point(part.edges[static_cast<std::size_t>(e)].curve, 0)));
            const Corners inside = common(polygon, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
            for (std::size_t i = 0; i < inside.size(); ++i)
                expected += segment_moments(inside[i], inside[(i + 1) % inside.size()], 2 * degree);
        }
        worst = std::max(worst, worst_of(rule_moments(rule, frame, 2 * degree) - expected));
    }
    return worst;
}

/// Of any part, about its centre and in units of half its size: the boundary cells' rules, with full products of inner cells,
/// against the part's own edges.
inline double whole_error(const Part& part, const CutCells& cells, const std::vector<CellRule>& rules, int degree) {
    const Box2 extent = bounding_box(part);
    const LocalFrame frame{extent.center(), Vec2::Constant(0.5 * extent.size().maxCoeff())};
    Moments sum = -part_moments(part, frame, 2 * degree);
    for (const CellRule& rule : rules) sum += rule_moments(rule, frame, 2 * degree);
    for (std::size_t c = 0; c < cells.cell_class.size(); ++c) {
        if (cells.cell_class[c] != CellClass::inner) continue;
        const Box2 b = box_of(cells.grid, static_cast<int>(c));
        const Vec2 low = frame(b.min), high = frame(b.max);
        sum += segment_moments({high.x(), low.y()}, high, 2 * degree) + segment_moments({low.x(), high.y()}, low, 2 * degree);
    }
    return worst_of(sum);
}

inline GaussRule repeated(const GaussRule& rule, int n_parts) {
    GaussRule whole;
    for (int k = 0; k < n_parts; ++k)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            whole.points.push_back((k + rule.points[i]) / n_parts);
            whole.weights.push_back(rule.weights[i] / n_parts);
        }
    return whole;
}

/// Of each cell by its contours, with so many Gauss points that nothing is missing: 64 on each of `n_parts` parts.
inline double contour_error(const Part& part, const CutCells& cells, const std::vector<CellRule>& rules, int degree,
                            int n_parts = 1) {
    const GaussRule gauss = repeated(gauss_rule(64), n_parts);
    double worst = 0;
    for (const CellRule& rule : rules) {
        const LocalFrame frame = unit_frame(cells.grid, rule.element);
        Moments sum = -rule_moments(rule, frame, 2 * degree);
        const auto c = static_cast<std::size_t>(rule.element);
        for (int k = cells.first_contour[c]; k < cells.first_contour[c + 1]; ++k) {
            const ContourPiece& piece = cells.contours[static_cast<std::size_t>(k)];
            for (std::size_t q = 0; q < gauss.points.size(); ++q) {
                const double t = piece.t0 + gauss.points[q] * (piece.t1 - piece.t0);
                const Box2 b = box_of(cells.grid, rule.element);
                const Curve curve = piece.edge < 0 ? Segment{{b.max.x(), 0}, {b.max.x(), 1}}
                                                   : part.edges[static_cast<std::size_t>(piece.edge)].curve;
                const Vec2 p = frame(point(curve, t));
                const double dv = gauss.weights[q] * (piece.t1 - piece.t0) * derivative(curve, t).y() / frame.scale.y();
                Eigen::VectorXd u = p.x() * powers(p.x(), 2 * degree);
                for (int i = 0; i <= 2 * degree; ++i) u[i] /= i + 1;
                sum += dv * u * powers(p.y(), 2 * degree).transpose();
            }
        }
        worst = std::max(worst, worst_of(sum));
    }
    return worst;
}

/// gauss_tolerance is far below; what is left are roundings of the points, to the power of up to 8.
inline constexpr double general_tolerance = 1e-12;

inline std::vector<BoundaryPoint> whole_boundary(const Part& part, const CutCells& cells, int n) {
    std::vector<BoundaryPoint> points;
    for (std::size_t e = 0; e < part.edges.size(); ++e) {
        const std::vector<BoundaryPoint> more = boundary_rule(part, cells, static_cast<int>(e), 0, 1, n);
        points.insert(points.end(), more.begin(), more.end());
    }
    return points;
}

/// The integral of n is zero, that of x.n twice the area, that of 1 the perimeter; the largest difference.
inline double divergence_error(const Part& part, const std::vector<BoundaryPoint>& points) {
    Vec2 normal(0, 0);
    double flux = 0, around = 0;
    for (const BoundaryPoint& p : points) {
        normal += p.weight * p.normal;
        flux += p.weight * p.x.dot(p.normal);
        around += p.weight;
    }
    return std::max({normal.norm(), std::abs(flux - 2 * area(part)), std::abs(around - perimeter(part))});
}

/// A few hundred points of coordinates of 1: their roundings.
inline constexpr double boundary_tolerance = 1e-13;

}  // namespace abut::geometry::test
