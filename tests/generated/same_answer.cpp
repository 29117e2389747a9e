// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/generated/same_answer.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include "geometry/brep/input_error.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::test {

namespace {

/// Of forces that statics determine, whose stated error is none: what rounding leaves.
constexpr double rounding = 1e-7;

/// All zones between two parts, as one, in the terms of the scene as drawn.
struct Touch {
    Vec2 force{0, 0};
    double force_error = 0;
    double pressing = 0;  ///< about the integral of the pressure, for a thickness of 1: press fits have no resultant
    double peak = 0, peak_error = 0;
    bool at_corner = false, is_known = true;  // whether the answer says how far it may be off
};

Vec2 as_drawn(const Vec2& v, const Change& change) {
    const double a = -change.turn * std::numbers::pi / 180;
    const Vec2 back(std::cos(a) * v.x() - std::sin(a) * v.y(), std::sin(a) * v.x() + std::cos(a) * v.y());
    return {change.mirror ? -back.x() : back.x(), back.y()};
}

/// By the names of the parts, the force on the one that comes first in the alphabet.
std::map<std::string, Touch> touches_of(const Result& r, const Change& change) {
    std::map<std::string, Touch> touches;
    const double stress = 1 / (change.unit * change.unit);
    for (const ContactResult& c : r.contacts) {
        const bool in_order = c.parts[0] < c.parts[1];
        Touch& t = touches[in_order ? c.parts[0] + " on " + c.parts[1] : c.parts[1] + " on " + c.parts[0]];
        t.force += (in_order ? 1 : -1) * as_drawn(c.force, change);
        const double peak = c.max_pressure.value * stress;
        t.pressing += peak * c.contact_length * change.unit;
        if (c.errors) t.force_error += c.errors->force * c.force.norm();
        if (peak > 0 && !c.errors) t.is_known = false;
        if (peak <= t.peak) continue;
        t.peak = peak;
        t.peak_error = c.errors ? c.errors->peak * peak : 0;
        t.at_corner = c.errors && c.errors->at_corner;
    }
    return touches;
}

std::string text(double v) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.6g", v);
    return buffer;
}

std::string apart(const std::string& what, double a, double b, double allowed) {
    return what + ": " + text(a) + " and " + text(b) + ", " + text(std::abs(a - b) / allowed) + " times what is stated";
}

double largest_force(const std::map<std::string, Touch>& touches) {
    double largest = 0;
    for (const auto& [name, t] : touches) largest = std::max({largest, t.force.norm(), t.pressing});
    return largest;
}

}  // namespace

std::vector<std::string> differences(const Answer& drawn, const Answer& other, const Change& change) {
    if (drawn.refused != other.refused)
        return {std::string("refused ") + (drawn.refused ? "as drawn only: " : "now: ") + drawn.message + other.message};
    if (drawn.refused) return {};
    std::vector<std::string> lines;
    const auto before = touches_of(drawn.result, {}), now = touches_of(other.result, change);
    const double largest = largest_force(before);
    double largest_peak = 0;
    for (const auto& [name, t] : before) largest_peak = std::max(largest_peak, t.peak);
    for (const auto& [name, a] : before) {
        const auto found = now.find(name);
        const Touch b = found == now.end() ? Touch{} : found->second;
        if (!a.is_known || !b.is_known) {
            lines.push_back(name + ": pressed, without a stated error");
            continue;
        }
        const double allowed = a.force_error + b.force_error + rounding * largest;
        if ((a.force - b.force).norm() > allowed)
            lines.push_back(apart("force of " + name, a.force.norm(), b.force.norm(), allowed) + " (" +
                            text((a.force - b.force).norm() / allowed) + " as vectors)");
        const double peaks = a.peak_error + b.peak_error + rounding * largest_peak;
        if (!a.at_corner && !b.at_corner && std::abs(a.peak - b.peak) > peaks)
            lines.push_back(apart("peak of " + name, a.peak, b.peak, peaks));
    }
    for (const auto& [name, b] : now)
        if (!before.count(name) && b.peak > 0) lines.push_back(name + " presses now only");
    const double u = drawn.result.strain_energy, v = other.result.strain_energy * change.unit;
    const double energies =
        drawn.result.error_estimate.energy.value_or(0) * u + other.result.error_estimate.energy.value_or(0) * v + rounding * u;
    if (std::abs(u - v) > energies) lines.push_back(apart("energy", u, v, energies));
    return lines;
}

std::vector<Change> changes_of(std::uint64_t seed) {
    const double turn = std::fmod(17.0 + 61.8 * static_cast<double>(seed), 360);
    return {{"turned", turn}, {"mirrored", 0, true}, {"reordered", 0, false, 1, seed}, {"in metres", 0, false, 1000}};
}

std::vector<std::string> faults_of_assembly(const std::string& text, const std::vector<Change>& changes, double balanced) {
    std::vector<std::string> lines;
    std::optional<Answer> drawn;
    const auto run = [&](const Change& change) {
        const Scene scene = read_scene_text(changed(text, change), "assembly.json");
        Answer answer = answer_of(scene);
        const std::string name = change.name.empty() ? "drawn" : change.name;
        if (!answer.refused)
            for (const std::string& fault : faults_of(scene, answer.result, balanced)) lines.push_back(name + ": " + fault);
        if (drawn)
            for (const std::string& line : differences(*drawn, answer, change)) lines.push_back(name + ": " + line);
        return answer;
    };
    drawn = run({});
    for (const Change& change : changes) run(change);
    return lines;
}

}  // namespace abut::test
