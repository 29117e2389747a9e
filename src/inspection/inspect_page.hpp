// SPDX-License-Identifier: GPL-3.0-or-later
// What the pictures of `inspect` share: the page, its axes, and elements of SVG with their classes.
#pragma once
#include <string>
#include <vector>

#include "src/report/svg_elements.hpp"
#include "src/scene/scene.hpp"

namespace abut::inspect {

inline constexpr double page_width = 1200, max_page_height = 820, page_margin = 96;
inline constexpr double axis_distance = 52;  ///< of the axes from the parts: room for labels on their outside
inline constexpr double legend_step = 18;

std::string text_element(const Vec2& at, const std::string& css_class, const std::string& anchor, const std::string& text,
                         const std::string& fill = "");
std::string line_element(const Vec2& a, const Vec2& b, const std::string& css_class);
/// attributes: what else the element has, beginning with a blank.
std::string path_element(const std::string& data, const std::string& css_class, const std::string& attributes = "");
std::string circle_element(const Vec2& center, double radius, const std::string& css_class);

/// Fits the box onto the page; an empty box or a point gets some room around it.
View page_view(Box2 box);
/// Opens a page with its title; css: rules beside those of the elements above.
std::string page_opening(double height, const std::string& title, const std::string& css);
/// The coordinate axes, left of the model and below it.
std::string page_axes(const View& view, const std::string& unit);

Box2 box_of_parts(const Scene& scene);
/// The part's colour, dark enough to read and saturated, so that the names of two parts' edges can be told apart.
std::string ink_of(int part);

/// A patch of colour and what it stands for.
struct LegendEntry {
    std::string color, text;
};
/// Closes a page, whose elements are given, with its legend below the model.
std::string page_with_legend(const View& view, const std::string& title, const std::string& css, const std::string& elements,
                             const std::vector<LegendEntry>& legend);

}  // namespace abut::inspect
