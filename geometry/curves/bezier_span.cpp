// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/bezier_span.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/curves/gauss.hpp"
#include "geometry/curves/homogeneous_span.hpp"
#include "geometry/curves/numbers.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry {

namespace {

template <class T>
using Coefficients = std::array<T, max_spline_degree + 1>;

template <class T>
struct Jet {
    T value, first, second;
};

/// Value and derivatives of the Bernstein polynomial of degree n at s (de Casteljau); overwrites c.
template <class T>
Jet<T> jet(Coefficients<T>& c, std::size_t n, double s) {
    const auto reduce_to = [&](std::size_t from, std::size_t to) {
        for (std::size_t k = from; k > to; --k)
            for (std::size_t i = 0; i < k; ++i) c[i] = (1 - s) * c[i] + s * c[i + 1];
    };
    const auto degree = static_cast<double>(n);
    Jet<T> result{c[0], c[0] - c[0], c[0] - c[0]};
    reduce_to(n, 2);
    if (n > 1) result.second = degree * (degree - 1) * ((c[2] - c[1]) - (c[1] - c[0]));
    reduce_to(std::min<std::size_t>(n, 2), 1);
    result.first = degree * (c[1] - c[0]);
    reduce_to(1, 0);
    result.value = c[0];
    return result;
}

/// Coordinates are taken from the nearer end, so that far from the origin nothing is lost but the last addition's rounding.
std::array<Vec2, 3> values(const BezierSpan& span, double s) {
    const std::size_t n = span.points.size() - 1;
    const Vec2 base = s < 0.5 ? span.points.front() : span.points.back();
    Coefficients<Vec2> q;
    for (std::size_t i = 0; i <= n; ++i) q[i] = span.points[i] - base;
    if (span.weights.empty()) {
        const Jet<Vec2> x = jet(q, n, s);
        return {base + x.value, x.first, x.second};
    }
    Coefficients<double> w;
    for (std::size_t i = 0; i <= n; ++i) {
        w[i] = span.weights[i];
        q[i] *= w[i];
    }
    const Jet<Vec2> x = jet(q, n, s);
    const Jet<double> v = jet(w, n, s);
    const Vec2 p = x.value / v.value;
    const Vec2 d = (x.first - v.first * p) / v.value;
    return {base + p, d, (x.second - 2 * v.first * d - v.second * p) / v.value};
}

double speed_integral(const BezierSpan& span, double s0, double s1) {
    const GaussRule& rule = gauss_rule(16);
    double sum = 0;
    for (std::size_t i = 0; i < rule.points.size(); ++i)
        sum += rule.weights[i] * values(span, s0 + rule.points[i] * (s1 - s0))[1].norm();
    return sum * (s1 - s0);
}

/// `whole` is the rule's value on [s0, s1]. Ends by itself: the parts shrink below the rounding of the whole.
double halved_length(const BezierSpan& span, double s0, double s1, double whole, double rounding) {
    const double m = 0.5 * (s0 + s1), a = speed_integral(span, s0, m), b = speed_integral(span, m, s1);
    if (!(std::abs(a + b - whole) > rounding)) return a + b;
    return halved_length(span, s0, m, a, rounding) + halved_length(span, m, s1, b, rounding);
}

}  // namespace

std::array<Vec2, 3> evaluate(const BezierSpan& span, double s) {
    std::array<Vec2, 3> result = values(span, s);
    if (result[1].isZero(0) && s == 0) result[1] = values(span, epsilon)[1];
    if (result[1].isZero(0) && s == 1) result[1] = values(span, 1 - epsilon)[1];
    return result;
}

double length(const BezierSpan& span, double s0, double s1) {
    const double roundings_of_a_sum = 16;
    return halved_length(span, s0, s1, speed_integral(span, s0, s1),
                         roundings_of_a_sum * epsilon * polygon_length(span.points));
}

/// With X = sum w_i x_i B_i^n = (1-s) X_a + s X_b and W alike, X'W - XW' = n (X_b W_a - X_a W_b), the product of polynomials of
/// degree n - 1; paired terms leave differences of points only.
Velocity velocity(const BezierSpan& span, int axis) {
    const std::size_t n = span.points.size() - 1;
    const double rounding = rounding_length(span.points);
    const auto leg = [&](std::size_t from, std::size_t to) { return span.points[to][axis] - span.points[from][axis]; };
    Velocity result;
    if (span.weights.empty()) {
        for (std::size_t i = 0; i < n; ++i) result.coefficients.push_back(leg(i, i + 1));
        result.errors.assign(n, rounding);
        return result;
    }
    result.coefficients.assign(2 * n - 1, 0.0);
    result.errors.assign(2 * n - 1, 0.0);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double share = binomial(n - 1, i) * binomial(n - 1, j) / binomial(2 * n - 2, i + j);
            result.coefficients[i + j] += share * span.weights[i + 1] * span.weights[j] * leg(j, i + 1);
            result.errors[i + j] += share * span.weights[i + 1] * span.weights[j] * rounding;
        }
    return result;
}

double polygon_length(std::span<const Vec2> points) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) sum += (points[i + 1] - points[i]).norm();
    return sum;
}

double rounding_length(std::span<const Vec2> points) {
    double largest = 0;
    for (const Vec2& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    return coordinate_roundings * epsilon * largest;
}

}  // namespace abut::geometry
