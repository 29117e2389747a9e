// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abut::geometry {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

Vec2 on_circle(const Arc& arc, double angle) {
    return arc.center + arc.radius * Vec2(std::cos(angle), std::sin(angle));
}

/// Points of the circle at the four quarter turns, exact where the angle is one: the cosine of pi/2 in doubles is not 0.
Vec2 at_quarter(const Arc& arc, long quarter) {
    static constexpr int c[] = {1, 0, -1, 0}, s[] = {0, 1, 0, -1};
    const auto k = static_cast<std::size_t>(((quarter % 4) + 4) % 4);
    return arc.center + arc.radius * Vec2(c[k], s[k]);
}

/// Parameters of the arc at the multiples of a quarter turn strictly inside it, with the multiple.
struct Quarter {
    double t;
    long k;
};
std::vector<Quarter> quarters(const Arc& arc) {
    const double quarter = std::numbers::pi / 2;
    const double lo = std::min(arc.start, arc.start + arc.sweep), hi = std::max(arc.start, arc.start + arc.sweep);
    std::vector<Quarter> found;
    for (long k = std::lround(std::floor(lo / quarter)); static_cast<double>(k) * quarter < hi; ++k) {
        const double t = (static_cast<double>(k) * quarter - arc.start) / arc.sweep;
        if (t > 0 && t < 1) found.push_back({t, k});
    }
    std::sort(found.begin(), found.end(), [](const Quarter& a, const Quarter& b) { return a.t < b.t; });
    return found;
}

template <class OnSegment, class OnArc>
auto visit(const Curve& curve, OnSegment on_segment, OnArc on_arc) {
    if (const auto* segment = std::get_if<Segment>(&curve)) return on_segment(*segment);
    return on_arc(std::get<Arc>(curve));
}

double closest_on_arc(const Arc& arc, const Vec2& p) {
    const Vec2 d = p - arc.center;
    if (d.squaredNorm() == 0) return 0;
    double turn = std::remainder(std::atan2(d.y(), d.x()) - arc.start, two_pi);
    if (arc.sweep > 0 && turn < 0) turn += two_pi;
    if (arc.sweep < 0 && turn > 0) turn -= two_pi;
    const double t = turn / arc.sweep;
    if (t <= 1) return t;
    return (p - point(arc, 0)).squaredNorm() <= (p - point(arc, 1)).squaredNorm() ? 0.0 : 1.0;
}

}  // namespace

Vec2 point(const Curve& curve, double t) {
    return visit(
        curve, [&](const Segment& s) -> Vec2 { return t == 1 ? s.to : Vec2(s.from + t * (s.to - s.from)); },
        [&](const Arc& a) -> Vec2 { return on_circle(a, a.start + t * a.sweep); });
}

Vec2 derivative(const Curve& curve, double t) {
    return visit(
        curve, [&](const Segment& s) -> Vec2 { return s.to - s.from; },
        [&](const Arc& a) -> Vec2 {
            const double angle = a.start + t * a.sweep;
            return a.radius * a.sweep * Vec2(-std::sin(angle), std::cos(angle));
        });
}

Vec2 unit_tangent(const Curve& curve, double t) {
    return derivative(curve, t).normalized();
}

Vec2 outward_normal(const Curve& curve, double t) {
    return right_of(unit_tangent(curve, t));
}

double curvature(const Curve& curve, double) {
    return visit(
        curve, [](const Segment&) { return 0.0; }, [](const Arc& a) { return std::copysign(1 / a.radius, a.sweep); });
}

double length(const Curve& curve) {
    return length(curve, 0, 1);
}

double length(const Curve& curve, double t0, double t1) {
    return visit(
        curve, [&](const Segment& s) { return (t1 - t0) * (s.to - s.from).norm(); },
        [&](const Arc& a) { return (t1 - t0) * a.radius * std::abs(a.sweep); });
}

Box2 bounding_box(const Curve& curve) {
    Box2 box;
    box.extend(point(curve, 0));
    box.extend(point(curve, 1));
    if (const auto* arc = std::get_if<Arc>(&curve))
        for (const Quarter& q : quarters(*arc)) box.extend(at_quarter(*arc, q.k));
    return box;
}

double closest_parameter(const Curve& curve, const Vec2& p) {
    return visit(
        curve,
        [&](const Segment& s) {
            const Vec2 d = s.to - s.from;
            return std::clamp((p - s.from).dot(d) / d.squaredNorm(), 0.0, 1.0);
        },
        [&](const Arc& a) { return closest_on_arc(a, p); });
}

std::vector<double> axis_extrema(const Curve& curve) {
    std::vector<double> found;
    if (const auto* arc = std::get_if<Arc>(&curve))
        for (const Quarter& q : quarters(*arc)) found.push_back(q.t);
    return found;
}

Curve reversed(const Curve& curve) {
    return visit(
        curve,
        [](const Segment& s) -> Curve {
            return Segment{s.to, s.from};
        },
        [](const Arc& a) -> Curve {
            return Arc{a.center, a.radius, a.start + a.sweep, -a.sweep};
        });
}

Curve trimmed(const Curve& curve, double t0, double t1) {
    return visit(
        curve,
        [&](const Segment& s) -> Curve {
            return Segment{point(s, t0), point(s, t1)};
        },
        [&](const Arc& a) -> Curve {
            return Arc{a.center, a.radius, a.start + t0 * a.sweep, (t1 - t0) * a.sweep};
        });
}

Curve transformed(const Curve& curve, double c, double s, const Vec2& d) {
    const auto move = [&](const Vec2& p) { return Vec2(c * p.x() - s * p.y() + d.x(), s * p.x() + c * p.y() + d.y()); };
    return visit(
        curve,
        [&](const Segment& g) -> Curve {
            return Segment{move(g.from), move(g.to)};
        },
        [&](const Arc& a) -> Curve {
            return Arc{move(a.center), a.radius, a.start + std::atan2(s, c), a.sweep};
        });
}

}  // namespace abut::geometry
