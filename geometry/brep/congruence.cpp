// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/congruence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/curves/bezier_span.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry {

namespace {

/// Are two curves the same, to a distance by which their points, and an angle by which their arcs, may differ?
struct AreSame {
    double distance, angle;

    bool near(const Vec2& a, const Vec2& b) const { return (a - b).norm() <= distance; }
    bool operator()(const Segment& a, const Segment& b) const { return near(a.from, b.from) && near(a.to, b.to); }
    bool operator()(const Arc& a, const Arc& b) const {
        return near(a.center, b.center) && std::abs(a.radius - b.radius) <= distance && std::abs(a.sweep - b.sweep) <= angle &&
               near(point(a, 0), point(b, 0));
    }
    bool operator()(const EllipticArc& a, const EllipticArc& b) const {
        return near(a.center, b.center) && near(a.a, b.a) && near(a.b, b.b) && std::abs(a.start - b.start) <= angle &&
               std::abs(a.sweep - b.sweep) <= angle;
    }
    bool operator()(const Spline& a, const Spline& b) const {
        const SplineShape &s = *a.shape, &t = *b.shape;
        return a.begin == b.begin && a.end == b.end && s.degree == t.degree && s.breaks == t.breaks && s.weights == t.weights &&
               std::equal(s.points.begin(), s.points.end(), t.points.begin(), t.points.end(),
                          [this](const Vec2& p, const Vec2& q) { return near(p, q); });
    }
    template <class A, class B>
    bool operator()(const A&, const B&) const {
        return false;
    }
};

/// Two places of a part that are far from each other: where its first edge begins, and where or in whose middle another one is.
struct Lever {
    Vec2 from, to;
};
Lever lever_of(const Part& part, std::size_t edge, double t) {
    return {point(part.edges.front().curve, 0), point(part.edges[edge].curve, t)};
}

}  // namespace

std::optional<Similarity> congruence(const Part& from, const Part& to) {
    if (from.edges.empty() || from.edges.size() != to.edges.size() || from.loops.size() != to.loops.size()) return std::nullopt;
    for (std::size_t k = 0; k < from.edges.size(); ++k)
        if (from.edges[k].curve.index() != to.edges[k].curve.index()) return std::nullopt;
    Lever longest = lever_of(from, 0, 0), there = longest;
    for (std::size_t k = 0; k < from.edges.size(); ++k)
        for (const double t : {0.0, 0.5}) {
            const Lever lever = lever_of(from, k, t);
            if ((lever.to - lever.from).norm() <= (longest.to - longest.from).norm()) continue;
            longest = lever;
            there = lever_of(to, k, t);
        }
    const Vec2 a = longest.to - longest.from, b = there.to - there.from;
    const double product = a.norm() * b.norm();
    if (!(product > 0)) return std::nullopt;
    Similarity map{a.dot(b) / product, cross(a, b) / product};
    const double unit = std::hypot(map.c, map.s);
    map.c /= unit;
    map.s /= unit;
    map.d = 0.5 * (there.from + there.to) - map.turned(0.5 * (longest.from + longest.to));
    const Box2 box1 = bounding_box(from), box2 = bounding_box(to);
    const double coordinate = std::max({box1.min.norm(), box1.max.norm(), box2.min.norm(), box2.max.norm()}),
                 distance = coordinate_roundings * std::numeric_limits<double>::epsilon() * coordinate;
    const AreSame same{distance, distance / box1.diagonal()};
    for (std::size_t k = 0; k < from.edges.size(); ++k)
        if (!std::visit(same, transformed(from.edges[k].curve, map), to.edges[k].curve)) return std::nullopt;
    for (std::size_t k = 0; k < from.loops.size(); ++k)
        if (from.loops[k].edges != to.loops[k].edges) return std::nullopt;
    return map;
}

}  // namespace abut::geometry
