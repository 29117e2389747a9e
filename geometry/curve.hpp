// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary curves. Every curve runs over the parameter t in [0, 1]; a new kind joins the variant and the functions below.
#pragma once
#include <variant>
#include <vector>

#include "geometry/vec2.hpp"

namespace abut::geometry {

struct Segment {
    Vec2 from, to;
};

/// Circular arc; angles in radians. sweep > 0 runs counter-clockwise, |sweep| <= 2 pi (a full circle).
struct Arc {
    Vec2 center;
    double radius;
    double start;
    double sweep;
};

using Curve = std::variant<Segment, Arc>;

Vec2 point(const Curve& curve, double t);
/// First derivative by t (not normalised).
Vec2 derivative(const Curve& curve, double t);
Vec2 unit_tangent(const Curve& curve, double t);
/// Unit normal on the right of the direction of travel: outward for a part's edge (material on the left).
Vec2 outward_normal(const Curve& curve, double t);
/// Signed curvature, positive where the curve turns left (1/length).
double curvature(const Curve& curve, double t);
/// Arc length of the whole curve, or between two parameters (signed).
double length(const Curve& curve);
double length(const Curve& curve, double t0, double t1);
Box2 bounding_box(const Curve& curve);
/// Parameter of the point closest to p (global minimum; the smaller parameter where several are equally close).
double closest_parameter(const Curve& curve, const Vec2& p);
/// Parameters in [0, 1], ascending, where the tangent is parallel to an axis: with 0 and 1 they bound the x- and y-monotone
/// pieces.
std::vector<double> axis_extrema(const Curve& curve);
/// The same curve run backwards.
Curve reversed(const Curve& curve);
/// The portion between two parameters, t0 < t1.
Curve trimmed(const Curve& curve, double t0, double t1);
/// Moved by x -> R x + d with R = [c -s; s c] and (c, s) of unit length.
Curve transformed(const Curve& curve, double c, double s, const Vec2& d);

}  // namespace abut::geometry
