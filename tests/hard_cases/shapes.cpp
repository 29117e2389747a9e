// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard_cases/shapes.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/curves/spline_shape.hpp"

namespace abut::test {

namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Part;
using geometry::Segment;
using std::numbers::pi;

void add_loop(Part& part, const std::vector<Curve>& curves) {
    geometry::Loop loop;
    for (const Curve& curve : curves) {
        loop.edges.push_back(static_cast<int>(part.edges.size()));
        const std::string name = "e" + std::to_string(part.edges.size());
        part.edges.push_back({curve, name, name, true, 0});
    }
    part.loops.push_back(loop);
}

Part part_of(const std::vector<Curve>& outline) {
    Part part;
    part.name = "part";
    add_loop(part, outline);
    return part;
}

/// Clockwise: a hole.
void add_spline_hole(Part& part, const Vec2& c, double r) {
    const auto at = [&](double x, double y) { return Vec2(c + r * Vec2(x, y)); };
    add_loop(part, {geometry::bezier_curve({at(-1, 0), at(-0.9, 1.5), at(0.7, 1.1), at(1, 0)}, {}),
                    geometry::bezier_curve({at(1, 0), at(1.3, -1.1), at(-1.1, -1.5), at(-1, 0)}, {})});
}

}  // namespace

Part polygon(const std::vector<Vec2>& points) {
    std::vector<Curve> outline;
    for (std::size_t i = 0; i < points.size(); ++i) outline.push_back(Segment{points[i], points[(i + 1) % points.size()]});
    return part_of(outline);
}

Part rectangle(const Vec2& min, const Vec2& max) {
    return polygon({min, {max.x(), min.y()}, max, {min.x(), max.y()}});
}

Part disc(const Vec2& center, double radius) {
    return part_of({Arc{center, radius, 0, pi}, Arc{center, radius, pi, pi}});
}

Part ell() {
    return polygon({{0, 0}, {0, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, 0}});
}

Part turned_square(const Vec2& center, double side, double degrees) {
    const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180), a = side / 2;
    return transformed(rectangle({-a, -a}, {a, a}), c, s, center);
}

Part plate_quarter(double size) {
    return part_of({Segment{{1, 0}, {size, 0}}, Segment{{size, 0}, {size, size}}, Segment{{size, size}, {0, size}},
                    Segment{{0, size}, {0, 1}}, Arc{{0, 0}, 1, pi / 2, -pi / 2}});
}

Part ring_quarter(double inner, double outer) {
    return part_of({Segment{{inner, 0}, {outer, 0}}, Arc{{0, 0}, outer, 0, pi / 2}, Segment{{0, outer}, {0, inner}},
                    Arc{{0, 0}, inner, pi / 2, -pi / 2}});
}

Part ring(double inner, double outer) {
    return with_hole(disc({0, 0}, outer), {0, 0}, inner);
}

Part plate_with_splines() {
    const Vec2 lower(1.31, 0), upper(1.31, 1.17);
    Part part = part_of({Segment{{0, 0}, lower}, geometry::bezier_curve({lower, {1.31, 0.35}, {1.08, 0.8}, upper}, {}),
                         Segment{upper, {0, 1.17}}, Segment{{0, 1.17}, {0, 0}}});
    add_spline_hole(part, {0.87, 0.47}, 0.17);
    return with_hole(std::move(part), {0.37, 0.72}, 0.19);
}

Part with_hole(Part part, const Vec2& center, double radius) {
    add_loop(part, {Arc{center, radius, pi, -pi}, Arc{center, radius, 0, -pi}});
    return part;
}

const std::vector<SweptShape>& swept_shapes() {
    static const std::vector<SweptShape> shapes{
        {"rectangle", rectangle({-0.5, -0.31}, {0.5, 0.43}), 3, false},
        {"disc", disc({0, 0}, 0.5), 0, false},
        {"L", polygon({{0, 0}, {0, -0.47}, {0.53, -0.47}, {0.53, 0.5}, {-0.5, 0.5}, {-0.5, 0}}), 4, false},
        {"turned square", turned_square({0, 0}, 0.85, 31), 1, true}};
    return shapes;
}

}  // namespace abut::test
