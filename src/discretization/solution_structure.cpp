// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/solution_structure.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "geometry/curves/gauss.hpp"
#include "geometry/quadrature/transformed_gauss.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/discretization/boundary_points.hpp"
#include "src/discretization/weight_fields.hpp"
#include "src/scene/dissertation_method.hpp"

namespace abut {

namespace {

using geometry::Jet;

bool has_rigid_support(const Scene& scene, const PartOnGrid& g) {
    return std::any_of(scene.supports.begin(), scene.supports.end(), [&](const Support& s) {
        return s.kind == Support::Kind::rigid && s.part == scene.parts[at(g.part)].name;
    });
}

bool is_asked_for(const Scene& scene) {
    return scene.accuracy.dirichlet == "solution_structure";
}

/// Axes of the grid that a support holds along a whole edge, as far as weights can do that.
std::vector<int> held_axes(const Support& support, const PartOnGrid& g, int edge) {
    const geometry::Curve& curve = g.local.edges[at(edge)].curve;
    if (support.kind == Support::Kind::symmetry) {
        const auto axis =
            std::holds_alternative<geometry::Segment>(curve) ? grid_axis(outward_normal(curve, 0.5)) : std::nullopt;
        return axis ? std::vector<int>{*axis} : std::vector<int>{};
    }
    if (support.x && support.y) return {0, 1};
    const auto axis = grid_axis(g.frame.vector_to_local(support.x ? Vec2(1, 0) : Vec2(0, 1)));
    return axis ? std::vector<int>{*axis} : std::vector<int>{};
}

bool holds_edges(const Support& s) {
    return s.kind == Support::Kind::fix || s.kind == Support::Kind::displacement || s.kind == Support::Kind::symmetry;
}

/// The edges of one support, each component that no support before holds already.
void add_edges(std::vector<HeldByWeight>& all, int support, const Support& s, const std::vector<EdgePortion>& portions,
               const PartOnGrid& g, std::set<std::pair<int, int>>& taken) {
    std::array<HeldByWeight, 2> held{HeldByWeight{support, 0, {}, {}}, HeldByWeight{support, 1, {}, {}}};
    for (const EdgePortion& p : portions) {
        if (p.part != g.part || p.t0 != 0 || p.t1 != 1) continue;
        for (int axis : held_axes(s, g, p.edge))
            if (taken.insert({p.edge, axis}).second) held[at(axis)].edges.push_back(p.edge);
    }
    for (const HeldByWeight& h : held)
        if (!h.edges.empty()) all.push_back(h);
}

void add_points(std::vector<HeldByWeight>& all, int support, const Support& s, const PartOnGrid& g) {
    std::vector<Vec2> points;
    for (const Vec2& p : s.at) points.push_back(g.frame.to_local(p));
    if (held_axes(s, g, 0).empty())
        throw InputError(s.where, "points can be held in one direction only where the part's grid lies along it",
                         "fix both components, or take away the grid's angle");
    for (int axis : held_axes(s, g, 0)) all.push_back({support, axis, {}, points});
}

/// Value that a support prescribes along an axis of the grid, as a function of the grid's coordinates; its gradient by central
/// differences of fourth order, exact for quartics but for rounding.
JetField prescribed_value(const Support& s, int axis, const PartOnGrid& g) {
    const Vec2 direction = g.frame.vector_to_global(Vec2::Unit(axis));
    const auto value = [s, direction, frame = g.frame](const Vec2& local) {
        const Vec2 x = frame.to_global(local);
        double sum = 0;
        for (int c = 0; c < 2; ++c)
            if (c == 0 ? s.x : s.y) sum += direction[c] * s.value[at(c)](x.x(), x.y());
        return sum;
    };
    constexpr double step_fraction = 1e-3;  // of the part's size: truncation and rounding both near 1e-12
    return [value, h = step_fraction * g.size](const Vec2& p) -> Jet {
        const auto slope = [&](const Vec2& d) {
            return (8 * (value(p + d) - value(p - d)) - (value(p + 2 * d) - value(p - 2 * d))) / (12 * h);
        };
        return {value(p), slope({h, 0}), slope({0, h}), 0, 0, 0};
    };
}

bool prescribes_zero(const Support& s) {
    if (s.kind != Support::Kind::displacement) return true;
    const auto zero = [](const Expression& e) { return e.is_constant() && e.constant() == 0; };
    return (!s.x || zero(s.value[0])) && (!s.y || zero(s.value[1]));
}

/// The part's geometry in the grid's frame.
geometry::CsgNode local_tree(const Scene& scene, const PartOnGrid& g) {
    const ScenePart& part = scene.parts[at(g.part)];
    if (!part.tree) return {geometry::Imported{g.local}, "", part.where};
    return geometry::transformed(*part.tree, g.frame.c, -g.frame.s, -g.frame.shift);
}

std::vector<WeightField> fields_of(const Scene& scene, const HeldByWeight& held, const PartOnGrid& g) {
    if (held.edges.empty()) return {point_weight(held.points, g.size)};
    return edge_fields(g.local, held.edges, g.size, edge_weights(scene.accuracy.weights), local_tree(scene, g));
}

/// phi of a component; empty where nothing but zeros is prescribed.
JetField data_of(const Scene& scene, const std::vector<HeldByWeight>& held, const PartOnGrid& g) {
    std::vector<PrescribedField> fields;
    std::vector<WeightField> zeros;
    for (const HeldByWeight& h : held) {
        const Support& s = scene.supports[at(h.support)];
        const std::vector<WeightField> own = fields_of(scene, h, g);
        if (prescribes_zero(s))
            zeros.insert(zeros.end(), own.begin(), own.end());
        else
            fields.push_back({conjoined(own), prescribed_value(s, h.component, g)});
    }
    if (fields.empty()) return {};
    if (!zeros.empty()) fields.push_back({conjoined(zeros), [](const Vec2&) { return Jet(0); }});
    return blended(fields);
}

/// Untrimmed weights must not hold the part where no support does.
void check_whole(const Scene& scene, const std::vector<HeldByWeight>& held, const std::vector<int>& edges,
                 const PartOnGrid& g) {
    const std::optional<int> more = edge_that_holds_more(g.local, edges, g.size, local_tree(scene, g));
    if (!more) return;
    const auto its = std::find_if(held.begin(), held.end(), [&](const HeldByWeight& h) {
        return std::find(h.edges.begin(), h.edges.end(), *more) != h.edges.end();
    });
    throw InputError(scene.supports[at(its->support)].where,
                     "as an R-function the whole line or circle of edge " + g.local.edges[at(*more)].name +
                         " would hold part " + g.local.name + " where it goes on inside it",
                     "give accuracy.weights \"joined\", which end where the edge does");
}

WeightField weight_of(const Scene& scene, const std::vector<HeldByWeight>& held, const PartOnGrid& g) {
    std::vector<int> edges;
    std::vector<Vec2> points;
    for (const HeldByWeight& h : held) {
        edges.insert(edges.end(), h.edges.begin(), h.edges.end());
        points.insert(points.end(), h.points.begin(), h.points.end());
    }
    const EdgeWeights how = edge_weights(scene.accuracy.weights);
    if (how == EdgeWeights::r_function) check_whole(scene, held, edges, g);
    std::vector<WeightField> fields = edge_fields(g.local, edges, g.size, how, local_tree(scene, g));
    if (!points.empty()) fields.push_back(point_weight(points, g.size));
    return conjoined(fields);
}

/// Gauss points of a full cell.
solver::CellRule full_cell_rule(const geometry::Grid& grid, int cell, int n) {
    const geometry::Box2 box = grid.box(cell);
    const geometry::GaussRule& line = geometry::gauss_rule(n);
    const Vec2 size = box.size();
    solver::CellRule rule{cell, {}, {}};
    for (std::size_t b = 0; b < line.points.size(); ++b)
        for (std::size_t a = 0; a < line.points.size(); ++a) {
            rule.points.emplace_back(box.min + Vec2(line.points[a], line.points[b]).cwiseProduct(size));
            rule.weights.push_back(line.weights[a] * line.weights[b] * size.x() * size.y());
        }
    return rule;
}

/// Where weights have no derivatives: ends of held edges, and held points.
std::vector<Vec2> kinks_of(const std::vector<HeldByWeight>& held, const PartOnGrid& g) {
    std::vector<Vec2> kinks;
    for (const HeldByWeight& h : held) {
        kinks.insert(kinks.end(), h.points.begin(), h.points.end());
        for (int e : h.edges)
            for (double t : {0.0, 1.0}) kinks.push_back(point(g.local.edges[at(e)].curve, t));
    }
    return kinks;
}

/// Which cells have a kink in them or next to them.
std::vector<char> cells_at(const std::vector<Vec2>& kinks, const geometry::Grid& grid) {
    std::vector<char> is_at(at(grid.n_cells()), 0);
    for (const Vec2& p : kinks) grid.for_cells_in(grid.box(grid.cell_at(p)), [&](int cell) { is_at[at(cell)] = 1; });
    return is_at;
}

/// Rules of all elements: exact for the space's functions times linear weights, with extra points for others.
std::vector<solver::CellRule> rules_of(const PartOnGrid& g, const std::vector<HeldByWeight>& held, bool is_polynomial) {
    const int degree = std::max(g.input.space.x.degree, g.input.space.y.degree) + 1;
    const int far = is_polynomial ? 0 : extra_points_elsewhere, near = is_polynomial ? 0 : extra_points_at_kinks;
    const std::vector<char> at_kink = cells_at(kinks_of(held, g), g.cells.grid);
    std::vector<solver::CellRule> rules;
    for (int cell = 0; cell < g.input.space.n_cells(); ++cell)
        if (g.input.space.fraction[at(cell)] == 1)
            rules.push_back(full_cell_rule(g.cells.grid, cell, degree + 1 + (at_kink[at(cell)] ? near : far)));
    std::vector<geometry::CellRule> cut = transformed_rules(g.local, g.cells, g.elements, degree, far), finer;
    if (near != far) finer = transformed_rules(g.local, g.cells, g.elements, degree, near);
    for (std::size_t k = 0; k < cut.size(); ++k) {
        const bool is_near = near != far && at_kink[at(g.elements.cell_of(cut[k].element))];
        geometry::CellRule& rule = is_near ? finer[k] : cut[k];
        rules.push_back({rule.element, std::move(rule.points), std::move(rule.weights)});
    }
    return rules;
}

/// Divides w N by the largest w in its support [Grishin10, eq 4.1], as the rules' points see it.
void divide_by_extremes(const PartOnGrid& g, solver::SolutionStructure& s) {
    for (std::size_t c = 0; c < 2; ++c) {
        if (!s.weight[c]) continue;
        Eigen::VectorXd largest = Eigen::VectorXd::Zero(g.input.space.n_functions);
        for (const solver::CellRule& rule : s.rules) {
            double w = 0;
            for (const Vec2& p : rule.points) w = std::max(w, std::abs(s.weight[c](p).value));
            for (const int f : extraction(g.input.space, rule.element).functions) largest[f] = std::max(largest[f], w);
        }
        s.scale[c] = largest.unaryExpr([](double w) { return w > 0 ? 1 / w : 1; });
    }
}

void check_finite(const Scene& scene, const PartOnGrid& g, const solver::SolutionStructure& s) {
    for (const solver::ScalarField& phi : s.data)
        for (const solver::CellRule& rule : s.rules)
            for (const Vec2& p : rule.points) {
                if (!phi) continue;
                const solver::ScalarAt v = phi(p);
                if (std::isfinite(v.value) && v.gradient.allFinite()) continue;
                const Vec2 x = g.frame.to_global(p);
                throw InputError(scene.parts[at(g.part)].where,
                                 "a prescribed displacement has no finite value at (" + std::to_string(x.x()) + ", " +
                                     std::to_string(x.y()) + ") inside part " + g.local.name +
                                     ", where the solution structure continues it",
                                 "give expressions that are finite in the whole part, or take dirichlet \"nitsche\"");
            }
}

}  // namespace

std::vector<HeldByWeight> held_by_weight(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& g) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    std::vector<HeldByWeight> held;
    if (!is_asked_for(scene) || has_rigid_support(scene, g)) return held;
    std::set<std::pair<int, int>> taken;
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        const Support& s = scene.supports[i];
        if (s.kind == Support::Kind::points && s.part == scene.parts[at(g.part)].name)
            add_points(held, static_cast<int>(i), s, g);
        else if (holds_edges(s))
            add_edges(held, static_cast<int>(i), s, conditions.supports[i], g, taken);
    }
    return held;
}

