// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/rigid_parts.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/curves/gauss.hpp"
#include "src/discretization/load_vector.hpp"
#include "src/io/number_text.hpp"
#include "src/plan/axisymmetric.hpp"
#include "src/plan/support_components.hpp"
#include "src/scene/selection.hpp"
#include "src/solution/contact_pairing.hpp"

namespace abut {

namespace {

using geometry::BoundaryPoint;
using solver::MotionCondition;

constexpr int cells_across = 6;  // for the quadrature of loads that vary
constexpr int rule_degree = 3;
constexpr int sampled_pairs = 200;  // along a candidate between rigid parts
/// Rigid faces that overlap by more than this fraction of the smaller diagonal press on each other.
constexpr double pressed_fraction = 1e-6;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

const Material& material_of(const Scene& scene, int part) {
    return scene.materials[at(scene.parts[at(part)].material)];
}

bool can_touch(const PartReach& reach, int i, int j) {
    return reach.within(i, j, reach.searched(i, j, 1));
}

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

void refuse_springs(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& g) {
    for (std::size_t i = 0; i < scene.supports.size(); ++i)
        for (const EdgePortion& p : conditions.supports[i])
            if (scene.supports[i].kind == Support::Kind::spring && p.part == g.part)
                throw InputError(scene.supports[i].where,
                                 "part " + scene.parts[at(g.part)].name + " is rigid, and rests on springs",
                                 "springs need an elastic part: give it a material of its own");
}

/// How deep two rigid parts overlap along a candidate after the solution.
double depth_of(const Scene& scene, const SolvedAssembly& solved, const Candidate& c) {
    const std::array<int, 2> parts{c.first, c.second};
    double deepest = 0, guess = c.zone.begin2;
    for (int k = 0; k <= sampled_pairs; ++k) {
        const double t = static_cast<double>(k) / sampled_pairs;
        const auto pair = pair_from_first(scene.parts[at(c.first)].part, scene.parts[at(c.second)].part, c.zone,
                                          (1 - t) * c.zone.begin1 + t * c.zone.end1, guess);
        if (!pair.found) continue;
        guess = pair.s2;
        double gap = pair.gap - c.closing;
        for (std::size_t side = 0; side < 2; ++side) {
            const std::size_t i = at(solved.solver_part[at(parts[side])]);
            const PartOnGrid& g = solved.grids[i];
            const Vec2 x = g.frame.to_local(side == 0 ? pair.on1.x : pair.on2.x);
            const auto u = solver::displacement_at(g.input, solved.solution.displacement[i],
                                                   element_at(g.local, g.cells, g.elements, x), x);
            gap += (side == 0 ? -1 : 1) * pair.normal.dot(g.frame.vector_to_global(u.value));
        }
        deepest = std::max(deepest, -gap);
    }
    return deepest;
}

bool is_on(const Scene& scene, const Selection& selection, int part) {
    const std::vector<EdgePortion> portions = select(scene, selection);
    return std::any_of(portions.begin(), portions.end(), [&](const EdgePortion& p) { return p.part == part; });
}

/// Would a part's own deformation show, however stiff it is? It does where it grows by temperature, rests on springs or has
/// displacements given, and where its own loads bend it between its supports.
bool deforms_by_itself(const Scene& scene, int part) {
    bool held = false, loaded = false;
    for (const Support& s : scene.supports) {
        if (s.part != scene.parts[at(part)].name && !is_on(scene, s.on, part)) continue;
        if (s.kind == Support::Kind::spring || s.kind == Support::Kind::displacement) return true;
        held = held || s.kind == Support::Kind::fix || s.kind == Support::Kind::points;  // the others are guides
    }
    for (const Load& load : scene.loads) {
        if (is_edge_load(load) ? !is_on(scene, load.on, part) : !acts_on_volume_of(scene, load, part)) continue;
        if (load.kind == Load::Kind::temperature) return true;
        loaded = true;
    }
    return held && loaded;
}

}  // namespace

std::string why_rigid(const Scene& scene, int part) {
    const Material& own = material_of(scene, part);
    if (own.rigid) return "its material is \"rigid\"";
    const auto is_softer = [&](const Material& m) { return own.E > rigid_stiffness_ratio * m.E; };
    if (std::none_of(scene.materials.begin(), scene.materials.end(), is_softer)) return "";
    const PartReach reach(scene);
    bool has_neighbour = false;
    for (int j = 0; j < static_cast<int>(scene.parts.size()); ++j) {
        if (j == part) continue;
        const bool softer = is_softer(material_of(scene, j));
        if (!softer && !can_touch(reach, part, j)) continue;
        if (!softer) return "";
        has_neighbour = has_neighbour || can_touch(reach, part, j);
    }
    if (!has_neighbour || deforms_by_itself(scene, part)) return "";
    return "it is stiffer than all that it can touch by more than " + number_text(rigid_stiffness_ratio, 2);
}

PartOnGrid put_rigid_part(const Scene& scene, int part) {
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
    refuse_springs(scene, conditions, g);
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
    solver::PartSystem system = solver::make_rigid_system(g.input, std::move(held), load.vector, g.center, g.size);
    if (!is_consistent(*system.body))
        throw InputError(scene.supports[at(last)].where,
                         "the supports of the rigid part " + scene.parts[at(g.part)].name +
                             " prescribe displacements that no rigid motion has (off by " +
                             number_text(system.body->contradiction, 3) + ")",
                         "prescribe one motion, or make the part elastic");
    return system;
}

std::string rigid_pair_failure(const Scene& scene, const Outcome& out) {
    for (const Candidate& c : out.candidates) {
        const int a = out.solved.solver_part[at(c.first)], b = out.solved.solver_part[at(c.second)];
        if (a < 0 || b < 0 || !out.solved.grids[at(a)].is_rigid || !out.solved.grids[at(b)].is_rigid) continue;
        const double size = std::min(out.solved.grids[at(a)].size, out.solved.grids[at(b)].size);
        const double depth = depth_of(scene, out.solved, c);
        if (depth > pressed_fraction * size)
            return "the rigid parts " + scene.parts[at(c.first)].name + " and " + scene.parts[at(c.second)].name +
                   " are pushed into each other by " + number_text(depth, 3) +
                   ": no pressure follows between rigid parts. Make one of them elastic";
    }
    return "";
}

}  // namespace abut
