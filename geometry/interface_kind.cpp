// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/interface_kind.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/facing.hpp"

namespace abut::geometry {

namespace {

enum class Shape { flat, convex, concave };

const Curve& curve_of(const Part& part, int edge) {
    return part.edges[static_cast<std::size_t>(edge)].curve;
}

Shape shape_of(const Part& part, int edge) {
    const Curve& curve = curve_of(part, edge);
    if (std::holds_alternative<Segment>(curve)) return Shape::flat;
    return curvature(curve, 0.5) > 0 ? Shape::convex : Shape::concave;
}

const Loop& loop_of(const Part& part, int edge) {
    for (const Loop& loop : part.loops)
        if (std::find(loop.edges.begin(), loop.edges.end(), edge) != loop.edges.end()) return loop;
    return part.loops.front();
}

/// Drawn circles may come in several arcs whose centres and radii agree to the drawing's digits only.
constexpr double same_circle_fraction = 1e-4;

/// How far round the circle of this arc goes in its loop, radians.
double turn_of_circle(const Part& part, int edge) {
    const Arc& arc = std::get<Arc>(curve_of(part, edge));
    const double same = same_circle_fraction * arc.radius;
    double turn = 0;
    for (const int e : loop_of(part, edge).edges) {
        const auto* other = std::get_if<Arc>(&curve_of(part, e));
        if (other && other->sweep * arc.sweep > 0 && (other->center - arc.center).norm() <= same &&
            std::abs(other->radius - arc.radius) <= same)
            turn += std::abs(other->sweep);
    }
    return turn;
}

std::string round_in(const Part& part, int concave_edge) {
    constexpr double rounding = 1e-9;
    return turn_of_circle(part, concave_edge) > std::numbers::pi + rounding ? "pin-in-hole" : "round-in-groove";
}

}  // namespace

std::string interface_kind(const Part& part1, int edge1, const Part& part2, int edge2) {
    const Shape s1 = shape_of(part1, edge1), s2 = shape_of(part2, edge2);
    if (s1 == Shape::convex && s2 == Shape::concave) return round_in(part2, edge2);
    if (s1 == Shape::concave && s2 == Shape::convex) return round_in(part1, edge1);
    if (s1 == Shape::concave || s2 == Shape::concave) return "general";
    const auto word = [](Shape s) { return s == Shape::flat ? std::string("flat") : std::string("round"); };
    return word(s1) + "-on-" + word(s2);
}

bool is_convex_corner(const Part& part, int edge, double t) {
    constexpr double at_the_end = 1e-9;
    if (t > at_the_end && t < 1 - at_the_end) return false;
    const std::vector<int>& edges = loop_of(part, edge).edges;
    const auto n = edges.size();
    const auto i = static_cast<std::size_t>(std::find(edges.begin(), edges.end(), edge) - edges.begin());
    const int before = t < 0.5 ? edges[(i + n - 1) % n] : edge, after = t < 0.5 ? edge : edges[(i + 1) % n];
    const Vec2 in = unit_tangent(curve_of(part, before), 1), out = unit_tangent(curve_of(part, after), 0);
    return std::atan2(cross(in, out), in.dot(out)) > chain_angle;
}

std::string corner_interface(const Part& part1, int edge1, double t1, const Part& part2, int edge2, double t2) {
    const bool corner1 = is_convex_corner(part1, edge1, t1), corner2 = is_convex_corner(part2, edge2, t2);
    if (corner1 == corner2) return "general";
    const Shape face = corner1 ? shape_of(part2, edge2) : shape_of(part1, edge1);
    return face == Shape::flat ? "edge-on-flat" : "general";
}

}  // namespace abut::geometry
