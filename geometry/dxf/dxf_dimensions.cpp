// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_dimensions.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/brep/message_text.hpp"

namespace abut::geometry::dxf {

namespace {

constexpr double same_share = 0.005;  // texts are rounded, and scales are simple numbers

/// What a dimension says, and between what.
struct Dimension {
    double drawn = 0, said = 0;
    double rounding = 0;  ///< of what is said: half its last digit
    Vec2 at{0, 0};
    int line = 0;
    double factor() const { return said / drawn; }
    bool is_other() const { return std::abs(said - drawn) > std::max(1.01 * rounding, same_share * drawn); }
};

/// Dimensions in another unit than the drawing are no scale: metres and centimetres or millimetres, inches
/// or feet and millimetres.
bool is_of_units(double factor) {
    constexpr std::array units{25.4, 304.8, 100.0, 1000.0};
    return std::any_of(units.begin(), units.end(), [&](double unit) {
        return std::abs(factor / unit - 1) <= same_share || std::abs(factor * unit - 1) <= same_share;
    });
}

struct Said {
    double value, rounding;
};

/// The text without its format: {...}, \\H0.7x;, \\A1;, blanks at its ends.
std::string plain(const std::string& text) {
    std::string out;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == '\\') {
            const std::size_t end = text.find(';', k);
            if (end == std::string::npos) return {};
            k = end;
        } else if (text[k] != '{' && text[k] != '}' && text[k] != '(' && text[k] != ')') {
            out += text[k];
        }
    }
    const std::size_t begin = out.find_first_not_of(' ');
    return begin == std::string::npos ? "" : out.substr(begin, out.find_last_not_of(' ') - begin + 1);
}

/// What a text says that is a number, perhaps with a unit, a tolerance or a fit behind it ("100", "12,5", "40 H7",
/// "100%%p0.1"); nothing of others, and of numbers that can be read in two ways ("1,500").
std::optional<Said> number_in(std::string text) {
    std::replace(text.begin(), text.end(), ',', '.');
    const std::size_t end = text.find_first_not_of("0123456789.");
    const std::string digits = text.substr(0, end);
    std::string rest = end == std::string::npos ? "" : text.substr(end);
    rest.erase(0, std::min(rest.find_first_not_of(' '), rest.size()));
    const auto is = [&](std::size_t k, auto&& what) {
        return k < rest.size() && what(static_cast<unsigned char>(rest[k])) != 0;
    };
    const bool is_fit = is(0, [](int c) { return std::isalpha(c); }) && is(1, [](int c) { return std::isdigit(c); }) &&
                        rest[0] != 'x' && rest[0] != 'X';
    const bool is_followed_well = rest.empty() || rest == "mm" || rest.starts_with("%%p") || rest.starts_with("\u00b1") ||
                                  rest.starts_with("+") || rest.starts_with("-") || is_fit;
    double value = 0;
    if (digits.empty() || !is_followed_well || !parse_number(digits, value)) return std::nullopt;
    const std::size_t point = digits.find('.');
    const int decimals = point == std::string::npos ? 0 : static_cast<int>(digits.size() - point) - 1;
    if (decimals == 3 && text.find('.') != std::string::npos && value >= 1 && value == std::floor(value * 10) / 10)
        return std::nullopt;
    return Said{value, 0.5 * std::pow(10.0, -decimals)};
}

/// DIMLFAC: of the entity itself, of its style, or of the header. Negative ones count in paper space only.
double factor_of(const Structure& structure, const Record& record) {
    constexpr int dimlfac = 144;
    double factor = 1;
    if (const auto current = structure.header.find("$DIMLFAC"); current != structure.header.end())
        parse_number(current->second, factor);
    if (const auto style = structure.dimension_factors.find(upper_case(record.text(3)));
        style != structure.dimension_factors.end())
        factor = style->second;
    for (std::size_t k = 0; k + 1 < record.groups.size(); ++k)
        if (record.groups[k].code == 1070 && parse_integer(record.groups[k].value) == dimlfac &&
            record.groups[k + 1].code == 1040)
            parse_number(record.groups[k + 1].value, factor);
    return factor > 0 ? factor : 1;
}

