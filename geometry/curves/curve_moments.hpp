// SPDX-License-Identifier: GPL-3.0-or-later
// Areas and first moments by Green's theorem.
#pragma once
#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// An area (length^2) and its first moments (length^3) about a point o.
struct Moments {
    double area = 0;
    Vec2 first{0, 0};  ///< integral of (x - o)
};

/// The area and first moments of the region between the portion [t0, t1] of the curve and its chord; positive where the curve
/// runs on the right of the chord (bulges outward, material on the left). Closed forms for lines, circles and ellipses; splines
/// by Gauss rules with as many points as polynomials need, halved until rounding where they are rational.
Moments bulge(const Curve& curve, double t0, double t1, const Vec2& o);

}  // namespace abut::geometry
