// SPDX-License-Identifier: GPL-3.0-or-later
// Quadrature points of cut cells and of the boundary.
#pragma once
#include <vector>

#include "geometry/cells/elements.hpp"

namespace abut::geometry {

/// Points (n) and weights (n) of one element of a boundary cell.
struct CellRule {
    int element;
    std::vector<Vec2> points;
    std::vector<double> weights;
};

/// Rules of all boundary cells for products of two tensor polynomials of the given degree, by the divergence theorem: along
/// each contour Gauss points, from the cell's left side to each of them Gauss points again [Gunderman21].
/// Exact but for rounding along segments, ellipses and splines, to 1e-9 along circular arcs (gauss_portions.hpp). Points may
/// lie outside the part and weights may be negative.
std::vector<CellRule> cell_rules(const Part& part, const CutCells& cells, int degree);
/// Rules of all elements of all boundary cells: by cell, then by element. Where no cell is split, they are those by cells bit
/// for bit.
std::vector<CellRule> cell_rules(const Part& part, const CutCells& cells, const Elements& elements, int degree);

/// A quadrature point of the boundary.
struct BoundaryPoint {
    int element;
    int edge;
    double t;
    Vec2 x, normal;  ///< normal: unit, outward
    double weight;   ///< arc length
};

/// Gauss points of the portion [t0, t1] of an edge, cell by cell, for polynomials of total degree 2n - 1 times the arc length:
/// n points a cell, more where the edge curves. As exact as cell_rules.
std::vector<BoundaryPoint> boundary_rule(const Part& part, const CutCells& cells, int edge, double t0, double t1, int n);
/// Gauss points of a portion of an edge, with elements in place of the cells that they are in; otherwise as by cells.
std::vector<BoundaryPoint> boundary_rule(const Part& part, const CutCells& cells, const Elements& elements, int edge, double t0,
                                         double t1, int n);

}  // namespace abut::geometry
