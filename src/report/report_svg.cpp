// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/report_svg.hpp"

#include <algorithm>
#include <cmath>

#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/io/utf8.hpp"
#include "src/report/report_contours.hpp"
#include "src/report/report_sections.hpp"
#include "src/results/result_units.hpp"

namespace abut::report {

namespace {

constexpr double tick_font = 11;
constexpr double axis_left = 64, axis_bottom = 30;  ///< distance of the axes from the picture's edge: room for tick labels
constexpr double mark_room = 50;                    ///< around the model, for load arrows, supports and labels

/// Those ticks that lie within the limits.
std::vector<double> inner_ticks(double low, double high, int n) {
    std::vector<double> ticks = nice_ticks(low, high, n);
    const double slack = 1e-9 * (high - low);
    std::erase_if(ticks, [&](double t) { return t < low - slack || t > high + slack; });
    return ticks;
}

/// So many ticks that their labels stay apart.
int tick_count(double pixels, double label_pixels) {
    return std::clamp(static_cast<int>(pixels / label_pixels), 3, 11);
}

}  // namespace

std::string open_svg(double width, double height, const std::string& label) {
    const std::string w = coordinate_text(width), h = coordinate_text(height);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + w + " " + h + "\" style=\"max-width:" + w +
           "px\" role=\"img\" aria-label=\"" + escape_xml(label) + "\">\n";
}

double text_pixels(const std::string& words, double font_size) {
    return 0.66 * font_size * static_cast<double>(text_width(words));
}

std::string arrow(const Vec2& tail, const Vec2& tip, const std::string& color) {
    const Vec2 along = (tip - tail).normalized(), across = geometry::left_of(along);
    const Vec2 neck = tip - 8 * along;
    return line(tail, neck, "stroke=\"" + color + "\" stroke-width=\"1.6\"") +
           polygon({tip, neck + 3.6 * across, neck - 3.6 * across}, "fill=\"" + color + "\"");
}

View model_view(const Box2& box, double width, double max_height) {
    View view = fit_view(box, width - axis_left, max_height - axis_bottom, mark_room);
    view.offset.x() += axis_left;
    view.width = width;
    view.height += axis_bottom;
    return view;
}

std::string model_axes(const View& view, const std::string& length_unit) {
    const Vec2 low = view.box.min, high = view.box.max;
    const Vec2 corner = view(low), far = view(high);
    const double x_axis = view.height - axis_bottom;
    const double y_axis = std::max(corner.x() - mark_room, axis_left - 4);
    std::string svg = "<g class=\"axes\">\n";
    svg += line({corner.x(), x_axis}, {far.x(), x_axis}, "") + line({y_axis, corner.y()}, {y_axis, far.y()}, "");
    for (double t : inner_ticks(low.x(), high.x(), tick_count(far.x() - corner.x(), 70))) {
        const double x = view(Vec2(t, 0)).x();
        svg += line({x, x_axis}, {x, x_axis + 4}, "") + text({x, x_axis + 16}, "middle", number_text(t, 6));
    }
    double lowest = corner.y();
    for (double t : inner_ticks(low.y(), high.y(), tick_count(corner.y() - far.y(), 34))) {
        const double y = view(Vec2(0, t)).y();
        svg += line({y_axis - 4, y}, {y_axis, y}, "") + text({y_axis - 7, y + 4}, "end", number_text(t, 6));
        lowest = std::min(lowest, y);
    }
    svg += text({far.x() + 5, x_axis + 4}, "start", heading("x", length_unit), "class=\"axis-title\"");
    svg += text({y_axis + 2, std::min(far.y(), lowest) - 12}, "end", heading("y", length_unit), "class=\"axis-title\"");
    return svg + "</g>\n";
}

std::string color_bar(const ColorBar& bar, double width) {
    if (!(bar.top > 0))
        return open_svg(width, 20, bar.title) +
               text({12, 14}, "start", bar.title + ": zero everywhere", "class=\"bar-title\"") + "</svg>\n";
    const double left = 12, right = width - 46, top = 20, height = 13;
    const double total = bar.note.empty() ? 52 : 70;
    std::string svg = open_svg(width, total, "colour scale: " + bar.title);
    svg += text({left, 13}, "start", bar.title, "class=\"bar-title\"");
    for (int band = 0; band < n_bands; ++band) {
        const double x = left + (right - left) * band / n_bands;
        const double overlap = band + 1 < n_bands ? 0.5 : 0;  // no seams
        svg += rectangle({x, top}, {(right - left) / n_bands + overlap, height}, "fill=\"" + band_color(band) + "\"");
    }
    svg += rectangle({left, top}, {right - left, height}, "fill=\"none\" stroke=\"#555\" stroke-width=\"0.7\"");
    svg += "<g class=\"axes\">\n";
    for (double t : inner_ticks(0, bar.top, 6)) {
        const double x = left + (right - left) * t / bar.top;
        svg += line({x, top + height}, {x, top + height + 4}, "") + text({x, top + height + 16}, "middle", number_text(t, 4));
    }
    svg += "</g>\n";
    if (!bar.note.empty()) svg += text({left, 66}, "start", bar.note, "class=\"note\"");
    return svg + "</svg>\n";
}

std::string figure(const std::string& svg, const std::string& caption, double width) {
    return std::string("<figure") + (width > half_width ? " class=\"wide\"" : "") + " style=\"width:" + coordinate_text(width) +
           "px\">\n" + (caption.empty() ? "" : "<figcaption>" + caption + "</figcaption>\n") + svg + "</figure>\n";
}

std::string clip_path(const std::string& id, const std::string& data) {
    return "<clipPath id=\"" + id + "\">" + "<path clip-rule=\"evenodd\" d=\"" + data + "\"/></clipPath>\n";
}

}  // namespace abut::report
