// SPDX-License-Identifier: GPL-3.0-or-later
// The exact numbers, points and curves of CGAL in which Booleans are evaluated, and how doubles become them and come back.
// Includes CGAL: only boolean.cpp and boolean_model.cpp may include this (tests/src/layers_test.cpp).
#pragma once
#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/primitives.hpp"

namespace abut::geometry::exact {

/// Every monotone curve carries the number of its SourcePortion. Where two primitives' edges coincide, the one that comes first
/// in reading order owns the boundary.
struct KeepFirst {
    int operator()(int a, int b) const { return std::min(a, b); }
};

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using PlaneTraits = CGAL::Arr_circle_segment_traits_2<Kernel>;
using EdgeTraits = CGAL::Arr_curve_data_traits_2<PlaneTraits, int, KeepFirst>;
using MonotoneCurve = EdgeTraits::X_monotone_curve_2;
using Rational = Kernel::Point_2;      ///< a point with rational coordinates
using OneRoot = PlaneTraits::Point_2;  ///< a point whose coordinates are a + b sqrt(c)
using Coordinate = OneRoot::CoordNT;

/// Rounded to within a few units in the last place: a + b sqrt(c) is rewritten where it cancels.
inline double rounded(const Coordinate& v) {
    const auto a = CGAL::exact(v.a0());
    if (!v.is_extended()) return CGAL::to_double(a);
    const auto b = CGAL::exact(v.a1()), c = CGAL::exact(v.root());
    const double da = CGAL::to_double(a), db = CGAL::to_double(b) * std::sqrt(CGAL::to_double(c));
    if (da * db >= 0) return da + db;
    return CGAL::to_double(decltype(a)(a * a - b * b * c)) / (da - db);
}

inline Vec2 rounded(const OneRoot& p) {
    return {rounded(p.x()), rounded(p.y())};
}

struct Rotation {
    Number c, s;
};

/// Exactly on the unit circle: t is the tangent of half the angle beyond the quarter turns.
inline Rotation rotation(int quarter_turns, double half_tangent) {
    const Number t(half_tangent);
    const Number denominator = 1 + t * t;
    const Number c = (1 - t * t) / denominator, s = 2 * t / denominator;
    switch (((quarter_turns % 4) + 4) % 4) {
        case 0:
            return {c, s};
        case 1:
            return {-s, c};
        case 2:
            return {-c, -s};
        default:
            return {s, -c};
    }
}

/// The rational point of the unit circle within rounding of the angle.
inline Rotation rotation(double angle) {
    const double quarters = std::nearbyint(angle / (std::numbers::pi / 2));
    return rotation(static_cast<int>(quarters), std::tan((angle - quarters * (std::numbers::pi / 2)) / 2));
}

inline Rational exact_point(const Vec2& p) {
    return {Number(p.x()), Number(p.y())};
}

/// x -> [xx xy; yx yy] x + (dx, dy): all moves of a primitive in one.
struct ExactMap {
    Number xx = 1, xy = 0, yx = 0, yy = 1, dx = 0, dy = 0;
    double scale = 1;
    bool identity = true;
};

inline ExactMap exact_map(const std::vector<Move>& moves) {
    ExactMap m;
    for (const Move& move : moves) {
        const Rotation r = rotation(move.quarter_turns, move.half_tangent);
        const Number sx = move.mirror == Mirror::x ? -Number(move.scale) : Number(move.scale);
        const Number sy = move.mirror == Mirror::y ? -Number(move.scale) : Number(move.scale);
        const Number px = m.dx - move.about.x(), py = m.dy - move.about.y();
        const auto turned_x = [&](const Number& x, const Number& y) { return r.c * sx * x - r.s * sy * y; };
        const auto turned_y = [&](const Number& x, const Number& y) { return r.s * sx * x + r.c * sy * y; };
        m = {turned_x(m.xx, m.yx),
             turned_x(m.xy, m.yy),
             turned_y(m.xx, m.yx),
             turned_y(m.xy, m.yy),
             turned_x(px, py) + move.about.x() + move.translate.x(),
             turned_y(px, py) + move.about.y() + move.translate.y(),
             m.scale * move.scale,
             false};
        for (const Number* n : {&m.xx, &m.xy, &m.yx, &m.yy, &m.dx, &m.dy}) CGAL::exact(*n);  // keeps lazy numbers flat
    }
    return m;
}

inline Rational placed_exactly(const Vec2& p, const ExactMap& m) {
    if (m.identity) return exact_point(p);
    const Number x(p.x()), y(p.y());
    return {m.xx * x + m.xy * y + m.dx, m.yx * x + m.yy * y + m.dy};
}

/// A normal: rotated, mirrored and scaled only.
inline Kernel::Vector_2 turned_exactly(const Vec2& v, const ExactMap& m) {
    const Number x(v.x()), y(v.y());
    return {m.xx * x + m.xy * y, m.yx * x + m.yy * y};
}

inline OneRoot one_root(const Rational& p) {
    return {Coordinate(p.x()), Coordinate(p.y())};
}

}  // namespace abut::geometry::exact
