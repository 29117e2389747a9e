// SPDX-License-Identifier: GPL-3.0-or-later
// Small DXF texts for tests.
#pragma once
#include <initializer_list>
#include <sstream>
#include <string>
#include <utility>

namespace abut::geometry {

/// A record: its type, handle and layer (empty: left out), and number groups.
inline std::string dxf_record(const std::string& type, const std::string& handle, const std::string& layer,
                              std::initializer_list<std::pair<int, double>> numbers) {
    std::ostringstream text;
    text.precision(17);
    text << "0\n" << type << "\n";
    if (!handle.empty()) text << "5\n" << handle << "\n";
    if (!layer.empty()) text << "8\n" << layer << "\n";
    for (const auto& [code, value] : numbers) text << code << "\n" << value << "\n";
    return text.str();
}

inline std::string dxf_line(const std::string& handle, const std::string& layer, double x1, double y1, double x2, double y2) {
    return dxf_record("LINE", handle, layer, {{10, x1}, {20, y1}, {11, x2}, {21, y2}});
}

inline std::string dxf_arc(const std::string& handle, const std::string& layer, double x, double y, double r, double from,
                           double to) {
    return dxf_record("ARC", handle, layer, {{10, x}, {20, y}, {40, r}, {50, from}, {51, to}});
}

inline std::string dxf_circle(const std::string& handle, const std::string& layer, double x, double y, double r) {
    return dxf_record("CIRCLE", handle, layer, {{10, x}, {20, y}, {40, r}});
}

/// The four sides of a rectangle, counter-clockwise from the bottom, with handles h0, h1, h2, h3 after the prefix.
inline std::string dxf_rectangle(const std::string& prefix, const std::string& layer, double x1, double y1, double x2,
                                 double y2) {
    return dxf_line(prefix + "0", layer, x1, y1, x2, y1) + dxf_line(prefix + "1", layer, x2, y1, x2, y2) +
           dxf_line(prefix + "2", layer, x2, y2, x1, y2) + dxf_line(prefix + "3", layer, x1, y2, x1, y1);
}

inline std::string dxf_section(const std::string& name, const std::string& records) {
    return "0\nSECTION\n2\n" + name + "\n" + records + "0\nENDSEC\n";
}

inline std::string dxf_file(const std::string& entities, const std::string& sections_before = "") {
    return sections_before + dxf_section("ENTITIES", entities) + "0\nEOF\n";
}

}  // namespace abut::geometry
