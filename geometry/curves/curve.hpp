// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary curves. Every curve runs over the parameter t in [0, 1]. A new kind joins the variant and the functions below, and
// what asks for a kind by name (README.md beside this file).
//
// Lines and circles have closed forms for everything. Ellipses and splines answer by Newton iterations on the true curve,
// started from pieces on which they are safe: the pieces monotone in x and in y (boxes, crossings, closest points), or the arc
// spline that follows the curve (arc_spline.hpp: crossings of two curves, facing zones, Booleans).
#pragma once
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "geometry/curves/vec2.hpp"

namespace abut::geometry {

/// A straight line from point to point.
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

/// Portion of an ellipse: center + cos(u) a + sin(u) b with u = start + t sweep (eccentric angle, radians). a and b are the
/// semi-axes, at a right angle; b lies clockwise of a on a mirrored ellipse. |sweep| <= 2 pi (a full ellipse).
struct EllipticArc {
    Vec2 center, a, b;
    double start;
    double sweep;
};

struct SplineShape;

/// Portion of a smooth rational spline (spline_shape.hpp): t runs over the shape's parameter from `begin` to `end`, both in
/// [0, 1]; begin > end runs the shape backwards. Copies share the shape.
struct Spline {
    std::shared_ptr<const SplineShape> shape;
    double begin = 0, end = 1;
};

using Curve = std::variant<Segment, Arc, EllipticArc, Spline>;

/// The kind of a curve in a word: "line", "arc", "ellipse", "bezier", "nurbs".
std::string kind_name(const Curve& curve);
bool is_finite(const Curve& curve);

/// The point at parameter t.
Vec2 point(const Curve& curve, double t);
/// The first and the second derivative by t (not normalised).
Vec2 derivative(const Curve& curve, double t);
Vec2 second_derivative(const Curve& curve, double t);
Vec2 unit_tangent(const Curve& curve, double t);
/// Unit normal on the right of the direction of travel: outward for a part's edge (material on the left).
Vec2 outward_normal(const Curve& curve, double t);
/// Signed curvature, positive where the curve turns left (1/length).
double curvature(const Curve& curve, double t);
/// The arc length of the whole curve, or between two parameters (signed); to rounding.
double length(const Curve& curve);
double length(const Curve& curve, double t0, double t1);
/// Parameter of the point at arc length s from the curve's beginning; s outside the curve gives its nearer end.
double parameter_at_length(const Curve& curve, double s);
/// The smallest axis-parallel box around the curve, exact but for rounding.
Box2 bounding_box(const Curve& curve);
/// Parameter of the point closest to p (global minimum; the smaller parameter where several are equally close).
double closest_parameter(const Curve& curve, const Vec2& p);
/// Parameters in (0, 1), ascending, where the tangent is parallel to an axis: with 0 and 1 they bound the x- and y-monotone
/// pieces.
std::vector<double> axis_extrema(const Curve& curve);
/// Parameters in (0, 1), ascending, where the curve is less than infinitely smooth (a spline's knots): Gauss rules and Taylor
/// series must not run across them.
std::vector<double> smoothness_breaks(const Curve& curve);
/// t0 <= t1, with those in between.
std::vector<double> smooth_cuts(const Curve& curve, double t0 = 0, double t1 = 1);
/// Parameters in [0, 1], ascending, where coordinate `axis` (0: x, 1: y) equals c: all crossings and touching points. A curve
/// that runs along the line has none.
std::vector<double> crossings(const Curve& curve, int axis, double c);
/// The angle (radians) by which the tangent turns between two parameters, t0 <= t1, left and right turns both counted positive;
/// for splines an upper estimate.
double turning(const Curve& curve, double t0, double t1);
/// The curve run backwards.
Curve reversed(const Curve& curve);
/// The portion of the curve between two parameters, t0 < t1.
Curve trimmed(const Curve& curve, double t0, double t1);

/// x -> scale R M x + d: M negates x where `mirror` is set, R = [c -s; s c] with (c, s) of unit length, scale > 0.
struct Similarity {
    double c = 1, s = 0;
    Vec2 d{0, 0};
    double scale = 1;
    bool mirror = false;
    Vec2 operator()(const Vec2& p) const { return turned(p) + d; }
    Vec2 turned(const Vec2& v) const {
        const double x = mirror ? -v.x() : v.x();
        return scale * Vec2(c * x - s * v.y(), s * x + c * v.y());
    }
};
/// The image of a curve. It runs the same way through its parameter; what lay on its left lies on its right if the map mirrors.
Curve transformed(const Curve& curve, const Similarity& map);
/// The curve moved by x -> R x + d with R = [c -s; s c] and (c, s) of unit length.
Curve transformed(const Curve& curve, double c, double s, const Vec2& d);

}  // namespace abut::geometry
