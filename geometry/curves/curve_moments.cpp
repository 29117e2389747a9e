// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/curve_moments.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/curves/gauss.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry {

namespace {

/// The closed forms cancel for small angles. Below this one series are summed; above it the loss is under two digits.
constexpr double small_half_angle = 0.5;

/// h - sin(h) cos(h): the area of the unit circle's segment of half angle h.
double unit_area(double h) {
    if (std::abs(h) > small_half_angle) return h - std::sin(h) * std::cos(h);
    // (2h - sin 2h) / 2
    double term = 2 * h, sum = 0;
    for (int k = 1; k < 12; ++k) {
        term *= -4 * h * h / (2 * k * (2 * k + 1));
        sum -= term / 2;
    }
    return sum;
}

/// First moment of that segment about its chord: the integral of unit_area(h) sin(h) dh = (9 sin h + sin 3h)/12 - h cos h.
double unit_moment(double h) {
    if (std::abs(h) > small_half_angle) return (9 * std::sin(h) + std::sin(3 * h)) / 12 - h * std::cos(h);
    // the coefficients (9^k + 3) / 4 - (2k + 1) of (-1)^k h^(2k+1) / (2k+1)! vanish for k = 0, 1
    double term = h, power = 1, sum = 0;
    for (int k = 1; k < 14; ++k) {
        term *= -h * h / (2 * k * (2 * k + 1));
        power *= 9;
        sum += term * ((power + 3) / 4 - (2 * k + 1));
    }
    return sum;
}

/// An affine image of the unit circle's segment: a and b are those of its axes, it runs from angle u by `sweep`. About o.
Moments of_ellipse(const Vec2& a, const Vec2& b, double u, double sweep, const Vec2& chord_middle, const Vec2& o) {
    const double half = sweep / 2, middle = u + half, scale = cross(a, b);
    const double area = scale * unit_area(half);
    const Vec2 along = std::cos(middle) * a + std::sin(middle) * b;
    return {area, area * (chord_middle - o) + scale * unit_moment(half) * along};
}

Moments of_triangle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& o) {
    const double area = cross(b - a, c - a) / 2;
    return {area, area * ((a - o) + (b - o) + (c - o)) / 3};
}

void add(Moments& sum, const Moments& m) {
    sum.area += m.area;
    sum.first += m.first;
}

/// Between the portion [u0, u1] of one span and its chord, by n Gauss points: the sum of the thin triangles from its first
/// point.
Moments by_gauss(const SplineShape& shape, double u0, double u1, int n, const Vec2& o) {
    const GaussRule& rule = gauss_rule(n);
    const Vec2 from = evaluate(shape, u0)[0];
    double area = 0;
    Vec2 first(0, 0);
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
        const auto values = evaluate(shape, u0 + rule.points[i] * (u1 - u0));
        const Vec2 r = values[0] - from;
        const double rate = rule.weights[i] * (u1 - u0) * cross(r, values[1]);
        area += rate / 2;
        first += rate / 3 * r;
    }
    return {area, first + area * (from - o)};
}

/// Rational spans, halved until two rules agree: within a rounding of the portion's box, or at the last halving.
Moments by_halving(const SplineShape& shape, double u0, double u1, const Vec2& o, double area_rounding, int halvings) {
    constexpr int n = 12;
    const double middle = 0.5 * (u0 + u1);
    const Moments whole = by_gauss(shape, u0, u1, n, o);
    Moments sum = by_gauss(shape, u0, middle, n, o);
    add(sum, by_gauss(shape, middle, u1, n, o));
    const Vec2 a = evaluate(shape, u0)[0], b = evaluate(shape, middle)[0], c = evaluate(shape, u1)[0];
    const Moments triangle = of_triangle(a, b, c, o);
    add(sum, triangle);
    if (halvings == 0 || std::abs(sum.area - whole.area) <= area_rounding) return sum;
    Moments halves = by_halving(shape, u0, middle, o, area_rounding, halvings - 1);
    add(halves, by_halving(shape, middle, u1, o, area_rounding, halvings - 1));
    add(halves, triangle);
    return halves;
}

/// Area within which two rules agree "to rounding": the integrand's own roundings, of the size of the span's control polygon.
constexpr double rounding_fraction = 1e-15;
constexpr int most_moment_halvings = 30;

Moments of_span_portion(const SplineShape& shape, std::size_t span, double u0, double u1, const Vec2& o) {
    if (!shape.rational) return by_gauss(shape, u0, u1, (3 * shape.degree + 1) / 2, o);
    Box2 box;
    const std::size_t n = static_cast<std::size_t>(shape.degree) + 1;
    for (std::size_t i = 0; i < n; ++i) box.extend(shape.points[span * n + i]);
    return by_halving(shape, u0, u1, o, rounding_fraction * box.size().squaredNorm(), most_moment_halvings);
}

/// u0 < u1.
Moments of_spline(const SplineShape& shape, double u0, double u1, const Vec2& o) {
    const Vec2 from = evaluate(shape, u0)[0];
    Moments sum;
    Vec2 at = from;
    for (std::size_t k = 0; k + 1 < shape.breaks.size(); ++k) {
        const double a = std::max(u0, shape.breaks[k]), b = std::min(u1, shape.breaks[k + 1]);
        if (a >= b) continue;
        const Vec2 next = evaluate(shape, b)[0];
        add(sum, of_span_portion(shape, k, a, b, o));
        add(sum, of_triangle(from, at, next, o));
        at = next;
    }
    return sum;
}

}  // namespace

Moments bulge(const Curve& curve, double t0, double t1, const Vec2& o) {
    const auto chord_middle = [&] { return Vec2(0.5 * (point(curve, t0) + point(curve, t1))); };
    if (const auto* arc = std::get_if<Arc>(&curve))
        return of_ellipse({arc->radius, 0}, {0, arc->radius}, arc->start + t0 * arc->sweep, (t1 - t0) * arc->sweep,
                          chord_middle(), o);
    if (const auto* arc = std::get_if<EllipticArc>(&curve))
        return of_ellipse(arc->a, arc->b, arc->start + t0 * arc->sweep, (t1 - t0) * arc->sweep, chord_middle(), o);
    const auto* spline = std::get_if<Spline>(&curve);
    if (!spline) return {};
    const double u0 = spline->begin + t0 * (spline->end - spline->begin);
    const double u1 = t1 == 1 ? spline->end : spline->begin + t1 * (spline->end - spline->begin);
    if (u0 == u1) return {};
    Moments sum = of_spline(*spline->shape, std::min(u0, u1), std::max(u0, u1), o);
    if (u1 > u0) return sum;
    return {-sum.area, -sum.first};
}

}  // namespace abut::geometry
