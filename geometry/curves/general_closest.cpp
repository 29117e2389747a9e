// SPDX-License-Identifier: GPL-3.0-or-later
// The closest point of an ellipse or a spline. On a rational span c = X / w, with Q = X - p w, the squared distance has the
// slope 2 N / w^3, N = (Q . Q') w - (Q . Q) w': a polynomial in Bernstein form, whose coefficients change sign at least as
// often as it has roots. Halving until they change sign once finds every minimum; spans whose control boxes are farther than
// the best point known are left out before that.
#include <algorithm>
#include <cmath>

#include "geometry/curves/bernstein.hpp"
#include "geometry/curves/general_curve.hpp"
#include "geometry/curves/homogeneous_span.hpp"
#include "geometry/curves/numbers.hpp"

namespace abut::geometry {

namespace {

/// Roundings of a coefficient of N: products of up to nine terms, each rounded a few times.
constexpr double slope_roundings = 16;
/// Roundings of a coordinate of the curve's points.
constexpr double point_roundings = 4;

/// Distance squared within which two points are equally close.
double distance_rounding(double d2, const Vec2& p) {
    const double d = std::sqrt(d2), move = point_roundings * epsilon * (p.cwiseAbs().maxCoeff() + d);
    return 2 * d * move + move * move;
}

/// The best parameter known: the smallest of those that are equally close.
struct Search {
    const Curve& curve;
    Vec2 p;
    double t = 0;
    double least = infinity;  ///< distance squared
    double rounding = 0;
};

void offer(Search& search, double t, const Vec2& at) {
    const double d2 = (at - search.p).squaredNorm();
    const bool better = d2 < search.least - search.rounding;
    if (better || (d2 <= search.least + search.rounding && t < search.t)) search.t = t;
    if (d2 >= search.least) return;
    search.least = d2;
    search.rounding = distance_rounding(d2, search.p);
}

void offer(Search& search, double t) {
    offer(search, t, general_values(search.curve, t)[0]);
}

/// Half the slope of the squared distance by t, and the slope of that.
struct Slope {
    double value, rate, speed2;
};
Slope slope_at(const Search& search, double t) {
    const auto [x, d, dd] = general_values(search.curve, t);
    return {(x - search.p).dot(d), d.squaredNorm() + (x - search.p).dot(dd), d.squaredNorm()};
}

/// The one minimum between lo and hi, from `t` on: Newton's steps while they halve, else half the interval.
double minimum_between(const Search& search, double lo, double hi, double t) {
    double step = hi - lo;
    for (;;) {
        const double middle = 0.5 * (lo + hi);
        if (!(lo < middle && middle < hi)) return t;
        if (!(lo < t && t < hi)) t = middle;
        const Slope slope = slope_at(search, t);
        if (slope.value == 0) return t;
        (slope.value < 0 ? lo : hi) = t;
        const double newton = t - slope.value / slope.rate;
        const bool good = lo < newton && newton < hi && std::abs(newton - t) <= 0.5 * std::abs(step);
        const double next = good ? newton : 0.5 * (lo + hi);
        step = next - t;
        if (std::abs(step) <= epsilon * std::abs(t)) return next;
        t = next;
    }
}

Bernstein distance_slope(const HomogeneousSpan& q, double& rounding) {
    const Bernstein dx = derivative(q.x), dy = derivative(q.y);
    const Bernstein along = q.x * dx + q.y * dy;
    const double size = largest(q.x) * largest(dx) + largest(q.y) * largest(dy);
    rounding = slope_roundings * epsilon * size;
    if (!q.rational) return along;
    const Bernstein dw = derivative(q.w), squared = q.x * q.x + q.y * q.y;
    rounding = slope_roundings * epsilon * (size * largest(q.w) + largest(squared) * largest(dw));
    return along * q.w - squared * dw;
}

/// Signs of the coefficients in order, zeros left out: how often they change, the first, and where the first change is.
struct Signs {
    int changes = 0, first = 0;
    double crossing = 0.5;  ///< of the control polygon, in [0, 1]
};
Signs signs_of(const Bernstein& n, double rounding) {
    Signs signs;
    int last = 0, at = 0;
    for (int i = 0; i <= n.degree; ++i) {
        if (std::abs(n[i]) <= rounding) continue;
        const int sign = n[i] < 0 ? -1 : 1;
        if (last == 0) signs.first = sign;
        if (sign == -last && ++signs.changes == 1) signs.crossing = (at + n[at] / (n[at] - n[i]) * (i - at)) / n.degree;
        last = sign;
        at = i;
    }
    return signs;
}

/// Offers all minima inside [s0, s1] of a span; `parameter` maps s to t, ascending or descending.
template <class Parameter>
void offer_minima(Search& search, const Bernstein& n, double rounding, double s0, double s1, int halvings,
                  const Parameter& parameter) {
    const Signs signs = signs_of(n, rounding);
    if (signs.changes == 0 || (signs.changes == 1 && signs.first > 0)) return;
    if (signs.changes == 1 || halvings == 0) {
        const double a = parameter(s0), b = parameter(s1), t = parameter(s0 + signs.crossing * (s1 - s0));
        return offer(search, minimum_between(search, std::min(a, b), std::max(a, b), t));
    }
    const auto [before, behind] = halves(n);
    const double middle = 0.5 * (s0 + s1);
    offer(search, parameter(middle));  // a root exactly here is none of either half
    offer_minima(search, before, rounding, s0, middle, halvings - 1, parameter);
    offer_minima(search, behind, rounding, middle, s1, halvings - 1, parameter);
}

template <class Parameter>
void offer_span(Search& search, const HomogeneousSpan& relative_to_p, const Parameter& parameter) {
    double rounding = 0;
    const Bernstein slope = distance_slope(relative_to_p, rounding);
    offer_minima(search, slope, rounding, 0, 1, most_parameter_halvings, parameter);
}

/// Distance squared of p from a box.
double least_distance(const Box2& box, const Vec2& p) {
    return (box.min - p).cwiseMax(p - box.max).cwiseMax(0.0).squaredNorm();
}

bool worth_looking(const Search& search, double bound) {
    return bound <= search.least + search.rounding;
}

void search_ellipse(Search& search, const EllipticArc& arc) {
    const int n = static_cast<int>(std::ceil(std::abs(arc.sweep) / 1.58));  // quarter turns, with their roundings
    for (int i = 0; i <= n; ++i) offer(search, i * 1.0 / n);
    for (int i = 0; i < n; ++i) {
        const double t0 = i * 1.0 / n, t1 = (i + 1.0) / n, turn = (t1 - t0) * arc.sweep, tangent = std::tan(turn / 4);
        const HomogeneousSpan span = homogeneous_span(arc, arc.start + t0 * arc.sweep, arc.start + t1 * arc.sweep, search.p);
        if (!worth_looking(search, least_distance(control_box(span), Vec2::Zero()))) continue;
        offer_span(search, span, [&](double s) {
            return s == 0 ? t0 : s == 1 ? t1 : 0.5 * (t0 + t1) + 2 * std::atan((2 * s - 1) * tangent) / arc.sweep;
        });
    }
}

Box2 control_box(const SplineShape& shape, std::size_t k) {
    const std::size_t n = static_cast<std::size_t>(shape.degree) + 1;
    Box2 box;
    for (std::size_t i = k * n; i < (k + 1) * n; ++i) box.extend(shape.points[i]);
    return box;
}

/// One span of a spline, as far as the curve runs over it.
void search_span(Search& search, const Spline& spline, std::size_t k) {
    const SplineShape& shape = *spline.shape;
    if (!worth_looking(search, least_distance(control_box(shape, k), search.p))) return;
    const double u0 = shape.breaks[k], width = shape.breaks[k + 1] - u0, range = spline.end - spline.begin;
    const double lo = (std::min(spline.begin, spline.end) - u0) / width, hi = (std::max(spline.begin, spline.end) - u0) / width;
    const double s0 = std::max(lo, 0.0), s1 = std::min(hi, 1.0);
    HomogeneousSpan span = homogeneous_span(shape, k, search.p);
    if (s0 > 0 || s1 < 1) span = portion(span, s0, s1);
    offer_span(search, span,
               [&](double s) { return std::clamp((u0 + (s0 + s * (s1 - s0)) * width - spline.begin) / range, 0.0, 1.0); });
}

void search_spline(Search& search, const Spline& spline) {
    const SplineShape& shape = *spline.shape;
    const double lo = std::min(spline.begin, spline.end), hi = std::max(spline.begin, spline.end);
    offer(search, 0);
    offer(search, 1);
    std::size_t nearest = 0;
    double least = infinity;
    const auto each_span = [&](auto visit) {
        for (std::size_t k = 0; k + 1 < shape.breaks.size(); ++k)
            if (shape.breaks[k + 1] > lo && shape.breaks[k] < hi) visit(k);
    };
    each_span([&](std::size_t k) {
        const double u = shape.breaks[k];
        if (u > lo)
            offer(search, (u - spline.begin) / (spline.end - spline.begin),
                  shape.points[k * (static_cast<std::size_t>(shape.degree) + 1)]);
        const double bound = least_distance(control_box(shape, k), search.p);
        if (bound >= least) return;
        least = bound;
        nearest = k;
    });
    search_span(search, spline, nearest);
    each_span([&](std::size_t k) {
        if (k != nearest) search_span(search, spline, k);
    });
}

/// Where Newton is safe, and how small its steps are then: the curvature of the squared distance, as a fraction of the speed's.
constexpr double safe_fraction = 1e-7, safe_step = 1e-6;

/// A sample equally close as a minimum just behind it may have won by its smaller parameter.
double polished(const Search& search) {
    double t = search.t;
    for (int step = 0; step < 3; ++step) {
        const Slope slope = slope_at(search, t);
        if (slope.rate <= safe_fraction * slope.speed2) return search.t;
        t = std::clamp(t - slope.value / slope.rate, 0.0, 1.0);
        if (std::abs(t - search.t) > safe_step) return search.t;
    }
    const double d2 = (general_values(search.curve, t)[0] - search.p).squaredNorm();
    return d2 <= search.least + search.rounding ? t : search.t;
}

}  // namespace

double general_closest_parameter(const Curve& curve, const Vec2& p) {
    Search search{curve, p};
    if (const auto* arc = std::get_if<EllipticArc>(&curve)) {
        search_ellipse(search, *arc);
    } else {
        search_spline(search, std::get<Spline>(curve));
    }
    return polished(search);
}

}  // namespace abut::geometry
