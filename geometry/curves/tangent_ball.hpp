// SPDX-License-Identifier: GPL-3.0-or-later
// The circle that touches two boundaries from the outside. A facing pair (x1, x2) is exactly a pair of points where one circle
// touches both: x1 + r n1 = x2 + r n2, so (x2 - x1) x (n1 - n2) = 0 and gap = r |n1 - n2|. r < 0: the circle lies in both
// bodies. In closed form, hence for lines and circles only: ellipses and splines come as their arcs (facing_general).
#pragma once
#include <optional>
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// A circle that touches two curves.
struct TangentBall {
    double radius = 0;      ///< signed, see above
    double t = 0;           ///< parameter of the touching point on the other curve; beyond [0, 1]: on its continuation
    Vec2 x{0, 0}, n{0, 0};  ///< touching point on the other curve and outward normal there
};

/// The circle that touches at x, where the outward normal is n, and also touches `curve` (or its continuation as a line or full
/// circle). In closed form; none where the normals are equal or where the circle would have to pass the curve's centre.
/// The parameter on an arc is the one closest to its middle.
std::optional<TangentBall> tangent_ball(const Curve& curve, const Vec2& x, const Vec2& n);

/// Parameters on `curve` (or its continuation) of the pairs with `other` whose normals are parallel: there, and only there,
/// the gap along a pair of curves has an extremum. Empty where the normals are parallel everywhere or nowhere.
std::vector<double> parallel_points(const Curve& curve, const Curve& other);

}  // namespace abut::geometry
