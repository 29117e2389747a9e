// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and arcs recovered from what exports make of them: polylines, facets, splines.
#pragma once
#include <optional>
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// Points first..last (indices, modulo their number on closed polylines) as one line or arc.
struct FittedPiece {
    Curve curve;  ///< begins and ends exactly at its first and last point, or is the best full turn
    int first = 0, last = 0;
    double residual = 0;  ///< largest distance of its points from it
};

/// Facets turn by less than this, radians, where they stand for an arc: a hexagon or a chamfer stays what it is.
inline constexpr double largest_facet_turn = 0.27;
/// An arc needs at least so many facets.
inline constexpr int least_facets = 4;
/// Facets that stand off their arc by more than the tolerance are alike: none by more than this times what the middle one of
/// all does. The length of a side grows with the root of it.
inline constexpr double most_sagitta_of_median = 2;
/// Their points are off the arc by less than this part of what they stand off: a straight side that is as long as the facets
/// beside it, and tangent to their arc, ends off that by four times its sagitta.
inline constexpr double points_share = 0.1;
/// Points that rounding puts off their arc may be so by this part: beside four facets such a side ends off by 0.9 of it.
inline constexpr double rounded_share = 0.4;
/// Radius of an arc in units of its chord: a flatter one is a line, and its angles carry the points no more.
inline constexpr double flattest_radius = 1e5;

/// Splits a polyline into lines and arcs: greedy longest runs whose vertices lie on one line or one circle within the
/// tolerance, the sides of arcs' facets as well or alike all along. Corners (turns that fit no arc) are never rounded off. A
/// closed polyline wholly on one circle is one full arc. written: what rounding moves the points by, if known. Deterministic;
/// cost near linear.
std::vector<FittedPiece> fit_lines_and_arcs(const std::vector<Vec2>& points, bool closed, double tolerance, double written = 0);

/// The line or circular arc that the curve (an ellipse or a spline) is within the tolerance; none if it is neither.
std::optional<Curve> as_line_or_arc(const Curve& curve, double tolerance);

}  // namespace abut::geometry
