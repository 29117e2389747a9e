// SPDX-License-Identifier: GPL-3.0-or-later
// The assembly where it was analysed, and as it was drawn: parts, contacts, supports and loads.
#include <algorithm>
#include <cmath>

#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_marks.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_svg.hpp"
#include "src/report/report_table.hpp"
#include "src/results/result_units.hpp"

namespace abut::report {

namespace {

constexpr double side_by_side = 0.25;  ///< height / width of a model; below, half a page shows a strip that is too thin to see
constexpr double name_font = 12;
constexpr std::size_t most_numbers = 10;  ///< of contacts; more would hide the parts

std::string part_shapes(const Result& result, const View& view) {
    std::string svg;
    for (std::size_t i = 0; i < result.geometry.size(); ++i)
        svg += path(path_data(result.geometry[i], view), "fill=\"" + part_color(static_cast<int>(i)) +
                                                             "\" fill-rule=\"evenodd\" stroke=\"#444\" stroke-width=\"0.9\"");
    return svg;
}

/// Parts that were moved, where they were drawn.
std::vector<geometry::Part> drawn_parts(const Result& result) {
    std::vector<geometry::Part> drawn;
    for (std::size_t i = 0; i < result.geometry.size() && i < result.parts.size(); ++i) {
        if (!result.parts[i].placement) continue;
        const auto& [by, turn] = *result.parts[i].placement;
        const Vec2 middle = geometry::centroid(result.geometry[i]);
        const double c = std::cos(turn), s = -std::sin(turn);
        const Vec2 turned(c * middle.x() - s * middle.y(), s * middle.x() + c * middle.y());
        drawn.push_back(geometry::transformed(result.geometry[i], c, s, middle - by - turned));
    }
    return drawn;
}

/// Names on parts that have the room; all of them are in the legend.
std::string part_names(const Result& result, const View& view, LabelPlaces& places) {
    std::string svg;
    for (const geometry::Part& part : result.geometry) {
        if (part.edges.empty()) continue;
        const Vec2 middle = geometry::centroid(part);
        const Vec2 size(text_pixels(part.name, name_font), name_font + 2);
        const Vec2 half = 0.5 / view.scale * size;
        bool fits = middle.allFinite();
        for (double sx : {-1.0, 0.0, 1.0})
            for (double sy : {-1.0, 1.0}) fits = fits && geometry::contains(part, middle + Vec2(sx * half.x(), sy * half.y()));
        if (fits && places.take(view(middle), size))
            svg += text(view(middle) + Vec2(0, 4), "middle", part.name, "class=\"part-name\"");
    }
    return svg;
}

std::string contact_marks(const Result& result, const View& view, LabelPlaces& places) {
    std::string lines, numbers;
    std::vector<Vec2> anchors;
    for (const ContactResult& contact : result.contacts) {
        const auto stretches = contact_stretches(result, contact);
        lines += contact_lines(stretches, view, 4.5);
        anchors.push_back(view(contact_anchor(contact, stretches)));
        for (const ContactStretch& stretch : stretches)
            for (const Vec2& p : stretch.points) places.block(view(p), 3);
    }
    const std::vector<bool> is_numbered = strongest_contacts(result, most_numbers);
    for (std::size_t k = 0; k < anchors.size(); ++k)
        if (is_numbered[k]) numbers += number_disc(contact_number(k), anchors[k], places);
    return lines + numbers;
}

std::string sign(const std::string& shapes) {
    return "<svg class=\"sign\" viewBox=\"0 0 26 14\">" + shapes + "</svg>";
}

std::string line_sign(const std::string& color, double width) {
    return sign(line({3, 7}, {23, 7},
                     "stroke-linecap=\"round\" stroke=\"" + color + "\" stroke-width=\"" + coordinate_text(width) + "\""));
}

std::string sign_legend(const Result& result) {
    std::string html = "<ul class=\"legend signs\">\n";
    if (!result.contacts.empty()) {
        html += "<li>" + line_sign(contact_color, 4.5) + "contact, numbered as below</li>\n";
        html += "<li>" + line_sign(candidate_color, 2.7) + "searched, stayed open</li>\n";
    }
    if (!result.support_marks.empty())
        html += "<li>" +
                sign("<path d=\"M3 5H23M5 5l5 6M11 5l5 6M17 5l5 6\" fill=\"none\" stroke=\"" + std::string(support_color) +
                     "\" stroke-width=\"1.2\"/>") +
                "support (triangle: one direction)</li>\n";
    if (!result.load_marks.empty()) html += "<li>" + sign(arrow({2, 7}, {24, 7}, load_color)) + "load</li>\n";
    return html + "</ul>\n";
}

std::string part_legend(const Result& result) {
    std::string html = "<ul class=\"legend parts\">\n";
    for (std::size_t i = 0; i < result.parts.size(); ++i) {
        const PartResult& part = result.parts[i];
        html += "<li><span class=\"swatch\" style=\"background:" + part_color(static_cast<int>(i)) + "\"></span><span><b>" +
                escape_xml(part.name) + "</b>" + (part.material.empty() ? "" : ", " + escape_xml(part.material)) +
                (part.solved ? "" : " (not analysed)") + "</span></li>\n";
    }
    return html + "</ul>\n";
}

/// What most readers look for first, beside the picture: the strongest contacts.
std::string contact_list(const Result& result) {
    if (result.contacts.empty()) return "";
    const ResultUnits units = result_units(result);
    std::vector<std::vector<std::string>> rows;
    const std::vector<bool> listed = pictured_contacts(result);
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
        const ContactResult& c = result.contacts[k];
        if (!listed[k]) continue;
        rows.push_back({contact_number(k), c.parts[0] + " – " + c.parts[1], c.kind == "contact" ? c.status : c.kind,
                        number_text(c.force.norm(), 4), number_text(c.max_pressure.value, 4)});
    }
    return html_table(
        {{"", true}, {"contact"}, {""}, {heading("force", units.force), true}, {heading("max pressure", units.stress), true}},
        rows);
}

}  // namespace

