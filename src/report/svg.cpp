// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/curves/arc_spline.hpp"
#include "src/io/number_text.hpp"

namespace abut {

namespace {

constexpr double drawn_deviation = 0.05;  ///< pixels between a spline and the arcs that it is drawn as

std::string text_of(const Vec2& p) {
    return coordinate_text(p.x()) + " " + coordinate_text(p.y());
}

/// Radii and rotation of an SVG "A" command. Arcs run in pieces below a half turn: the large-arc flag is then always 0, and a
/// full circle, whose ends coincide, is drawn at all.
struct ArcCommand {
    double rx, ry;
    double rotation;  ///< degrees, SVG's sense: clockwise as seen
    double sweep;     ///< counter-clockwise in the model
};

std::optional<ArcCommand> arc_command(const geometry::Curve& curve) {
    if (const auto* arc = std::get_if<geometry::Arc>(&curve)) return ArcCommand{arc->radius, arc->radius, 0, arc->sweep};
    const auto* arc = std::get_if<geometry::EllipticArc>(&curve);
    if (!arc) return std::nullopt;
    const double rotation = -std::atan2(arc->a.y(), arc->a.x()) * 180 / std::numbers::pi;
    // On a mirrored ellipse growing eccentric angles run clockwise.
    return ArcCommand{arc->a.norm(), arc->b.norm(), rotation, geometry::cross(arc->a, arc->b) > 0 ? arc->sweep : -arc->sweep};
}

void append_arc(std::string& path, const geometry::Curve& curve, const ArcCommand& arc, double t0, double t1,
                const View& view) {
    const int n = 1 + static_cast<int>(std::abs(arc.sweep) * (t1 - t0) / (0.75 * std::numbers::pi));
    const std::string radii =
        coordinate_text(arc.rx * view.scale) + " " + coordinate_text(arc.ry * view.scale) + " " + coordinate_text(arc.rotation);
    const char* direction = arc.sweep > 0 ? " 0 0 " : " 0 1 ";  // y is turned down: counter-clockwise is SVG's negative sweep
    for (int i = 1; i <= n; ++i)
        path += "A" + radii + direction + text_of(view(geometry::point(curve, t0 + (t1 - t0) * i / n)));
}

/// Continues a path along the curve.
void append_curve(std::string& path, const geometry::Curve& curve, double t0, double t1, const View& view) {
    if (std::holds_alternative<geometry::Segment>(curve)) {
        path += "L" + text_of(view(geometry::point(curve, t1)));
        return;
    }
    if (const auto arc = arc_command(curve)) return append_arc(path, curve, *arc, t0, t1, view);
    for (const geometry::ArcPiece& piece : geometry::arc_spline(trimmed(curve, t0, t1), drawn_deviation / view.scale))
        append_curve(path, piece.curve, 0, 1, view);
}

std::string hex(const std::array<double, 3>& rgb) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string text = "#";
    for (double c : rgb) {
        const auto byte = static_cast<unsigned>(std::lround(std::clamp(c, 0.0, 255.0)));
        text += digits[byte / 16];
        text += digits[byte % 16];
    }
    return text;
}

}  // namespace

View fit_view(const Box2& box, double width, double max_height, double margin) {
    View view;
    view.box = box;
    view.width = width;
    if (box.empty()) {
        view.height = 2 * margin;
        view.offset = {margin, margin};
        return view;
    }
    const Vec2 size = box.size();
    const Vec2 room(std::max(width - 2 * margin, 1.0), std::max(max_height - 2 * margin, 1.0));
    const double longest = std::max(size.x() / room.x(), size.y() / room.y());
    view.scale = longest > 0 ? 1 / longest : 1;
    view.height = view.scale * size.y() + 2 * margin;
    view.offset = {width / 2 - view.scale * box.center().x(), view.height / 2 + view.scale * box.center().y()};
    return view;
}

