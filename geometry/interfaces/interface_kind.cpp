// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/interfaces/interface_kind.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/brep/closest_points.hpp"
#include "geometry/interfaces/teeth.hpp"
#include "geometry/proximity/facing.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

enum class Shape { flat, convex, concave };

bool is_general(const Curve& curve) {
    return !std::holds_alternative<Segment>(curve) && !std::holds_alternative<Arc>(curve);
}

/// Signed angle by which the tangent turns from one parameter to another, less than half a turn apart.
double turn(const Curve& curve, double t0, double t1) {
    return angle_between(derivative(curve, t0), derivative(curve, t1));
}

/// Turning of a curve to the left and to the right, both counted positive.
struct Turning {
    double left = 0, right = 0;
};
Turning turning_of(const Curve& curve) {
    std::vector<double> cuts{0, 1};
    for (const std::vector<double>& list : {axis_extrema(curve), smoothness_breaks(curve)})
        cuts.insert(cuts.end(), list.begin(), list.end());
    std::sort(cuts.begin(), cuts.end());
    constexpr int steps = 4;  // monotone pieces turn by a quarter at most; inflections inside them hide little of it
    Turning sum;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        for (int k = 0; k < steps; ++k) {
            const double width = (cuts[i + 1] - cuts[i]) / steps, t = cuts[i] + k * width;
            const double angle = turn(curve, t, t + width);
            (angle > 0 ? sum.left : sum.right) += std::abs(angle);
        }
    return sum;
}

/// Of an ellipse or spline at parameter t; where it is straight there, the curve as a whole.
Shape general_shape(const Curve& curve, double t) {
    const Turning turning = turning_of(curve);
    if (turning.left + turning.right < chain_angle) return Shape::flat;
    const double kappa = curvature(curve, t);
    const bool straight_here = std::abs(kappa) * length(curve) < chain_angle;
    return (straight_here ? turning.left - turning.right : kappa) > 0 ? Shape::convex : Shape::concave;
}

/// Of an edge at parameter t; on lines and circles it is the same everywhere.
Shape shape_at(const Part& part, int edge, double t) {
    const Curve& curve = curve_of(part, edge);
    if (std::holds_alternative<Segment>(curve)) return Shape::flat;
    if (is_general(curve)) return general_shape(curve, t);
    return curvature(curve, 0.5) > 0 ? Shape::convex : Shape::concave;
}

const Loop& loop_or_first(const Part& part, int edge) {
    const Loop* loop = loop_of(part, edge);
    return loop ? *loop : part.loops.front();
}

/// Drawn circles may come in several arcs whose centres and radii agree to the drawing's digits only.
constexpr double same_circle_fraction = 1e-4;

/// How far round the circle of this arc goes in its loop, radians.
double turn_of_circle(const Part& part, int edge) {
    const Arc& arc = std::get<Arc>(curve_of(part, edge));
    const double same = same_circle_fraction * arc.radius;
    double turn = 0;
    for (const int e : loop_or_first(part, edge).edges) {
        const auto* other = std::get_if<Arc>(&curve_of(part, e));
        if (other && other->sweep * arc.sweep > 0 && (other->center - arc.center).norm() <= same &&
            std::abs(other->radius - arc.radius) <= same)
            turn += std::abs(other->sweep);
    }
    return turn;
}

/// Turning to the right of the chain that the edge belongs to, radians; none where all of it is lines and circles, which know
/// their own circle.
std::optional<double> turn_of_chain(const Part& part, int edge) {
    for (const Chain& chain : smooth_chains(part)) {
        if (std::find(chain.edges.begin(), chain.edges.end(), edge) == chain.edges.end()) continue;
        const auto general = [&](int e) { return is_general(curve_of(part, e)); };
        if (std::none_of(chain.edges.begin(), chain.edges.end(), general)) return std::nullopt;
        double sum = 0;
        for (const int e : chain.edges) sum += turning_of(curve_of(part, e)).right;
        return sum;
    }
    return std::nullopt;
}

std::string round_in(const Part& part, int concave_edge) {
    constexpr double rounding = 1e-9;
    const std::optional<double> by_chain = turn_of_chain(part, concave_edge);
    const double around = by_chain ? *by_chain : turn_of_circle(part, concave_edge);
    return around > std::numbers::pi + rounding ? "pin-in-hole" : "round-in-groove";
}

/// Where the edges come closest: there the curvature tells the kind of contact. Not looked for where it is the same everywhere.
ClosestPoints contact_of(const Part& part1, int edge1, const Part& part2, int edge2) {
    const Curve &curve1 = curve_of(part1, edge1), &curve2 = curve_of(part2, edge2);
    if (!is_general(curve1) && !is_general(curve2)) return {};
    return closest_points(curve1, curve2);
}

bool are_toothed(const Part& part1, int edge1, const Part& part2, int edge2) {
    return count_teeth(part1, edge1) > 0 && count_teeth(part2, edge2) > 0;
}

}  // namespace

std::string interface_kind(const Part& part1, int edge1, const Part& part2, int edge2) {
    ENSURE(edge1 >= 0 && static_cast<std::size_t>(edge1) < part1.edges.size() && edge2 >= 0 &&
               static_cast<std::size_t>(edge2) < part2.edges.size(),
           "the edges are those of the parts");
    if (are_toothed(part1, edge1, part2, edge2)) return "tooth-on-tooth";
    const ClosestPoints contact = contact_of(part1, edge1, part2, edge2);
    const Shape s1 = shape_at(part1, edge1, contact.t1), s2 = shape_at(part2, edge2, contact.t2);
    if (s1 == Shape::convex && s2 == Shape::concave) return round_in(part2, edge2);
    if (s1 == Shape::concave && s2 == Shape::convex) return round_in(part1, edge1);
    if (s1 == Shape::concave || s2 == Shape::concave) return "general";
    const auto word = [](Shape s) { return s == Shape::flat ? std::string("flat") : std::string("round"); };
    return word(s1) + "-on-" + word(s2);
}

std::string corner_interface(const Part& part1, int edge1, double t1, const Part& part2, int edge2, double t2) {
    ENSURE(edge1 >= 0 && static_cast<std::size_t>(edge1) < part1.edges.size() && edge2 >= 0 &&
               static_cast<std::size_t>(edge2) < part2.edges.size(),
           "the edges are those of the parts");
    if (are_toothed(part1, edge1, part2, edge2)) return "tooth-on-tooth";
    const bool corner1 = is_convex_corner(part1, edge1, t1), corner2 = is_convex_corner(part2, edge2, t2);
    if (corner1 == corner2) return "general";
    const Shape face = corner1 ? shape_at(part2, edge2, t2) : shape_at(part1, edge1, t1);
    return face == Shape::flat ? "edge-on-flat" : "general";
}

}  // namespace abut::geometry
