// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/support_sets.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/assembly/ring.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/discretization/boundary_points.hpp"
#include "src/discretization/solution_structure.hpp"
#include "src/plan/support_components.hpp"
#include "src/scene/dissertation_method.hpp"

namespace abut {

namespace {

using geometry::BoundaryPoint;
using solver::GridSide;
using solver::SupportSet;

/// Grid side on which an edge lies wholly, if any, with its extent along it.
struct OnSide {
    GridSide side;
    double from, to;
};

std::optional<OnSide> grid_side_of(const PartOnGrid& g, int edge, double t0, double t1) {
    const geometry::Curve& curve = g.local.edges[at(edge)].curve;
    if (!std::holds_alternative<geometry::Segment>(curve)) return std::nullopt;
    const Vec2 a = point(curve, t0), b = point(curve, t1);
    const auto& grid = g.cells.grid;
    const double merge = geometry::merge_fraction * g.size;
    const auto on = [&](int axis, double line) { return std::abs(a[axis] - line) < merge && std::abs(b[axis] - line) < merge; };
    const auto result = [&](GridSide side, int along) {
        return OnSide{side, std::min(a[along], b[along]), std::max(a[along], b[along])};
    };
    if (on(0, grid.x.front())) return result(GridSide::left, 1);
    if (on(0, grid.x.back())) return result(GridSide::right, 1);
    if (on(1, grid.y.front())) return result(GridSide::bottom, 0);
    if (on(1, grid.y.back())) return result(GridSide::top, 0);
    return std::nullopt;
}

void append_points_of(SupportSet& set, const PartOnGrid& g, const EdgePortion& portion, const HeldComponent& component) {
    for (const BoundaryPoint& p : boundary_points(g, portion)) {
        const Vec2 direction = component.direction ? g.frame.vector_to_local(*component.direction) : p.normal;
        const Vec2 global = g.frame.to_global(p.x);
        const double value = component.value ? (*component.value)(global.x(), global.y()) : 0.0;
        if (!std::isfinite(value))
            throw InputError("",
                             "the prescribed displacement has no finite value at (" + std::to_string(global.x()) + ", " +
                                 std::to_string(global.y()) + ") on part " + g.local.name,
                             "check its expression");
        set.points.push_back({p.element, p.x, p.normal, direction, p.weight, value});
    }
}

void append_points(SupportSet& set, const PartOnGrid& g, const EdgePortion& whole, const HeldComponent& component) {
    if (component.value && !component.value->is_constant()) {
        const EdgeField value = [&](const Vec2& x, const Vec2& /*normal*/) {
            const Vec2 global = g.frame.to_global(x);
            return Vec2((*component.value)(global.x(), global.y()), 0);
        };
        for (const EdgePortion& portion : cut_where_rough(g, whole, value)) append_points_of(set, g, portion, component);
    } else {
        append_points_of(set, g, whole, component);
    }
}

/// Turns a set that lies on one grid side into one whose functions can be dropped, where that is exact; else notes why not.
void try_to_align(SupportSet& set, const std::vector<OnSide>& stretches) {
    const auto component = grid_axis(set.points.front().direction);
    const double value = set.points.front().value;
    for (const solver::SupportPoint& p : set.points) {
        if (!grid_axis(p.direction)) set.note = "holds a direction inclined to the grid";
        if (p.value != value) set.note = "prescribes values that vary along the edge";
    }
    if (!set.note.empty()) return;
    set.side = stretches.front().side;
    set.component = *component;
    set.value = set.points.front().direction[*component] > 0 ? value : -value;
    for (const OnSide& s : stretches) set.stretches.push_back({s.from, s.to});
}

/// Sets of one component by dropped functions or Nitsche's method; note: why not by other means, if that was asked for.
void append_sets(std::vector<SupportSet>& sets, const PartOnGrid& g, const std::vector<EdgePortion>& portions, int tag,
                 const HeldComponent& component, bool may_align, const std::string& note) {
    std::array<std::vector<EdgePortion>, 4> on_side;
    std::array<std::vector<OnSide>, 4> stretches;
    SupportSet other;
    other.tag = tag;
    other.note = note;
    for (const EdgePortion& p : portions) {
        const auto on = may_align ? grid_side_of(g, p.edge, p.t0, p.t1) : std::nullopt;
        if (!on) {
            append_points(other, g, p, component);
            continue;
        }
        on_side[static_cast<std::size_t>(on->side)].push_back(p);
        stretches[static_cast<std::size_t>(on->side)].push_back(*on);
    }
    if (!other.points.empty()) sets.push_back(std::move(other));
    for (std::size_t k = 0; k < 4; ++k) {
        if (on_side[k].empty()) continue;
        SupportSet set;
        set.tag = tag;
        for (const EdgePortion& p : on_side[k]) append_points(set, g, p, component);
        if (set.points.empty()) continue;
        try_to_align(set, stretches[k]);
        sets.push_back(std::move(set));
    }
}

SupportSet set_of(const HeldByWeight& held, const PartOnGrid& g) {
    SupportSet set;
    set.tag = held.support;
    set.component = held.component;
    set.by_structure = true;
    const Vec2 direction = Vec2::Unit(held.component);
    for (int e : held.edges)
        for (const BoundaryPoint& p : boundary_points(g, {g.part, e, 0, 1}))
            set.points.push_back({p.element, p.x, p.normal, direction, p.weight, 0});
    for (const Vec2& p : held.points)
        set.points.push_back({element_at(g.local, g.cells, g.elements, p), p, {0, 0}, direction, g.size, 0});
    set.note = held.points.empty() ? "accuracy.dirichlet asks for it; reaction from equilibrium"
                                   : "points can be held in no other way; reaction from equilibrium";
    return set;
}

bool holds(const HeldByWeight& held, int edge, int component) {
    return held.component == component && std::find(held.edges.begin(), held.edges.end(), edge) != held.edges.end();
}

/// The portions on this part that no weight holds in a component.
std::vector<EdgePortion> without_held(const std::vector<EdgePortion>& portions, const std::vector<HeldByWeight>& held,
                                      int support, const PartOnGrid& g, const HeldComponent& component) {
    const auto by_weight = [&](int edge, int c) {
        return std::any_of(held.begin(), held.end(),
                           [&](const HeldByWeight& h) { return h.support == support && holds(h, edge, c); });
    };
    std::vector<EdgePortion> rest;
    for (const EdgePortion& p : portions) {
        if (p.part != g.part) continue;
        const geometry::Curve& curve = g.local.edges[at(p.edge)].curve;
        const Vec2 d = component.direction ? g.frame.vector_to_local(*component.direction) : outward_normal(curve, 0.5);
        const auto axis = grid_axis(d);
        const bool is_held = axis ? by_weight(p.edge, *axis) : by_weight(p.edge, 0) && by_weight(p.edge, 1);
        if (!is_held) rest.push_back(p);
    }
    return rest;
}

/// The dissertation's method has no other way than weights to hold an edge.
void require_held(const Scene& scene, int support, const std::vector<EdgePortion>& rest, const PartOnGrid& g,
                  const std::string& why) {
    for (const EdgePortion& p : rest)
        if (p.part == g.part)
            throw InputError(scene.supports[at(support)].where,
                             "the dissertation's method cannot hold edge " + g.local.edges[at(p.edge)].name + " of part " +
                                 g.local.name + " so: " + why,
                             "hold whole edges in both directions or along the axes, or take accuracy.method out");
}

/// Points where a part is held in a direction, of all supports so far.
using HeldSoFar = std::vector<std::pair<Vec2, Vec2>>;

bool is_held(const HeldSoFar& so_far, const Vec2& p, const Vec2& direction, double merge) {
    return std::any_of(so_far.begin(), so_far.end(),
                       [&](const auto& held) { return (held.first - p).norm() <= merge && held.second == direction; });
}

/// The displacement at a point along a direction, (local), is zero.
solver::MeanConstraint at_point(const PartOnGrid& g, const Vec2& p, const Vec2& direction) {
    const int n = g.input.space.n_functions;
    const solver::PointBasis basis = evaluate(g.input.space, element_at(g.local, g.cells, g.elements, p), p);
    solver::MeanConstraint c;
    c.coefficient = {direction.x(), direction.y(), 0};
    c.area = 1;
    c.size = g.size;
    c.integrals.value = c.integrals.dx = c.integrals.dy = Eigen::VectorXd::Zero(n);
    for (std::size_t k = 0; k < basis.functions.size(); ++k)
        c.integrals.value[basis.functions[k]] = basis.value[static_cast<Eigen::Index>(k)];
    return c;
}

}  // namespace

std::vector<SupportSet> support_sets(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& on_grid) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    ENSURE(on_grid.part >= 0 && at(on_grid.part) < scene.parts.size(), "the part is one of the scene");
    std::vector<SupportSet> sets;
    const bool may_align = scene.accuracy.dirichlet != "nitsche";
    const std::vector<HeldByWeight> held = held_by_weight(scene, conditions, on_grid);
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        const int support = static_cast<int>(i);
        for (const HeldByWeight& h : held)
            if (h.support == support) sets.push_back(set_of(h, on_grid));
        const std::string note = may_align ? why_not_by_weight(scene, support, on_grid) : "accuracy.dirichlet asks for it";
        for (const HeldComponent& c : components_of(scene.supports[i])) {
            const std::vector<EdgePortion> rest = without_held(conditions.supports[i], held, support, on_grid, c);
            if (is_by_dissertation(scene)) require_held(scene, support, rest, on_grid, note);
            append_sets(sets, on_grid, rest, support, c, may_align, note);
        }
    }
    return sets;
}

