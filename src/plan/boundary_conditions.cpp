// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/boundary_conditions.hpp"

#include <algorithm>

#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/io/number_text.hpp"
#include "src/plan/axisymmetric.hpp"
#include "src/plan/dissertation_limits.hpp"
#include "src/plan/loads.hpp"
#include "src/plan/plan.hpp"
#include "src/plan/support_components.hpp"

namespace abut {

namespace {

/// Value that a support prescribes for component c, where it is one number.
std::optional<double> constant_value(const Support& s, int c) {
    if ((s.kind != Support::Kind::fix && s.kind != Support::Kind::displacement) || !(c == 0 ? s.x : s.y)) return std::nullopt;
    if (s.kind == Support::Kind::fix) return 0.0;
    const Expression& e = s.value[static_cast<std::size_t>(c)];
    return e.is_constant() ? std::optional<double>(e.constant()) : std::nullopt;
}

/// Two supports that prescribe different values of one component on the same stretch of an edge.
void append_contradictions(const Scene& scene, const std::vector<std::vector<EdgePortion>>& portions,
                           std::vector<Problem>& problems) {
    const auto meet = [&](std::size_t i, std::size_t j) -> const EdgePortion* {
        for (const EdgePortion& a : portions[i])
            for (const EdgePortion& b : portions[j])
                if (a.part == b.part && a.edge == b.edge && std::max(a.t0, b.t0) < std::min(a.t1, b.t1)) return &a;
        return nullptr;
    };
    for (std::size_t i = 0; i < portions.size(); ++i)
        for (std::size_t j = i + 1; j < portions.size(); ++j)
            for (int c : {0, 1}) {
                const auto a = constant_value(scene.supports[i], c), b = constant_value(scene.supports[j], c);
                const EdgePortion* shared = a && b && *a != *b ? meet(i, j) : nullptr;
                if (!shared) continue;
                const ScenePart& part = scene.parts[at(shared->part)];
                problems.push_back({scene.supports[j].where,
                                    "supports " + std::to_string(i) + " and " + std::to_string(j) + " prescribe different " +
                                        (c == 0 ? "x" : "y") + " displacements on " + part.name + "/" +
                                        part.part.edges[at(shared->edge)].name,
                                    "take one of them away"});
            }
}

bool is_on_boundary(const geometry::Part& part, const Vec2& p) {
    return std::any_of(part.edges.begin(), part.edges.end(), [&](const geometry::Edge& edge) {
        return (point(edge.curve, closest_parameter(edge.curve, p)) - p).norm() <= merge_length(part);
    });
}

/// Weight functions that hold points know neither the part's mean motion nor strains that are not elastic.
std::string why_no_points(const Scene& scene, int part) {
    if (scene.accuracy.dirichlet != "solution_structure") return "";
    const ScenePart& p = scene.parts[at(part)];
    for (const Support& other : scene.supports)
        if (other.kind == Support::Kind::rigid && other.part == p.name) return "which has a rigid support, too";
    for (const Load& load : scene.loads)
        if (load.kind == Load::Kind::temperature && acts_on_volume_of(scene, load, part)) return "whose temperature changes";
    if (is_nearly_incompressible(scene, scene.materials[at(p.material)])) return "which is nearly incompressible";
    return "";
}

/// The first support of edges that displaces a held point in a direction that its own support holds.
std::optional<std::size_t> displacing(const Scene& scene, const std::vector<std::vector<EdgePortion>>& portions,
                                      const Support& held, int part, const Vec2& p) {
    for (std::size_t k = 0; k < scene.supports.size(); ++k)
        for (int c : {0, 1})
            if ((c == 0 ? held.x : held.y) && constant_value(scene.supports[k], c).value_or(0) != 0 &&
                holds_at(scene, k, portions[k], part, p, Vec2::Unit(c)))
                return k;
    return std::nullopt;
}

void append_wrong_points(const Scene& scene, const std::vector<std::vector<EdgePortion>>& portions,
                         std::vector<Problem>& problems) {
    for (const Support& s : scene.supports) {
        if (s.kind != Support::Kind::points) continue;
        for (int i = 0; i < static_cast<int>(scene.parts.size()); ++i) {
            const ScenePart& part = scene.parts[at(i)];
            if (part.name != s.part) continue;
            if (const std::string why = why_no_points(scene, i); !why.empty())
                problems.push_back({s.where, "weight functions cannot hold points of part " + part.name + ", " + why,
                                    "take accuracy.dirichlet \"nitsche\", or hold edges instead"});
            for (const Vec2& p : s.at) {
                const std::string point = "the point (" + number_text(p.x(), 6) + ", " + number_text(p.y(), 6) + ")";
                if (!contains(part.part, p) && !is_on_boundary(part.part, p))
                    problems.push_back({s.where, point + " lies outside part " + part.name, "hold points inside the part"});
                else if (const auto k = displacing(scene, portions, s, i, p))
                    problems.push_back({s.where,
                                        point + " of part " + part.name + " is held, and support " + std::to_string(*k) +
                                            " displaces the edge that it lies on",
                                        "take one of them away"});
            }
        }
    }
}

}  // namespace

ResolvedConditions resolve_conditions(const Scene& scene) {
    ResolvedConditions r;
    std::vector<Problem> problems;
    const auto resolve = [&](const Selection& on) {
        try {
            return on.empty() ? std::vector<EdgePortion>{} : select(scene, on);
        } catch (const InputError& error) {
            problems.insert(problems.end(), error.problems().begin(), error.problems().end());
            return std::vector<EdgePortion>{};
        }
    };
    for (const Support& s : scene.supports) r.supports.push_back(resolve(s.on));
    for (const Load& l : scene.loads) {
        r.loads.push_back(resolve(l.on));
        if (l.kind != Load::Kind::bearing || r.loads.back().empty()) continue;
        if (l.value[0].constant() == 0 && l.value[1].constant() == 0) continue;  // presses no side
        r.loads.back() = pressed_portions(scene, l, r.loads.back());
        if (r.loads.back().empty())
            problems.push_back({l.where, "these edges cannot carry the force of a pin: none of them, or too little, faces it",
                                "give the edges of the hole, or load by \"force\""});
    }
    append_contradictions(scene, r.supports, problems);
    append_wrong_points(scene, r.supports, problems);
    append_axisymmetric_problems(scene, r, problems);
    append_dissertation_problems(scene, problems);
    if (!problems.empty()) throw InputError(problems);
    return r;
}

bool is_resolved(const Scene& scene, const ResolvedConditions& conditions) {
    return conditions.supports.size() == scene.supports.size() && conditions.loads.size() == scene.loads.size();
}

bool is_driven(const Scene& scene, const ResolvedConditions& conditions, int part) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    const auto on_part = [&](const std::vector<EdgePortion>& portions) {
        return std::any_of(portions.begin(), portions.end(), [&](const EdgePortion& p) { return p.part == part; });
    };
    for (std::size_t i = 0; i < scene.loads.size(); ++i)
        if (on_part(conditions.loads[i]) || acts_on_volume_of(scene, scene.loads[i], part)) return true;
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        const Support& s = scene.supports[i];
        const auto is_zero = [](const Expression& e) { return e.is_constant() && e.constant() == 0; };
        if (s.kind == Support::Kind::displacement && on_part(conditions.supports[i]) &&
            ((s.x && !is_zero(s.value[0])) || (s.y && !is_zero(s.value[1]))))
            return true;
        if (s.kind == Support::Kind::rigid && s.part == scene.parts[at(part)].name &&
            (s.rigid_x.value_or(0) != 0 || s.rigid_y.value_or(0) != 0 || s.rigid_rotation.value_or(0) != 0))
            return true;
    }
    return false;
}

std::string support_label(const Scene& scene, int support) {
    const Support& s = scene.supports[at(support)];
    std::string what;
    if (s.kind == Support::Kind::symmetry)
        what = "symmetry";
    else if (s.kind == Support::Kind::rigid)
        return "rigid hold of " + s.part;
    else if (s.kind == Support::Kind::spring)
        what = "spring";
    else {
        what = s.kind == Support::Kind::displacement ? "displacement " : "fix ";
        what += s.x && s.y ? "x, y" : (s.x ? "x" : "y");
    }
    if (s.kind == Support::Kind::points)
        return what + " at " + std::to_string(s.at.size()) + (s.at.size() == 1 ? " point of " : " points of ") + s.part;
    std::string on;
    for (const Selector& selector : s.on)
        on += (on.empty() ? "" : ", ") + (selector.pattern.empty() ? selector.part + " (selected)" : selector.pattern);
    return what + " on " + on;
}

}  // namespace abut
