// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/picture_files.hpp"

#include <algorithm>
#include <sstream>

#include "src/io/number_text.hpp"
#include "src/report/page_texts.hpp"
#include "src/report/report_field_layer.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_svg.hpp"
#include "src/report/svg_elements.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

constexpr double caption_font = 13, caption_line = 18, caption_room = 8, space_between = 24;  // pixels

/// The page's rules for what stands in pictures: they have no variables.
std::string picture_css() {
    std::string css = "svg{font-family:system-ui,\"DejaVu Sans\",Arial,sans-serif}\n";
    std::istringstream lines(report::page_style_text());
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("svg text", 0) == 0 || line.rfind("svg .axes", 0) == 0) css += line + "\n";
    return css + "text.caption{font-size:13px;fill:#444}\n";
}

/// The text between two others from a place on, which goes behind it; empty where there is none.
std::string next_between(const std::string& text, const std::string& begin, const std::string& end, std::size_t& place) {
    const std::size_t from = text.find(begin, place);
    const std::size_t to = from == std::string::npos ? from : text.find(end, from + begin.size());
    place = to == std::string::npos ? text.size() : to + end.size();
    return to == std::string::npos ? "" : text.substr(from + begin.size(), to - from - begin.size());
}

struct DrawnFigures {
    std::string svg;
    double width = 0, height = 0;
};

/// In lines that are not wider than so many pixels.
std::vector<std::string> wrapped(const std::string& words, double width) {
    std::vector<std::string> lines(1);
    std::istringstream list(words);
    for (std::string word; list >> word;) {
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (lines.back().empty() || report::text_pixels(longer, caption_font) <= width)
            lines.back() = longer;
        else
            lines.push_back(word);
    }
    return lines;
}

/// The pictures of one figure below each other and its caption, at a place of a larger one.
DrawnFigures figure_at(double left, const std::string& figure) {
    DrawnFigures drawn{"", 0, caption_room};
    std::size_t place = 0;
    std::istringstream style(next_between(figure, "style=\"width:", "px", place));
    double figure_width = 0;
    style >> figure_width;
    for (const std::string& line : wrapped(next_between(figure, "<figcaption>", "</figcaption>", place), figure_width - 24)) {
        drawn.height += caption_line;
        drawn.svg += "<text class=\"caption\" x=\"" + coordinate_text(left + 12) + "\" y=\"" +
                     coordinate_text(drawn.height - 4) + "\">" + line + "</text>\n";
    }
    drawn.height += caption_room;
    place = 0;
    for (std::string picture; !(picture = next_between(figure, "<svg ", "</svg>", place)).empty();) {
        std::size_t from = 0;
        std::istringstream box(next_between(picture, "viewBox=\"0 0 ", "\"", from));
        double width = 0, height = 0;
        box >> width >> height;
        drawn.svg += "<svg x=\"" + coordinate_text(left) + "\" y=\"" + coordinate_text(drawn.height) + "\" width=\"" +
                     coordinate_text(width) + "\" height=\"" + coordinate_text(height) + "\" " + picture + "</svg>\n";
        drawn.width = std::max(drawn.width, width);
        drawn.height += height;
    }
    return drawn;
}

/// The figures of a piece of a page side by side; empty where there are none.
std::string as_picture(const std::string& html, const std::string& title) {
    DrawnFigures all;
    std::size_t place = 0;
    for (std::string figure; !(figure = next_between(html, "<figure", "</figure>", place)).empty();) {
        const DrawnFigures one = figure_at(all.width > 0 ? all.width + space_between : 0, figure);
        all.width += (all.width > 0 ? space_between : 0) + one.width;
        all.height = std::max(all.height, one.height);
        all.svg += one.svg;
    }
    if (all.svg.empty()) return "";
    return report::open_picture(all.width, all.height, title, picture_css()) + all.svg + "</svg>\n";
}

}  // namespace

std::vector<PictureFile> picture_files(const Result& result, const ModelFacts& model) {
    std::vector<PictureFile> files;
    const Box2 box = report::model_box(result);
    if (box.empty()) return files;
    const auto add = [&](const std::string& name, const std::string& html, const std::string& what) {
        const std::string svg = as_picture(html, (result.title.empty() ? "" : result.title + ": ") + what);
        if (!svg.empty()) files.push_back({name, svg});
    };
    add("assembly", report::assembly_section(result, model), "the assembly");
    if (report::has_fields(result)) {
        const report::PictureSize size = report::picture_size(box);
        add("stress", report::stress_figure(result, size), "von Mises stress");
        add("displacement", report::deformed_figure(result, size), "deformed shape");
    }
    const std::vector<bool> pictured = report::pictured_contacts(result);
    for (std::size_t k = 0; k < pictured.size(); ++k)
        if (pictured[k])
            add("contact_" + contact_number(k), report::contact_curves(result, k) + report::contact_closeup(result, k),
                "contact " + contact_number(k));
    return files;
}

}  // namespace abut
