// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion/way_left.hpp"

#include <algorithm>
#include <limits>

#include "geometry/brep/part.hpp"
#include "src/base/index.hpp"
#include "src/contact/candidates.hpp"
#include "src/motion/leads.hpp"
#include "src/motion/settle.hpp"

namespace abut {

namespace {

/// Of a part's size: what a part slides on by in the solution, some ten times what steel is strained by. What goes along may be
/// small beside that, and its displacements are to stay small beside it: of the smallest part's size.
constexpr double slides_on = 1e-3, most_of_smallest = 0.02;

/// The scene with motions prescribed as far only as these placements have come.
Scene led_until(const Scene& drawn, const ResolvedConditions& conditions, const std::vector<Placement>& placements) {
    const Scene there = placed(drawn, conditions, placements);
    Scene scene = drawn;
    for (std::size_t k = 0; k < scene.supports.size(); ++k) {
        Support& s = scene.supports[k];
        const Support& left = there.supports[k];
        if (!prescribes_motion(s)) continue;
        if (s.rigid_x) *s.rigid_x -= *left.rigid_x;
        if (s.rigid_y) *s.rigid_y -= *left.rigid_y;
        if (s.rigid_rotation) *s.rigid_rotation -= *left.rigid_rotation;
        if (s.kind != Support::Kind::displacement) continue;
        if (s.x) s.value[0] = Expression(s.value[0].constant() - left.value[0].constant());
        if (s.y) s.value[1] = Expression(s.value[1].constant() - left.value[1].constant());
    }
    return scene;
}

/// Does a part slide on another that it touches, both placed so, as they go from there to their ends?
bool slides_to(const Scene& drawn, const std::vector<Candidate>& there, std::size_t part, const std::vector<Placement>& from,
               const std::vector<Placement>& ends) {
    const Vec2 center = centroid(drawn.parts[part].part);
    const double near = slides_on * bounding_box(drawn.parts[part].part).diagonal();
    const auto goes = [&](std::size_t i) -> Vec2 { return ends[i].of(center) - from[i].of(center); };
    return std::any_of(there.begin(), there.end(), [&](const Candidate& c) {
        if ((at(c.first) != part && at(c.second) != part) || c.friction == 0 || c.zone.gap_min > near) return false;
        return (goes(at(c.first)) - goes(at(c.second))).norm() > 0.5 * goes(part).norm();
    });
}

}  // namespace

Scene without_friction(Scene scene) {
    scene.contacts.friction = 0;
    for (PairRule& rule : scene.contacts.pairs) rule.friction.reset();
    return scene;
}

std::vector<Placement> with_way_left(const Scene& drawn, const ResolvedConditions& conditions,
                                     std::vector<Placement> placements, const std::vector<char>& slide) {
    if (!has_friction(drawn.contacts) || placements.empty()) return placements;
    const std::vector<Placement> ends = placements;
    const Leads leads = leads_of(drawn, conditions);
    double smallest = std::numeric_limits<double>::infinity();
    for (const ScenePart& part : drawn.parts) smallest = std::min(smallest, bounding_box(part.part).diagonal());
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (!leads.of[i].goes_anywhere() && (slide.empty() || !slide[i])) continue;
        const geometry::Part& part = drawn.parts[i].part;
        const Vec2 center = centroid(part), by = ends[i].of(center) - center;
        const double size = bounding_box(part).diagonal(), way = std::max(by.norm(), 0.5 * size * std::abs(ends[i].angle));
        if (way == 0) continue;
        const double gone = std::max(0.0, 1 - std::min(slides_on * size, most_of_smallest * smallest) / way);
        const auto goes_along = [&](std::size_t k) { return ends[k].angle == ends[i].angle && ends[k].shift == ends[i].shift; };
        for (std::size_t k = 0; k < ends.size(); ++k)  // bonded to it
            if (goes_along(k)) placements[k] = about_center(center, gone * by, gone * ends[i].angle);
    }
    return placements;
}

std::vector<Placement> short_of_rest(const Scene& drawn, const ResolvedConditions& conditions,
                                     const std::vector<Placement>& rest) {
    std::vector<Placement> led = with_way_left(drawn, conditions, rest);
    const Leads leads = leads_of(drawn, conditions);
    const auto goes = [](const Lead& lead) { return lead.goes_anywhere(); };
    if (!has_friction(drawn.contacts) || std::none_of(leads.of.begin(), leads.of.end(), goes)) return led;
    const Scene until = led_until(drawn, conditions, led);
    if (std::vector<Placement> held = settle_until_held(until, conditions, true).placements; !held.empty()) return held;
    std::vector<Placement> all = settle(without_friction(until), conditions, {}, true).placements;
    if (all.empty()) return led;
    const std::vector<Candidate> there = find_candidates_anyway(placed(drawn, conditions, all), 1);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!goes(leads.of[i]) && slides_to(drawn, there, i, all, rest)) led[i] = all[i];
    return led;
}

}  // namespace abut
