// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <charconv>
#include <cmath>

#include "src/result.hpp"

namespace abut {

namespace {

/// Shortest text that reads back as the same number; an unknown value is an empty field.
std::string exact(double value) {
    if (!std::isfinite(value)) return "";
    std::array<char, 32> buffer{};
    return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::string quoted(const std::string& field) {
    if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
    std::string text = "\"";
    for (char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
    return text + "\"";
}

}  // namespace

std::string contact_csv(const ContactResult& contact) {
    const ContactProfile& p = contact.profile;
    std::string text = "edge,s,x,y,pressure,gap\n";
    for (std::size_t i = 0; i < p.s.size(); ++i) {
        text += quoted(p.edge[i]);
        for (double value : {p.s[i], p.x[i], p.y[i], p.pressure[i], p.gap[i]}) text += "," + exact(value);
        text += "\n";
    }
    return text;
}

}  // namespace abut
