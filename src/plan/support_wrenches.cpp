// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/support_wrenches.hpp"

#include <algorithm>
#include <map>

#include "geometry/brep/outline.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/plan/support_components.hpp"

namespace abut {

using geometry::force_through;
using geometry::Screw;
using geometry::ScrewScale;

namespace {

/// Forces of a support along an edge, at points enough for any curve: ends and in between.
void append_along(const Scene& scene, const Support& support, const EdgePortion& portion, std::vector<Screw>& wrenches) {
    constexpr int steps = 4;
    const geometry::Curve& curve = scene.parts[at(portion.part)].part.edges[at(portion.edge)].curve;
    for (int k = 0; k <= steps; ++k) {
        const double t = portion.t0 + (portion.t1 - portion.t0) * k / steps;
        const Vec2 x = point(curve, t), normal = outward_normal(curve, t);
        for (const HeldComponent& held : components_of(support))
            wrenches.push_back(force_through(x, held.direction.value_or(normal)));
        if (support.kind == Support::Kind::spring && support.spring_normal > 0) wrenches.push_back(force_through(x, normal));
        if (support.kind == Support::Kind::spring && support.spring_tangential > 0)
            wrenches.push_back(force_through(x, geometry::left_of(normal)));
    }
}

void append_of_part(const Support& support, const ScenePart& part, std::vector<Screw>& wrenches) {
    for (const Vec2& x : support.at)
        for (const HeldComponent& held : components_of(support)) wrenches.push_back(force_through(x, *held.direction));
    if (support.kind != Support::Kind::rigid) return;
    const Vec2 center = centroid(part.part);
    if (support.rigid_x) wrenches.push_back(force_through(center, {1, 0}));
    if (support.rigid_y) wrenches.push_back(force_through(center, {0, 1}));
    if (support.rigid_rotation) wrenches.emplace_back(0, 0, 1);
}

}  // namespace

ScrewScale screw_scale(const Scene& scene) {
    geometry::Box2 box;
    for (const ScenePart& p : scene.parts) box.extend(bounding_box(p.part));
    return {box.center(), box.diagonal()};
}

std::vector<std::vector<Screw>> support_wrenches(const Scene& scene, const ResolvedConditions& conditions) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    std::vector<std::vector<Screw>> by_part(scene.parts.size());
    const ScrewScale scale = screw_scale(scene);
    for (std::size_t s = 0; s < scene.supports.size(); ++s) {
        std::map<int, std::vector<Screw>> held;
        for (const EdgePortion& portion : conditions.supports[s])
            append_along(scene, scene.supports[s], portion, held[portion.part]);
        for (std::size_t i = 0; i < scene.parts.size(); ++i)
            if (scene.parts[i].name == scene.supports[s].part)
                append_of_part(scene.supports[s], scene.parts[i], held[static_cast<int>(i)]);
        for (const auto& [part, wrenches] : held)
            for (const Screw& w : wrench_space(wrenches, scale)) by_part[at(part)].push_back(w);
    }
    if (scene.analysis == Analysis::axisymmetric)  // hoops stretch in all motions but that along the axis
        for (std::vector<Screw>& wrenches : by_part) {
            wrenches.insert(wrenches.end(), {Screw(1, 0, 0), Screw(0, 0, 1)});
            wrenches = wrench_space(wrenches, scale);
        }
    return by_part;
}

std::optional<Vec2> piece_not_held(const Scene& scene, const ResolvedConditions& conditions, int part) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    const geometry::Part& shape = scene.parts[at(part)].part;
    const int n = count_pieces(shape);
    if (n < 2) return std::nullopt;
    const std::vector<int> piece_of = pieces_of_edges(shape);
    std::vector<std::vector<Screw>> wrenches(at(n));
    for (std::size_t s = 0; s < conditions.supports.size(); ++s)
        for (const EdgePortion& portion : conditions.supports[s])
            if (portion.part == part && piece_of[at(portion.edge)] >= 0)
                append_along(scene, scene.supports[s], portion, wrenches[at(piece_of[at(portion.edge)])]);
    for (int k = 0; k < n; ++k) {
        if (scene.analysis == Analysis::axisymmetric)
            wrenches[at(k)].insert(wrenches[at(k)].end(), {Screw(1, 0, 0), Screw(0, 0, 1)});
        if (twist_space(wrenches[at(k)], screw_scale(scene)).empty()) continue;
        return point(
            shape.edges[static_cast<std::size_t>(std::find(piece_of.begin(), piece_of.end(), k) - piece_of.begin())].curve, 0);
    }
    return std::nullopt;
}

}  // namespace abut
