// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/rigid_part.hpp"

#include "geometry/curves/gauss.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/discretization/around_axis.hpp"
#include "src/discretization/boundary_points.hpp"
#include "src/discretization/support_sets.hpp"
#include "src/io/number_text.hpp"
#include "src/plan/support_components.hpp"

namespace abut {

namespace {

using geometry::BoundaryPoint;
using solver::MotionCondition;

constexpr int cells_across = 6;  // for the quadrature of loads that vary
constexpr int rule_degree = 3;

geometry::Grid coarse_grid(const geometry::Part& local) {
    const geometry::Box2 box = bounding_box(local);
    geometry::Grid grid;
    for (int k = 0; k <= cells_across; ++k) {
        const double t = static_cast<double>(k) / cells_across;
        grid.x.push_back((1 - t) * box.min.x() + t * box.max.x());
        grid.y.push_back((1 - t) * box.min.y() + t * box.max.y());
    }
    return grid;
}

void append_edges(const Support& support, int tag, const std::vector<EdgePortion>& portions, const PartOnGrid& g,
                  std::vector<MotionCondition>& conditions) {
    for (const HeldComponent& c : components_of(support))
        for (const EdgePortion& portion : portions) {
            if (portion.part != g.part) continue;
            for (const BoundaryPoint& p : boundary_points(g, portion)) {
                const Vec2 global = g.frame.to_global(p.x),
                           along = c.direction ? g.frame.vector_to_local(*c.direction) : p.normal;
                const double value = c.value ? (*c.value)(global.x(), global.y()) : 0.0;
                conditions.push_back(solver::held_point(tag, p.x, g.center, along, value, p.weight));
            }
        }
}

/// Mean displacement and rotation of a rigid part are its motion.
void append_motion(const Support& s, int tag, const PartOnGrid& g, std::vector<MotionCondition>& conditions) {
    const auto along = [&](const Vec2& direction, double value) {
        conditions.push_back(solver::held_point(tag, g.center, g.center, g.frame.vector_to_local(direction), value, g.size));
    };
    if (s.rigid_x) along({1, 0}, *s.rigid_x);
    if (s.rigid_y) along({0, 1}, *s.rigid_y);
    if (s.rigid_rotation) conditions.push_back({tag, {0, 0, g.size}, *s.rigid_rotation * g.size, g.size});
}

void append_points(const Support& s, int tag, const PartOnGrid& g, std::vector<MotionCondition>& conditions) {
    for (const Vec2& p : s.at)
        for (int c = 0; c < 2; ++c)
            if (c == 0 ? s.x : s.y)
                conditions.push_back(
                    solver::held_point(tag, g.frame.to_local(p), g.center, g.frame.vector_to_local(Vec2::Unit(c)), 0, g.size));
}

}  // namespace

PartOnGrid put_rigid_part(const Scene& scene, int part) {
    ENSURE(part >= 0 && at(part) < scene.parts.size(), "the part is one of the scene");
    const ScenePart& source = scene.parts[at(part)];
    PartOnGrid g;
    g.part = part;
    g.is_rigid = true;
    g.frame = frame_for(source.part, 0);
    g.local = transformed(source.part, g.frame.c, -g.frame.s, -g.frame.shift);
    g.cells = cut_cells(g.local, coarse_grid(g.local));
    g.elements = find_elements(g.local, g.cells);
    g.area = area(g.local);
    g.size = bounding_box(g.local).diagonal();
    g.center = centroid(g.local);
    g.input.space = solver::make_space({solver::clamped_knots(g.cells.grid.x, 1),
                                        solver::clamped_knots(g.cells.grid.y, 1),
                                        g.elements.fraction,
                                        {g.elements.cell_of_extra, g.elements.neighbours},
                                        solver::Basis::plain,
                                        {}});
    for (geometry::CellRule& rule : cell_rules(g.local, g.cells, g.elements, rule_degree))
        g.input.cut_rules.push_back({rule.element, std::move(rule.points), std::move(rule.weights)});
    const geometry::GaussRule& line = geometry::gauss_rule(rule_degree + 1);
    g.input.line_rule = {line.points, line.weights};
    g.input.elasticity = {};
    g.input.thickness = source.thickness;
    if (scene.analysis == Analysis::axisymmetric) put_around_axis(scene, g);
    return g;
}

solver::PartSystem rigid_system(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& g,
                                const PartLoad& load) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    ENSURE(g.is_rigid, "a rigid part is asked for");
    std::vector<MotionCondition> held;
    int last = 0;
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        const Support& s = scene.supports[i];
        const std::size_t before = held.size();
        const int tag = static_cast<int>(i);
        append_edges(s, tag, conditions.supports[i], g, held);
        if (s.part == scene.parts[at(g.part)].name) {
            if (s.kind == Support::Kind::rigid) append_motion(s, tag, g, held);
            if (s.kind == Support::Kind::points) append_points(s, tag, g, held);
        }
        if (held.size() > before) last = tag;
    }
    solver::PartSystem system =
        solver::make_rigid_system(g.input, std::move(held), load.vector, g.center, g.size, spring_sets(scene, conditions, g));
    if (!is_consistent(*system.body))
        throw InputError(scene.supports[at(last)].where,
                         "the supports of the rigid part " + scene.parts[at(g.part)].name +
                             " prescribe displacements that no rigid motion has (off by " +
                             number_text(system.body->contradiction, 3) + ")",
                         "prescribe one motion, or make the part elastic");
    return system;
}

}  // namespace abut
