// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion/rigid_loads.hpp"

#include <cmath>

#include "geometry/curves/curve_rule.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/plan/loads.hpp"

namespace abut {

namespace {

/// Of what loads add up from: resultants below are the rounding of places far from the origin.
constexpr double balanced = 1e-9;

/// What the loads of one part add up to, and from.
struct LoadSum {
    RigidLoad load;
    double forces = 0, moments = 0;  ///< magnitudes

    void add_moment(double moment) {
        load.moment += moment;
        moments += std::abs(moment);
    }
    void add(const Vec2& force, const Vec2& arm) {
        load.force += force;
        load.moment += geometry::cross(arm, force);
        forces += force.norm();
        moments += arm.norm() * force.norm();  // what runs through the centroid has no moment but rounding
    }
    RigidLoad resultant() const {
        return {load.force.norm() > balanced * forces ? load.force : Vec2(0, 0),
                std::abs(load.moment) > balanced * moments ? load.moment : 0, load.stretch};
    }
};

void add_edge_load(const Scene& scene, const Load& load, const std::vector<EdgePortion>& portions,
                   const std::vector<Vec2>& centers, std::vector<LoadSum>& on) {
    if (portions.empty()) return;
    const EdgeTraction spread = edge_traction(scene, load, portions);
    const bool keeps_direction = load.kind == Load::Kind::traction || load.kind == Load::Kind::edge_force;
    for (const EdgePortion& p : portions) {
        const geometry::Curve& curve = part_of(scene, p.part).edges[at(p.edge)].curve;
        const geometry::CurveRule rule = geometry::curve_rule(curve, p.t0, p.t1);
        for (std::size_t q = 0; q < rule.t.size(); ++q) {
            const double t = rule.t[q];
            const Vec2 x = point(curve, t);
            const double area = rule.weights[q] * derivative(curve, t).norm() * scene_part(scene, p.part).thickness;
            const Vec2 force = area * traction_at(load, spread, x, outward_normal(curve, t));
            const Vec2 arm = x - centers[at(p.part)];
            on[at(p.part)].add(force, arm);
            if (keeps_direction) on[at(p.part)].load.stretch += arm.dot(force);
        }
    }
}

/// Forces per volume are constant over the part, or those of a spin, which act in the centroid, too.
void add_volume_load(const Scene& scene, const Load& load, int part, const Vec2& center, LoadSum& on) {
    if (load.kind == Load::Kind::part_moment) {
        on.add_moment(load.value[0].constant());
        return;
    }
    const ScenePart& own = scene_part(scene, part);
    const double volume = area(own.part);
    on.add(volume * own.thickness * volume_force(scene, load, part, part_measure(own.part, load, volume), center), Vec2(0, 0));
}

}  // namespace

std::vector<RigidLoad> rigid_loads(const Scene& scene, const ResolvedConditions& conditions) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    std::vector<LoadSum> on(scene.parts.size());
    std::vector<Vec2> centers;
    for (const ScenePart& part : scene.parts) centers.push_back(centroid(part.part));
    for (std::size_t k = 0; k < scene.loads.size(); ++k) {
        const Load& load = scene.loads[k];
        if (load.kind == Load::Kind::temperature || load.kind == Load::Kind::preload) continue;
        if (is_edge_load(load)) add_edge_load(scene, load, conditions.loads[k], centers, on);
        for (std::size_t i = 0; !is_edge_load(load) && i < on.size(); ++i)
            if (const int part = static_cast<int>(i); acts_on_volume_of(scene, load, part))
                add_volume_load(scene, load, part, centers[i], on[i]);
    }
    std::vector<RigidLoad> resultants;
    for (const LoadSum& sum : on) resultants.push_back(sum.resultant());
    return resultants;
}

}  // namespace abut
