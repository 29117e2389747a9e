// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/plan/loads.hpp"

namespace abut {

namespace {

constexpr double marks_over_model = 40;  // marks of an edge as long as the whole model
constexpr int least_marks = 3;

template <class Add>
void along_portions(const Scene& scene, const std::vector<EdgePortion>& portions, Add add) {
    geometry::Box2 model;
    for (const ScenePart& part : scene.parts) model.extend(bounding_box(part.part));
    for (const EdgePortion& p : portions) {
        const geometry::Curve& curve = scene.parts[at(p.part)].part.edges[at(p.edge)].curve;
        const double share = length(curve, p.t0, p.t1) / model.diagonal();
        const int n = std::max(least_marks, static_cast<int>(std::lround(marks_over_model * share)));
        for (int k = 0; k < n; ++k) {
            const double t = p.t0 + (k + 0.5) / n * (p.t1 - p.t0);
            add(point(curve, t), outward_normal(curve, t));
        }
    }
}

}  // namespace

std::vector<SupportMark> support_marks(const Scene& scene, const ResolvedConditions& conditions) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    std::vector<SupportMark> marks;
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        const Support& s = scene.supports[i];
        const bool both = (s.x && s.y) || s.kind == Support::Kind::spring;
        along_portions(scene, conditions.supports[i], [&](const Vec2& x, const Vec2& n) {
            const bool normal_is_x = std::abs(n.x()) > std::abs(n.y());
            const bool symmetry = s.kind == Support::Kind::symmetry;
            marks.push_back({x, n, both || (symmetry ? normal_is_x : s.x), both || (symmetry ? !normal_is_x : s.y)});
        });
        for (const Vec2& p : s.at) marks.push_back({p, {0, -1}, s.x, s.y});
        if (s.kind == Support::Kind::rigid)
            for (const ScenePart& part : scene.parts)
                if (part.name == s.part)
                    marks.push_back({centroid(part.part), {0, -1}, s.rigid_x.has_value(), s.rigid_y.has_value()});
    }
    return marks;
}

std::vector<LoadMark> load_marks(const Scene& scene, const ResolvedConditions& conditions) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    std::vector<LoadMark> marks;
    const auto add = [&](const Vec2& x, const Vec2& direction) {
        if (direction.norm() > 0) marks.push_back({x, direction.normalized()});
    };
    for (std::size_t i = 0; i < scene.loads.size(); ++i) {
        const Load& load = scene.loads[i];
        const EdgeTraction spread = edge_traction(scene, load, conditions.loads[i]);
        along_portions(scene, conditions.loads[i],
                       [&](const Vec2& x, const Vec2& n) { add(x, traction_at(load, spread, x, n)); });
        if (load.at) add(*load.at, {load.value[0].constant(), load.value[1].constant()});
        if (load.kind == Load::Kind::preload) {
            const Vec2 along = load.across[1] - load.across[0], n = geometry::left_of(along);
            add(load.across[0] + 0.25 * along, n);
            add(load.across[0] + 0.75 * along, -n);
        }
        if (is_edge_load(load) || load.kind == Load::Kind::temperature || load.kind == Load::Kind::preload) continue;
        for (std::size_t p = 0; p < scene.parts.size(); ++p)
            if (acts_on_volume_of(scene, load, static_cast<int>(p))) {
                const Vec2 c = centroid(scene.parts[p].part);
                if (load.kind == Load::Kind::spin) add(c, c - load.about);
                add(c, {load.value[0](c.x(), c.y()), load.value[1](c.x(), c.y())});
            }
    }
    return marks;
}

}  // namespace abut
