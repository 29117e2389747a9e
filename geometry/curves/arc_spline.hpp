// SPDX-License-Identifier: GPL-3.0-or-later
// A curve followed by circular arcs. Everything global about general curves (Booleans, crossings of two curves, facing zones)
// is found on their arc splines, by the closed forms and exact arithmetic of lines and circles; everything exact is then
// polished on the curve itself by Newton iterations.
#pragma once
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// One arc (or segment, where the curve is straight) and the portion [t0, t1] of the curve that it follows.
struct ArcPiece {
    Curve curve;  ///< Segment or Arc, from the curve's point at t0 to the one at t1
    double t0, t1;
};

/// Tolerance of arc splines as a fraction of a model's size.
inline constexpr double arc_spline_fraction = 1e-6;

/// Neighbouring arcs' tangents differ by no more (radians): where arc splines stand for curves, their joints are no corners
/// (chain_angle in facing.hpp).
inline constexpr double most_arc_kink = 1e-3;

/// How closely arcs follow a curve.
struct ArcBounds {
    double tolerance;             ///< length, > 0
    double kink = most_arc_kink;  ///< the most that neighbouring arcs' tangents differ by (radians)
};

/// Arcs through three points of the curve each (ends and middle), nowhere farther than the tolerance from it nor it from them
/// (by a bound, not by samples), and within half the kink of its tangents at their ends. Joints lie on the curve, among them
/// all axis_extrema and smoothness_breaks. Lines and circles are returned as they are. The same curve gives the same pieces bit
/// for bit, the reversed curve the same backwards; portions of one curve share the joints inside both, but for a piece or two
/// at their ends. A tolerance below rounding of the size counts as that. The number of pieces grows with tolerance^(-1/3), or
/// kink^(-1/2) where that decides: a full ellipse takes about 100 at arc_spline_fraction, and hardly fewer at larger
/// tolerances. Some 2 microseconds each.
std::vector<ArcPiece> arc_spline(const Curve& curve, ArcBounds bounds);
inline std::vector<ArcPiece> arc_spline(const Curve& curve, double tolerance) {
    return arc_spline(curve, ArcBounds{tolerance});
}

}  // namespace abut::geometry
