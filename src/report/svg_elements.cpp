// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/svg_elements.hpp"

#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"

namespace abut::report {

namespace {

std::string attribute(const char* name, double value) {
    return std::string(" ") + name + "=\"" + coordinate_text(value) + "\"";
}

std::string point_list(const std::vector<Vec2>& points) {
    std::string list;
    for (const Vec2& p : points) list += (list.empty() ? "" : " ") + coordinate_text(p.x()) + "," + coordinate_text(p.y());
    return list;
}

std::string element(const std::string& name, const std::string& shape, const std::string& attributes) {
    return "<" + name + shape + (attributes.empty() ? "" : " " + attributes) + "/>\n";
}

}  // namespace

std::string line(const Vec2& a, const Vec2& b, const std::string& attributes) {
    return element("line", attribute("x1", a.x()) + attribute("y1", a.y()) + attribute("x2", b.x()) + attribute("y2", b.y()),
                   attributes);
}

std::string polyline(const std::vector<Vec2>& points, const std::string& attributes) {
    return element("polyline", " points=\"" + point_list(points) + "\"", attributes);
}

std::string polygon(const std::vector<Vec2>& points, const std::string& attributes) {
    return element("polygon", " points=\"" + point_list(points) + "\"", attributes);
}

std::string circle(const Vec2& center, double radius, const std::string& attributes) {
    return element("circle", attribute("cx", center.x()) + attribute("cy", center.y()) + attribute("r", radius), attributes);
}

std::string rectangle(const Vec2& corner, const Vec2& size, const std::string& attributes) {
    return element(
        "rect",
        attribute("x", corner.x()) + attribute("y", corner.y()) + attribute("width", size.x()) + attribute("height", size.y()),
        attributes);
}

std::string path(const std::string& data, const std::string& attributes) {
    return element("path", " d=\"" + data + "\"", attributes);
}

std::string text(const Vec2& at, const std::string& anchor, const std::string& words, const std::string& attributes) {
    return "<text" + attribute("x", at.x()) + attribute("y", at.y()) + " text-anchor=\"" + anchor + "\"" +
           (attributes.empty() ? "" : " " + attributes) + ">" + escape_xml(words) + "</text>\n";
}

std::string open_picture(double width, double height, const std::string& title, const std::string& css) {
    const std::string w = coordinate_text(width), h = coordinate_text(height);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w + " " + h +
           "\">\n<title>" + escape_xml(title) + "</title>\n<style>" + css + "</style>\n" +
           "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
}

}  // namespace abut::report
