// SPDX-License-Identifier: GPL-3.0-or-later
// Small DXF texts for tests.
#pragma once
#include <initializer_list>
#include <sstream>
#include <string>
#include <utility>

#include "geometry/dxf/dxf.hpp"

namespace abut::geometry {

inline std::string dxf_groups(std::initializer_list<std::pair<int, double>> numbers) {
    std::ostringstream text;
    text.precision(17);
    for (const auto& [code, value] : numbers) text << code << "\n" << value << "\n";
    return text.str();
}

/// A record: its type, handle and layer (empty: left out), and number groups.
inline std::string dxf_record(const std::string& type, const std::string& handle, const std::string& layer,
                              std::initializer_list<std::pair<int, double>> numbers) {
    std::ostringstream text;
    text << "0\n" << type << "\n";
    if (!handle.empty()) text << "5\n" << handle << "\n";
    if (!layer.empty()) text << "8\n" << layer << "\n";
    return text.str() + dxf_groups(numbers);
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

/// A block's definition, by itself to be put into dxf_section("BLOCKS", ...).
inline std::string dxf_block(const std::string& name, double base_x, double base_y, const std::string& entities,
                             int flags = 0) {
    std::ostringstream text;
    text.precision(17);
    text << "0\nBLOCK\n8\n0\n2\n" << name << "\n70\n" << flags << "\n10\n" << base_x << "\n20\n" << base_y << "\n";
    return text.str() + entities + "0\nENDBLK\n";
}

/// numbers: 41 and 42 scales, 50 rotation, 70 and 71 columns and rows, 44 and 45 their spacing, 230 normal.
inline std::string dxf_insert(const std::string& handle, const std::string& layer, const std::string& block, double x, double y,
                              std::initializer_list<std::pair<int, double>> numbers = {}) {
    return dxf_record("INSERT", handle, layer, {{10, x}, {20, y}}) + "2\n" + block + "\n" + dxf_groups(numbers);
}

/// One entity of every kind that is read, at the top and in a block that is inserted turned and squeezed.
inline std::string dxf_of_every_kind() {
    const std::string kinds =
        dxf_line("", "A", 0, 0, 1, 0) + dxf_arc("", "0", 1, 2, 3, 40, 100) + dxf_circle("", "B", 1, 1, 2) +
        dxf_record("ELLIPSE", "", "A", {{10, 1}, {20, 2}, {11, 3}, {21, 1}, {40, 0.5}, {41, 0}, {42, 3}}) +
        dxf_record("LWPOLYLINE", "", "A", {{90, 3}, {70, 1}, {10, 0}, {20, 0}, {42, 0.5}, {10, 2}, {20, 0}, {10, 2}, {20, 3}}) +
        dxf_record("POLYLINE", "", "A", {{66, 1}, {70, 1}}) + dxf_record("VERTEX", "", "A", {{10, 0}, {20, 0}}) +
        dxf_record("VERTEX", "", "A", {{10, 1}, {20, 0}, {42, -1}}) + dxf_record("SEQEND", "", "A", {}) +
        dxf_record("SPLINE", "", "A",
                   {{70, 8}, {71, 3}, {40, 0}, {40, 0}, {40, 0}, {40, 0}, {40, 1}, {40, 2}, {40, 2}, {40, 2}, {40, 2},
                    {10, 0}, {20, 0}, {10, 1}, {20, 2}, {10, 2}, {20, 0}, {10, 3}, {20, 2}, {10, 4}, {20, 0}}) +
        dxf_record("SPLINE", "", "A", {{70, 8}, {71, 3}, {11, 0}, {21, 0}, {11, 1}, {21, 2}, {11, 3}, {21, 2}});
    return dxf_section("HEADER", "9\n$INSUNITS\n70\n4\n") + dxf_section("BLOCKS", dxf_block("PART", 1, 2, kinds)) +
           dxf_section("ENTITIES",
                       kinds + dxf_insert("", "C", "PART", 20, 0, {{41, 2}, {42, -1}, {50, 30}, {70, 2}, {44, 9}})) +
           "0\nEOF\n";
}

inline Drawing read_drawing(const std::string& text) {
    return read_dxf_bytes("test.dxf", text);
}

}  // namespace abut::geometry
