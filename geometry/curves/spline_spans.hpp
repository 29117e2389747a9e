// SPDX-License-Identifier: GPL-3.0-or-later
// The Bezier spans of a spline, and smooth shapes of them: the way from control points to SplineShape.
#pragma once
#include <vector>

#include "geometry/curves/bezier_span.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry {

/// One span between two knots. Control points within rounding of an end that they follow (or precede) are that end.
struct KnotSpan {
    std::vector<Vec2> points;
    std::vector<double> weights;  ///< empty where all of the spline's are equal
    double begin, end;            ///< knots
    bool smooth = false;          ///< continues the span before it, tangent and all
};

/// Knots closer to each other than the rounding of the largest are made equal to the first of them.
std::vector<double> settled_knots(std::vector<double> knots);
/// The weights, or nothing where they are all equal.
std::vector<double> effective_weights(const std::vector<double>& weights);

/// The spans that have a length, in order; consecutive ones share their joint bit for bit unless there is a gap. An end that
/// returns to the beginning within rounding is the beginning.
std::vector<KnotSpan> knot_spans(const Nurbs& nurbs);
/// A Bezier curve as one span over [0, 1]; empty points if it has no length.
KnotSpan bezier_knot_span(const std::vector<Vec2>& points, const std::vector<double>& weights);

BezierSpan view(const KnotSpan& span);
BezierSpan view(const SplineShape& shape, std::size_t span);

/// A run of smoothly joined spans as one curve; a Segment if it is one span of degree 1 without weights.
Curve joined(const std::vector<KnotSpan>& run, bool from_nurbs);
/// Fills in the shape's arc_length.
void measure(SplineShape& shape);

}  // namespace abut::geometry
