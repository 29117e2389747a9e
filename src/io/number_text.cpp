// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace abut {

namespace {

constexpr int most_digits = 15;         ///< that a double has
constexpr int coordinate_decimals = 2;  ///< a hundredth of a pixel: finer than any screen or printer shows

std::string to_text(double value, std::chars_format format, int precision) {
    std::array<char, 400> buffer{};  // the longest fixed text of a double has 309 digits before the point
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision).ptr;
    return {buffer.data(), end};
}

void trim_zeros(std::string& text) {
    if (text.find('.') == std::string::npos) return;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
}

}  // namespace

std::string number_text(double value, int digits) {
    if (!std::isfinite(value)) return "n/a";
    if (value == 0) return "0";
    digits = std::max(digits, 1);
    // The exponent of the rounded value: 9.996 with three digits is 10.0, not 9.996's decade.
    std::string scientific = to_text(value, std::chars_format::scientific, digits - 1);
    const std::size_t e = scientific.find('e');
    const int exponent = std::stoi(scientific.substr(e + 1));
    if (exponent < -4 || exponent > 4) {
        std::string mantissa = scientific.substr(0, e);
        trim_zeros(mantissa);
        return mantissa + scientific.substr(e);
    }
    const double rounded = std::stod(scientific);
    std::string plain = to_text(rounded, std::chars_format::fixed, std::max(digits - 1 - exponent, 0));
    trim_zeros(plain);
    return plain;
}

std::string percent_text(double fraction) {
    return number_text(100 * fraction, 2) + " %";
}

std::string number_beside(double value, double other, int digits) {
    const std::string beside = number_text(other, digits);
    std::string text = number_text(value, digits);
    while (text == beside && digits < most_digits) text = number_text(value, ++digits);
    return text;
}

std::string percent_beside(double fraction, double other) {
    return number_beside(100 * fraction, 100 * other, 2) + " %";
}

std::string coordinate_text(double pixels) {
    if (!std::isfinite(pixels)) return "0";
    std::string text = to_text(pixels, std::chars_format::fixed, coordinate_decimals);
    trim_zeros(text);
    return text == "-0" ? "0" : text;
}

}  // namespace abut
