// SPDX-License-Identifier: GPL-3.0-or-later
// The true distance to a curve with its first two derivatives.
#pragma once
#include "geometry/curves/curve.hpp"
#include "geometry/implicit/jet.hpp"

namespace abut::geometry {

/// A value next to a curve. Sided: positive on the curve's left, negative on its right, smooth across the curve. Not sided
/// (beyond an end): never negative.
template <class T>
struct NearCurve {
    T w;
    bool sided = true;
};

/// The distance from p to the curve's closest point. At a closest point inside the curve the gradient is the unit normal and
/// the Hessian -k / (1 - k d) along the tangent (k curvature, positive to the left); at an end they are those of the distance
/// to it. It has kinks where several points of the curve are equally close.
NearCurve<Jet> curve_distance(const Curve& curve, const PointOf<Jet>& p);
NearCurve<double> curve_distance(const Curve& curve, const PointOf<double>& p);

}  // namespace abut::geometry
