// SPDX-License-Identifier: GPL-3.0-or-later
// contacts.svg: the assembly, the facing stretches numbered as in the table, near misses dashed.
#include <algorithm>

#include "geometry/brep/monotone.hpp"
#include "src/inspection/detect_pictures.hpp"
#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/label_placement.hpp"
#include "src/report/svg_elements.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

constexpr double picture_width = 1000, max_height = 760, page_border = 40, legend_row = 18;
constexpr double badge_radius = 9, label_size = 12;
/// Marks farther apart than this many times the usual step belong to different stretches: the line is interrupted.
constexpr double break_factor = 3;

constexpr const char* detection_css =
    "text{font:12px sans-serif;fill:#222}.part{stroke:#555;stroke-width:1;fill-rule:evenodd;fill-opacity:.45}"
    ".touching{stroke:#c2185b}.gap{stroke:#e08a00}.overlap{stroke:#7b1fa2}.face{fill:none;stroke-width:4;"
    "stroke-linecap:round;stroke-linejoin:round}.miss{stroke:#333;stroke-width:1.2;stroke-dasharray:5 4;fill:none}"
    ".badge{fill:#fff;stroke-width:2}.number{font-weight:bold}.name{fill:#333}";

std::string point_text(const Vec2& p) {
    return coordinate_text(p.x()) + " " + coordinate_text(p.y());
}

Vec2 middle_of(const std::array<Vec2, 2>& mark) {
    return 0.5 * (mark[0] + mark[1]);
}

/// The line midway between the facing boundaries, interrupted between separate stretches.
std::string stretch_path(const DetectedPair& pair, const View& view) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < pair.marks.size(); ++i)
        steps.push_back((middle_of(pair.marks[i]) - middle_of(pair.marks[i - 1])).norm());
    std::vector<double> sorted = steps;
    std::sort(sorted.begin(), sorted.end());
    const double usual = sorted.empty() ? 0 : sorted[sorted.size() / 2];
    std::string path = "M" + point_text(view(middle_of(pair.marks[0])));
    for (std::size_t i = 1; i < pair.marks.size(); ++i)
        path += (steps[i - 1] > break_factor * usual ? "M" : "L") + point_text(view(middle_of(pair.marks[i])));
    if (pair.marks.size() == 1) path += "l0 0";  // a dot, by the round line cap
    return path;
}

Vec2 badge_place(const DetectedPair& pair, const View& view) {
    return view(middle_of(pair.marks[pair.marks.size() / 2]));
}

Box2 badge_box(const DetectedPair& pair, const View& view) {
    const Vec2 p = badge_place(pair, view), half = Vec2::Constant(badge_radius + 1);
    return {p - half, p + half};
}

std::string badge(const DetectedPair& pair, std::size_t number, const View& view) {
    const Vec2 p = badge_place(pair, view);
    return report::circle(p, badge_radius, "class=\"badge " + pair.status + "\"") +
           report::text(p + Vec2(0, 4), "middle", std::to_string(number), "class=\"number\"");
}

std::string parts_svg(const Scene& scene, const View& view) {
    std::string svg;
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        svg += "<path class=\"part\" fill=\"" + part_color(static_cast<int>(i)) + "\" d=\"" +
               path_data(scene.parts[i].part, view) + "\"><title>" + escape_xml(scene.parts[i].name) + "</title></path>\n";
    return svg;
}

std::string marks_svg(const Detection& detection, const View& view) {
    std::string svg;
    for (const DetectedPair& p : detection.pairs)
        if (!p.marks.empty())
            svg += "<path class=\"face " + p.status + "\" d=\"" + stretch_path(p, view) + "\"><title>" + escape_xml(p.why) +
                   "</title></path>\n";
    for (const DetectedPair& p : detection.near_misses)
        for (const auto& mark : p.marks)
            svg += "<path class=\"miss\" d=\"M" + point_text(view(mark[0])) + "L" + point_text(view(mark[1])) + "\"><title>" +
                   escape_xml(p.why) + "</title></path>\n";
    for (std::size_t k = 0; k < detection.pairs.size(); ++k)
        if (!detection.pairs[k].marks.empty()) svg += badge(detection.pairs[k], k + 1, view);
    return svg;
}

