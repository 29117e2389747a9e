// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/boundary_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace abut {

namespace {

using geometry::BoundaryPoint;
using solver::GridSide;
using solver::SupportSet;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

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

std::vector<BoundaryPoint> points_of(const PartOnGrid& g, const EdgePortion& portion) {
    const int degree = std::max(g.input.space.x.degree, g.input.space.y.degree);
    return boundary_rule(g.local, g.cells, portion.edge, portion.t0, portion.t1, degree + 2);
}

/// One held component of a support: its direction (none: the boundary's normal) and value in the assembly's frame.
struct Component {
    std::optional<Vec2> direction;
    const Expression* value = nullptr;
};

std::vector<Component> components_of(const Support& support) {
    if (support.kind == Support::Kind::symmetry) return {Component{}};
    std::vector<Component> list;
    const bool prescribed = support.kind == Support::Kind::displacement;
    if (support.x) list.push_back({Vec2(1, 0), prescribed ? &support.value[0] : nullptr});
    if (support.y) list.push_back({Vec2(0, 1), prescribed ? &support.value[1] : nullptr});
    return list;
}

void append_points(SupportSet& set, const PartOnGrid& g, const EdgePortion& portion, const Component& component) {
    for (const BoundaryPoint& p : points_of(g, portion)) {
        const Vec2 direction = component.direction ? g.frame.vector_to_local(*component.direction) : p.normal;
        const Vec2 global = g.frame.to_global(p.x);
        const double value = component.value ? (*component.value)(global.x(), global.y()) : 0.0;
        if (!std::isfinite(value))
            throw InputError("",
                             "the prescribed displacement has no finite value at (" + std::to_string(global.x()) + ", " +
                                 std::to_string(global.y()) + ") on part " + g.local.name,
                             "check its expression");
        set.points.push_back({p.cell, p.x, p.normal, direction, p.weight, value});
    }
}

/// Turns a set that lies on one grid side into one whose functions can be dropped, where that is exact.
void try_to_align(SupportSet& set, const std::vector<OnSide>& stretches) {
    const GridSide side = stretches.front().side;
    const Vec2 d = set.points.front().direction;
    const double value = set.points.front().value;
    constexpr double parallel = 1e-12;  // sine of the angle that rounding leaves between a direction and a grid axis
    const int component = std::abs(d.x()) > std::abs(d.y()) ? 0 : 1;
    if (std::abs(d[1 - component]) > parallel) return;
    for (const solver::SupportPoint& p : set.points)
        if (p.value != value || std::abs(p.direction[1 - component]) > parallel) return;
    set.side = side;
    set.component = component;
    set.value = d[component] > 0 ? value : -value;
    for (const OnSide& s : stretches) set.stretches.push_back({s.from, s.to});
}

void append_sets(std::vector<SupportSet>& sets, const PartOnGrid& g, const std::vector<EdgePortion>& portions, int tag,
                 const Component& component, bool may_align) {
    std::array<std::vector<EdgePortion>, 4> on_side;
    std::array<std::vector<OnSide>, 4> stretches;
    SupportSet other;
    other.tag = tag;
    for (const EdgePortion& p : portions) {
        if (p.part != g.part) continue;
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

double selected_area(const Scene& scene, const std::vector<EdgePortion>& portions) {
    double sum = 0;
    for (const EdgePortion& p : portions) {
        const ScenePart& part = scene.parts[at(p.part)];
        sum += part.thickness * length(part.part.edges[at(p.edge)].curve, p.t0, p.t1);
    }
    return sum;
}

/// Traction of an edge load at a point, in the assembly's frame.
Vec2 traction_at(const Load& load, const Vec2& x, const Vec2& normal, double total_area) {
    const Vec2 value(load.value[0](x.x(), x.y()), load.value[1](x.x(), x.y()));
    if (load.kind == Load::Kind::pressure) return -value.x() * normal;
    if (load.kind == Load::Kind::edge_force) return value / total_area;
    return value;
}

bool is_edge_load(const Load& load) {
    return load.kind == Load::Kind::pressure || load.kind == Load::Kind::traction || load.kind == Load::Kind::edge_force;
}

bool acts_on_volume_of(const Scene& scene, const Load& load, int part) {
    if (load.kind == Load::Kind::gravity) return true;
    return !is_edge_load(load) && (load.part == "*" || load.part == scene.parts[at(part)].name);
}

/// Force per volume of a volume load, in the assembly's frame.
Vec2 volume_force(const Scene& scene, const Load& load, const PartOnGrid& g, const Vec2& x) {
    const Vec2 value(load.value[0](x.x(), x.y()), load.value[1](x.x(), x.y()));
    const ScenePart& part = scene.parts[at(g.part)];
    if (load.kind == Load::Kind::part_force) return value / (g.area * part.thickness);
    if (load.kind == Load::Kind::gravity) return value * scene.materials[at(part.material)].density;
    return value;
}

void add_edge_load(const Scene& scene, const Load& load, const std::vector<EdgePortion>& portions, const PartOnGrid& g,
                   PartLoad& result) {
    const double total = selected_area(scene, portions);
    std::vector<solver::TractionPoint> points;
    double magnitude = 0;
    for (const EdgePortion& portion : portions) {
        if (portion.part != g.part) continue;
        for (const BoundaryPoint& p : points_of(g, portion)) {
            const Vec2 t = traction_at(load, g.frame.to_global(p.x), g.frame.vector_to_global(p.normal), total);
            points.push_back({p.cell, p.x, p.weight, g.frame.vector_to_local(t)});
            magnitude += p.weight * g.input.thickness * t.norm();
        }
    }
    if (points.empty()) return;
    result.vector += boundary_load(g.input, points);
    result.scale = std::max(result.scale, magnitude);
}

void add_volume_load(const Scene& scene, const Load& load, const PartOnGrid& g, PartLoad& result) {
    double largest = 0;
    result.vector += body_load(g.input, [&](const Vec2& local) -> Vec2 {
        const Vec2 force = volume_force(scene, load, g, g.frame.to_global(local));
        largest = std::max(largest, force.norm());
        return g.frame.vector_to_local(force);
    });
    result.scale = std::max(result.scale, largest * g.area * g.input.thickness);
}

/// Value that a support prescribes for component c, where it is one number.
std::optional<double> constant_value(const Support& s, int c) {
    if (s.kind == Support::Kind::symmetry || !(c == 0 ? s.x : s.y)) return std::nullopt;
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
    for (const Load& l : scene.loads) r.loads.push_back(resolve(l.on));
    append_contradictions(scene, r.supports, problems);
    if (!problems.empty()) throw InputError(problems);
    return r;
}

std::vector<SupportSet> support_sets(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& on_grid) {
    std::vector<SupportSet> sets;
    const bool may_align = scene.accuracy.dirichlet != "nitsche";
    for (std::size_t i = 0; i < scene.supports.size(); ++i)
        for (const Component& c : components_of(scene.supports[i]))
            append_sets(sets, on_grid, conditions.supports[i], static_cast<int>(i), c, may_align);
    return sets;
}

std::vector<solver::MeanConstraint> mean_constraints(const Scene& scene, const PartOnGrid& on_grid, int part) {
    std::vector<solver::MeanConstraint> constraints;
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
            c.area = on_grid.area;
            c.size = on_grid.size;
            c.integrals = solver::integrate_functions(on_grid.input);
            constraints.push_back(std::move(c));
        };
        if (s.rigid_x) add({1, 0}, 0, *s.rigid_x);
        if (s.rigid_y) add({0, 1}, 0, *s.rigid_y);
        if (s.rigid_rotation) add({0, 0}, 1, *s.rigid_rotation * on_grid.size);
    }
    return constraints;
}

PartLoad load_vector(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& on_grid) {
    PartLoad result{Eigen::VectorXd::Zero(2 * on_grid.input.space.n_functions), 0};
    for (std::size_t i = 0; i < scene.loads.size(); ++i) {
        if (is_edge_load(scene.loads[i]))
            add_edge_load(scene, scene.loads[i], conditions.loads[i], on_grid, result);
        else if (acts_on_volume_of(scene, scene.loads[i], on_grid.part))
            add_volume_load(scene, scene.loads[i], on_grid, result);
        if (!result.vector.allFinite())
            throw InputError(scene.loads[i].where,
                             "this load has no finite value everywhere on part " + scene.parts[at(on_grid.part)].name,
                             "check its expressions for divisions by zero and roots of negative numbers");
    }
    return result;
}

bool is_driven(const Scene& scene, const ResolvedConditions& conditions, int part) {
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
    else {
        what = s.kind == Support::Kind::fix ? "fix " : "displacement ";
        what += s.x && s.y ? "x, y" : (s.x ? "x" : "y");
    }
    std::string on;
    for (const Selector& selector : s.on)
        on += (on.empty() ? "" : ", ") + (selector.pattern.empty() ? selector.part + " (selected)" : selector.pattern);
    return what + " on " + on;
}

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
    std::vector<SupportMark> marks;
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        const Support& s = scene.supports[i];
        const bool both = s.x && s.y;
        along_portions(scene, conditions.supports[i], [&](const Vec2& x, const Vec2& n) {
            const bool normal_is_x = std::abs(n.x()) > std::abs(n.y());
            const bool symmetry = s.kind == Support::Kind::symmetry;
            marks.push_back({x, n, both || (symmetry ? normal_is_x : s.x), both || (symmetry ? !normal_is_x : s.y)});
        });
        if (s.kind == Support::Kind::rigid)
            for (const ScenePart& part : scene.parts)
                if (part.name == s.part)
                    marks.push_back({centroid(part.part), {0, -1}, s.rigid_x.has_value(), s.rigid_y.has_value()});
    }
    return marks;
}

std::vector<LoadMark> load_marks(const Scene& scene, const ResolvedConditions& conditions) {
    std::vector<LoadMark> marks;
    const auto add = [&](const Vec2& x, const Vec2& direction) {
        if (direction.norm() > 0) marks.push_back({x, direction.normalized()});
    };
    for (std::size_t i = 0; i < scene.loads.size(); ++i) {
        const Load& load = scene.loads[i];
        along_portions(scene, conditions.loads[i], [&](const Vec2& x, const Vec2& n) { add(x, traction_at(load, x, n, 1)); });
        if (is_edge_load(load)) continue;
        for (std::size_t p = 0; p < scene.parts.size(); ++p)
            if (acts_on_volume_of(scene, load, static_cast<int>(p))) {
                const Vec2 c = centroid(scene.parts[p].part);
                add(c, {load.value[0](c.x(), c.y()), load.value[1](c.x(), c.y())});
            }
    }
    return marks;
}

}  // namespace abut