std::string path_data(const geometry::Part& part, const View& view) {
    std::string path;
    for (const geometry::Loop& loop : part.loops) {
        bool first = true;
        for (int e : loop.edges) {
            const geometry::Curve& curve = part.edges[static_cast<std::size_t>(e)].curve;
            if (first) path += "M" + text_of(view(geometry::point(curve, 0)));
            first = false;
            append_curve(path, curve, 0, 1, view);
        }
        if (!first) path += "Z";
    }
    return path;
}

std::string path_data(const geometry::Curve& curve, double t0, double t1, const View& view) {
    std::string path = "M" + text_of(view(geometry::point(curve, t0)));
    append_curve(path, curve, t0, t1, view);
    return path;
}

std::string path_data(const std::vector<std::vector<Vec2>>& loops, const View& view) {
    std::string path;
    for (const std::vector<Vec2>& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) path += (i == 0 ? "M" : "L") + text_of(view(loop[i]));
        if (!loop.empty()) path += "Z";
    }
    return path;
}

std::string part_color(int i) {
    // Light tones between which black text, red contact lines and blue marks stay readable; neighbours differ in hue and
    // lightness.
    static constexpr std::array<const char*, 12> colors{"#a9c4e4", "#f3cf9c", "#a8d8b0", "#d3b8df", "#efe7a2", "#9fd6d6",
                                                        "#e6b5ab", "#c4ccd6", "#cfe39c", "#b9b3e6", "#d8c3a5", "#f0bcd6"};
    const int n = static_cast<int>(colors.size());
    return colors[static_cast<std::size_t>(((i % n) + n) % n)];
}

std::string map_color(double t) {
    // Viridis (S. van der Walt, N. Smith; CC0) at sixteen equal steps, linear between them.
    static constexpr std::array<std::array<double, 3>, 16> table{{{68, 1, 84},
                                                                  {72, 26, 108},
                                                                  {71, 47, 125},
                                                                  {65, 68, 135},
                                                                  {57, 86, 140},
                                                                  {49, 104, 142},
                                                                  {42, 120, 142},
                                                                  {35, 136, 142},
                                                                  {31, 152, 139},
                                                                  {34, 168, 132},
                                                                  {53, 183, 121},
                                                                  {84, 197, 104},
                                                                  {122, 209, 81},
                                                                  {165, 219, 54},
                                                                  {210, 226, 27},
                                                                  {253, 231, 37}}};
    if (!(t > 0)) return hex(table.front());
    if (t >= 1) return hex(table.back());
    const double place = t * static_cast<double>(table.size() - 1);
    const auto i = static_cast<std::size_t>(place);
    const double w = place - static_cast<double>(i);
    std::array<double, 3> rgb{};
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = (1 - w) * table[i][c] + w * table[i + 1][c];
    return hex(rgb);
}

std::vector<double> nice_ticks(double low, double high, int n) {
    if (!std::isfinite(low) || !std::isfinite(high)) return {0, 1};
    if (low > high) std::swap(low, high);
    if (!(high - low > 1e-12 * std::max(std::abs(low), std::abs(high)))) {  // one value: room on both sides of it
        const double room = low == 0 ? 0.5 : 0.5 * std::abs(low);
        low -= room;
        high += room;
    }
    const double raw = (high - low) / std::max(n - 1, 1);
    const double decade = std::pow(10.0, std::floor(std::log10(raw)));
    const double mantissa = raw / decade;
    // The thresholds are the geometric means of neighbours: the number of ticks stays as near to n as it can.
    const double step = decade * (mantissa < std::sqrt(2.0)    ? 1
                                  : mantissa < std::sqrt(10.0) ? 2
                                  : mantissa < std::sqrt(50.0) ? 5
                                                               : 10);
    const double slack = 1e-9;  // of a step: rounding of the limits adds no tick
    const auto first = std::llround(std::floor(low / step + slack)), last = std::llround(std::ceil(high / step - slack));
    std::vector<double> ticks;
    for (auto k = first; k <= last; ++k) ticks.push_back(static_cast<double>(k) * step);
    return ticks;
}

}  // namespace abut
