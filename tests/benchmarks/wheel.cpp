// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/wheel.hpp"

#include <cmath>
#include <numbers>

#include "geometry/curves/elliptic_arc.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace abut::benchmarks {

using namespace geometry;

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

}  // namespace

Curve edge_between(EdgeKind kind, const Vec2& p, const Vec2& q) {
    constexpr double half = 0.75;  // of an arc's angle
    const Vec2 d = q - p, middle = 0.5 * (p + q);
    const Vec2 along = -0.5 / std::sin(half) * d, outward = 0.3 * right_of(d);
    if (kind == arcs) {
        const Vec2 center = middle + 0.5 / std::tan(half) * left_of(d);
        return Arc{center, along.norm(), std::atan2((p - center).y(), (p - center).x()), 2 * half};
    }
    if (kind == ellipses) return EllipticArc{middle - std::cos(half) * outward, along, outward, two_pi / 4 - half, 2 * half};
    if (kind == cubics) return bezier_curve({p, p + 0.3 * d + outward, q - 0.4 * d + outward, q}, {});
    return Segment{p, q};
}

Part wheel(EdgeKind kind, int n) {
    Part part;
    part.loops.resize(1);
    const auto corner = [&](int i) {
        const double angle = two_pi * i / n + 0.1, radius = 1 + 0.05 * std::sin(7 * angle);
        return Vec2(radius * std::cos(angle), radius * std::sin(angle));
    };
    for (int i = 0; i < n; ++i) {
        part.loops[0].edges.push_back(i);
        part.edges.push_back({edge_between(kind, corner(i), corner((i + 1) % n)), "", ""});
    }
    return part;
}

Grid grid_around(const Part& part, int n) {
    const Box2 box = bounding_box(part);
    Grid grid;
    for (int axis : {0, 1}) {
        std::vector<double>& coordinates = axis == 0 ? grid.x : grid.y;
        for (int k = 0; k <= n; ++k) {
            const double s = static_cast<double>(k) / n, bent = s + 0.02 * std::sin(two_pi * s);
            coordinates.push_back(box.min[axis] - 0.01 + bent * (box.size()[axis] + 0.02));
        }
    }
    return grid;
}

}  // namespace abut::benchmarks
