// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/gauss_portions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/curves/gauss.hpp"
#include "geometry/curves/homogeneous_span.hpp"
#include "geometry/curves/numbers.hpp"

namespace abut::geometry {

namespace {

constexpr int many_points = 48;    // from here on a portion of a rational spline or an ellipse is halved
constexpr int most_halvings = 40;  // where a curve stands still, the last portion is a rounding of the parameter

/// The integrand along an arc is a trigonometric polynomial of degree `frequency`: Gauss points needed beyond the straight case
/// so that the patch test on discs holds to 1e-9.
int extra_points(int frequency, double angle) {
    return angle > 0 ? 2 + static_cast<int>(std::ceil(0.5 * frequency * angle)) : 0;
}

/// How far a portion gets from its middle, in units of a cell, in the complex plane; z runs over the portion from 0 to 1.
struct Reach {
    double offset;   ///< |x - x_m|
    double rate;     ///< |dx/dz|
    double density;  ///< |ds/dz|, in units of what it is at the middle, about
};

/// A portion of an ellipse or of one span of a spline, with what its Reach follows from.
struct Complexity {
    bool is_ellipse = false;
    double half_angle = 0, rate = 0, from_center = 0;  // ellipse: |x'(u)| and |x - center| at the middle
    double radius_by_speed = 0;                        // ellipse: |x - center| / |x'(u)| at the middle, no cell involved
    int degree = 1;
    bool rational = false;
    double largest = 1, middle = 1, half_range = 0;  // weights: max, (max + min) / 2, (max - min) / 2
    double extent = 0;                               // control points: |P - P_m|
    int velocity_degree = 0;                         // of the numerator of dx/dz, and the radius of its coefficients about
    double velocity_range = 0;                       // their middle, by the distance of the middle from zero
};

double scaled(const Vec2& v, const Vec2& cell) {
    return v.cwiseAbs().cwiseQuotient(cell).maxCoeff();
}

Complexity ellipse_portion(const EllipticArc& arc, double t0, double t1, const Vec2& cell) {
    const double u = arc.start + 0.5 * (t0 + t1) * arc.sweep;
    Complexity p;
    p.is_ellipse = true;
    p.half_angle = 0.5 * std::abs(arc.sweep) * (t1 - t0);
    p.rate = scaled(std::cos(u) * arc.b - std::sin(u) * arc.a, cell);
    const Vec2 from_center = std::cos(u) * arc.a + std::sin(u) * arc.b;
    p.from_center = scaled(from_center, cell);
    p.radius_by_speed = from_center.norm() / (std::cos(u) * arc.b - std::sin(u) * arc.a).norm();
    return p;
}

/// The shape's parameter, in the span that holds the portion, as one over that span.
struct SpanPortion {
    std::size_t span;
    double begin, end;
};
SpanPortion span_portion(const Spline& spline, double t0, double t1) {
    const std::vector<double>& breaks = spline.shape->breaks;
    const auto u = [&](double t) { return spline.begin + t * (spline.end - spline.begin); };
    const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, u(0.5 * (t0 + t1)));
    const auto k = static_cast<std::size_t>(after - breaks.begin()) - 1;
    const auto local = [&](double t) { return std::clamp((u(t) - breaks[k]) / (breaks[k + 1] - breaks[k]), 0.0, 1.0); };
    const double s0 = local(t0), s1 = local(t1);
    return {k, std::min(s0, s1), std::max(s0, s1)};
}

/// Numerator of the derivative of a / w.
Bernstein velocity(const Bernstein& a, const HomogeneousSpan& span) {
    return span.rational ? derivative(a) * span.w - a * derivative(span.w) : derivative(a);
}

/// The velocity of the whole span is cut down to the portion, for that of a short portion would be differences of roundings.
void describe_velocity(Complexity& p, const HomogeneousSpan& span, const SpanPortion& where) {
    const Bernstein u = portion(velocity(span.x, span), where.begin, where.end);
    const Bernstein v = portion(velocity(span.y, span), where.begin, where.end);
    Box2 box;
    for (int i = 0; i <= u.degree; ++i) box.extend(Vec2(u[i], v[i]));
    double range = 0;
    for (int i = 0; i <= u.degree; ++i) range = std::max(range, (Vec2(u[i], v[i]) - box.center()).norm());
    p.velocity_degree = u.degree;
    p.velocity_range = range / box.center().norm();
}

Complexity spline_portion(const Spline& spline, double t0, double t1, const Vec2& cell) {
    const SplineShape& shape = *spline.shape;
    const SpanPortion where = span_portion(spline, t0, t1);
    // an origin near the portion, so that differences of its points keep their digits
    const Vec2 origin = shape.points[where.span * (static_cast<std::size_t>(shape.degree) + 1)];
    const HomogeneousSpan span = homogeneous_span(shape, where.span, origin);
    const HomogeneousSpan part = portion(span, where.begin, where.end);
    Complexity p;
    p.degree = shape.degree;
    p.rational = part.rational;
    p.extent = 0.5 * scaled(control_box(part).size(), cell);
    if (part.rational) {
        const auto [low, high] = std::minmax_element(part.w.c.begin(), part.w.c.begin() + part.w.degree + 1);
        p.largest = *high;
        p.middle = 0.5 * (*high + *low);
        p.half_range = 0.5 * (*high - *low);
    }
    describe_velocity(p, span, where);
    return p;
}

double power(double base, int exponent) {
    double result = 1;
    for (int k = 0; k < exponent; ++k) result *= base;
    return result;
}

/// What is within `range` of 1 is less than that, and cannot vanish: its root stays smooth. Infinite if it can.
double clear_of_zero(double range) {
    return range < 1 ? 1 + range : infinity;
}

/// On the ellipse with sigma; infinite where the weights (or, for the density, the velocity) may vanish on it.
Reach reach(const Complexity& p, double sigma) {
    if (p.is_ellipse) {
        const double v = p.half_angle * sigma, sinh = std::sinh(v), cosh = std::cosh(v);
        return {p.rate * sinh + p.from_center * (cosh - 1), 2 * p.half_angle * (p.rate * cosh + p.from_center * sinh),
                clear_of_zero(cosh - 1 + p.radius_by_speed * sinh)};
    }
    const double lower = power(sigma, p.degree - 1), full = lower * sigma;
    const double least = p.middle - p.half_range * full;
    if (least <= 0) return {infinity, infinity, infinity};
    const double offset = p.extent * p.largest * full / least, by_weight = p.middle / least;
    return {offset, 2 * p.degree * p.extent * p.largest * lower * (p.middle + 2 * p.half_range * full) / (least * least),
            by_weight * by_weight * clear_of_zero(p.velocity_range * power(sigma, p.velocity_degree))};
}

enum class Measure { dy, ds };

/// Gauss points for coordinates (of size 1) to the power `factors`, times dy/dz or ds/dz; more than most_gauss_points if too
/// many.
int points_for(const Complexity& p, int factors, Measure measure) {
    double fewest = infinity;
    for (double rho = 1.2; rho < 1e4; rho *= 1.3) {
        const Reach r = reach(p, 0.5 * (rho + 1 / rho));
        const double factor = measure == Measure::dy ? std::max(r.rate, std::numeric_limits<double>::min()) : r.density;
        const double largest = factors * std::log1p(r.offset) + std::log(factor);
        if (!std::isfinite(largest)) break;
        const double n = 1 + (largest + std::log(32.0 / 15 / gauss_tolerance / (1 - 1 / (rho * rho)))) / (2 * std::log(rho));
        if (n > fewest) break;
        fewest = n;
    }
    return fewest < most_gauss_points ? std::max(1, static_cast<int>(std::ceil(fewest))) : most_gauss_points + 1;
}

/// Does the portion stay within gauss_tolerance of its middle? Then no rule is too coarse, and halving would only see
/// roundings: beside a point where the curve stands still the velocity is nothing else.
bool is_negligible(const Complexity& p) {
    return reach(p, 1).offset <= gauss_tolerance;
}

Complexity complexity(const Curve& curve, double t0, double t1, const Vec2& cell) {
    if (const auto* arc = std::get_if<EllipticArc>(&curve)) return ellipse_portion(*arc, t0, t1, cell);
    return spline_portion(std::get<Spline>(curve), t0, t1, cell);
}

void append_general_area(std::vector<GaussPortion>& portions, const Curve& curve, double t0, double t1, int degree,
                         const Vec2& cell, int halvings) {
    const Complexity p = complexity(curve, t0, t1, cell);
    const bool polynomial = !p.is_ellipse && !p.rational;
    int n = points_for(p, 4 * degree + 1, Measure::dy);
    if (polynomial) n = std::min(n, p.degree * (2 * degree + 1));
    if (n > (polynomial ? most_gauss_points : many_points) && halvings > 0 && !is_negligible(p)) {
        const double middle = 0.5 * (t0 + t1);
        append_general_area(portions, curve, t0, middle, degree, cell, halvings - 1);
        append_general_area(portions, curve, middle, t1, degree, cell, halvings - 1);
    } else {
        portions.push_back({t0, t1, std::min(n, most_gauss_points)});
    }
}

void append_general_length(std::vector<GaussPortion>& portions, const Curve& curve, double t0, double t1, int n,
                           const Vec2& cell, int halvings) {
    const Complexity p = complexity(curve, t0, t1, cell);
    const int needed = points_for(p, 2 * n - 1, Measure::ds);
    if (needed <= many_points || halvings == 0 || is_negligible(p)) {
        portions.push_back({t0, t1, std::min(needed, many_points)});
        return;
    }
    const double middle = 0.5 * (t0 + t1);
    append_general_length(portions, curve, t0, middle, n, cell, halvings - 1);
    append_general_length(portions, curve, middle, t1, n, cell, halvings - 1);
}

/// Angle of a portion of an arc; 0 for a segment.
double angle_of(const Curve& curve, double t0, double t1) {
    const auto* arc = std::get_if<Arc>(&curve);
    return arc ? std::abs(arc->sweep) * (t1 - t0) : 0.0;
}

bool is_general(const Curve& curve) {
    return !std::holds_alternative<Segment>(curve) && !std::holds_alternative<Arc>(curve);
}

}  // namespace

void append_area_portions(std::vector<GaussPortion>& portions, const Curve& curve, double t0, double t1, int degree,
                          const Vec2& cell) {
    if (is_general(curve)) return append_general_area(portions, curve, t0, t1, degree, cell, most_halvings);
    const int n = 2 * degree + 1 + extra_points(4 * degree + 2, angle_of(curve, t0, t1));
    portions.push_back({t0, t1, std::min(n, most_gauss_points)});
}

void append_length_portions(std::vector<GaussPortion>& portions, const Curve& curve, double t0, double t1, int n,
                            const Vec2& cell) {
    if (is_general(curve)) return append_general_length(portions, curve, t0, t1, n, cell, most_halvings);
    portions.push_back({t0, t1, std::min(n + extra_points(2 * n, angle_of(curve, t0, t1)), most_gauss_points)});
}

}  // namespace abut::geometry
