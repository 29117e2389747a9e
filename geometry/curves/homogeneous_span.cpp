// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/homogeneous_span.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/curves/numbers.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

using Binomials = std::array<std::array<double, Bernstein::max_degree + 1>, Bernstein::max_degree + 1>;

constexpr Binomials make_binomials() {
    Binomials b{};
    for (std::size_t n = 0; n < b.size(); ++n) {
        b[n][0] = 1;
        for (std::size_t k = 1; k <= n; ++k) b[n][k] = b[n - 1][k - 1] + (k < n ? b[n - 1][k] : 0);
    }
    return b;
}

constexpr Binomials binomials = make_binomials();

template <class Operation>
Bernstein combined(const Bernstein& a, const Bernstein& b, Operation operation) {
    Bernstein sum;
    sum.degree = a.degree;
    for (int i = 0; i <= a.degree; ++i) sum[i] = operation(a[i], b[i]);
    return sum;
}

/// Splits at s: returns what lies before, leaves what lies behind.
Bernstein split(Bernstein& a, double s) {
    Bernstein before;
    before.degree = a.degree;
    for (int n = a.degree; n >= 0; --n) {
        before[a.degree - n] = a[0];
        for (int i = 0; i < n; ++i) a[i] = (1 - s) * a[i] + s * a[i + 1];
    }
    return before;
}

/// Of a polygon of directions (x[i], y[i]); those shorter than `rounding` have none.
double polygon_turning(const Bernstein& x, const Bernstein& y, double rounding, int halvings) {
    if (halvings > 0) {
        const auto [x0, x1] = halves(x);
        const auto [y0, y1] = halves(y);
        return polygon_turning(x0, y0, rounding, halvings - 1) + polygon_turning(x1, y1, rounding, halvings - 1);
    }
    double sum = 0;
    Vec2 before(0, 0);
    bool any = false;
    for (int i = 0; i <= x.degree; ++i) {
        const Vec2 d(x[i], y[i]);
        if (d.norm() <= rounding) continue;
        if (any) sum += std::abs(angle_between(before, d));
        before = d;
        any = true;
    }
    return sum;
}

}  // namespace

double binomial(std::size_t n, std::size_t k) {
    return binomials[n][k];
}

Bernstein operator+(const Bernstein& a, const Bernstein& b) {
    return combined(a, b, [](double x, double y) { return x + y; });
}

Bernstein operator-(const Bernstein& a, const Bernstein& b) {
    return combined(a, b, [](double x, double y) { return x - y; });
}

Bernstein operator*(double factor, const Bernstein& a) {
    return combined(a, a, [&](double x, double) { return factor * x; });
}

Bernstein operator*(const Bernstein& a, const Bernstein& b) {
    Bernstein product;
    product.degree = a.degree + b.degree;
    for (int i = 0; i <= a.degree; ++i) {
        const double scaled = binomial(at(a.degree), at(i)) * a[i];
        for (int j = 0; j <= b.degree; ++j) product[i + j] += scaled * binomial(at(b.degree), at(j)) * b[j];
    }
    for (int k = 0; k <= product.degree; ++k) product[k] /= binomial(at(product.degree), at(k));
    return product;
}

Bernstein derivative(const Bernstein& a) {
    Bernstein rate;
    rate.degree = std::max(a.degree - 1, 0);
    for (int i = 0; i < a.degree; ++i) rate[i] = a.degree * (a[i + 1] - a[i]);
    return rate;
}

std::array<Bernstein, 2> halves(const Bernstein& a) {
    Bernstein behind = a;
    const Bernstein before = split(behind, 0.5);
    return {before, behind};
}

Bernstein portion(const Bernstein& a, double s0, double s1) {
    Bernstein behind = a;
    Bernstein before = s1 < 1 ? split(behind, s1) : a;
    if (s0 > 0) split(before, s0 / s1);
    return before;
}

double largest(const Bernstein& a) {
    double value = 0;
    for (int i = 0; i <= a.degree; ++i) value = std::max(value, std::abs(a[i]));
    return value;
}

HomogeneousSpan homogeneous_span(const SplineShape& shape, std::size_t k, const Vec2& origin) {
    HomogeneousSpan span;
    span.rational = shape.rational;
    span.x.degree = span.y.degree = shape.degree;
    span.w.degree = shape.rational ? shape.degree : 0;
    span.w[0] = 1;
    const std::size_t first = k * (static_cast<std::size_t>(shape.degree) + 1);
    for (int i = 0; i <= shape.degree; ++i) {
        const std::size_t at = first + static_cast<std::size_t>(i);
        const double w = shape.rational ? shape.weights[at] : 1.0;
        if (shape.rational) span.w[i] = w;
        span.x[i] = w * (shape.points[at].x() - origin.x());
        span.y[i] = w * (shape.points[at].y() - origin.y());
    }
    return span;
}

HomogeneousSpan homogeneous_span(const EllipticArc& ellipse, double u0, double u1, const Vec2& origin) {
    const EllipticArc by_angle{ellipse.center, ellipse.a, ellipse.b, 0, 1};
    const double w = std::cos(0.5 * (u1 - u0)), middle = 0.5 * (u0 + u1);
    const Vec2 from = evaluate(by_angle, u0)[0] - origin, to = evaluate(by_angle, u1)[0] - origin;
    const Vec2 via = w * (ellipse.center - origin) + std::cos(middle) * ellipse.a + std::sin(middle) * ellipse.b;
    HomogeneousSpan span;
    span.rational = true;
    span.x.degree = span.y.degree = span.w.degree = 2;
    span.x.c = {from.x(), via.x(), to.x()};
    span.y.c = {from.y(), via.y(), to.y()};
    span.w.c = {1, w, 1};
    return span;
}

HomogeneousSpan portion(const HomogeneousSpan& span, double s0, double s1) {
    return {portion(span.x, s0, s1), portion(span.y, s0, s1), span.rational ? portion(span.w, s0, s1) : span.w, span.rational};
}

Box2 control_box(const HomogeneousSpan& span) {
    Box2 box;
    for (int i = 0; i <= span.x.degree; ++i) {
        const double w = span.rational ? span.w[i] : 1.0;
        box.extend(Vec2(span.x[i] / w, span.y[i] / w));
    }
    return box;
}

double turning_bound(const HomogeneousSpan& span) {
    Bernstein x = derivative(span.x), y = derivative(span.y);
    if (span.rational) {
        const Bernstein dw = derivative(span.w);
        x = x * span.w - span.x * dw;
        y = y * span.w - span.y * dw;
    }
    constexpr double direction_rounding = 64 * epsilon;
    constexpr int halvings = 2;
    return polygon_turning(x, y, direction_rounding * std::hypot(largest(x), largest(y)), halvings);
}

}  // namespace abut::geometry
