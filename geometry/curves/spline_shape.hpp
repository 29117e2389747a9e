// SPDX-License-Identifier: GPL-3.0-or-later
// Rational splines, kept as Bezier spans: NURBS of any valid knot vector come down to these exactly (Boehm's knot insertion).
#pragma once
#include <array>
#include <string>
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

inline constexpr int max_spline_degree = 8;

/// A smooth curve of rational Bezier spans, joined with a continuous tangent. Immutable; its parameter runs from 0 to 1.
struct SplineShape {
    int degree = 1;
    std::vector<double> breaks;      ///< n_spans + 1 parameters, ascending from 0 to 1
    std::vector<Vec2> points;        ///< (degree + 1) control points per span, span after span
    std::vector<double> weights;     ///< the same number, positive
    bool rational = false;           ///< are the weights different?
    bool from_nurbs = false;         ///< how the model wrote it: as NURBS, or as one Bezier curve
    std::vector<double> arc_length;  ///< from the beginning to each break
};

/// A spline as models write it. weights may be empty (all 1). n_points + degree + 1 knots, non-decreasing; the curve is what
/// lies between knots[degree] and knots[n_points], so that clamped, unclamped and closed (wrapped) knot vectors all do.
struct Nurbs {
    int degree = 3;
    std::vector<double> knots;
    std::vector<Vec2> points;
    std::vector<double> weights;
};

/// What is wrong with the numbers, as one line for the user ("it has 7 knots, 4 points of degree 3 need 8"); empty if nothing.
/// A cusp (or stop) between knots is a fault: the curve has no normal there, and no knot to cut it at. Indices count from 0.
std::string spline_fault(const Nurbs& nurbs);
std::string bezier_fault(const std::vector<Vec2>& points, const std::vector<double>& weights);

/// The curve in pieces that are smooth: it is cut at knots where the tangent turns by more than a rounding, or where the curve
/// has a gap (full multiplicity) or stands still. In order, head to tail (bit for bit) unless there is a gap; spans without
/// length are left out, and an end within rounding of the beginning is the beginning. Degree 1 is cut at every knot, and gives
/// Segments where the weights are equal. The numbers must be valid (spline_fault).
std::vector<Curve> nurbs_curves(const Nurbs& nurbs);
/// One Bezier curve of degree points.size() - 1; weights may be empty. A Segment if it has two points and equal weights. The
/// numbers must be valid (bezier_fault).
Curve bezier_curve(const std::vector<Vec2>& points, const std::vector<double>& weights);

/// The point and the first two derivatives by the shape's parameter u in [0, 1]; at a break those of the span that begins
/// there. Both ends and all breaks are control points bit for bit. Where the curve stands still at an end, the derivative is
/// the one a rounding of u further in: tiny, but with the tangent's direction.
std::array<Vec2, 3> evaluate(const SplineShape& shape, double u);
/// The signed arc length between two parameters.
double length(const SplineShape& shape, double u0, double u1);
/// Parameters in (0, 1), ascending, where dx/du (axis 0) or dy/du (axis 1) changes its sign: all of them, by Bernstein
/// subdivision; where it only touches zero, they may be given. None where the coordinate is constant but for rounding.
std::vector<double> stationary_parameters(const SplineShape& shape, int axis);
/// The shape moved by a similarity.
SplineShape transformed(const SplineShape& shape, const Similarity& map);
/// The image of a shape under the affine map p -> origin + p.x x_axis + p.y y_axis, which acts on its control points; used by
/// imports.
SplineShape affine_image(const SplineShape& shape, const Vec2& x_axis, const Vec2& y_axis, const Vec2& origin);

}  // namespace abut::geometry
