// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/tangent_ball.hpp"

#include <cmath>

#include "geometry/curves/numbers.hpp"

namespace abut::geometry {

namespace {

double arc_parameter(const Arc& arc, const Vec2& direction) {
    const double middle = arc.start + arc.sweep / 2;
    return 0.5 + std::remainder(std::atan2(direction.y(), direction.x()) - middle, two_pi) / arc.sweep;
}

double foot_parameter(const Segment& segment, const Vec2& p) {
    const Vec2 d = segment.to - segment.from;
    return (p - segment.from).dot(d) / d.squaredNorm();
}

// (x + r n - p).n2 = r for any point p of the line.
std::optional<TangentBall> ball_on_line(const Segment& segment, const Vec2& x, const Vec2& n) {
    const Vec2 n2 = right_of((segment.to - segment.from).normalized());
    const double denominator = 1 - n.dot(n2);
    if (denominator <= 0) return std::nullopt;
    const double r = (x - segment.from).dot(n2) / denominator;
    const Vec2 x2 = x + r * (n - n2);
    return TangentBall{r, foot_parameter(segment, x2), x2, n2};
}

// |x + r n - c| = R + r on a convex arc, R - r on a concave one; squared, r^2 cancels. Written with the signed radius R.
std::optional<TangentBall> ball_on_circle(const Arc& arc, const Vec2& x, const Vec2& n) {
    const double R = std::copysign(arc.radius, arc.sweep);
    const Vec2 d = x - arc.center;
    const double denominator = 2 * (n.dot(d) - R);
    if (denominator == 0) return std::nullopt;
    const double distance = d.norm();
    const double r = (arc.radius - distance) * (arc.radius + distance) / denominator;
    if (!(1 + r / R > 0)) return std::nullopt;
    const Vec2 radial = (d + r * n).normalized();
    return TangentBall{r, arc_parameter(arc, radial), arc.center + arc.radius * radial, std::copysign(1.0, R) * radial};
}

}  // namespace

std::optional<TangentBall> tangent_ball(const Curve& curve, const Vec2& x, const Vec2& n) {
    if (const auto* segment = std::get_if<Segment>(&curve)) return ball_on_line(*segment, x, n);
    return ball_on_circle(std::get<Arc>(curve), x, n);
}

std::vector<double> parallel_points(const Curve& curve, const Curve& other) {
    const auto* line = std::get_if<Segment>(&curve);
    const auto* other_line = std::get_if<Segment>(&other);
    if (line && other_line) return {};
    if (line) return {foot_parameter(*line, std::get<Arc>(other).center)};
    const Arc& arc = std::get<Arc>(curve);
    const Vec2 along =
        other_line ? right_of(other_line->to - other_line->from) : Vec2(std::get<Arc>(other).center - arc.center);
    if (along.norm() <= 1e-14 * arc.radius) return {};  // concentric to rounding
    return {arc_parameter(arc, along), arc_parameter(arc, -along)};
}

}  // namespace abut::geometry