std::string why_not_by_weight(const Scene& scene, int support, const PartOnGrid& g) {
    if (!is_asked_for(scene)) return "";
    if (has_rigid_support(scene, g)) return "no weight functions beside a rigid support";
    if (scene.supports[at(support)].kind == Support::Kind::symmetry)
        return "weights hold straight whole edges along the grid's axes only";
    return "weights hold whole edges, in both components or along the grid's axes, once";
}

std::shared_ptr<const solver::SolutionStructure> make_structure(const Scene& scene, const ResolvedConditions& conditions,
                                                                const PartOnGrid& g) {
    const std::vector<HeldByWeight> all = held_by_weight(scene, conditions, g);
    if (all.empty()) return nullptr;
    auto structure = std::make_shared<solver::SolutionStructure>();
    bool is_polynomial = true;
    for (int c = 0; c < 2; ++c) {
        std::vector<HeldByWeight> held;
        std::copy_if(all.begin(), all.end(), std::back_inserter(held), [&](const HeldByWeight& h) { return h.component == c; });
        if (held.empty()) continue;
        const WeightField weight = weight_of(scene, held, g);
        structure->weight[at(c)] = scalar_field(weight.field, g.center);
        const JetField data = data_of(scene, held, g);
        if (data) structure->data[at(c)] = scalar_field(data, g.center);
        is_polynomial = is_polynomial && weight.is_linear && !data;
    }
    structure->rules = rules_of(g, all, is_polynomial);
    if (is_by_dissertation(scene)) divide_by_extremes(g, *structure);
    check_finite(scene, g, *structure);
    return structure;
}

}  // namespace abut
