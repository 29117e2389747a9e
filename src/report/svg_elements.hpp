// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of SVG for all our pictures, in picture coordinates (pixels, y down). attributes: what else an element has, such as
// class="axis"; may be empty.
#pragma once
#include <string>
#include <vector>

#include "src/report/svg.hpp"

namespace abut::report {

std::string line(const Vec2& a, const Vec2& b, const std::string& attributes);
std::string polyline(const std::vector<Vec2>& points, const std::string& attributes);
std::string polygon(const std::vector<Vec2>& points, const std::string& attributes);
std::string circle(const Vec2& center, double radius, const std::string& attributes);
std::string rectangle(const Vec2& corner, const Vec2& size, const std::string& attributes);
std::string path(const std::string& data, const std::string& attributes);
/// Text (escaped here) at its baseline; anchor: "start", "middle", "end".
std::string text(const Vec2& at, const std::string& anchor, const std::string& words, const std::string& attributes = "");

/// Opens a picture of its own (an SVG file), in white, with the title that viewers show; css: rules of its elements.
std::string open_picture(double width, double height, const std::string& title, const std::string& css);

}  // namespace abut::report
