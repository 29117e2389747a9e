// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/arc_portion.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "geometry/curves/numbers.hpp"

namespace abut::geometry {

namespace {

/// Circle or line through the first point as { q : curvature q.q / 2 = q . normal }, q relative to that point; normal is a unit
/// vector, towards the centre.
struct Through {
    Vec2 normal;
    double curvature;
};

/// Through the origin, `via` and `to`.
Through through(const Vec2& via, const Vec2& to) {
    const Vec2 back = to - via;
    const double area = cross(via, to);
    const double curvature = 2 * std::abs(area) / (via.norm() * to.norm() * back.norm());
    // the tangent at the origin turns against `via` as much as `to` does against `back` (inscribed angles)
    using Complex = std::complex<double>;
    const Complex turned = Complex(via.x(), via.y()) * Complex(to.x(), to.y()) * Complex(back.x(), -back.y());
    const Vec2 tangent = Vec2(turned.real(), turned.imag()).normalized();
    return {area < 0 ? right_of(tangent) : left_of(tangent), curvature};
}

/// Halvings of the portion for its bound: Bernstein coefficients exceed their polynomial by a part that falls with their
/// square.
constexpr int bound_halvings = 2;

Bernstein one(int degree) {
    Bernstein unit;
    unit.degree = degree;
    std::fill_n(unit.c.begin(), degree + 1, 1.0);
    return unit;
}

/// A bound of |gap / weight| on [0, 1].
double ratio_bound(const Bernstein& gap, const Bernstein& weight, int halvings) {
    if (halvings == 0) return largest(gap) / *std::min_element(weight.c.begin(), weight.c.begin() + weight.degree + 1);
    const auto [g0, g1] = halves(gap);
    const auto [w0, w1] = halves(weight);
    return std::max(ratio_bound(g0, w0, halvings - 1), ratio_bound(g1, w1, halvings - 1));
}

/// A bound of |curvature q.q / 2 - q.normal| = |(rho - r)(rho + r)| / (2 r), rho the distance from the centre.
double gap_bound(const HomogeneousSpan& span, const Through& circle) {
    const Bernstein squared = (0.5 * circle.curvature) * (span.x * span.x + span.y * span.y);
    const Bernstein across = circle.normal.x() * span.x + circle.normal.y() * span.y;
    const Bernstein weight = span.rational ? span.w : one(span.x.degree);
    return ratio_bound(squared - across * weight, weight * weight, bound_halvings);
}

/// Where the sagitta, and the rounding of the radius too, would be this fraction of the tolerance: less of the one and more of
/// the other make a segment, for the centre would be too far for doubles.
constexpr double straight_fraction = 0.01;
/// The bound holds for the distance itself while the deviation is small against the radius.
constexpr double most_relative_deviation = 0.25;

/// The larger of deviation and kink, as excess: an end's kink grows with the square of the length.
double excess(const Portion& portion, const Curve& curve, double deviation, const ArcBounds& bounds) {
    const auto kink = [&](double t, const Vec2& tangent) { return std::abs(cross(unit_tangent(curve, t), tangent)); };
    const double end_kink = std::max(kink(0, portion.first_tangent), kink(1, portion.last_tangent));
    return std::max(deviation / bounds.tolerance, std::pow(2 * end_kink / bounds.kink, 1.5));
}

}  // namespace

ArcFit fit_arc(const Portion& portion, const ArcBounds& bounds) {
    const Vec2 chord = portion.to - portion.from, d = portion.via - portion.from;
    const double offset = cross(chord.normalized(), d), negligible = straight_fraction * bounds.tolerance;
    const Through circle = through(d, chord);
    if (std::abs(offset) <= negligible && epsilon >= negligible * circle.curvature) {
        const Segment segment{portion.from, portion.to};
        return {segment, excess(portion, segment, gap_bound(portion.span, {left_of(chord.normalized()), 0}), bounds)};
    }
    const double radius = 1 / circle.curvature, deviation = gap_bound(portion.span, circle);
    const double half = std::asin(std::min(1.0, 0.5 * chord.norm() * circle.curvature));
    const Vec2 r = -circle.normal;
    // what runs on the right of its chord turns left
    const Arc arc{portion.from + radius * circle.normal, radius, std::atan2(r.y(), r.x()), offset < 0 ? 2 * half : -2 * half};
    const bool flat = deviation <= most_relative_deviation * radius && d.dot(chord) > 0 && (chord - d).dot(chord) > 0;
    if (!flat) return {arc, std::numeric_limits<double>::infinity()};
    return {arc, excess(portion, arc, deviation * (1 + deviation / radius), bounds)};
}

}  // namespace abut::geometry
