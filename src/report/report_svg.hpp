// SPDX-License-Identifier: GPL-3.0-or-later
// What the report's pictures share: axes, arrows, colour bars, figures.
#pragma once
#include <string>
#include <vector>

#include "src/report/svg.hpp"
#include "src/report/svg_elements.hpp"

namespace abut::report {

/// Opens a picture that scales with the page; label is what a screen reader says.
std::string open_svg(double width, double height, const std::string& label);

/// The width of a text in pixels, estimated generously: there are no font metrics here.
double text_pixels(const std::string& words, double font_size);

/// An arrow from tail to tip with a filled head.
std::string arrow(const Vec2& tail, const Vec2& tip, const std::string& color);

/// The view of a model with room for the axes of model_axes, for tick labels, and for the marks around the model.
View model_view(const Box2& box, double width, double max_height);
/// The assembly's coordinate axes, below and left of the model.
std::string model_axes(const View& view, const std::string& length_unit);

/// What a colour bar says: the scale runs from 0 to top; note: a sentence below it, may be empty.
struct ColorBar {
    double top;
    std::string title, note;
};
/// A horizontal bar as a picture of its own.
std::string color_bar(const ColorBar& bar, double width);

/// A picture (svg elements) under its caption, as wide as given where the page allows it. The caption is HTML.
std::string figure(const std::string& svg, const std::string& caption, double width);

/// A clip path of the data (fill rule even-odd) under the id.
std::string clip_path(const std::string& id, const std::string& data);

}  // namespace abut::report
