// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/batch_thumbnail.hpp"

#include <algorithm>
#include <cmath>

#include "src/io/number_text.hpp"
#include "src/report/svg.hpp"

namespace abut {

namespace {

constexpr double margin = 3;
constexpr double marked_points = 24;  // of a contact: enough for an arc of this size
constexpr const char *red = "#d3102b", *orange = "#e08a00", *violet = "#7b1fa2";

Box2 box_of(const Scene& scene) {
    Box2 box;
    for (const ScenePart& part : scene.parts) box.extend(geometry::bounding_box(part.part));
    return box;
}

std::string point_text(const Vec2& p) {
    return coordinate_text(p.x()) + " " + coordinate_text(p.y());
}

/// A line through some of the points. Steps much longer than the others are gaps between separate stretches.
std::string line_through(const std::vector<Vec2>& points, const View& view, const char* color) {
    if (points.empty()) return "";
    const auto n = static_cast<double>(points.size());
    const auto step = static_cast<std::size_t>(std::max(1.0, std::ceil(n / marked_points)));
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    const double far = 4 * length * static_cast<double>(step) / n;
    std::string path = "M" + point_text(view(points[0]));
    Vec2 last = points[0];
    for (std::size_t i = step; i < points.size() + step - 1; i += step) {
        const Vec2 p = points[std::min(i, points.size() - 1)];
        path += ((p - last).norm() > far ? "M" : "L") + point_text(view(p));
        last = p;
    }
    if (points.size() == 1) path += "l0 0";  // a dot, by the round line cap
    return "<path fill=\"none\" stroke-width=\"2\" stroke-linecap=\"round\" stroke=\"" + std::string(color) + "\" d=\"" + path +
           "\"/>";
}

std::string picture(const View& view, const Scene& scene, const std::string& marks) {
    const std::string width = coordinate_text(view.width), height = coordinate_text(view.height);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
                      "\" viewBox=\"0 0 " + width + " " + height + "\">";
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        svg += "<path stroke=\"#555\" stroke-width=\".6\" fill-rule=\"evenodd\" fill-opacity=\".55\" fill=\"" +
               part_color(static_cast<int>(i)) + "\" d=\"" + path_data(scene.parts[i].part, view) + "\"/>";
    return svg + marks + "</svg>\n";
}

}  // namespace

std::string thumbnail(const Scene& scene, const Result& result) {
    const View view = fit_view(box_of(scene), thumbnail_width, thumbnail_height, margin);
    std::string marks;
    for (const ContactResult& contact : result.contacts) {
        std::vector<Vec2> points;
        const ContactProfile& profile = contact.profile;
        const bool open = contact.status == "open";
        for (std::size_t i = 0; i < profile.x.size(); ++i)
            if (open || profile.pressure[i] != 0) points.emplace_back(profile.x[i], profile.y[i]);
        marks += line_through(points, view, open ? orange : red);
    }
    return picture(view, scene, marks);
}

std::string thumbnail(const Scene& scene, const Detection& detection) {
    const View view = fit_view(box_of(scene), thumbnail_width, thumbnail_height, margin);
    std::string marks;
    for (const DetectedPair& pair : detection.pairs) {
        std::vector<Vec2> points;
        for (const auto& mark : pair.marks) points.push_back(0.5 * (mark[0] + mark[1]));
        marks += line_through(points, view, pair.status == "touching" ? red : pair.status == "overlap" ? violet : orange);
    }
    return picture(view, scene, marks);
}

}  // namespace abut
