// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/implicit/trimmed_edge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abut::geometry {

namespace {

/// Arcs whose sweep lacks less than this of a full turn, radians, are closed: ends closer than rounding cannot be told apart.
constexpr double closed_gap = 1e-12;

bool is_full_turn(double sweep) {
    return std::abs(sweep) > 2 * std::numbers::pi - closed_gap;
}

template <class T>
struct Functions {
    T f, g;
};

template <class T>
PointOf<T> in_frame(const TrimmedConic& c, const PointOf<T>& p) {
    const T x = p.x - c.middle.x(), y = p.y - c.middle.y();
    return {c.frame_x.x() * x + c.frame_x.y() * y, c.frame_y.x() * x + c.frame_y.y() * y};
}

/// An ellipse's f out of F = f in the frame: F / sqrt(grad F^2 + 2 F / A^2), where A is the longer semi-axis. The root is
/// 1/A sqrt(1 + (q / B)^2 ((A / B)^2 - 1)) with q the coordinate along the shorter semi-axis B: it vanishes nowhere, and for
/// circles f is (r^2 - x^2) / (2 r) again.
template <class T>
T normalised(const TrimmedConic& c, const T& f, const PointOf<T>& z) {
    using std::sqrt;
    const double longer = std::max(c.a, c.b), shorter = std::min(c.a, c.b), ratio = longer / shorter;
    // from the middle of the chord to the centre, in units of the shorter semi-axis
    const Vec2 centre = -c.cosine * c.across;
    const T q = c.a < c.b ? T(z.x - centre.x()) : T(z.y - centre.y());
    return T(longer * f / sqrt(T(1 + (ratio - 1) * (ratio + 1) * (q * q))));
}

/// The whole line's, circle's or ellipse's f, positive on the left of the line and inside the others.
template <class T>
T untrimmed(const TrimmedConic& c, const PointOf<T>& z) {
    const T outward = c.across.x() * z.x + c.across.y() * z.y;
    if (c.radius == 0) return T(-outward);
    const T bulge = (c.half_chord * c.half_chord - (z.x * z.x + z.y * z.y)) / (2 * c.radius);
    const T f = c.is_closed ? T(bulge + c.radius / 2) : T(bulge - c.cosine * outward);
    return c.is_ellipse ? normalised(c, f, z) : f;
}

template <class T>
T trimming(const TrimmedConic& c, const PointOf<T>& z) {
    const T p = (c.half_chord * c.half_chord - (z.x * z.x + z.y * z.y)) / (2 * c.half_chord);
    return T(c.unit * (c.cosine * p + c.sine * (c.across.x() * z.x + c.across.y() * z.y)));
}

template <class T>
T whole(const TrimmedConic& c, const PointOf<T>& p) {
    return T(c.side * untrimmed(c, in_frame(c, p)));
}

template <class T>
NearCurve<T> trimmed_by(const TrimmedConic& c, const PointOf<T>& p) {
    using std::sqrt;
    const PointOf<T> z = in_frame(c, p);
    const T f = c.side * untrimmed(c, z);
    if (c.is_closed) return {f, true};
    const T g = trimming(c, z);
    const T f2 = f * f / (c.unit * c.half_chord);
    const T root = sqrt(T(g * g + f2 * f2));
    if (g > T(0)) {
        // (root - g) / 2 = f k without cancellation
        const T k = f * f2 / (2 * c.unit * c.half_chord * (root + g));
        return {T(f * sqrt(T(1 + k * k))), true};
    }
    const T beyond = (root - g) / 2;
    return {T(sqrt(T(f * f + beyond * beyond))), false};
}

}  // namespace

TrimmedConic trimmed_conic(const Segment& segment) {
    TrimmedConic c;
    const Vec2 d = segment.to - segment.from;
    c.middle = 0.5 * (segment.from + segment.to);
    c.half_chord = 0.5 * d.norm();
    c.across = right_of(d).normalized();
    return c;
}

TrimmedConic trimmed_conic(const Arc& arc) {
    TrimmedConic c;
    c.radius = arc.radius;
    c.side = arc.sweep > 0 ? 1 : -1;
    c.middle = arc.center;
    c.is_closed = is_full_turn(arc.sweep);
    if (c.is_closed) return c;
    const double half = 0.5 * std::abs(arc.sweep), bisector = arc.start + 0.5 * arc.sweep;
    c.cosine = std::cos(half);
    c.sine = std::sin(half);
    c.across = {std::cos(bisector), std::sin(bisector)};
    c.middle += arc.radius * c.cosine * c.across;
    c.half_chord = arc.radius * c.sine;
    return c;
}

TrimmedConic trimmed_conic(const EllipticArc& arc) {
    TrimmedConic c = trimmed_conic(Arc{{0, 0}, 1, arc.start, arc.sweep});
    c.is_ellipse = true;
    c.a = arc.a.norm();
    c.b = arc.b.norm();
    c.frame_x = arc.a / arc.a.squaredNorm();
    c.frame_y = arc.b / arc.b.squaredNorm();
    if (cross(arc.a, arc.b) < 0) c.side = -c.side;
    const Vec2 chord = left_of(c.across);
    c.unit = (chord.x() * arc.a + chord.y() * arc.b).norm();
    c.middle = arc.center + c.middle.x() * arc.a + c.middle.y() * arc.b;
    return c;
}

double whole_curve(const TrimmedConic& conic, const PointOf<double>& p) {
    return whole(conic, p);
}
Jet whole_curve(const TrimmedConic& conic, const PointOf<Jet>& p) {
    return whole(conic, p);
}
NearCurve<double> trimmed(const TrimmedConic& conic, const PointOf<double>& p) {
    return trimmed_by(conic, p);
}
NearCurve<Jet> trimmed(const TrimmedConic& conic, const PointOf<Jet>& p) {
    return trimmed_by(conic, p);
}

TrimmedEdge trimmed_edge(const Curve& curve) {
    TrimmedEdge edge;
    edge.curve = curve;
    if (const auto* segment = std::get_if<Segment>(&curve))
        edge.conic = trimmed_conic(*segment);
    else if (const auto* arc = std::get_if<Arc>(&curve))
        edge.conic = trimmed_conic(*arc);
    else if (const auto* ellipse = std::get_if<EllipticArc>(&curve))
        edge.conic = trimmed_conic(*ellipse);
    else
        edge.is_conic = false;
    return edge;
}

NearCurve<double> trimmed(const TrimmedEdge& edge, const PointOf<double>& p) {
    return edge.is_conic ? trimmed(edge.conic, p) : curve_distance(edge.curve, p);
}
NearCurve<Jet> trimmed(const TrimmedEdge& edge, const PointOf<Jet>& p) {
    return edge.is_conic ? trimmed(edge.conic, p) : curve_distance(edge.curve, p);
}

}  // namespace abut::geometry
