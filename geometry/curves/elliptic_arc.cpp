// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/elliptic_arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/curves/numbers.hpp"

namespace abut::geometry {

namespace {

constexpr double quarter = std::numbers::pi / 2;

/// Roundings of an angle start + t sweep: within this, two angles are one.
double angle_rounding(const EllipticArc& arc) {
    return 2 * epsilon * (std::abs(arc.start) + std::abs(arc.sweep));
}

struct Turn {
    double c, s;
};

/// Cosine and sine; exact at the quarter turns, where the angle is one but for its rounding: the cosine of pi/2 in doubles is
/// not 0.
Turn turn_of(double u, double rounding) {
    const double k = std::round(u / quarter);
    if (std::abs(u - k * quarter) > rounding) return {std::cos(u), std::sin(u)};
    static constexpr double c[] = {1, 0, -1, 0}, s[] = {0, 1, 0, -1};
    const auto i = static_cast<std::size_t>(std::lround(k - 4 * std::floor(k / 4)));
    return {c[i], s[i]};
}

}  // namespace

EllipticArc from_conjugate(const Vec2& center, const Vec2& p, const Vec2& q, double start, double sweep) {
    const double mixed = 2 * p.dot(q);
    if (mixed == 0) return {center, p, q, start, sweep};
    // of the two solutions of tan(2 shift) = 2 p.q / (p.p - q.q) the nearer: axes that are rounded stay themselves
    const double shift = 0.5 * std::atan(mixed / (p.squaredNorm() - q.squaredNorm()));
    const double c = std::cos(shift), s = std::sin(shift);
    // the longer axis has no cancellation; the shorter one follows from the area, which keeps the right angle
    if (p.squaredNorm() >= q.squaredNorm()) {
        const Vec2 a = c * p + s * q;
        return {center, a, left_of(a) * (cross(p, q) / a.squaredNorm()), start - shift, sweep};
    }
    const Vec2 b = c * q - s * p;
    return {center, right_of(b) * (cross(p, q) / b.squaredNorm()), b, start - shift, sweep};
}

std::array<Vec2, 3> evaluate(const EllipticArc& arc, double t) {
    const double u = arc.start + t * arc.sweep;
    const auto [c, s] = turn_of(u, std::max(angle_rounding(arc), 2 * epsilon * std::abs(u)));
    const Vec2 from_center = c * arc.a + s * arc.b;
    return {arc.center + from_center, arc.sweep * (c * arc.b - s * arc.a), -arc.sweep * arc.sweep * from_center};
}

std::vector<double> stationary_parameters(const EllipticArc& arc, int axis) {
    const double lo = std::min(arc.start, arc.start + arc.sweep), hi = std::max(arc.start, arc.start + arc.sweep);
    const double rounding = angle_rounding(arc);
    const double root = std::atan2(arc.b[axis], arc.a[axis]);
    std::vector<double> found;
    for (double k = std::floor((lo - root) / std::numbers::pi); root + k * std::numbers::pi < hi; ++k) {
        const double u = root + k * std::numbers::pi;
        if (u - lo > rounding && hi - u > rounding) found.push_back((u - arc.start) / arc.sweep);
    }
    if (arc.sweep < 0) std::reverse(found.begin(), found.end());
    return found;
}

}  // namespace abut::geometry