/// Points where a part's name may stand, in picture coordinates, the best first: inside it, the nearest to its centroid, ...
std::vector<Vec2> inner_places(const geometry::Part& part, const View& view) {
    constexpr int n = 16;
    const Box2 box = bounding_box(part);
    const Vec2 center = view(geometry::centroid(part));
    std::vector<Vec2> places{center};
    for (int i = 1; i < n; ++i)
        for (int k = 1; k < n; ++k) places.push_back(view(box.min + box.size().cwiseProduct(Vec2(i, k)) / n));
    std::stable_sort(places.begin(), places.end(),
                     [&](const Vec2& a, const Vec2& b) { return (a - center).norm() < (b - center).norm(); });
    const std::vector<geometry::MonotonePiece> material = geometry::monotone_pieces(part);
    const auto in_model = [&](const Vec2& p) {
        return Vec2((p.x() - view.offset.x()) / view.scale, (view.offset.y() - p.y()) / view.scale);
    };
    std::erase_if(places, [&](const Vec2& p) { return !contains(material, in_model(p)); });
    return places;
}

/// ... or around it, where it is too small.
std::vector<Vec2> outer_places(const geometry::Part& part, const View& view, const Vec2& text) {
    const Box2 box = bounding_box(part);
    const Vec2 half = 0.5 * view.scale * box.size() + 0.5 * text + Vec2(5, 5), center = view(box.center());
    return {center - Vec2(0, half.y()), center + Vec2(0, half.y()), center + Vec2(half.x(), 0), center - Vec2(half.x(), 0)};
}

/// Names of the parts where they hide neither lines nor numbers; a part without any such place goes without.
std::string names_svg(const Scene& scene, const Detection& detection, const View& view) {
    Box2 area;
    area.extend(Vec2(0, 0));
    area.extend(Vec2(view.width, view.height));
    LabelPlacement labels(area);
    for (const ScenePart& p : scene.parts)
        for (const geometry::Edge& edge : p.part.edges) labels.add_line(edge.curve, view);
    for (const DetectedPair& p : detection.pairs)
        if (!p.marks.empty()) labels.take(badge_box(p, view));
    std::string svg;
    for (const ScenePart& p : scene.parts) {
        const Box2 text = text_box(p.name, label_size, {0, 0});
        std::vector<Vec2> places = inner_places(p.part, view);
        for (const Vec2& place : outer_places(p.part, view, text.size())) places.push_back(place);
        const auto moved = [&](const Vec2& place) { return Box2{text.min + place, text.max + place}; };
        const auto free =
            std::find_if(places.begin(), places.end(), [&](const Vec2& place) { return labels.is_free(moved(place), true); });
        if (free == places.end()) continue;
        labels.take(moved(*free));
        svg += report::text(*free + Vec2(0, 0.35 * label_size), "middle", p.name, "class=\"name\"");
    }
    return svg;
}

/// What the numbers mean, one line each.
std::string legend_svg(const Scene& scene, const Detection& detection, double top) {
    std::string svg;
    double y = top;
    const auto line = [&](const std::string& number, const std::string& css, const std::string& text) {
        svg += report::path("M" + point_text({page_border, y - 4}) + "h26", "class=\"" + css + "\"");
        svg += report::text({page_border + 36, y}, "start", number + text);
        y += legend_row;
    };
    for (std::size_t k = 0; k < detection.pairs.size(); ++k) {
        const DetectedPair& p = detection.pairs[k];
        line(contact_number(k) + "  ", "face " + p.status,
             p.parts[0] + " - " + p.parts[1] + ": " + p.status + ", " + p.interface + ", gap " + number_text(p.gap_min, 3) +
                 " to " + with_unit(p.gap_max, 3, scene.length_unit));
    }
    for (const DetectedPair& p : detection.near_misses) line("", "miss", p.parts[0] + " - " + p.parts[1] + ": " + p.why);
    return svg;
}

}  // namespace

std::string detection_svg(const Scene& scene, const Detection& detection) {
    Box2 box;
    for (const ScenePart& p : scene.parts) box.extend(bounding_box(p.part));
    const View view = fit_view(box, picture_width, max_height, page_border);
    const auto rows = static_cast<double>(detection.pairs.size() + detection.near_misses.size());
    const double height = view.height + legend_row * (rows + 1);
    const std::string title = "Contacts of " + (scene.title.empty() ? scene.file : scene.title);
    return report::open_picture(view.width, height, title, detection_css) + parts_svg(scene, view) +
           names_svg(scene, detection, view) + marks_svg(detection, view) +
           legend_svg(scene, detection, view.height + legend_row / 2) + "</svg>\n";
}

}  // namespace abut
