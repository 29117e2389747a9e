// SPDX-License-Identifier: GPL-3.0-or-later
// Where a block's content stands in the drawing: affine maps, and what they make of curves.
#pragma once
#include "geometry/curves/curve.hpp"

namespace abut::geometry::dxf {

/// x -> shift + A (x - base), A = [x_axis, y_axis]. The base is taken off first and the shift added last, so that blocks drawn
/// far from the origin, and inserted far from it, keep their digits.
struct Placement {
    Vec2 x_axis{1, 0}, y_axis{0, 1};
    Vec2 base{0, 0}, shift{0, 0};

    Vec2 turned(const Vec2& v) const { return v.x() * x_axis + v.y() * y_axis; }
    Vec2 operator()(const Vec2& p) const { return turned(p - base) + shift; }
};

/// The map that applies `inner` first.
Placement composed(const Placement& outer, const Placement& inner);

/// The map whose axes are scaled by sx and sy, then rotated by an angle (degrees; quarter turns are exact).
Placement rotated_and_scaled(double degrees, double sx, double sy);

/// The map that negates x: coordinates of a plane whose normal is -z (the "arbitrary axis" of an extrusion (0, 0, -1)).
Placement seen_from_below();

/// What is wrong with a placement, as one line for the user ("its scale is zero"); empty if nothing. Coordinates and scales
/// beyond `largest` are damage, not drawing.
std::string placement_fault(const Placement& placement, double largest);

/// The ellipse center + cos(u) a + sin(u) b, or the circle where a and b are equally long and at a right angle within rounding.
Curve circle_or_ellipse(const Vec2& center, const Vec2& a, const Vec2& b, double start, double sweep);

/// The image of the curve, run the same way: lines and splines of any map; circles and arcs stay what they are where both axes
/// are equally long and at a right angle (within rounding), and are arcs of ellipses else.
Curve placed(const Curve& curve, const Placement& placement);

}  // namespace abut::geometry::dxf
