// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/general_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/curves/elliptic_arc.hpp"
#include "geometry/curves/gauss.hpp"
#include "geometry/curves/numbers.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry {

namespace {

/// Where the rules of two halves agree with that of the whole by this fraction, their own error is far smaller still: halving
/// divides it by up to 2^32, the rule's degree.
constexpr int n_length_points = 16;
constexpr double agreement = 1e-13;
/// `whole` is the rule's length of [t0, t1]; `total` that of the curve, of which a rounding is good enough.
double length_by_halving(const Curve& curve, double t0, double t1, double whole, double total, int halvings) {
    const double middle = 0.5 * (t0 + t1);
    const double a = length_by_gauss(curve, t0, middle), b = length_by_gauss(curve, middle, t1);
    if (halvings == 0 || lengths_agree(a + b, whole, total)) return a + b;
    return length_by_halving(curve, t0, middle, a, total, halvings - 1) +
           length_by_halving(curve, middle, t1, b, total, halvings - 1);
}

/// Is the interval one that doubles cannot halve?
bool settled(double lo, double hi) {
    const double middle = 0.5 * (lo + hi);
    return !(lo < middle && middle < hi);
}

}  // namespace

std::array<Vec2, 3> general_values(const Curve& curve, double t) {
    if (const auto* arc = std::get_if<EllipticArc>(&curve)) return evaluate(*arc, t);
    const Spline& spline = std::get<Spline>(curve);
    const double rate = spline.end - spline.begin;
    std::array<Vec2, 3> values = evaluate(*spline.shape, t == 1 ? spline.end : spline.begin + t * rate);
    values[1] *= rate;
    values[2] *= rate * rate;
    return values;
}

double length_by_gauss(const Curve& curve, double t0, double t1) {
    const GaussRule& rule = gauss_rule(n_length_points);
    double sum = 0;
    for (std::size_t i = 0; i < rule.points.size(); ++i)
        sum += rule.weights[i] * general_values(curve, t0 + rule.points[i] * (t1 - t0))[1].norm();
    return (t1 - t0) * sum;
}

bool lengths_agree(double halves, double whole, double total) {
    return std::abs(halves - whole) <= std::max(agreement * halves, epsilon * total);
}

double general_length(const Curve& curve, double t0, double t1) {
    if (t0 > t1) return -general_length(curve, t1, t0);
    const std::vector<double> cuts = smooth_cuts(curve, t0, t1);
    std::vector<double> rough;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) rough.push_back(length_by_gauss(curve, cuts[i], cuts[i + 1]));
    const double total = std::accumulate(rough.begin(), rough.end(), 0.0);
    double sum = 0;
    for (std::size_t i = 0; i < rough.size(); ++i)
        sum += length_by_halving(curve, cuts[i], cuts[i + 1], rough[i], total, most_length_halvings);
    return sum;
}

double general_parameter_at_length(const Curve& curve, double s) {
    const double total = length(curve);
    if (!(s > 0)) return 0;
    if (s >= total) return 1;
    double lo = 0, hi = 1, t = s / total, reached = length(curve, 0, t);
    while (!settled(lo, hi)) {
        if (reached == s) return t;
        (reached < s ? lo : hi) = t;
        const double newton = t + (s - reached) / general_values(curve, t)[1].norm();
        const double next = lo < newton && newton < hi ? newton : 0.5 * (lo + hi);
        if (std::abs(next - t) <= epsilon) return next;  // reversed splines resolve no finer near their beginning
        reached += length(curve, t, next);
        t = next;
    }
    return t;
}

double monotone_crossing(const Curve& curve, double t0, double t1, int axis, double c) {
    const double at0 = point(curve, t0)[axis] - c, at1 = point(curve, t1)[axis] - c;
    if (at0 == 0 || at1 == 0 || (at0 < 0) == (at1 < 0)) return std::abs(at0) <= std::abs(at1) ? t0 : t1;
    double lo = t0, hi = t1, t = t0 - at0 * (t1 - t0) / (at1 - at0), step = t1 - t0;
    for (;;) {
        if (!(lo < t && t < hi)) t = 0.5 * (lo + hi);
        const double value = point(curve, t)[axis] - c;
        if (value == 0 || settled(lo, hi)) return t;
        ((value < 0) == (at0 < 0) ? lo : hi) = t;
        const double newton = t - value / derivative(curve, t)[axis];
        // Newton's steps must halve: near an extremum, and across inflections, the interval is halved instead
        const bool good = lo < newton && newton < hi && std::abs(newton - t) <= 0.5 * std::abs(step);
        const double next = good ? newton : 0.5 * (lo + hi);
        step = next - t;
        if (std::abs(step) <= epsilon * std::abs(t)) return next;
        t = next;
    }
}

}  // namespace abut::geometry
