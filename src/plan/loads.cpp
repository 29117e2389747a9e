// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/loads.hpp"

#include <algorithm>

#include "src/base/index.hpp"

namespace abut {

PartMeasure part_measure(const geometry::Part& part, const Load& load, double volume) {
    if (load.kind != Load::Kind::part_moment) return {volume};
    const Vec2 c = centroid(part);
    return {volume, c, second_moments(part, c).trace()};
}

Vec2 volume_force(const Scene& scene, const Load& load, int part, const PartMeasure& measure, const Vec2& x) {
    const Vec2 value(load.value[0](x.x(), x.y()), load.value[1](x.x(), x.y()));
    const ScenePart& own = scene.parts[at(part)];
    if (load.kind == Load::Kind::spin) {
        const Vec2 arm = scene.analysis == Analysis::axisymmetric ? Vec2(x.x(), 0) : Vec2(x - load.about);
        return scene.materials[at(own.material)].density * load.omega * load.omega * arm;
    }
    if (load.kind == Load::Kind::part_force) return value / (measure.volume * own.thickness);
    if (load.kind == Load::Kind::part_moment) {
        const Vec2 arm = x - measure.center;
        return value.x() / (measure.polar_moment * own.thickness) * Vec2(-arm.y(), arm.x());
    }
    if (load.kind == Load::Kind::gravity) return value * scene.materials[at(own.material)].density;
    return value;
}

Vec2 traction_at(const Load& load, const EdgeTraction& spread, const Vec2& x, const Vec2& normal) {
    const Vec2 value(load.value[0](x.x(), x.y()), load.value[1](x.x(), x.y()));
    if (load.kind == Load::Kind::pressure) return -value.x() * normal;
    if (load.kind == Load::Kind::traction) return value;
    const Vec2 arm = x - spread.center;
    return spread.even + spread.turning * Vec2(-arm.y(), arm.x()) - std::max(0.0, -normal.dot(spread.pressing)) * normal;
}

bool is_edge_load(const Load& load) {
    switch (load.kind) {
        case Load::Kind::pressure:
        case Load::Kind::traction:
        case Load::Kind::edge_force:
        case Load::Kind::edge_moment:
        case Load::Kind::bearing:
            return true;
        default:
            return false;
    }
}

std::string effect_of(const Load& load) {
    if (is_edge_load(load)) return "edge loads";
    switch (load.kind) {
        case Load::Kind::gravity:
            return "gravity";
        case Load::Kind::spin:
            return "spin";
        case Load::Kind::temperature:
            return "temperature";
        case Load::Kind::preload:
            return "preload";
        default:
            return "body force";
    }
}

bool acts_on_volume_of(const Scene& scene, const Load& load, int part) {
    if (load.kind == Load::Kind::gravity) return true;
    return !is_edge_load(load) && (load.part == "*" || load.part == scene.parts[at(part)].name);
}

}  // namespace abut
