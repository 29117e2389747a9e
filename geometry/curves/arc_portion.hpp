// SPDX-License-Identifier: GPL-3.0-or-later
// One arc for a portion of a curve, with a bound of how far they are apart: the step that arc splines are made of.
#pragma once
#include "geometry/curves/arc_spline.hpp"
#include "geometry/curves/homogeneous_span.hpp"

namespace abut::geometry {

/// A portion of an ellipse or of one span of a spline, monotone in x and in y.
struct Portion {
    Vec2 from, via, to;                ///< its ends, and a point between them
    Vec2 first_tangent, last_tangent;  ///< unit vectors
    HomogeneousSpan span;              ///< relative to `from`
};

/// The arc that a portion is fitted by.
struct ArcFit {
    Curve curve;    ///< the arc through the three points, or a segment
    double excess;  ///< at most 1: within the bounds. Grows with the third power of the length
};

/// Fits one arc to a portion; the bounds are what its excess is measured by.
ArcFit fit_arc(const Portion& portion, const ArcBounds& bounds);

}  // namespace abut::geometry