std::optional<Dimension> dimension_of(const Structure& structure, const Record& record) {
    enum { rotated, aligned, diameter = 3, radius };
    const int kind = record.integer(70, 0) & 7;
    const auto place = [&](int x) { return Vec2(record.number(x, NAN), record.number(x + 10, NAN)); };
    const bool is_round = kind == diameter || kind == radius;
    if (kind != rotated && kind != aligned && !is_round) return std::nullopt;
    const Vec2 a = place(is_round ? 10 : 13), b = place(is_round ? 15 : 14), way = b - a;
    const double angle = record.number(50, 0) * std::numbers::pi / 180;
    Dimension d;
    d.drawn = kind == rotated ? std::abs(way.dot(Vec2(std::cos(angle), std::sin(angle)))) : way.norm();
    d.at = 0.5 * (a + b);
    d.line = record.line;
    if (!std::isfinite(d.drawn) || !(d.drawn > 0)) return std::nullopt;
    const std::string text = plain(record.text(1));
    if (text.empty() && !record.text(1).empty()) return std::nullopt;
    if (text.empty() || text == "<>") {
        d.said = d.drawn * factor_of(structure, record);
        return d;
    }
    std::string number = text;
    if (kind == radius && (number.starts_with("R") || number.starts_with("r"))) number.erase(0, 1);
    for (const std::string sign : {"%%c", "\u00d8", "\u2300"})
        if (kind == diameter && number.starts_with(sign)) number.erase(0, sign.size());
    const std::optional<Said> said = number_in(number);
    if (!said || said->value == 0) return std::nullopt;
    d.said = said->value;
    d.rounding = said->rounding;
    return d;
}

std::string place_of(const Dimension& d) {
    return number_text(d.said) + " where " + number_text(d.drawn) + " is drawn";
}

}  // namespace

void tell_other_dimensions(const Structure& structure, Drawing& drawing) {
    constexpr std::size_t most_told = 3;
    constexpr const char* full_size = "draw it full size (in CAD: SCALE by that factor) where the dimension is right";
    std::vector<Dimension> all, other;
    for (const std::span<const Record>& section : structure.entities)
        for (const Record& record : section)
            if (record.type == "DIMENSION" && record.integer(67, 0) == 0)
                if (const std::optional<Dimension> d = dimension_of(structure, record)) all.push_back(*d);
    std::copy_if(all.begin(), all.end(), std::back_inserter(other),
                 [](const Dimension& d) { return d.is_other() && !is_of_units(d.factor()); });
    if (other.empty()) return;
    std::vector<double> factors;
    for (const Dimension& d : other) factors.push_back(d.factor());
    std::nth_element(factors.begin(), factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2), factors.end());
    const double factor = factors[factors.size() / 2];
    const auto n_alike = std::count_if(other.begin(), other.end(), [&](const Dimension& d) {
        return std::abs(d.said - factor * d.drawn) <= std::max(1.01 * d.rounding, same_share * d.said);
    });
    if (2 * static_cast<std::size_t>(n_alike) > all.size()) {
        drawing.warnings.push_back({"dimensions say " + number_text(factor) + " times what is drawn (" +
                                        place_of(other.front()) + "): it is drawn to a scale; what is drawn counts",
                                    other.front().at, "", other.front().line, full_size});
        return;
    }
    for (std::size_t k = 0; k < std::min(most_told, other.size()); ++k)
        drawing.warnings.push_back({"a dimension says " + place_of(other[k]) +
                                        (k + 1 == most_told && other.size() > most_told
                                             ? "; so do " + std::to_string(other.size() - most_told) + " others"
                                             : "") +
                                        ": what is drawn counts",
                                    other[k].at, "", other[k].line, full_size});
}

}  // namespace abut::geometry::dxf