std::vector<solver::SpringSet> spring_sets(const Scene& scene, const ResolvedConditions& conditions,
                                           const PartOnGrid& on_grid) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    ENSURE(on_grid.part >= 0 && at(on_grid.part) < scene.parts.size(), "the part is one of the scene");
    std::vector<solver::SpringSet> sets;
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        const Support& s = scene.supports[i];
        if (s.kind != Support::Kind::spring) continue;
        solver::SpringSet set{static_cast<int>(i), {}, s.spring_normal, s.spring_tangential};
        for (const EdgePortion& portion : conditions.supports[i]) {
            if (portion.part != on_grid.part) continue;
            for (const BoundaryPoint& p : boundary_points(on_grid, portion))
                set.points.push_back({p.element, p.x, p.normal, p.weight});
        }
        if (!set.points.empty()) sets.push_back(std::move(set));
    }
    return sets;
}

std::vector<solver::MeanConstraint> mean_constraints(const Scene& scene, const PartOnGrid& on_grid, int part) {
    std::vector<solver::MeanConstraint> constraints;
    const solver::FunctionIntegrals integrals = solver::integrate_functions(on_grid.input);
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        const Support& s = scene.supports[i];
        if (s.kind != Support::Kind::rigid || s.part != scene.parts[at(on_grid.part)].name) continue;
        const auto add = [&](const Vec2& direction, double turn, double value) {
            const Vec2 d = on_grid.frame.vector_to_local(direction);
            solver::MeanConstraint c;
            c.tag = static_cast<int>(i);
            c.part = part;
            c.coefficient = {d.x(), d.y(), turn};
            c.value = value;
            c.area = on_grid.input.axis ? solver::measure(on_grid.input) : on_grid.area;
            c.size = on_grid.size;
            c.integrals = integrals;
            constraints.push_back(std::move(c));
        };
        if (s.rigid_x) add({1, 0}, 0, *s.rigid_x);
        if (s.rigid_y) add({0, 1}, 0, *s.rigid_y);
        if (s.rigid_rotation) add({0, 0}, 1, *s.rigid_rotation * on_grid.size);
    }
    return constraints;
}

std::vector<solver::MeanConstraint> point_constraints(const Scene& scene, const ResolvedConditions& conditions,
                                                      const PartOnGrid& on_grid, int part) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    std::vector<solver::MeanConstraint> constraints;
    if (on_grid.input.structure) return constraints;
    const geometry::Part& drawn = scene.parts[at(on_grid.part)].part;
    HeldSoFar so_far;
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        const Support& s = scene.supports[i];
        if (s.kind != Support::Kind::points || s.part != scene.parts[at(on_grid.part)].name) continue;
        for (const Vec2& p : s.at)
            for (const HeldComponent& held : components_of(s)) {
                bool is_taken = is_held(so_far, p, *held.direction, merge_length(drawn));
                for (std::size_t k = 0; k < scene.supports.size() && !is_taken; ++k)
                    is_taken = holds_at(scene, k, conditions.supports[k], on_grid.part, p, *held.direction);
                if (is_taken) continue;
                so_far.emplace_back(p, *held.direction);
                constraints.push_back(
                    at_point(on_grid, on_grid.frame.to_local(p), on_grid.frame.vector_to_local(*held.direction)));
                constraints.back().tag = static_cast<int>(i);
                constraints.back().part = part;
            }
    }
    return constraints;
}

}  // namespace abut
