// SPDX-License-Identifier: GPL-3.0-or-later
// Ellipses, circles as NURBS, and parts of one edge, for tests of curves that have no closed forms.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/brep/part.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry::test {

/// With semi-axes a, turned by `angle`, and b.
inline EllipticArc ellipse(const Vec2& center, double a, double b, double angle = 0, double start = 0,
                           double sweep = 2 * std::numbers::pi) {
    const Vec2 u(std::cos(angle), std::sin(angle));
    return {center, a * u, b * left_of(u), start, sweep};
}

/// The square of nine points.
inline Curve nurbs_circle(const Vec2& center, double radius) {
    const double w = std::sqrt(0.5);
    Nurbs nurbs{2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, {}, {1, w, 1, w, 1, w, 1, w, 1}};
    const int x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    for (int i = 0; i < 9; ++i) nurbs.points.push_back(center + radius * Vec2(x[i], y[i]));
    const std::vector<Curve> curves = nurbs_curves(nurbs);
    EXPECT_EQ(curves.size(), 1u);
    return curves.front();
}

inline Part of_one_edge(const Curve& curve) {
    Part part;
    part.edges.emplace_back();
    part.edges.back().curve = curve;
    part.loops.push_back({{0}});
    return part;
}

}  // namespace abut::geometry::test
