// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/csv_field.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace abut {

std::string csv_field(double value) {
    if (!std::isfinite(value)) return "";
    std::array<char, 32> buffer{};
    return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

}  // namespace abut
