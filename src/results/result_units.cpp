// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/result_units.hpp"

#include <algorithm>
#include <cmath>

#include "src/io/number_text.hpp"

namespace abut {

namespace {

constexpr double rounding_fraction = 1e-9;  ///< of the largest value: what is smaller is rounding
constexpr double place_fraction = 1e-5;     ///< of the model's size: finer places tell a reader nothing

std::string stress_unit(const std::string& force, const std::string& length) {
    struct Named {
        const char *force, *length, *stress;
    };
    static constexpr Named named[] = {{"N", "mm", "MPa"}, {"N", "m", "Pa"},     {"kN", "m", "kPa"}, {"kN", "mm", "GPa"},
                                      {"MN", "m", "MPa"}, {"lbf", "in", "psi"}, {"N", "um", "TPa"}};
    for (const Named& n : named)
        if (force == n.force && length == n.length) return n.stress;
    if (force.empty() || length.empty()) return "";
    return force + "/" + length + "²";
}

}  // namespace

ResultUnits result_units(const Result& result) {
    const std::string &length = result.length_unit, &force = result.force_unit;
    ResultUnits units;
    units.length = length;
    units.force = force;
    if (!length.empty()) units.area = length + "²";
    if (!length.empty() && !force.empty()) units.moment = force + " " + length;
    units.energy = units.moment;
    units.stress = stress_unit(force, length);
    return units;
}

std::string with_unit(double value, int digits, const std::string& unit) {
    return number_text(value, digits) + (unit.empty() ? "" : " " + unit);
}

std::string heading(const std::string& quantity, const std::string& unit) {
    return unit.empty() ? quantity : quantity + " [" + unit + "]";
}

double rounded_off(double value, double largest) {
    return std::abs(value) <= rounding_fraction * std::abs(largest) ? 0 : value;
}

const PartResult* most_stressed(const Result& result) {
    const PartResult* most = nullptr;
    for (const PartResult& part : result.parts)
        if (part.solved && part.max_von_mises.value > (most ? most->max_von_mises.value : 0)) most = &part;
    return most;
}

std::string largest_stress_text(const PartResult& part, int digits, const std::string& unit) {
    const std::string text = with_unit(part.max_von_mises.value, digits, unit);
    if (part.max_von_mises_at_corner) return text + " at a corner";
    return part.max_von_mises_error ? text + " ± " + number_text(100 * *part.max_von_mises_error, 2) + " %" : text;
}

std::string pair_text(const Vec2& v, int digits) {
    const double largest = v.cwiseAbs().maxCoeff();
    return "(" + number_text(rounded_off(v.x(), largest), digits) + ", " + number_text(rounded_off(v.y(), largest), digits) +
           ")";
}

std::string place_text(const Vec2& p, double model_size) {
    if (!(model_size > 0)) return pair_text(p, 6);
    const double step = std::pow(10.0, std::floor(std::log10(place_fraction * model_size)));
    const auto text = [&](double c) { return number_text(std::round(c / step) * step, 7); };
    return "(" + text(p.x()) + ", " + text(p.y()) + ")";
}

double model_size(const Result& result) {
    geometry::Box2 box;
    for (const geometry::Part& part : result.geometry) box.extend(geometry::bounding_box(part));
    return box.diagonal();
}

std::string contact_number(std::size_t k) {
    return std::to_string(k + 1);
}

std::string joined(const std::vector<std::string>& items, const std::string& separator) {
    std::string text;
    for (const std::string& item : items) text += (text.empty() ? "" : separator) + item;
    return text;
}

std::string counted(std::size_t n, const std::string& singular) {
    return std::to_string(n) + " " + singular + (n == 1 ? "" : "s");
}

std::string seconds_text(double seconds) {
    if (!(seconds > 0)) return "";
    return seconds < 0.01 ? number_text(1e3 * seconds, 2) + " ms" : number_text(seconds, 3) + " s";
}

double stage_seconds(const Result& result, const std::string& stage) {
    for (const auto& [name, seconds] : result.timing)
        if (name == stage) return seconds;
    return 0;
}

}  // namespace abut
