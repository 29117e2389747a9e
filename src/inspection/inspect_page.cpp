// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/inspection/inspect_page.hpp"

#include <algorithm>
#include <array>

#include "src/io/number_text.hpp"

namespace abut::inspect {

namespace {

std::string x_axis(const View& view, const std::string& unit) {
    const double y = view(view.box.min).y() + axis_distance, right = view(view.box.max).x();
    std::string svg = line_element({view(view.box.min).x(), y}, {right, y}, "axis");
    for (double tick : nice_ticks(view.box.min.x(), view.box.max.x(), 10)) {
        if (tick < view.box.min.x() || tick > view.box.max.x()) continue;
        const double x = view({tick, 0}).x();
        svg += line_element({x, y}, {x, y + 6}, "axis") + text_element({x, y + 20}, "tick", "middle", number_text(tick, 6));
    }
    return svg + text_element({right, y + 36}, "tick", "end", unit.empty() ? "x" : "x [" + unit + "]");
}

std::string y_axis(const View& view, const std::string& unit) {
    const double x = view(view.box.min).x() - axis_distance, top = view(view.box.max).y(), bottom = view(view.box.min).y();
    std::string svg = line_element({x, bottom}, {x, top}, "axis");
    const int n = std::max(2, static_cast<int>((bottom - top) / 70));
    for (double tick : nice_ticks(view.box.min.y(), view.box.max.y(), n)) {
        if (tick < view.box.min.y() || tick > view.box.max.y()) continue;
        const double y = view({0, tick}).y();
        svg += line_element({x - 6, y}, {x, y}, "axis") + text_element({x - 9, y + 4}, "tick", "end", number_text(tick, 6));
    }
    return svg + text_element({x, top - 12}, "tick", "middle", unit.empty() ? "y" : "y [" + unit + "]");
}

}  // namespace

std::string text_element(const Vec2& at, const std::string& css_class, const std::string& anchor, const std::string& text,
                         const std::string& fill) {
    return report::text(at, anchor, text, "class=\"" + css_class + "\"" + (fill.empty() ? "" : " fill=\"" + fill + "\""));
}

std::string line_element(const Vec2& a, const Vec2& b, const std::string& css_class) {
    return report::line(a, b, "class=\"" + css_class + "\"");
}

std::string path_element(const std::string& data, const std::string& css_class, const std::string& attributes) {
    return report::path(data, "class=\"" + css_class + "\"" + attributes);
}

std::string circle_element(const Vec2& center, double radius, const std::string& css_class) {
    return report::circle(center, radius, "class=\"" + css_class + "\"");
}

View page_view(Box2 box) {
    if (box.empty() || box.diagonal() == 0) {
        const Vec2 middle = box.empty() ? Vec2(0, 0) : box.center();
        box.extend(Vec2(middle - Vec2(1, 1)));
        box.extend(Vec2(middle + Vec2(1, 1)));
    }
    return fit_view(box, page_width, max_page_height, page_margin);
}

std::string page_opening(double height, const std::string& title, const std::string& css) {
    return report::open_picture(
               page_width, height, title,
               "text{font-family:Helvetica,Arial,'Liberation Sans',sans-serif}.axis{stroke:#666;stroke-width:1}"
               ".tick{font-size:11px;fill:#444}.title{font-size:14px;fill:#222}.legend{font-size:12px;fill:#222}" +
                   css) +
           text_element({page_margin - axis_distance, 20}, "title", "start", title);
}

std::string page_axes(const View& view, const std::string& unit) {
    return x_axis(view, unit) + y_axis(view, unit);
}

Box2 box_of_parts(const Scene& scene) {
    Box2 box;
    for (const ScenePart& part : scene.parts) box.extend(bounding_box(part.part));
    return box;
}

std::string ink_of(int part) {
    const std::string color = part_color(part);
    std::array<int, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i) rgb[i] = std::stoi(color.substr(1 + 2 * i, 2), nullptr, 16);
    const auto [lowest, highest] = std::minmax_element(rgb.begin(), rgb.end());
    constexpr int brightest = 140;
    static constexpr char digits[] = "0123456789abcdef";
    std::string ink = "#";
    for (int channel : rgb) {
        const int dark = *highest > *lowest ? (channel - *lowest) * brightest / (*highest - *lowest) : 0;
        ink += {digits[dark / 16], digits[dark % 16]};
    }
    return ink;
}

std::string page_with_legend(const View& view, const std::string& title, const std::string& css, const std::string& elements,
                             const std::vector<LegendEntry>& legend) {
    const double top = view.height + 14, left = page_margin - axis_distance;
    std::string svg = page_opening(top + legend_step * static_cast<double>(legend.size()), title, css) + elements;
    for (std::size_t i = 0; i < legend.size(); ++i) {
        const double y = top + legend_step * static_cast<double>(i);
        if (!legend[i].color.empty())
            svg += report::rectangle({left - 8, y - 10}, {16, 10},
                                     "fill=\"" + legend[i].color + "\" stroke=\"#666\" stroke-width=\".5\"");
        svg += text_element({left + 16, y}, "legend", "start", legend[i].text);
    }
    return svg + "</svg>\n";
}

}  // namespace abut::inspect