Box2 model_box(const Result& result) {
    Box2 box;
    for (const geometry::Part& part : result.geometry) box.extend(geometry::bounding_box(part));
    return box;
}

PictureSize picture_size(const Box2& model) {
    const Vec2 size = model.size();
    if (size.y() > side_by_side * size.x()) return {half_width, 640};
    return {page_width, 700};
}

std::string assembly_section(const Result& result, const ModelFacts& model) {
    Box2 box = model_box(result);
    if (box.empty()) return "";
    const std::vector<geometry::Part> drawn = drawn_parts(result);
    for (const geometry::Part& part : drawn) box.extend(geometry::bounding_box(part));
    const PictureSize size = picture_size(box);
    const View view = model_view(box, size.width, size.max_height);
    Box2 frame;
    frame.extend(Vec2(2, 2));
    frame.extend(Vec2(view.width - 2, view.height - 32));
    LabelPlaces places(frame);

    std::string svg = open_svg(view.width, view.height, "the assembly") + model_axes(view, result.length_unit);
    svg += part_shapes(result, view);
    for (const geometry::Part& part : drawn)
        svg += path(path_data(part, view), "fill=\"none\" stroke=\"#555\" stroke-width=\"0.8\" stroke-dasharray=\"4 3\"");
    svg += support_signs(result.support_marks, view, places) + load_arrows(result, view, places);
    svg += contact_marks(result, view, places);
    svg += load_values(result, model, view, places) + part_names(result, view, places) + "</svg>\n";
    return "<section><h2>Assembly</h2>\n<div class=\"row\">" +
           figure(svg,
                  std::string("Parts, contacts, supports and loads, ") +
                      (drawn.empty() ? "as drawn" : "where the loads take the parts; dashed: where they were drawn"),
                  size.width) +
           "<div class=\"legends\">\n" + part_legend(result) + sign_legend(result) + contact_list(result) +
           "</div></div></section>\n";
}

}  // namespace abut::report
