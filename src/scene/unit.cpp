// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions: the SI brochure (9th edition), and NIST SP 811, appendix B, for inches, pounds and what is made of them.
#include "src/scene/unit.hpp"

#include <cctype>
#include <numbers>
#include <optional>
#include <vector>

#include "geometry/brep/input_error.hpp"
#include "geometry/sketch/sketch.hpp"
#include "src/io/nearest_name.hpp"

namespace abut {

namespace {

constexpr Dimension mass{-1, 1, 2};
constexpr long double degree_in_rad = std::numbers::pi_v<long double> / 180;
constexpr long double inch = 0.0254L, pound = 0.45359237L, pound_force = pound * 9.80665L;

struct NamedUnit {
    const char* symbol;
    Dimension dimension;
    long double size;
};
constexpr NamedUnit named_units[] = {
    {"um", dimension::length, 1e-6L},
    {"µm", dimension::length, 1e-6L},
    {"mm", dimension::length, 1e-3L},
    {"cm", dimension::length, 1e-2L},
    {"dm", dimension::length, 1e-1L},
    {"m", dimension::length, 1},
    {"in", dimension::length, inch},
    {"ft", dimension::length, 12 * inch},
    {"uN", dimension::force, 1e-6L},
    {"mN", dimension::force, 1e-3L},
    {"N", dimension::force, 1},
    {"daN", dimension::force, 10},
    {"kN", dimension::force, 1e3L},
    {"MN", dimension::force, 1e6L},
    {"kgf", dimension::force, 9.80665L},
    {"lbf", dimension::force, pound_force},
    {"kip", dimension::force, 1e3L * pound_force},
    {"Pa", dimension::stress, 1},
    {"kPa", dimension::stress, 1e3L},
    {"MPa", dimension::stress, 1e6L},
    {"GPa", dimension::stress, 1e9L},
    {"bar", dimension::stress, 1e5L},
    {"psi", dimension::stress, pound_force / (inch * inch)},
    {"ksi", dimension::stress, 1e3L * pound_force / (inch * inch)},
    {"g", mass, 1e-3L},
    {"kg", mass, 1},
    {"t", mass, 1e3L},
    {"lb", mass, pound},
    {"ms", {0, 0, 1}, 1e-3L},
    {"s", {0, 0, 1}, 1},
    {"min", {0, 0, 1}, 60},
    {"K", dimension::temperature, 1},
    {"rad", dimension::angle, 1},
    {"deg", dimension::angle, degree_in_rad},
    {"°", dimension::angle, degree_in_rad},
    {"rpm", dimension::angular_speed, 6 * degree_in_rad},
};

/// The other lengths are those that drawings may state.
std::optional<NamedUnit> find_unit(const std::string& symbol) {
    for (const NamedUnit& unit : named_units)
        if (symbol == unit.symbol) return unit;
    const double metres = geometry::unit_factor(symbol, "m");
    return metres > 0 ? std::optional(NamedUnit{"", dimension::length, metres}) : std::nullopt;
}

NamedUnit known_unit(const std::string& symbol) {
    if (const std::optional<NamedUnit> unit = find_unit(symbol)) return *unit;
    std::vector<std::string> known;
    for (const NamedUnit& unit : named_units) known.emplace_back(unit.symbol);
    std::string hint = nearest_name_hint(symbol, known);
    hint = hint.starts_with("did you mean") ? hint.substr(0, hint.find('?') + 1) : "units are like mm, kN, GPa, kg/m^3, 1/K;";
    const bool is_celsius = symbol == "C" || symbol == "°C";
    throw InputError("", "unknown unit '" + shortened(symbol) + "'",
                     is_celsius ? "temperatures are rises, in K" : hint + " a product is written 2*x");
}

void append_factor(Unit& unit, const NamedUnit& by, int power) {
    unit.dimension.length += power * by.dimension.length;
    unit.dimension.force += power * by.dimension.force;
    unit.dimension.time += power * by.dimension.time;
    unit.dimension.temperature += power * by.dimension.temperature;
    unit.dimension.angle += power * by.dimension.angle;
    for (int k = 0; k < power; ++k) unit.size *= by.size;
    for (int k = 0; k > power; --k) unit.size /= by.size;
}

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}
/// Letters, the bytes of signs beyond ASCII (°, µ), and _ (ft_us).
bool is_symbol(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80 || c == '_';
}

/// What is left of a unit's text, from the left.
class UnitText {
public:
    explicit UnitText(const std::string& text) : text_(text) {}

