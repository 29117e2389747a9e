// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/support_components.hpp"

#include <algorithm>
#include <cmath>

#include "src/base/index.hpp"

namespace abut {

std::vector<HeldComponent> components_of(const Support& support) {
    using Kind = Support::Kind;
    if (support.kind == Kind::symmetry) return {HeldComponent{}};
    std::vector<HeldComponent> list;
    if (support.kind != Kind::fix && support.kind != Kind::displacement && support.kind != Kind::points) return list;
    const bool prescribed = support.kind == Kind::displacement;
    if (support.x) list.push_back({Vec2(1, 0), prescribed ? &support.value[0] : nullptr});
    if (support.y) list.push_back({Vec2(0, 1), prescribed ? &support.value[1] : nullptr});
    return list;
}

bool holds_at(const Scene& scene, std::size_t support, const std::vector<EdgePortion>& portions, int part, const Vec2& p,
              const Vec2& direction) {
    constexpr double same_direction = geometry::merge_fraction;  // sine of the angle between
    const geometry::Part& drawn = scene.parts[at(part)].part;
    const std::vector<HeldComponent> held = components_of(scene.supports[support]);
    return std::any_of(portions.begin(), portions.end(), [&](const EdgePortion& portion) {
        if (portion.part != part) return false;
        const geometry::Curve& curve = drawn.edges[at(portion.edge)].curve;
        const double t = std::clamp(closest_parameter(curve, p), portion.t0, portion.t1);
        if ((point(curve, t) - p).norm() > merge_length(drawn)) return false;
        return std::any_of(held.begin(), held.end(), [&](const HeldComponent& c) {
            return std::abs(geometry::cross(c.direction.value_or(outward_normal(curve, t)), direction)) <= same_direction;
        });
    });
}

std::string effect_of(const Support& support) {
    switch (support.kind) {
        case Support::Kind::rigid:
            return "rigid supports";
        case Support::Kind::points:
            return "held points";
        case Support::Kind::spring:
            return "springs";
        default:
            return "";
    }
}

}  // namespace abut
