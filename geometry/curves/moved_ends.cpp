// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/moved_ends.hpp"

#include <cmath>
#include <numbers>

#include "geometry/curves/spline_shape.hpp"
#include "geometry/curves/spline_spans.hpp"

namespace abut::geometry {

namespace {

/// Ends are well apart if that is more than this fraction of the curve's length: moving one by e then moves no point by more
/// than about e / fraction.
constexpr double well_apart_fraction = 0.1;

Curve turned_as_a_whole(const Curve& curve, const Vec2& from, const Vec2& to) {
    const Vec2 begin = point(curve, 0), drawn = point(curve, 1) - begin, wanted = to - from;
    const Vec2 turn(drawn.dot(wanted), cross(drawn, wanted));
    Similarity map;
    map.scale = wanted.norm() / drawn.norm();
    map.c = turn.x() / turn.norm();
    map.s = turn.y() / turn.norm();
    map.d = from - map.turned(begin);
    return transformed(curve, map);
}

/// Rational quadratic spans of a quarter turn at most: the same points at another parameter.
Spline as_spline(const EllipticArc& arc) {
    constexpr double most = std::numbers::pi / 2;
    const int n = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / most)));
    const double half = arc.sweep / (2 * n), middle_weight = std::cos(half);
    const auto at = [&](double angle, double radius) -> Vec2 {
        return arc.center + radius * (std::cos(angle) * arc.a + std::sin(angle) * arc.b);
    };
    SplineShape shape{2, {0.0}, {}, {}, true, true, {}};
    for (int k = 0; k < n; ++k) {
        const double begin = arc.start + 2 * k * half;
        shape.points.insert(shape.points.end(), {at(begin, 1), at(begin + half, 1 / middle_weight), at(begin + 2 * half, 1)});
        shape.weights.insert(shape.weights.end(), {1, middle_weight, 1});
        shape.breaks.push_back(static_cast<double>(k + 1) / n);
    }
    measure(shape);
    return {std::make_shared<const SplineShape>(std::move(shape)), 0, 1};
}

/// Control points moved by what the ends are to move, in proportion of the parameter they stand for. Exact for polynomial
/// splines and where ends are control points.
Spline bent(const Spline& spline, const Vec2& at_begin, const Vec2& at_end) {
    SplineShape shape = *spline.shape;
    const auto n = static_cast<std::size_t>(shape.degree) + 1;
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const std::size_t span = i / n;
        const double within = static_cast<double>(i % n) / shape.degree;
        const double u = (1 - within) * shape.breaks[span] + within * shape.breaks[span + 1];
        const double t = (u - spline.begin) / (spline.end - spline.begin);
        shape.points[i] += (1 - t) * at_begin + t * at_end;
    }
    measure(shape);
    return {std::make_shared<const SplineShape>(std::move(shape)), spline.begin, spline.end};
}

/// What is left after one step, of a portion of a rational spline, is a fraction of it.
Curve bent_until_it_meets(Spline spline, const Vec2& from, const Vec2& to) {
    constexpr int most_steps = 20;
    for (int step = 0; step < most_steps; ++step) {
        const Vec2 at_begin = from - point(spline, 0), at_end = to - point(spline, 1);
        if (at_begin == Vec2(0, 0) && at_end == Vec2(0, 0)) break;
        spline = bent(spline, at_begin, at_end);
    }
    return spline;
}

}  // namespace

Curve with_moved_ends(const Curve& curve, const Vec2& from, const Vec2& to) {
    const double apart = (point(curve, 1) - point(curve, 0)).norm();
    const bool is_well_apart = apart > well_apart_fraction * length(curve);
    if (is_well_apart && from != to) return turned_as_a_whole(curve, from, to);
    const auto* ellipse = std::get_if<EllipticArc>(&curve);
    if (ellipse && from == to && std::abs(ellipse->sweep) > std::numbers::pi) {
        const Vec2 move = from - point(curve, 0);
        return EllipticArc{ellipse->center + move, ellipse->a, ellipse->b, ellipse->start,
                           std::copysign(2 * std::numbers::pi, ellipse->sweep)};
    }
    return bent_until_it_meets(ellipse ? as_spline(*ellipse) : std::get<Spline>(curve), from, to);
}

}  // namespace abut::geometry
