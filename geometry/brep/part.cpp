// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/part.hpp"

#include <algorithm>

#include "geometry/brep/monotone.hpp"
#include "geometry/curves/curve_moments.hpp"
#include "geometry/curves/curve_rule.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

/// Green's theorem, about o: the triangle under the edge's chord, and what bulges out from it.
Moments of_edge(const Curve& curve, const Vec2& o) {
    const Vec2 a = point(curve, 0) - o, b = point(curve, 1) - o;
    const double twice = cross(a, b);
    const Moments outside = bulge(curve, 0, 1, o);
    return {twice / 2 + outside.area, twice / 6 * (a + b) + outside.first};
}

Moments moments(const Part& part, const Vec2& o) {
    Moments sum;
    for (const Edge& edge : part.edges) {
        const Moments m = of_edge(edge.curve, o);
        sum.area += m.area;
        sum.first += m.first;
    }
    return sum;
}

double signed_area(const Part& part, const Loop& loop) {
    const Vec2 o = point(part.edges[static_cast<std::size_t>(loop.edges.front())].curve, 0);
    double sum = 0;
    for (const int e : loop.edges) sum += of_edge(part.edges[static_cast<std::size_t>(e)].curve, o).area;
    return sum;
}

}  // namespace

const Loop* loop_of(const Part& part, int edge) {
    for (const Loop& loop : part.loops)
        if (std::find(loop.edges.begin(), loop.edges.end(), edge) != loop.edges.end()) return &loop;
    return nullptr;
}

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

Eigen::Matrix2d second_moments(const Part& part, const Vec2& c) {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (const Edge& edge : part.edges) {
        const CurveRule rule = curve_rule(edge.curve);
        for (std::size_t q = 0; q < rule.t.size(); ++q) {
            const Vec2 arm = point(edge.curve, rule.t[q]) - c;  // of div(arm arm' arm) = 4 arm arm'
            sum += rule.weights[q] / 4 * cross(arm, derivative(edge.curve, rule.t[q])) * arm * arm.transpose();
        }
    }
    return sum;
}

double perimeter(const Part& part) {
    double sum = 0;
    for (const Edge& edge : part.edges) sum += length(edge.curve);
    return sum;
}

int count_holes(const Part& part) {
    return static_cast<int>(std::count_if(part.loops.begin(), part.loops.end(), [&](const Loop& loop) {
        return !loop.edges.empty() && signed_area(part, loop) < 0;
    }));
}

bool has_general_curves(const Part& part) {
    return std::any_of(part.edges.begin(), part.edges.end(), [](const Edge& edge) {
        return std::holds_alternative<EllipticArc>(edge.curve) || std::holds_alternative<Spline>(edge.curve);
    });
}

bool contains(const Part& part, const Vec2& p) {
    return contains(monotone_pieces(part), p);
}

double merge_length(const Part& part) {
    return merge_fraction * bounding_box(part).diagonal();
}

Part transformed(const Part& part, double c, double s, const Vec2& d) {
    ENSURE(std::abs(c * c + s * s - 1) < 1e-9, "a cosine and a sine are of one angle");
    Part moved = part;
    for (Edge& edge : moved.edges) edge.curve = transformed(edge.curve, c, s, d);
    return moved;
}

double edge_arc_length(const Edge& edge, double t) {
    return edge.along_source ? length(edge.curve, 0, t) : length(edge.curve, t, 1);
}

}  // namespace abut::geometry
