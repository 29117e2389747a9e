// SPDX-License-Identifier: GPL-3.0-or-later
// Legend: p points, h chord lengths, d differences of points, m slopes (derivatives by the parameter) at the points.
#include "geometry/curves/spline_through.hpp"

#include <cmath>

namespace abut::geometry {

namespace {

/// Points that are apart by no more than this part of all are one, rounded twice.
constexpr double same_point_fraction = 1e-9;

std::vector<Vec2> distinct_points(const SplineThrough& through) {
    Box2 box;
    for (const Vec2& point : through.points) box.extend(point);
    const auto are_same = [same = same_point_fraction * box.diagonal()](const Vec2& a, const Vec2& b) {
        return (a - b).norm() <= same;
    };
    std::vector<Vec2> p;
    for (const Vec2& point : through.points)
        if (p.empty() || !are_same(p.back(), point)) p.push_back(point);
    while (through.closed && p.size() > 1 && are_same(p.front(), p.back())) p.pop_back();
    return p;
}

/// below[i] x[i-1] + on[i] x[i] + above[i] x[i+1] = right[i], diagonally dominant.
struct Tridiagonal {
    std::vector<double> below, on, above;
    std::vector<Vec2> right;

    explicit Tridiagonal(std::size_t n) : below(n, 0), on(n, 0), above(n, 0), right(n, Vec2(0, 0)) {}
};

std::vector<Vec2> solved(Tridiagonal s) {
    const std::size_t n = s.on.size();
    for (std::size_t i = 1; i < n; ++i) {
        const double factor = s.below[i] / s.on[i - 1];
        s.on[i] -= factor * s.above[i - 1];
        s.right[i] -= factor * s.right[i - 1];
    }
    std::vector<Vec2> x = s.right;
    x[n - 1] /= s.on[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) x[i] = (x[i] - s.above[i] * x[i + 1]) / s.on[i];
    return x;
}

/// With the entries above the first row's beginning (below[0]) and after the last row's end (above[n-1]) in the opposite
/// corners, n > 2: a correction of rank one (Sherman and Morrison).
std::vector<Vec2> solved_cyclic(Tridiagonal s) {
    const std::size_t n = s.on.size();
    const double top_right = s.below[0], bottom_left = s.above[n - 1], gamma = -s.on[0];
    s.on[0] -= gamma;
    s.on[n - 1] -= top_right * bottom_left / gamma;
    Tridiagonal corner = s;
    corner.right.assign(n, Vec2(0, 0));
    corner.right[0] = Vec2(gamma, 0);
    corner.right[n - 1] = Vec2(bottom_left, 0);
    std::vector<Vec2> x = solved(std::move(s));
    const std::vector<Vec2> z = solved(std::move(corner));
    const Vec2 factor = (x[0] + top_right / gamma * x[n - 1]) / (1 + z[0].x() + top_right / gamma * z[n - 1].x());
    for (std::size_t i = 0; i < n; ++i) x[i] -= z[i].x() * factor;
    return x;
}

/// The second derivative is continuous at a point between chords 1 and 2.
void set_smooth(Tridiagonal& s, std::size_t i, double h1, const Vec2& d1, double h2, const Vec2& d2) {
    s.below[i] = 1 / h1;
    s.on[i] = 2 / h1 + 2 / h2;
    s.above[i] = 1 / h2;
    s.right[i] = 3 * (d1 / (h1 * h1) + d2 / (h2 * h2));
}

/// A given slope, or no second derivative; `inner` is the matrix entry of the neighbour.
void set_end(Tridiagonal& s, std::size_t i, double& inner, const std::optional<Vec2>& tangent, const Vec2& d, double h) {
    s.on[i] = tangent ? 1 : 2;
    inner = tangent ? 0 : 1;
    s.right[i] = tangent ? Vec2(tangent->normalized()) : Vec2(3 * d / h);
}

std::vector<Vec2> slopes(const SplineThrough& through, const std::vector<Vec2>& d, const std::vector<double>& h) {
    const std::size_t n_chords = d.size();
    if (through.closed) {
        Tridiagonal s(n_chords);
        for (std::size_t i = 0; i < n_chords; ++i) {
            const std::size_t before = (i + n_chords - 1) % n_chords;
            set_smooth(s, i, h[before], d[before], h[i], d[i]);
        }
        std::vector<Vec2> m = solved_cyclic(std::move(s));
        m.push_back(m.front());
        return m;
    }
    Tridiagonal s(n_chords + 1);
    set_end(s, 0, s.above[0], through.start_tangent, d.front(), h.front());
    for (std::size_t i = 1; i < n_chords; ++i) set_smooth(s, i, h[i - 1], d[i - 1], h[i], d[i]);
    set_end(s, n_chords, s.below[n_chords], through.end_tangent, d.back(), h.back());
    return solved(std::move(s));
}

}  // namespace

std::string through_fault(const SplineThrough& through) {
    const std::size_t n = distinct_points(through).size();
    if (n < 2) return "it has fewer than two different points";
    if (through.closed && n < 3) return "it is closed and has fewer than three different points";
    return {};
}

Nurbs spline_through(const SplineThrough& through) {
    std::vector<Vec2> p = distinct_points(through);
    if (through.closed) p.push_back(p.front());
    std::vector<Vec2> d;
    std::vector<double> h;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        d.push_back(p[i + 1] - p[i]);
        h.push_back(d.back().norm());
    }
    const std::vector<Vec2> m = slopes(through, d, h);
    Nurbs nurbs{3, {0, 0, 0, 0}, {p.front()}, {}};
    double t = 0;
    for (std::size_t i = 0; i < h.size(); ++i) {
        t += h[i];
        nurbs.points.insert(nurbs.points.end(), {p[i] + h[i] / 3 * m[i], p[i + 1] - h[i] / 3 * m[i + 1], p[i + 1]});
        nurbs.knots.insert(nurbs.knots.end(), 3, t);
    }
    nurbs.knots.push_back(t);
    return nurbs;
}

}  // namespace abut::geometry
