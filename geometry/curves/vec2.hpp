// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace abut::geometry {

/// A point or vector in the plane, in the scene's length unit.
using Vec2 = Eigen::Vector2d;

/// z component of a x b: positive when b lies counter-clockwise of a.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Angle by which a is to be turned to point along b: in [-pi, pi], positive counter-clockwise.
inline double angle_between(const Vec2& a, const Vec2& b) {
    return std::atan2(cross(a, b), a.dot(b));
}

/// v turned by +90 degrees.
inline Vec2 left_of(const Vec2& v) {
    return {-v.y(), v.x()};
}

/// v turned by -90 degrees: the outward normal of a boundary whose material lies on its left.
inline Vec2 right_of(const Vec2& v) {
    return {v.y(), -v.x()};
}

/// Axis-parallel box; empty until it has been extended.
struct Box2 {
    Vec2 min = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 max = Vec2::Constant(-std::numeric_limits<double>::infinity());

    void extend(const Vec2& p) {
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }
    void extend(const Box2& b) {
        min = min.cwiseMin(b.min);
        max = max.cwiseMax(b.max);
    }
    bool empty() const { return !(min.x() <= max.x() && min.y() <= max.y()); }
    Vec2 size() const { return max - min; }
    Vec2 center() const { return 0.5 * (min + max); }
    double diagonal() const { return empty() ? 0.0 : size().norm(); }
    bool overlaps(const Box2& b, double margin) const {
        return min.x() - margin <= b.max.x() && b.min.x() <= max.x() + margin && min.y() - margin <= b.max.y() &&
               b.min.y() <= max.y() + margin;
    }
    bool is_within(const Box2& outer, double margin) const {
        return (min.array() >= outer.min.array() - margin).all() && (max.array() <= outer.max.array() + margin).all();
    }
};

}  // namespace abut::geometry
