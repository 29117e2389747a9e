// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/part.hpp"

#include <cmath>

#include "geometry/monotone.hpp"

namespace abut::geometry {

namespace {

/// Contribution of one curve to the area and to its first moments about o, by Green's theorem: the segment's share, plus for
/// arcs the circular segment between chord and arc.
struct Moments {
    double area = 0;
    Vec2 first{0, 0};
};

Moments of_chord(const Vec2& a, const Vec2& b) {
    const double twice = cross(a, b);
    return {twice / 2, twice / 6 * (a + b)};
}

Moments of_circular_segment(const Arc& arc, const Vec2& o) {
    const double half = arc.sweep / 2;
    const double area = arc.radius * arc.radius * (half - std::sin(half) * std::cos(half));
    const double sine = std::sin(half);
    const double middle = arc.start + half;
    // first moment of a circular segment about the circle's centre: 2/3 r^3 sin^3(half) along the bisector
    const double moment = 2.0 / 3.0 * std::pow(arc.radius, 3) * std::pow(sine, 3);
    const Vec2 along(std::cos(middle), std::sin(middle));
    return {area, moment * along + area * (arc.center - o)};
}

Moments moments(const Part& part, const Vec2& o) {
    Moments sum;
    const auto add = [&](const Moments& m) {
        sum.area += m.area;
        sum.first += m.first;
    };
    for (const Edge& edge : part.edges) {
        add(of_chord(point(edge.curve, 0) - o, point(edge.curve, 1) - o));
        if (const auto* arc = std::get_if<Arc>(&edge.curve)) add(of_circular_segment(*arc, o));
    }
    return sum;
}

}  // namespace

Box2 bounding_box(const Part& part) {
    Box2 box;
    for (const Edge& edge : part.edges) box.extend(bounding_box(edge.curve));
    return box;
}

double area(const Part& part) {
    return part.edges.empty() ? 0.0 : moments(part, bounding_box(part).center()).area;
}

Vec2 centroid(const Part& part) {
    const Vec2 o = bounding_box(part).center();
    const Moments m = moments(part, o);
    return o + m.first / m.area;
}

double perimeter(const Part& part) {
    double sum = 0;
    for (const Edge& edge : part.edges) sum += length(edge.curve);
    return sum;
}

int count_holes(const Part& part) {
    int holes = 0;
    for (const Loop& loop : part.loops) {
        Part alone;
        for (int e : loop.edges) alone.edges.push_back(part.edges[static_cast<std::size_t>(e)]);
        if (area(alone) < 0) ++holes;
    }
    return holes;
}

bool contains(const Part& part, const Vec2& p) {
    return contains(monotone_pieces(part), p);
}

double merge_length(const Part& part) {
    return merge_fraction * bounding_box(part).diagonal();
}

Part transformed(const Part& part, double c, double s, const Vec2& d) {
    Part moved = part;
    for (Edge& edge : moved.edges) edge.curve = transformed(edge.curve, c, s, d);
    return moved;
}

double edge_arc_length(const Edge& edge, double t) {
    return edge.along_source ? length(edge.curve, 0, t) : length(edge.curve, t, 1);
}

}  // namespace abut::geometry
