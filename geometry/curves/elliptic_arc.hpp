// SPDX-License-Identifier: GPL-3.0-or-later
// What is special to ellipses; what they share with splines is in general_curve.hpp.
#pragma once
#include <array>
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// The ellipse center + cos(u) p + sin(u) q of any two conjugate half diameters p, q (not parallel), as one with semi-axes: the
/// same points at shifted u. This is how an affine map acts on ellipses and circles.
EllipticArc from_conjugate(const Vec2& center, const Vec2& p, const Vec2& q, double start, double sweep);

/// The point and the first two derivatives by t.
std::array<Vec2, 3> evaluate(const EllipticArc& arc, double t);
/// Parameters in (0, 1), ascending, where dx/dt (axis 0) or dy/dt (axis 1) vanishes.
std::vector<double> stationary_parameters(const EllipticArc& arc, int axis);

}  // namespace abut::geometry