    bool at_end() {
        while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
        return at_ == text_.size();
    }
    bool take(char c) {
        if (at_end() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    std::string symbol() {
        at_end();
        const std::size_t begin = at_;
        while (at_ < text_.size() && is_symbol(text_[at_])) ++at_;
        if (at_ == begin) fail();
        return text_.substr(begin, at_ - begin);
    }
    /// The power behind a ^, 1 without one: one digit is more than any quantity takes.
    int power() {
        if (!take('^')) return 1;
        const int sign = take('-') ? -1 : 1;
        if (at_end() || std::isdigit(static_cast<unsigned char>(text_[at_])) == 0) fail();
        return sign * (text_[at_++] - '0');
    }
    [[noreturn]] void fail() const {
        throw InputError("", "'" + shortened(text_) + "' is no unit",
                         "an expression has one unit, at its end, like kN, N/mm^2, kg/m^3 or 1/K; a product is written 2*x");
    }

private:
    const std::string& text_;
    std::size_t at_ = 0;
};

struct NamedDimension {
    Dimension dimension;
    const char* text;
};
constexpr NamedDimension named_dimensions[] = {
    {dimension::none, "a plain number"},
    {dimension::length, "a length (mm, m, in)"},
    {dimension::force, "a force (N, kN, lbf)"},
    {dimension::moment, "a moment (N mm, N m, lbf in)"},
    {dimension::stress, "a stress (MPa, GPa, N/mm^2)"},
    {dimension::body_force, "a force per volume or a stress per displacement (N/mm^3, N/m^3)"},
    {dimension::density, "a density (kg/m^3, g/cm^3, t/mm^3)"},
    {dimension::acceleration, "an acceleration (m/s^2)"},
    {dimension::temperature, "a difference of temperatures (K)"},
    {dimension::expansion, "a strain per temperature (1/K)"},
    {dimension::angle, "an angle (deg, rad)"},
    {dimension::angular_speed, "an angular speed (rad/s, rpm)"},
    {mass, "a mass (kg, t)"},
};

/// The scene's own unit of length or force.
NamedUnit scene_unit(const std::string& symbol, const Dimension& dimension, const char* what, const std::string& text) {
    if (symbol.empty())
        throw InputError("", "'" + shortened(text) + "' needs to know which unit of " + what + " the scene's numbers are in",
                         R"(give the scene its "units", for instance {"length": "mm", "force": "N"})");
    const std::optional<NamedUnit> unit = find_unit(symbol);
    if (unit && unit->dimension == dimension) return *unit;
    throw InputError(
        "", "'" + shortened(text) + "' cannot be converted into the scene's unit of " + what + ", '" + shortened(symbol) + "'",
        "numbers without a unit are in the scene's own");
}

double factor_to(const Unit& unit, const std::string& text, const SceneUnits& scene) {
    const Dimension& d = unit.dimension;
    Unit in_scene = unit;
    if (d.length != 0) append_factor(in_scene, scene_unit(scene.length, dimension::length, "length", text), -d.length);
    if (d.force != 0) append_factor(in_scene, scene_unit(scene.force, dimension::force, "force", text), -d.force);
    if (d == dimension::angle) in_scene.size /= degree_in_rad;
    return static_cast<double>(in_scene.size);
}

}  // namespace

Unit parse_unit(const std::string& text) {
    Unit unit;
    UnitText rest(text);
    int sign = 1;
    if (rest.take('1')) {  // 1/K
        if (!rest.take('/')) rest.fail();
        sign = -1;
    }
    for (;;) {
        const NamedUnit next = known_unit(rest.symbol());
        append_factor(unit, next, sign * rest.power());
        if (rest.at_end()) return unit;
        sign = rest.take('/') ? -1 : 1;
        if (sign == 1) rest.take('*');
    }
}

double unit_factor(const std::string& text, const Dimension& wanted, const SceneUnits& scene) {
    const Unit unit = parse_unit(text);
    if (unit.dimension != wanted)
        throw InputError("", "'" + shortened(text) + "' is the unit of " + dimension_text(unit.dimension),
                         "what is needed here is " + dimension_text(wanted));
    return factor_to(unit, text, scene);
}

double unit_factor_of_any(const std::string& text, const SceneUnits& scene, Dimension& dimension) {
    const Unit unit = parse_unit(text);
    dimension = unit.dimension;
    return factor_to(unit, text, scene);
}

std::string dimension_text(const Dimension& dimension) {
    for (const NamedDimension& named : named_dimensions)
        if (named.dimension == dimension) return named.text;
    return "some other quantity";
}

}  // namespace abut
