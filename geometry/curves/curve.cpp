// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/curves/elliptic_arc.hpp"
#include "geometry/curves/general_curve.hpp"
#include "geometry/curves/homogeneous_span.hpp"
#include "geometry/curves/numbers.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry {

namespace {

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

/// Calls the function of the curve's kind; ellipses and splines go to the last one.
template <class OnSegment, class OnArc, class OnGeneral>
auto visit(const Curve& curve, OnSegment on_segment, OnArc on_arc, OnGeneral on_general) {
    if (const auto* segment = std::get_if<Segment>(&curve)) return on_segment(*segment);
    if (const auto* arc = std::get_if<Arc>(&curve)) return on_arc(*arc);
    return on_general();
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

double shape_parameter(const Spline& spline, double t) {
    return t == 1 ? spline.end : spline.begin + t * (spline.end - spline.begin);
}

/// Parameters of the shape, ascending, as those of the curve inside it, ascending; what is an end but for rounding is left out.
std::vector<double> curve_parameters(const Spline& spline, const std::vector<double>& shape_parameters) {
    const double rounding = 4 * epsilon / std::abs(spline.end - spline.begin);
    std::vector<double> found;
    for (const double u : shape_parameters) {
        const double t = (u - spline.begin) / (spline.end - spline.begin);
        if (t > rounding && t < 1 - rounding) found.push_back(t);
    }
    if (spline.end < spline.begin) std::reverse(found.begin(), found.end());
    return found;
}

/// Parameters in (0, 1) where coordinate `axis` is stationary.
std::vector<double> stationary(const Curve& curve, int axis) {
    if (const auto* arc = std::get_if<Arc>(&curve)) {
        std::vector<double> found;
        for (const Quarter& q : quarters(*arc))
            if ((q.k % 2 == 0) == (axis == 0)) found.push_back(q.t);
        return found;
    }
    if (const auto* arc = std::get_if<EllipticArc>(&curve)) return stationary_parameters(*arc, axis);
    if (const auto* spline = std::get_if<Spline>(&curve))
        return curve_parameters(*spline, stationary_parameters(*spline->shape, axis));
    return {};
}

/// An ellipse turns one way, and between two of its extrema by a quarter turn.
double turning_of_ellipse(const Curve& curve, double t0, double t1) {
    double sum = 0;
    Vec2 before = derivative(curve, t0);
    for (const double t : axis_extrema(curve)) {
        if (t <= t0 || t >= t1) continue;
        const Vec2 here = derivative(curve, t);
        sum += std::abs(angle_between(before, here));
        before = here;
    }
    return sum + std::abs(angle_between(before, derivative(curve, t1)));
}

double turning_bound(const Spline& spline, double t0, double t1) {
    const SplineShape& shape = *spline.shape;
    const double a = shape_parameter(spline, t0), b = shape_parameter(spline, t1), lo = std::min(a, b), hi = std::max(a, b);
    double sum = 0;
    for (std::size_t k = 0; k + 1 < shape.breaks.size(); ++k) {
        const double u0 = shape.breaks[k], width = shape.breaks[k + 1] - u0;
        const double s0 = std::max(0.0, (lo - u0) / width), s1 = std::min(1.0, (hi - u0) / width);
        if (s0 >= s1) continue;
        const Vec2 origin = shape.points[k * (static_cast<std::size_t>(shape.degree) + 1)];
        sum += turning_bound(portion(homogeneous_span(shape, k, origin), s0, s1));
    }
    return sum;
}

}  // namespace

std::string kind_name(const Curve& curve) {
    if (const auto* spline = std::get_if<Spline>(&curve)) return spline->shape->from_nurbs ? "nurbs" : "bezier";
    return std::holds_alternative<Segment>(curve) ? "line" : std::holds_alternative<Arc>(curve) ? "arc" : "ellipse";
}

bool is_finite(const Curve& curve) {
    if (const auto* s = std::get_if<Segment>(&curve)) return s->from.allFinite() && s->to.allFinite();
    if (const auto* a = std::get_if<Arc>(&curve))
        return a->center.allFinite() && std::isfinite(a->radius) && std::isfinite(a->start) && std::isfinite(a->sweep);
    if (const auto* e = std::get_if<EllipticArc>(&curve))
        return e->center.allFinite() && e->a.allFinite() && e->b.allFinite() && std::isfinite(e->start) &&
               std::isfinite(e->sweep);
    const std::vector<Vec2>& points = std::get<Spline>(curve).shape->points;
    return std::all_of(points.begin(), points.end(), [](const Vec2& p) { return p.allFinite(); });
}

Vec2 point(const Curve& curve, double t) {
    return visit(
        curve, [&](const Segment& s) -> Vec2 { return t == 1 ? s.to : Vec2(s.from + t * (s.to - s.from)); },
        [&](const Arc& a) -> Vec2 { return on_circle(a, a.start + t * a.sweep); },
        [&]() -> Vec2 { return general_values(curve, t)[0]; });
}

Vec2 derivative(const Curve& curve, double t) {
    return visit(
        curve, [&](const Segment& s) -> Vec2 { return s.to - s.from; },
        [&](const Arc& a) -> Vec2 {
            const double angle = a.start + t * a.sweep;
            return a.radius * a.sweep * Vec2(-std::sin(angle), std::cos(angle));
        },
        [&]() -> Vec2 { return general_values(curve, t)[1]; });
}

Vec2 second_derivative(const Curve& curve, double t) {
    return visit(
        curve, [&](const Segment&) -> Vec2 { return Vec2::Zero(); },
        [&](const Arc& a) -> Vec2 { return -a.sweep * a.sweep * (on_circle(a, a.start + t * a.sweep) - a.center); },
        [&]() -> Vec2 { return general_values(curve, t)[2]; });
}

Vec2 unit_tangent(const Curve& curve, double t) {
    return derivative(curve, t).normalized();
}

Vec2 outward_normal(const Curve& curve, double t) {
    return right_of(unit_tangent(curve, t));
}

double curvature(const Curve& curve, double t) {
    return visit(
        curve, [](const Segment&) { return 0.0; }, [](const Arc& a) { return std::copysign(1 / a.radius, a.sweep); },
        [&]() {
            const auto [x, d, dd] = general_values(curve, t);
            return cross(d, dd) / std::pow(d.norm(), 3);
        });
}

double length(const Curve& curve) {
    return length(curve, 0, 1);
}

double length(const Curve& curve, double t0, double t1) {
    return visit(
        curve, [&](const Segment& s) { return (t1 - t0) * (s.to - s.from).norm(); },
        [&](const Arc& a) { return (t1 - t0) * a.radius * std::abs(a.sweep); },
        [&]() {
            const auto* spline = std::get_if<Spline>(&curve);
            if (!spline) return general_length(curve, t0, t1);
            const double s = length(*spline->shape, shape_parameter(*spline, t0), shape_parameter(*spline, t1));
            return spline->end < spline->begin ? -s : s;
        });
}

double parameter_at_length(const Curve& curve, double s) {
    const auto proportional = [&](double total) { return std::clamp(s / total, 0.0, 1.0); };
    return visit(
        curve, [&](const Segment&) { return proportional(length(curve)); },
        [&](const Arc&) { return proportional(length(curve)); }, [&]() { return general_parameter_at_length(curve, s); });
}

Box2 bounding_box(const Curve& curve) {
    Box2 box;
    box.extend(point(curve, 0));
    box.extend(point(curve, 1));
    if (const auto* arc = std::get_if<Arc>(&curve)) {
        for (const Quarter& q : quarters(*arc)) box.extend(at_quarter(*arc, q.k));
        return box;
    }
    for (const double t : axis_extrema(curve)) box.extend(point(curve, t));
    return box;
}

double closest_parameter(const Curve& curve, const Vec2& p) {
    return visit(
        curve,
        [&](const Segment& s) {
            const Vec2 d = s.to - s.from;
            return std::clamp((p - s.from).dot(d) / d.squaredNorm(), 0.0, 1.0);
        },
        [&](const Arc& a) { return closest_on_arc(a, p); }, [&]() { return general_closest_parameter(curve, p); });
}

std::vector<double> axis_extrema(const Curve& curve) {
    if (std::holds_alternative<Segment>(curve)) return {};
    std::vector<double> found = stationary(curve, 0);
    for (const double t : stationary(curve, 1)) found.push_back(t);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::vector<double> smoothness_breaks(const Curve& curve) {
    const auto* spline = std::get_if<Spline>(&curve);
    return spline ? curve_parameters(*spline, spline->shape->breaks) : std::vector<double>{};
}

std::vector<double> smooth_cuts(const Curve& curve, double t0, double t1) {
    std::vector<double> cuts{t0};
    for (const double t : smoothness_breaks(curve))
        if (t > t0 && t < t1) cuts.push_back(t);
    cuts.push_back(t1);
    return cuts;
}

std::vector<double> crossings(const Curve& curve, int axis, double c) {
    std::vector<double> ends = stationary(curve, axis), found;
    ends.insert(ends.begin(), 0.0);
    ends.push_back(1.0);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double a = point(curve, ends[i])[axis] - c, b = point(curve, ends[i + 1])[axis] - c;
        if (a == b || a * b > 0) continue;
        const double t = a == 0 ? ends[i] : b == 0 ? ends[i + 1] : monotone_crossing(curve, ends[i], ends[i + 1], axis, c);
        if (found.empty() || t > found.back()) found.push_back(t);
    }
    return found;
}

double turning(const Curve& curve, double t0, double t1) {
    return visit(
        curve, [](const Segment&) { return 0.0; }, [&](const Arc& a) { return std::abs(a.sweep) * (t1 - t0); },
        [&]() {
            const auto* spline = std::get_if<Spline>(&curve);
            return spline ? turning_bound(*spline, t0, t1) : turning_of_ellipse(curve, t0, t1);
        });
}

Curve reversed(const Curve& curve) {
    if (const auto* s = std::get_if<Segment>(&curve)) return Segment{s->to, s->from};
    if (const auto* a = std::get_if<Arc>(&curve)) return Arc{a->center, a->radius, a->start + a->sweep, -a->sweep};
    if (const auto* e = std::get_if<EllipticArc>(&curve))
        return EllipticArc{e->center, e->a, e->b, e->start + e->sweep, -e->sweep};
    const Spline& spline = std::get<Spline>(curve);
    return Spline{spline.shape, spline.end, spline.begin};
}

Curve trimmed(const Curve& curve, double t0, double t1) {
    if (std::holds_alternative<Segment>(curve)) return Segment{point(curve, t0), point(curve, t1)};
    if (const auto* a = std::get_if<Arc>(&curve))
        return Arc{a->center, a->radius, a->start + t0 * a->sweep, (t1 - t0) * a->sweep};
    if (const auto* e = std::get_if<EllipticArc>(&curve))
        return EllipticArc{e->center, e->a, e->b, e->start + t0 * e->sweep, (t1 - t0) * e->sweep};
    const Spline& spline = std::get<Spline>(curve);
    return Spline{spline.shape, shape_parameter(spline, t0), shape_parameter(spline, t1)};
}

Curve transformed(const Curve& curve, const Similarity& map) {
    if (const auto* s = std::get_if<Segment>(&curve)) return Segment{map(s->from), map(s->to)};
    if (const auto* a = std::get_if<Arc>(&curve)) {
        const double turn = std::atan2(map.s, map.c), pi = std::numbers::pi;
        if (map.mirror) return Arc{map(a->center), map.scale * a->radius, turn + pi - a->start, -a->sweep};
        return Arc{map(a->center), map.scale * a->radius, a->start + turn, a->sweep};
    }
    if (const auto* e = std::get_if<EllipticArc>(&curve))
        return EllipticArc{map(e->center), map.turned(e->a), map.turned(e->b), e->start, e->sweep};
    const Spline& spline = std::get<Spline>(curve);
    return Spline{std::make_shared<const SplineShape>(transformed(*spline.shape, map)), spline.begin, spline.end};
}

Curve transformed(const Curve& curve, double c, double s, const Vec2& d) {
    return transformed(curve, Similarity{c, s, d, 1, false});
}

}  // namespace abut::geometry
