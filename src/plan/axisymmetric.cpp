// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/axisymmetric.hpp"

#include <algorithm>
#include <cmath>

#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/scene/dissertation_method.hpp"

namespace abut {

namespace {

bool is_on_axis(const geometry::Curve& curve, double t0, double t1, double merge) {
    return std::holds_alternative<geometry::Segment>(curve) && std::abs(point(curve, t0).x()) <= merge &&
           std::abs(point(curve, t1).x()) <= merge;
}

void append_parts_across(const Scene& scene, std::vector<Problem>& problems) {
    for (const ScenePart& part : scene.parts)
        if (bounding_box(part.part).min.x() < -merge_length(part.part))
            problems.push_back({part.where, "part " + part.name + " reaches to negative x, across the axis x = 0",
                                "x is the radius: draw the half of the section that lies at x >= 0"});
}

void append_wrong_gravity(const Scene& scene, std::vector<Problem>& problems) {
    for (const Load& load : scene.loads)
        if (load.kind == Load::Kind::gravity && load.value[0].constant() != 0)
            problems.push_back({load.where + "/gravity", "gravity across the axis is not axisymmetric",
                                "its x component must be 0; y runs along the axis"});
}

void append_wrong_loads(const Scene& scene, std::vector<Problem>& problems) {
    for (const Load& load : scene.loads) {
        const bool is_moment = load.kind == Load::Kind::edge_moment || load.kind == Load::Kind::part_moment;
        if (is_moment || load.at || load.kind == Load::Kind::bearing)
            problems.push_back({load.where,
                                std::string(is_moment ? "a moment"
                                            : load.at ? "a force off its edges"
                                                      : "the force of a pin") +
                                    " in the plane of the section is not axisymmetric",
                                "load by \"pressure\", \"traction\" or \"force\""});
    }
}

void append_wrong_supports(const Scene& scene, std::vector<Problem>& problems) {
    for (const Support& s : scene.supports) {
        if (s.kind == Support::Kind::rigid && (s.rigid_x || s.rigid_rotation))
            problems.push_back({s.where + "/rigid", "an axisymmetric part has no rigid motion but along y",
                                "write \"translation\": [null, y], \"rotation\": null"});
        if (s.kind == Support::Kind::points)
            problems.push_back({s.where, "points cannot be held in an axisymmetric analysis", "hold an edge"});
    }
    if (scene.accuracy.dirichlet == "solution_structure" && !is_by_dissertation(scene))
        problems.push_back({"/accuracy/dirichlet", "there are no weight functions in an axisymmetric analysis",
                            "take \"auto\", \"aligned\" or \"nitsche\""});
}

/// Edges on the axis have no area: u_x is 0 there by itself, and nothing else can be said there.
void append_conditions_on_axis(const Scene& scene, const ResolvedConditions& conditions, std::vector<Problem>& problems) {
    const auto append = [&](const std::vector<EdgePortion>& portions, const std::string& where, const char* hint) {
        for (const EdgePortion& p : portions) {
            if (!abut::is_on_axis(scene, p)) continue;
            const ScenePart& part = scene.parts[at(p.part)];
            problems.push_back(
                {where, "edge " + part.name + "/" + part.part.edges[at(p.edge)].name + " lies on the axis and has no area",
                 hint});
            return;
        }
    };
    for (std::size_t i = 0; i < scene.loads.size(); ++i) append(conditions.loads[i], scene.loads[i].where, "load another edge");
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        const Support& s = scene.supports[i];
        const bool holds_radius_alone = s.kind == Support::Kind::symmetry || (s.kind == Support::Kind::fix && !s.y);
        if (!holds_radius_alone)
            append(conditions.supports[i], s.where, "the axis is held by itself; hold another edge along y");
    }
}

}  // namespace

bool touches_axis(const geometry::Part& part) {
    const double merge = merge_length(part);
    return std::any_of(part.edges.begin(), part.edges.end(),
                       [&](const geometry::Edge& e) { return is_on_axis(e.curve, 0, 1, merge); });
}

bool is_on_axis(const Scene& scene, const EdgePortion& p) {
    const geometry::Part& part = scene.parts[at(p.part)].part;
    return is_on_axis(part.edges[at(p.edge)].curve, p.t0, p.t1, merge_length(part));
}

void append_axisymmetric_problems(const Scene& scene, const ResolvedConditions& conditions, std::vector<Problem>& problems) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    if (scene.analysis != Analysis::axisymmetric) return;
    append_parts_across(scene, problems);
    append_wrong_loads(scene, problems);
    append_wrong_gravity(scene, problems);
    append_wrong_supports(scene, problems);
    append_conditions_on_axis(scene, conditions, problems);
}

}  // namespace abut
