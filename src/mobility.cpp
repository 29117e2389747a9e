// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/mobility.hpp"

#include <algorithm>
#include <map>

#include "geometry/extent.hpp"
#include "geometry/interface_kind.hpp"
#include "src/detect.hpp"
#include "src/facing_edges.hpp"
#include "src/motion_text.hpp"
#include "src/support_components.hpp"

namespace abut {

namespace {

using geometry::Connection;
using geometry::force_through;
using geometry::Part;
using geometry::ScrewScale;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

ScrewScale scale_of(const std::vector<const Part*>& parts) {
    geometry::Box2 box;
    for (const Part* part : parts) box.extend(bounding_box(*part));
    return {box.center(), box.diagonal()};
}

ScrewScale scale_of(const Scene& scene) {
    std::vector<const Part*> parts;
    for (const ScenePart& p : scene.parts) parts.push_back(&p.part);
    return scale_of(parts);
}

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

/// By part: the wrenches of each support that holds it, reduced to a basis.
std::vector<std::vector<Screw>> support_wrenches(const Scene& scene, const ResolvedConditions& conditions) {
    std::vector<std::vector<Screw>> by_part(scene.parts.size());
    const ScrewScale scale = scale_of(scene);
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

struct Joint {
    std::array<int, 2> part;
    std::vector<Screw> wrenches;  ///< on the first
};

std::vector<std::string> words_of(const std::vector<Screw>& twists, const ScrewScale& scale) {
    std::vector<std::string> words;
    for (const Screw& t : twists) words.push_back(motion_words(t, scale));
    return words;
}

MobilityResult mobility_of(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Joint>& joints) {
    const ScrewScale scale = scale_of(scene);
    const std::vector<std::vector<Screw>> held = support_wrenches(scene, conditions);
    std::vector<Connection> connections;
    for (std::size_t i = 0; i < held.size(); ++i)
        for (const Screw& w : held[i]) connections.push_back({static_cast<int>(i), -1, w});
    for (const Joint& joint : joints)
        for (const Screw& w : joint.wrenches) connections.push_back({joint.part[0], joint.part[1], w});
    const geometry::Mobility found = geometry::mobility(static_cast<int>(scene.parts.size()), connections, scale);
    MobilityResult result{found.degrees_of_freedom, found.gruebler, found.redundant, {}};
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        result.parts.push_back({scene.parts[i].name, wrench_space(held[i], scale), twist_space(held[i], scale),
                                words_of(twist_space(held[i], scale), scale), found.free[i], words_of(found.free[i], scale)});
    return result;
}

FunctionalInterface bonded_interface(const FacingEdges& stretch) {
    FunctionalInterface result;
    result.kind = "bonded";
    result.at = 0.5 * (stretch.ends[0] + stretch.ends[1]);
    result.wrenches = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    return result;
}

}  // namespace

FunctionalInterface functional_interface(const Scene& scene, const Candidate& candidate) {
    const Part &first = scene.parts[at(candidate.first)].part, &second = scene.parts[at(candidate.second)].part;
    std::vector<FacingEdges> stretches;
    for (const geometry::ZonePiece& piece : zone_pieces(first, second, candidate.zone))
        stretches.push_back(facing_edges(first, second, candidate.zone, piece));
    if (stretches.empty()) return {};
    const auto longest = std::max_element(stretches.begin(), stretches.end(),
                                          [](const FacingEdges& a, const FacingEdges& b) { return a.length < b.length; });
    put_first(stretches, longest->edge1, longest->edge2);
    if (candidate.bonded) return bonded_interface(stretches.front());
    const std::string kind = geometry::interface_kind(first, stretches[0].edge1, second, stretches[0].edge2);
    return functional_interface(first, second, kind, stretches, scale_of({&first, &second}));
}

MobilityResult mobility_as_drawn(const Scene& scene, const ResolvedConditions& conditions,
                                 const std::vector<Candidate>& candidates) {
    std::vector<Joint> joints;
    for (const Candidate& c : candidates) {
        const double size =
            std::min(geometry::extent(scene.parts[at(c.first)].part), geometry::extent(scene.parts[at(c.second)].part));
        if (c.zone.gap_min - c.closing <= default_distance_fraction * size)
            joints.push_back({{c.first, c.second}, functional_interface(scene, c).wrenches});
    }
    return mobility_of(scene, conditions, joints);
}

MobilityResult mobility_under_load(const Scene& scene, const ResolvedConditions& conditions,
                                   const std::vector<ContactResult>& contacts) {
    std::vector<Joint> joints;
    for (const ContactResult& c : contacts)
        if (c.functional && c.status != "open") joints.push_back({c.part, c.functional->wrenches});
    return mobility_of(scene, conditions, joints);
}

}  // namespace abut
