// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/needed_friction.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "src/base/index.hpp"
#include "src/io/number_text.hpp"
#include "src/results/result_units.hpp"
#include "src/scene/scene.hpp"

namespace abut {

namespace {

/// Forces push across a direction where less of them than this goes along it.
constexpr double next_to_none = 0.01;
/// Coefficients that any dry faces have.
constexpr double least_noted = 0.01;

/// The one direction, x or y, in which a support holds one part; none where it holds more.
std::optional<int> single_axis(const Support& support) {
    const bool is_rigid = support.kind == Support::Kind::rigid, x = is_rigid ? support.rigid_x.has_value() : support.x,
               y = is_rigid ? support.rigid_y.has_value() : support.y;
    const bool is_fixed = is_rigid || support.kind == Support::Kind::fix || support.kind == Support::Kind::points;
    if (!is_fixed || x == y) return std::nullopt;
    return x ? 0 : 1;
}

std::optional<int> single_part(const Scene& scene, const Support& support, const std::vector<EdgePortion>& portions) {
    std::set<int> parts;
    for (const EdgePortion& portion : portions) parts.insert(portion.part);
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        if (scene.parts[i].name == support.part) parts.insert(static_cast<int>(i));
    return parts.size() == 1 ? std::optional(*parts.begin()) : std::nullopt;
}

/// The sum of the forces that press on a part across the axis; none where a contact has friction, or holds the part against
/// what the support does.
std::optional<double> pressed_across(const Result& result, int part, int axis, double support) {
    double sum = 0;
    for (const ContactResult& c : result.contacts) {
        if (c.part[0] != part && c.part[1] != part) continue;
        const double force = c.force.norm(), along = (c.part[0] == part ? 1 : -1) * c.force[axis];
        if (c.kind != "contact" || c.friction) return std::nullopt;
        if (std::abs(along) <= next_to_none * force)
            sum += force;
        else if (along * support > 0)
            return std::nullopt;
    }
    return sum;
}

}  // namespace

void note_needed_friction(const Scene& scene, const ResolvedConditions& conditions, Result& result) {
    struct Held {
        double force = 0;
        std::set<std::string> supports;
    };
    std::map<std::pair<int, int>, Held> held;  // by part and axis
    for (const Reaction& r : result.reactions) {
        const Support& support = scene.supports[at(r.support)];
        const std::optional<int> axis = single_axis(support),
                                 part = single_part(scene, support, conditions.supports[at(r.support)]);
        if (!axis || !part) continue;
        Held& h = held[{*part, *axis}];
        h.force += r.force[*axis];
        h.supports.insert(r.label);
    }
    for (const auto& [of, h] : held) {
        const std::optional<double> pressed = pressed_across(result, of.first, of.second, h.force);
        if (!pressed || std::abs(h.force) < least_noted * *pressed || *pressed == 0) continue;
        result.notes.push_back(joined({h.supports.begin(), h.supports.end()}, ", ") +
                               ": in place of this, friction would have to hold " + scene.parts[at(of.first)].name + " along " +
                               (of.second == 0 ? "x" : "y") + ": its contacts would need a coefficient of at least " +
                               number_text(std::abs(h.force) / *pressed, 2) + " (" + number_text(std::abs(h.force), 4) +
                               " over the " + number_text(*pressed, 4) + " that press on it)");
    }
}

}  // namespace abut
