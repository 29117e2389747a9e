// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion/placement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/io/number_text.hpp"
#include "src/motion/leads.hpp"
#include "src/scene/dissertation_method.hpp"

namespace abut {

namespace {

double without_digits_below(double digit, double value) {
    return digit > 0 ? digit * std::round(value / digit) : value;
}

/// Cosine and sine. Those of quarter turns are exact: what was drawn along the axes, and its grid with it, stays along them.
Vec2 direction(double angle) {
    constexpr double rounding = 1e-15;
    const double quarters = angle / (std::numbers::pi / 2), whole = std::round(quarters);
    if (std::abs(quarters - whole) > rounding * std::max(1.0, std::abs(whole))) return {std::cos(angle), std::sin(angle)};
    const auto number = static_cast<int>(whole - 4 * std::floor(whole / 4));
    const double sign = number < 2 ? 1 : -1;
    return number % 2 == 0 ? Vec2(sign, 0) : Vec2(0, sign);
}

bool varies_by_place(const Load& load) {
    return !load.value[0].is_constant() || !load.value[1].is_constant();
}

/// What is left of a prescribed motion.
double rest_of(double prescribed, double done, double size) {
    constexpr double rounding = 1e-11;
    const double rest = prescribed - done;
    return std::abs(rest) > rounding * size ? rest : 0;
}

/// Supports prescribe motions from where their parts are drawn.
void take_off(const Placement& p, const ScenePart& drawn, Support& s) {
    const Vec2 center = centroid(drawn.part), done = p.of(center) - center;
    const double size = bounding_box(drawn.part).diagonal();
    if (s.rigid_x) s.rigid_x = rest_of(*s.rigid_x, done.x(), size);
    if (s.rigid_y) s.rigid_y = rest_of(*s.rigid_y, done.y(), size);
    if (s.rigid_rotation) s.rigid_rotation = rest_of(*s.rigid_rotation, p.angle, 1);
    if (s.kind != Support::Kind::displacement || !prescribes_motion(s)) return;
    if (s.x) s.value[0] = Expression(rest_of(s.value[0].constant(), done.x(), size));
    if (s.y) s.value[1] = Expression(rest_of(s.value[1].constant(), done.y(), size));
}

/// Grid lines are given in assembly coordinates turned by -angle.
void move_grid(const Placement& p, GridOptions& grid) {
    grid.angle += p.angle;
    const double c = std::cos(grid.angle), s = std::sin(grid.angle);
    const Vec2 by(c * p.shift.x() + s * p.shift.y(), -s * p.shift.x() + c * p.shift.y());
    for (double& x : grid.x) x += by.x();
    for (double& y : grid.y) y += by.y();
    for (GridOptions::Halved& box : grid.refine) {
        box.low += by;
        box.high += by;
    }
}

void move_load(const Scene& drawn, const std::vector<EdgePortion>& on, const std::vector<Placement>& placements, Load& load) {
    if (load.at && !on.empty()) load.at = placements[at(on.front().part)].of(*load.at);
    for (std::size_t i = 0; load.kind == Load::Kind::preload && i < drawn.parts.size(); ++i)
        if (drawn.parts[i].name == load.part)
            load.across = {placements[i].of(load.across[0]), placements[i].of(load.across[1])};
}

}  // namespace

Vec2 Placement::turned(const Vec2& v) const {
    const double c = direction(angle).x(), s = direction(angle).y();
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

Placement about_center(const Vec2& center, const Vec2& translation, double rotation) {
    Placement p{rotation, {0, 0}};
    p.shift = center + translation - p.turned(center);
    return p;
}

Placement along_screw(const Vec2& center, const Vec2& translation, double rotation) {
    constexpr double straight = 1e-8;  // radians: the second order is rounding
    const double w = rotation, along = std::abs(w) < straight ? 1 : std::sin(w) / w,
                 across = std::abs(w) < straight ? 0.5 * w : (1 - std::cos(w)) / w;
    return about_center(center, along * translation + across * geometry::left_of(translation), rotation);
}

Placement followed_by(const Placement& first, const Placement& then) {
    return {first.angle + then.angle, then.of(first.shift)};
}

Placement without_rounding(const Placement& placement, const Vec2& center, double size, double digits) {
    const Vec2 translation = placement.of(center) - center;
    const double digit = digits * std::max(translation.norm(), size * std::abs(placement.angle));
    return about_center(center, {without_digits_below(digit, translation.x()), without_digits_below(digit, translation.y())},
                        without_digits_below(digit / size, placement.angle));
}

bool is_far(const Vec2& translation, double turn, double size) {
    return std::max(translation.norm(), 0.5 * size * std::abs(turn)) > placed_fraction * size || std::abs(turn) > placed_turn;
}

bool has_fits(const ContactOptions& contacts) {
    return contacts.overlap != "report" ||
           std::any_of(contacts.pairs.begin(), contacts.pairs.end(), [](const PairRule& r) { return r.interference != 0; });
}

bool has_friction(const ContactOptions& contacts) {
    return contacts.friction > 0 || std::any_of(contacts.pairs.begin(), contacts.pairs.end(),
                                                [](const PairRule& r) { return r.friction.value_or(0) > 0; });
}

std::string why_not_followed(const Scene& scene, const ResolvedConditions& conditions) {
    if (!scene.follows_motion) return "\"motion\" is \"off\"";
    if (scene.analysis == Analysis::axisymmetric) return "parts around an axis stay where they are drawn";
    if (is_by_dissertation(scene)) return "the dissertation's method is one solution, from where parts are drawn";
    if (std::any_of(scene.loads.begin(), scene.loads.end(), varies_by_place))
        return "a load is given by expressions of the place";
    return leads_of(scene, conditions).why_not;
}

Scene placed(const Scene& drawn, const ResolvedConditions& conditions, const std::vector<Placement>& placements) {
    ENSURE(is_resolved(drawn, conditions), "conditions are resolved for this scene");
    ENSURE(placements.size() == drawn.parts.size(), "every part has a place");
    Scene scene = drawn;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const Placement& p = placements[i];
        if (p.goes_nowhere()) continue;
        ScenePart& part = scene.parts[i];
        turn_and_shift(part, direction(p.angle).x(), direction(p.angle).y(), p.shift);
        for (Probe& probe : scene.output.probes)
            if (probe.part == part.name) probe.at = p.of(probe.at);
        for (Support& support : scene.supports)
            if (support.part == part.name)
                for (Vec2& x : support.at) x = p.of(x);
        for (std::size_t k = 0; k < scene.supports.size(); ++k) {
            const std::vector<EdgePortion>& on = conditions.supports[k];
            const bool is_its = scene.supports[k].part == part.name || (!on.empty() && on.front().part == static_cast<int>(i));
            if (is_its) take_off(p, drawn.parts[i], scene.supports[k]);
        }
        if (const auto grid = scene.accuracy.grids.find(part.name); grid != scene.accuracy.grids.end())
            move_grid(p, grid->second);
    }
    for (std::size_t k = 0; k < scene.loads.size(); ++k) move_load(drawn, conditions.loads[k], placements, scene.loads[k]);
    return scene;
}

Rest rest_at(const Scene& drawn, const ResolvedConditions& conditions, std::vector<Placement> placements, bool is_held) {
    Scene there = placed(drawn, conditions, placements);
    return {std::move(there), std::move(placements), is_held};
}

std::string placement_text(const std::string& part, const Placement& placement, const Vec2& center, double size) {
    constexpr double told = 1e-3;       // of its size, by what a turn moves the part's rim
    constexpr double rounding = 1e-12;  // likewise
    constexpr double digits = 1e-4;     // of how far it goes: what the digits of that do not show
    Vec2 by = placement.of(center) - center;
    const double least = std::max(rounding * size, digits * by.norm());
    for (double& b : by)
        if (std::abs(b) <= least) b = 0;
    std::string text = part + " by (" + number_text(by.x(), 3) + ", " + number_text(by.y(), 3) + ")";
    if (std::abs(placement.angle) * size > told * size)
        text += " and " + number_text(placement.angle * 180 / std::numbers::pi, 2) + " degrees";
    return text;
}

std::optional<Vec2> far_middle(const Scene& scene) {
    geometry::Box2 box;
    for (const ScenePart& part : scene.parts) box.extend(bounding_box(part.part));
    if (box.center().norm() <= box.diagonal()) return std::nullopt;
    return box.center();
}

Scene shifted(const Scene& drawn, const ResolvedConditions& conditions, const Vec2& by) {
    Scene scene = placed(drawn, conditions, std::vector<Placement>(drawn.parts.size(), Placement{0, by}));
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        scene.supports[i].rigid_x = drawn.supports[i].rigid_x;
        scene.supports[i].rigid_y = drawn.supports[i].rigid_y;
        scene.supports[i].value = drawn.supports[i].value;
    }
    return scene;
}

}  // namespace abut
