// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_loops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "src/scene/read_general_edges.hpp"

namespace abut {

namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Segment;
/// What one edge of the file stands for: one curve, or the smooth pieces of one.
using Curves = std::vector<Curve>;

constexpr double two_pi = 2 * std::numbers::pi;
/// Two radii of an arc (centre to start, centre to end) may differ by this fraction: about the rounding of coordinates with ten
/// digits.
constexpr double radius_mismatch = 1e-9;
/// Three points of an arc must span an angle (sine) greater than this: flatter ones leave the radius undetermined.
constexpr double collinear_sine = 1e-9;

double angle_of(const Vec2& v) {
    return std::atan2(v.y(), v.x());
}

/// The turn from a to b, in (0, 2 pi] counter-clockwise or in [-2 pi, 0) clockwise.
double turn(double a, double b, bool ccw) {
    const double forward = b - a - two_pi * std::floor((b - a) / two_pi);
    if (ccw) return forward > 0 ? forward : two_pi;
    return forward > 0 ? forward - two_pi : -two_pi;
}

Curves read_line(SceneReading& reading, const JsonValue& value) {
    if (!check_object(reading, value, {"from", "to"})) return {};
    const auto from = required_member(reading, value, "from", read_vector, dimension::length),
               to = required_member(reading, value, "to", read_vector, dimension::length);
    if (!from || !to) return {};
    if (*from != *to) return {Segment{*from, *to}};
    report_problem(reading, value, "the line begins where it ends");
    return {};
}

Curves arc_about_center(SceneReading& reading, const JsonValue& value, const Vec2& from, const Vec2& to) {
    const auto center = required_member(reading, value, "center", read_vector, dimension::length);
    const bool ccw = member_or(reading, value, "ccw", true, read_flag);
    if (!center) return {};
    const double r0 = (from - *center).norm(), r1 = (to - *center).norm();
    if (std::abs(r0 - r1) > radius_mismatch * std::max(r0, r1)) {
        report_problem(
            reading, value,
            "the arc's ends lie at different distances from its center: " + std::to_string(r0) + " and " + std::to_string(r1),
            "correct one of the points, or give 'from', 'via' and 'to'");
        return {};
    }
    if (!(r0 > 0)) {
        report_problem(reading, value, "the arc has no radius", "'from' must differ from 'center'");
        return {};
    }
    const double start = angle_of(from - *center);
    return {
        Arc{*center, 0.5 * (r0 + r1), start, from == to ? (ccw ? two_pi : -two_pi) : turn(start, angle_of(to - *center), ccw)}};
}

Curves arc_through(SceneReading& reading, const JsonValue& value, const Vec2& from, const Vec2& to) {
    const auto via = required_member(reading, value, "via", read_vector, dimension::length);
    if (!via) return {};
    // Centre c relative to `from`: 2 c.a = a.a and 2 c.b = b.b for a = via - from, b = to - from.
    const Vec2 a = *via - from, b = to - from;
    const double twice = 2 * geometry::cross(a, b);
    if (!(std::abs(twice) > 2 * collinear_sine * a.norm() * b.norm())) {
        report_problem(reading, value, "the three points of the arc lie on one line", "write a 'line', or move 'via'");
        return {};
    }
    const Vec2 c =
        Vec2(b.y() * a.squaredNorm() - a.y() * b.squaredNorm(), a.x() * b.squaredNorm() - b.x() * a.squaredNorm()) / twice;
    const double start = angle_of(-c);
    // via lies on the right of the chord from -> to where the arc turns left.
    return {Arc{from + c, c.norm(), start, turn(start, angle_of(b - c), twice > 0)}};
}

Curves read_arc(SceneReading& reading, const JsonValue& value) {
    const bool through = find_member(value, "via") != nullptr;
    const Words keys = through ? Words{"from", "via", "to"} : Words{"from", "to", "center", "ccw", "via"};
    if (!check_object(reading, value, keys)) return {};
    const auto from = required_member(reading, value, "from", read_vector, dimension::length),
               to = required_member(reading, value, "to", read_vector, dimension::length);
    if (!from || !to) return {};
    return through ? arc_through(reading, value, *from, *to) : arc_about_center(reading, value, *from, *to);
}

struct EdgeKind {
    const char* key;
    Curves (*read)(SceneReading&, const JsonValue&);
};
constexpr EdgeKind edge_kinds[] = {
    {"line", read_line}, {"arc", read_arc}, {"elliptic_arc", read_elliptic_arc}, {"bezier", read_bezier}, {"nurbs", read_nurbs},
};

/// Empty where the edge is wrong (reported).
Curves read_curves(SceneReading& reading, const JsonValue& edge) {
    static const std::vector<std::string> kinds = [] {
        std::vector<std::string> keys;
        for (const EdgeKind& kind : edge_kinds) keys.emplace_back(kind.key);
        return keys;
    }();
    Words words = kinds;
    words.emplace_back("name");
    const std::size_t before = reading.problems.size();
    if (!check_object(reading, edge, words) || reading.problems.size() > before) return {};
    const JsonValue* value = exactly_one(reading, edge, kinds);
    for (const EdgeKind& kind : edge_kinds)
        if (value && value->key == kind.key) return kind.read(reading, *value);
    return {};
}

void append_edges(std::vector<geometry::LoopEdge>& loop, Curves curves, const std::string& name, const std::string& where) {
    for (std::size_t k = 0; k < curves.size(); ++k)
        loop.push_back({std::move(curves[k]), curves.size() > 1 ? name + "#" + std::to_string(k) : name, where});
}

}  // namespace

std::string read_edge_prefix(SceneReading& reading, const JsonValue& object) {
    const JsonValue* value = find_member(object, "name");
    const std::optional<std::string> name = value ? read_text(reading, *value) : std::nullopt;
    if (!name) return "";
    if (name->find_first_of("#*") == std::string::npos) return *name;
    report_problem(reading, *value, "the name '" + *name + "' contains '#' or '*'",
                   "these have a meaning where edges are selected");
    return "";
}

std::optional<geometry::Loops> read_loops(SceneReading& reading, const JsonValue& value) {
    if (!check_list(reading, value, 1, "loops")) return std::nullopt;
    const std::size_t before = reading.problems.size();
    geometry::Loops loops;
    std::set<std::string> names;
    int n_edges = 0;
    for (const JsonValue& loop : value.items) {
        loops.loops.emplace_back();
        if (!check_list(reading, loop, 1, "edges")) continue;
        for (const JsonValue& edge : loop.items) {
            std::string name = read_edge_prefix(reading, edge);
            if (name.empty()) name = "e" + std::to_string(n_edges);
            ++n_edges;
            if (!names.insert(name).second)
                report_problem(reading, edge, "two edges have the name '" + name + "'", "rename one of them");
            append_edges(loops.loops.back(), read_curves(reading, edge), name, edge.pointer);
        }
    }
    if (reading.problems.size() > before) return std::nullopt;
    return loops;
}

}  // namespace abut
