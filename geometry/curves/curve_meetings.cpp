// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and circles. The closest approach of two curves is a crossing of the lines or circles that carry them, the point where
// these come closest without crossing, or an end of one of the curves. All of these are tried; those that lie on both curves
// are kept.
#include "geometry/curves/curve_meetings.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/curves/general_meetings.hpp"

namespace abut::geometry {

namespace {

void add_line_line(const Segment& a, const Segment& b, std::vector<Vec2>& found) {
    const Vec2 u = a.to - a.from, v = b.to - b.from;
    const double det = cross(u, v);
    if (det != 0) found.push_back(a.from + cross(b.from - a.from, v) / det * u);
}

void add_line_circle(const Segment& line, const Arc& arc, std::vector<Vec2>& found) {
    const Vec2 u = (line.to - line.from).normalized();
    const Vec2 foot = line.from + (arc.center - line.from).dot(u) * u;
    const double half = std::sqrt(std::max(0.0, arc.radius * arc.radius - (foot - arc.center).squaredNorm()));
    for (double s : {0.0, half, -half}) found.push_back(foot + s * u);
}

void add_circle_circle(const Arc& a, const Arc& b, std::vector<Vec2>& found) {
    const Vec2 between = b.center - a.center;
    const double d = between.norm();
    if (d == 0) return;  // concentric: the distance is the same everywhere, the ends decide
    const Vec2 u = between / d;
    for (double side : {1.0, -1.0}) found.push_back(a.center + side * a.radius * u);
    const double along = (d + (a.radius - b.radius) * (a.radius + b.radius) / d) / 2;
    const double half = std::sqrt(std::max(0.0, (a.radius - along) * (a.radius + along)));
    for (double side : {1.0, -1.0}) found.push_back(a.center + along * u + side * half * left_of(u));
}

bool is_line_or_circle(const Curve& curve) {
    return std::holds_alternative<Segment>(curve) || std::holds_alternative<Arc>(curve);
}

}  // namespace

std::vector<Vec2> meeting_points(const Curve& a, const Curve& b, double tolerance) {
    if (!is_line_or_circle(a) || !is_line_or_circle(b)) return general_meeting_points(a, b, tolerance);
    std::vector<Vec2> tried{point(a, 0), point(a, 1), point(b, 0), point(b, 1)};
    const auto* line_a = std::get_if<Segment>(&a);
    const auto* line_b = std::get_if<Segment>(&b);
    if (line_a && line_b)
        add_line_line(*line_a, *line_b, tried);
    else if (line_a)
        add_line_circle(*line_a, std::get<Arc>(b), tried);
    else if (line_b)
        add_line_circle(*line_b, std::get<Arc>(a), tried);
    else
        add_circle_circle(std::get<Arc>(a), std::get<Arc>(b), tried);

    const auto near = [&](const Curve& curve, const Vec2& p) {
        return (point(curve, closest_parameter(curve, p)) - p).norm() <= tolerance;
    };
    std::erase_if(tried, [&](const Vec2& p) { return !near(a, p) || !near(b, p); });
    return tried;
}

}  // namespace abut::geometry
