// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_placement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/curves/elliptic_arc.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry::dxf {

namespace {

/// Axes whose lengths or right angle are off by less (relative) are so by rounding: a few rotations, each of some epsilons.
constexpr double axis_rounding = 1e-12;
/// A block squeezed to less than this fraction is flat.
constexpr double flat_fraction = 1e-12;

bool are_like_a_circle(const Vec2& a, const Vec2& b) {
    const double aa = a.squaredNorm(), bb = b.squaredNorm();
    return std::abs(aa - bb) <= 2 * axis_rounding * aa && std::abs(a.dot(b)) <= axis_rounding * aa;
}

Curve image(const Segment& s, const Placement& placement) {
    return Segment{placement(s.from), placement(s.to)};
}

Curve image(const Arc& arc, const Placement& placement) {
    return circle_or_ellipse(placement(arc.center), arc.radius * placement.x_axis, arc.radius * placement.y_axis, arc.start,
                             arc.sweep);
}

Curve image(const EllipticArc& arc, const Placement& placement) {
    return circle_or_ellipse(placement(arc.center), placement.turned(arc.a), placement.turned(arc.b), arc.start, arc.sweep);
}

Curve image(const Spline& spline, const Placement& placement) {
    const bool is_at_base = placement.base == Vec2(0, 0);
    const SplineShape& shape = *spline.shape;
    SplineShape moved = affine_image(is_at_base ? shape : affine_image(shape, {1, 0}, {0, 1}, -placement.base),
                                     placement.x_axis, placement.y_axis, placement.shift);
    return Spline{std::make_shared<const SplineShape>(std::move(moved)), spline.begin, spline.end};
}

/// Exact at quarter turns, where the sine of a rounded angle is not.
Vec2 direction(double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    if (turn == 0) return {1, 0};
    if (turn == 90) return {0, 1};
    if (turn == -90) return {0, -1};
    if (std::abs(turn) == 180) return {-1, 0};
    const double angle = turn * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle)};
}

}  // namespace

Placement composed(const Placement& outer, const Placement& inner) {
    Placement both;
    both.x_axis = outer.turned(inner.x_axis);
    both.y_axis = outer.turned(inner.y_axis);
    both.base = inner.base;
    both.shift = outer(inner.shift);
    return both;
}

Placement rotated_and_scaled(double degrees, double sx, double sy) {
    const Vec2 x = direction(degrees);
    Placement placement;
    placement.x_axis = sx * x;
    placement.y_axis = sy * left_of(x);
    return placement;
}

Placement seen_from_below() {
    Placement mirror;
    mirror.x_axis = {-1, 0};
    return mirror;
}

std::string placement_fault(const Placement& placement, double largest) {
    const double x = placement.x_axis.norm(), y = placement.y_axis.norm();
    if (x == 0 || y == 0) return "its scale is zero";
    const double coordinates = std::max(placement.base.lpNorm<Eigen::Infinity>(), placement.shift.lpNorm<Eigen::Infinity>());
    const bool is_sensible = std::max({x, y, 1 / x, 1 / y, coordinates}) <= largest;  // false of what is no number
    if (!is_sensible) return "its place or scale is of no sensible size";
    if (std::abs(cross(placement.x_axis, placement.y_axis)) <= flat_fraction * x * y) return "it is squeezed flat";
    return {};
}

Curve circle_or_ellipse(const Vec2& center, const Vec2& a, const Vec2& b, double start, double sweep) {
    if (!are_like_a_circle(a, b)) return from_conjugate(center, a, b, start, sweep);
    const double turn = std::atan2(a.y(), a.x());
    return cross(a, b) > 0 ? Arc{center, a.norm(), turn + start, sweep} : Arc{center, a.norm(), turn - start, -sweep};
}

Curve placed(const Curve& curve, const Placement& placement) {
    return std::visit([&](const auto& c) { return image(c, placement); }, curve);
}

}  // namespace abut::geometry::dxf
