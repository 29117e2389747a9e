// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_general_edges.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "geometry/curves/spline_shape.hpp"

namespace abut {

namespace {

using geometry::Curve;

constexpr double full_turn = 360, quarter_turn = 90;  // degrees

/// The unit vector at an angle in degrees, exact at quarter turns: the cosine of pi/2 in doubles is not 0.
Vec2 direction_at(double degrees) {
    const double turn = std::remainder(degrees, full_turn);
    const double quarters = turn / quarter_turn;
    if (quarters != std::nearbyint(quarters)) {
        const double angle = turn * std::numbers::pi / 180;
        return {std::cos(angle), std::sin(angle)};
    }
    static constexpr int c[] = {1, 0, -1, 0}, s[] = {0, 1, 0, -1};
    const auto k = static_cast<std::size_t>((static_cast<int>(quarters) + 4) % 4);
    return Vec2(c[k], s[k]);
}

/// Counter-clockwise from one angle to the other (degrees), in (0, 360]; equal angles are a full turn.
double turn_between(double start, double end) {
    const double turn = std::fmod(std::fmod(end, full_turn) - std::fmod(start, full_turn), full_turn);
    return turn > 0 ? turn : turn + full_turn;
}

/// Every item by the reader; nothing where one of them is wrong (reported).
template <class T, class Read>
std::optional<std::vector<T>> read_list(SceneReading& reading, const JsonValue& value, const std::string& of_what, Read read) {
    if (!check_list(reading, value, 1, of_what)) return std::nullopt;
    std::vector<T> list;
    for (const JsonValue& item : value.items)
        if (const auto read_item = read(reading, item)) list.push_back(*read_item);
    if (list.size() != value.items.size()) return std::nullopt;
    return list;
}

std::optional<std::vector<double>> read_numbers(SceneReading& reading, const JsonValue& value) {
    return read_list<double>(reading, value, "numbers",
                             [](SceneReading& r, const JsonValue& v) { return read_number(r, v, dimension::none); });
}

std::optional<std::vector<Vec2>> read_points(SceneReading& reading, const JsonValue& value) {
    return read_list<Vec2>(reading, value, "points",
                           [](SceneReading& r, const JsonValue& v) { return read_vector(r, v, dimension::length); });
}

std::optional<std::vector<double>> read_weights(SceneReading& reading, const JsonValue& spline) {
    const JsonValue* weights = find_member(spline, "weights");
    return weights ? read_numbers(reading, *weights) : std::vector<double>{};
}

std::optional<int> read_degree(SceneReading& reading, const JsonValue& value) {
    return read_integer(reading, value, 1, geometry::max_spline_degree);
}

}  // namespace

std::optional<Vec2> read_radii(SceneReading& reading, const JsonValue& value) {
    const auto radii = read_vector(reading, value, dimension::length);
    if (!radii || (radii->x() > 0 && radii->y() > 0)) return radii;
    report_problem(reading, value, "both radii must be greater than 0");
    return std::nullopt;
}

std::vector<Curve> read_elliptic_arc(SceneReading& reading, const JsonValue& value) {
    if (!check_object(reading, value, {"center", "radii", "angle", "start", "end"})) return {};
    const auto center = required_member(reading, value, "center", read_vector, dimension::length),
               radii = required_member(reading, value, "radii", read_radii);
    const double angle = member_or(reading, value, "angle", 0.0, read_number, dimension::angle);
    const auto start = required_member(reading, value, "start", read_number, dimension::angle),
               end = required_member(reading, value, "end", read_number, dimension::angle);
    if (!center || !radii || !start || !end) return {};
    const Vec2 axis = direction_at(angle);
    constexpr double degree = std::numbers::pi / 180;
    return {geometry::EllipticArc{*center, radii->x() * axis, radii->y() * geometry::left_of(axis),
                                  std::fmod(*start, full_turn) * degree, turn_between(*start, *end) * degree}};
}

std::vector<Curve> read_bezier(SceneReading& reading, const JsonValue& value) {
    if (!check_object(reading, value, {"points", "weights"})) return {};
    const auto points = required_member(reading, value, "points", read_points);
    const auto weights = read_weights(reading, value);
    if (!points || !weights) return {};
    const std::string fault = geometry::bezier_fault(*points, *weights);
    if (fault.empty()) return {geometry::bezier_curve(*points, *weights)};
    report_problem(reading, value, "the Bezier curve is not valid: " + fault);
    return {};
}

std::vector<Curve> read_nurbs(SceneReading& reading, const JsonValue& value) {
    if (!check_object(reading, value, {"degree", "knots", "points", "weights"})) return {};
    const auto degree = required_member(reading, value, "degree", read_degree);
    const auto knots = required_member(reading, value, "knots", read_numbers);
    const auto points = required_member(reading, value, "points", read_points);
    const auto weights = read_weights(reading, value);
    if (!degree || !knots || !points || !weights) return {};
    const geometry::Nurbs nurbs{*degree, *knots, *points, *weights};
    const std::string fault = geometry::spline_fault(nurbs);
    if (fault.empty()) return geometry::nurbs_curves(nurbs);
    report_problem(reading, value, "the NURBS curve is not valid: " + fault);
    return {};
}

}  // namespace abut
