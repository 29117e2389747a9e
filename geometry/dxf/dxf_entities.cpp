// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_entities.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

#include "geometry/curves/numbers.hpp"
#include "geometry/dxf/dxf_numbers.hpp"
#include "geometry/dxf/dxf_placement.hpp"
#include "geometry/dxf/dxf_splines.hpp"

namespace abut::geometry::dxf {

namespace {

constexpr double one_degree = std::numbers::pi / 180;

Outline outline_of(const Numbers& numbers, const Curve& curve) {
    if (!numbers.is_good()) return {{}, false, numbers.wrong()};
    return {{curve}, false, {}};
}

Outline read_line(const Record& record) {
    Numbers numbers(record);
    const Vec2 from = numbers.point(10);
    return outline_of(numbers, Segment{from, numbers.point(11)});
}

/// An arc, or where it has shrunk to its centre a segment of no length.
Curve arc_or_point(const Vec2& center, double radius, double start, double sweep) {
    if (radius == 0) return Segment{center, center};
    return Arc{center, radius, start, sweep};
}

double radius_of(Numbers& numbers) {
    const double radius = numbers(40);
    if (radius < 0) numbers.fail("its radius is negative");
    return radius;
}

Outline read_circle(const Record& record) {
    Numbers numbers(record);
    const Vec2 center = numbers.point(10);
    return outline_of(numbers, arc_or_point(center, radius_of(numbers), 0, two_pi));
}

/// Counter-clockwise from one angle to the other (degrees); equal angles are a full turn.
Outline read_arc(const Record& record) {
    Numbers numbers(record);
    const Vec2 center = numbers.point(10);
    const double radius = radius_of(numbers), from = numbers(50), to = numbers(51);
    const double start = std::fmod(from, 360.0);
    double sweep = std::fmod(std::fmod(to, 360.0) - start, 360.0);
    if (sweep <= 0) sweep += 360;
    return outline_of(numbers, arc_or_point(center, radius, start * one_degree, sweep * one_degree));
}

/// Eccentric angles that differ by a full turn but for this are one: six decimals of 2 pi are 3e-7 off.
constexpr double angle_rounding = 1e-6;
/// Least ratio of the axes that the DXF reference allows.
constexpr double least_ratio = 1e-6;

double elliptic_sweep(double from, double to) {
    double sweep = std::fmod(to - from, two_pi);
    if (sweep < 0) sweep += two_pi;
    return sweep <= angle_rounding || sweep >= two_pi - angle_rounding ? two_pi : sweep;
}

/// The second axis is the normal times the first, times their ratio.
Outline read_ellipse(const Record& record) {
    Numbers numbers(record);
    const Vec2 center = numbers.point(10), a = numbers.point(11);
    const double side = record.number(230, 1) < 0 ? -1 : 1, ratio = numbers(40);
    const double from = numbers(41, 0), to = numbers(42, two_pi);
    if (std::abs(ratio) < least_ratio) numbers.fail("its axes have a ratio of less than 1e-6");
    if (!numbers.is_good() || a == Vec2(0, 0)) return outline_of(numbers, Segment{center, center});
    const double start = std::fmod(from, two_pi);  // billions of turns would leave no digit for the place on the ellipse
    return outline_of(numbers, circle_or_ellipse(center, a, side * ratio * left_of(a), start, elliptic_sweep(from, to)));
}

// ---- polylines ----

struct Vertex {
    Vec2 at{0, 0};
    double bulge = 0;  ///< of the piece that begins here: tan(sweep / 4), positive counter-clockwise
};

/// Below this the sagitta is smaller than the rounding of the arc's centre.
const double straight_bulge = std::sqrt(std::numeric_limits<double>::epsilon());

Outline polyline(const std::vector<Vertex>& vertices, bool is_closed) {
    if (vertices.empty()) return {{}, true, "it has no vertices"};
    Outline outline{{}, true, {}};
    const std::size_t n = vertices.size();
    for (std::size_t k = 0; k + (is_closed ? 0 : 1) < n; ++k) {
        const Vertex &a = vertices[k], &b = vertices[(k + 1) % n];
        if (k > 0 && k + 1 == n && a.at == b.at) break;  // the first point was repeated, and the polyline flagged as closed
        outline.curves.push_back(from_bulge(a.at, b.at, a.bulge));
    }
    if (n == 1 && !is_closed) outline.curves.push_back(Segment{vertices[0].at, vertices[0].at});
    return outline;
}

bool is_closed(const Record& record) {
    return (record.integer(70, 0) & 1) != 0;
}

/// x, y and bulge follow each other, vertex after vertex.
Outline read_light_polyline(const Record& record) {
    Numbers numbers(record);
    std::vector<Vertex> vertices;
    std::vector<const Group*> bulges;
    std::size_t n_y = 0;
    for (const Group& group : record.groups) {
        if (group.code == 10) {
            if (n_y < vertices.size()) break;
            vertices.push_back({{numbers.of(group), 0}, 0});
        } else if (group.code == 20) {
            if (++n_y != vertices.size()) break;
            vertices.back().at.y() = numbers.of(group);
        } else if (group.code == 42 && !vertices.empty()) {
            bulges.resize(vertices.size(), nullptr);
            bulges.back() = &group;
        }
    }
    if (n_y != vertices.size()) numbers.fail("its vertices lack coordinates");
    bulges.resize(vertices.size(), nullptr);
    const std::size_t n_pieces = vertices.size() - (is_closed(record) || vertices.empty() ? 0 : 1);
    for (std::size_t k = 0; k < (vertices.size() > 1 ? n_pieces : 0); ++k)  // behind the last vertex nothing bulges
        if (bulges[k]) vertices[k].bulge = numbers.of(*bulges[k]);
    return numbers.is_good() ? polyline(vertices, is_closed(record)) : Outline{{}, true, numbers.wrong()};
}

/// Vertices follow the record; control points of spline-fitted polylines (flag 16) are not on the curve.
Outline read_heavy_polyline(std::span<const Record> records, std::size_t i) {
    constexpr int control_point = 16;
    const Record& head = records[i];
    std::vector<Vertex> vertices;
    for (++i; i < records.size() && records[i].type == "VERTEX"; ++i) {
        if ((records[i].integer(70, 0) & control_point) != 0) continue;
        Numbers numbers(records[i]);
        const Vec2 at = numbers.point(10);
        vertices.push_back({at, numbers(42, 0)});
        if (!numbers.is_good()) return {{}, true, "vertex at line " + std::to_string(records[i].line) + ": " + numbers.wrong()};
    }
    return polyline(vertices, is_closed(head));
}

}  // namespace

Curve from_bulge(const Vec2& from, const Vec2& to, double bulge) {
    if (std::abs(bulge) < straight_bulge || from == to) return Segment{from, to};
    const Vec2 center = 0.5 * (from + to) + (1 - bulge * bulge) / (4 * bulge) * left_of(to - from);
    const Vec2 d = from - center;
    return Arc{center, d.norm(), std::atan2(d.y(), d.x()), 4 * std::atan(bulge)};
}

Outline read_outline(std::span<const Record> records, std::size_t i) {
    const Record& record = records[i];
    if (record.type == "LINE") return read_line(record);
    if (record.type == "ARC") return read_arc(record);
    if (record.type == "CIRCLE") return read_circle(record);
    if (record.type == "ELLIPSE") return read_ellipse(record);
    if (record.type == "LWPOLYLINE") return read_light_polyline(record);
    if (record.type == "POLYLINE") return read_heavy_polyline(records, i);
    return read_spline(record);
}

Heights heights_of(std::span<const Record> records, std::size_t i) {
    std::vector<double> heights;
    const auto take = [&](const Record& record, std::initializer_list<int> codes) {
        for (const Group& group : record.groups)
            if (double z = 0; std::find(codes.begin(), codes.end(), group.code) != codes.end() && parse_number(group.value, z))
                heights.push_back(is_seen_from_below(record) ? -z : z);
    };
    const Record& record = records[i];
    if (record.type == "LWPOLYLINE")
        take(record, {38});
    else if (record.type == "LINE" || record.type == "SPLINE")
        take(record, {30, 31});
    else if (record.type != "POLYLINE" || has_own_plane(record))
        take(record, {30});
    else
        for (std::size_t k = i + 1; k < records.size() && records[k].type == "VERTEX"; ++k) take(records[k], {30});
    if (heights.empty()) return {};
    const auto [least, largest] = std::minmax_element(heights.begin(), heights.end());
    return {*least, *largest};
}

bool has_own_plane(const Record& entity) {
    constexpr int polyline_3d = 8;
    if (entity.type == "POLYLINE") return (entity.integer(70, 0) & polyline_3d) == 0;
    return entity.type != "LINE" && entity.type != "SPLINE";
}

bool is_seen_from_below(const Record& entity) {
    return has_own_plane(entity) && entity.type != "ELLIPSE" && entity.number(230, 1) < 0;
}

Vec2 first_point(const Record& record) {
    const int code = record.find(10) ? 10 : 11;  // splines may have fit points only
    return {record.number(code, 0), record.number(code + 10, 0)};
}

}  // namespace abut::geometry::dxf
