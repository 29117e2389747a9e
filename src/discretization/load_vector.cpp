// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/load_vector.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/curves/gauss.hpp"
#include "solver/assembly/ring.hpp"
#include "solver/terms/free_strain.hpp"
#include "solver/terms/solution_structure.hpp"
#include "src/plan/support_components.hpp"

namespace abut {

namespace {

using geometry::BoundaryPoint;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Integral of the radius along a curve: the area that it sweeps around the axis, over 2 pi.
double length_times_radius(const geometry::Curve& curve, double t0, double t1) {
    constexpr int pieces = 16, points = 8;  // exact to rounding for arcs
    const geometry::GaussRule& rule = geometry::gauss_rule(points);
    double sum = 0;
    for (int k = 0; k < pieces; ++k)
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const double h = (t1 - t0) / pieces, t = t0 + h * (k + rule.points[q]);
            sum += std::abs(h) * rule.weights[q] * point(curve, t).x() * derivative(curve, t).norm();
        }
    return sum;
}

void add_edge_load(const Scene& scene, const Load& load, const std::vector<EdgePortion>& portions, const PartOnGrid& g,
                   PartLoad& result) {
    const double total = selected_area(scene, portions);
    std::vector<solver::TractionPoint> points;
    double magnitude = 0;
    const auto is_here = [&](const EdgePortion& portion) { return portion.part == g.part; };
    if (std::none_of(portions.begin(), portions.end(), is_here)) return;
    MeteredCall call(result.uses, effect_of(load));
    for (const EdgePortion& portion : portions) {
        if (!is_here(portion)) continue;
        for (const BoundaryPoint& p : boundary_points(g, portion)) {
            const Vec2 t = traction_at(load, g.frame.to_global(p.x), g.frame.vector_to_global(p.normal), total);
            points.push_back({p.element, p.x, p.weight, g.frame.vector_to_local(t)});
            magnitude += p.weight * g.input.thickness * t.norm();
        }
    }
    if (points.empty()) return;
    call.count(points.size());
    result.vector += boundary_load(g.input, points);
    if (g.input.structure) result.weighted += weighted_boundary_load(g.input, points);
    result.scale = std::max(result.scale, magnitude);
}

void add_volume_load(const Scene& scene, const Load& load, const PartOnGrid& g, PartLoad& result) {
    const double volume = g.input.axis ? solver::measure(g.input) : g.area;
    double largest = 0;
    MeteredCall call(result.uses, effect_of(load));
    const auto at_point = [&](const Vec2& local) -> Vec2 {
        call.count(1);
        const Vec2 force = volume_force(scene, load, g.part, volume, g.frame.to_global(local));
        largest = std::max(largest, force.norm());
        return g.frame.vector_to_local(force);
    };
    result.vector += body_load(g.input, at_point);
    if (g.input.structure) result.weighted += weighted_body_load(g.input, at_point);
    result.scale = std::max(result.scale, largest * volume * g.input.thickness);
}

/// A temperature is no load of its own: it is in the part's free strain. Rounding of the balance is relative to what it would
/// press with, restrained.
void check_temperature(const Scene& scene, const Load& load, const PartOnGrid& g, PartLoad& result) {
    if (!g.input.free_strain || !acts_on_volume_of(scene, load, g.part)) return;
    MeteredCall call(result.uses, effect_of(load));
    const double stress = solver::largest_restrained_stress(g.input);
    if (!std::isfinite(stress)) result.vector[0] = stress;
    result.scale = std::max(result.scale, stress * g.size * g.input.thickness);
}

}  // namespace

double selected_area(const Scene& scene, const std::vector<EdgePortion>& portions) {
    double sum = 0;
    for (const EdgePortion& p : portions) {
        const ScenePart& part = scene.parts[at(p.part)];
        const geometry::Curve& curve = part.part.edges[at(p.edge)].curve;
        sum += part.thickness *
               (scene.analysis == Analysis::axisymmetric ? length_times_radius(curve, p.t0, p.t1) : length(curve, p.t0, p.t1));
    }
    return sum;
}

Vec2 volume_force(const Scene& scene, const Load& load, int part, double volume, const Vec2& x) {
    const Vec2 value(load.value[0](x.x(), x.y()), load.value[1](x.x(), x.y()));
    const ScenePart& own = scene.parts[at(part)];
    if (load.kind == Load::Kind::spin) {
        const Vec2 arm = scene.analysis == Analysis::axisymmetric ? Vec2(x.x(), 0) : Vec2(x - load.about);
        return scene.materials[at(own.material)].density * load.omega * load.omega * arm;
    }
    if (load.kind == Load::Kind::part_force) return value / (volume * own.thickness);
    if (load.kind == Load::Kind::gravity) return value * scene.materials[at(own.material)].density;
    return value;
}

Vec2 traction_at(const Load& load, const Vec2& x, const Vec2& normal, double total_area) {
    const Vec2 value(load.value[0](x.x(), x.y()), load.value[1](x.x(), x.y()));
    if (load.kind == Load::Kind::pressure) return -value.x() * normal;
    if (load.kind == Load::Kind::edge_force) return value / total_area;
    return value;
}

std::function<double(const Vec2&)> free_strain(const Scene& scene, const PartOnGrid& on_grid) {
    std::vector<const Load*> loads;
    for (const Load& load : scene.loads)
        if (load.kind == Load::Kind::temperature && acts_on_volume_of(scene, load, on_grid.part)) loads.push_back(&load);
    const double expansion = scene.materials[at(scene.parts[at(on_grid.part)].material)].expansion.value_or(0);
    if (loads.empty() || expansion == 0) return {};
    return [loads, expansion, frame = on_grid.frame](const Vec2& local) {
        const Vec2 x = frame.to_global(local);
        double rise = 0;
        for (const Load* load : loads) rise += load->value[0](x.x(), x.y());
        return expansion * rise;
    };
}

bool is_edge_load(const Load& load) {
    return load.kind == Load::Kind::pressure || load.kind == Load::Kind::traction || load.kind == Load::Kind::edge_force;
}

std::string effect_of(const Load& load) {
    if (is_edge_load(load)) return "edge loads";
    switch (load.kind) {
        case Load::Kind::gravity:
            return "gravity";
        case Load::Kind::spin:
            return "spin";
        case Load::Kind::temperature:
            return "temperature";
        default:
            return "body force";
    }
}

bool acts_on_volume_of(const Scene& scene, const Load& load, int part) {
    if (load.kind == Load::Kind::gravity) return true;
    return !is_edge_load(load) && (load.part == "*" || load.part == scene.parts[at(part)].name);
}

PartLoad load_vector(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& on_grid) {
    PartLoad result;
    result.vector = Eigen::VectorXd::Zero(2 * on_grid.input.space.n_functions);
    if (on_grid.input.structure) result.weighted = result.vector;
    for (std::size_t i = 0; i < scene.loads.size(); ++i) {
        if (scene.loads[i].kind == Load::Kind::temperature)
            check_temperature(scene, scene.loads[i], on_grid, result);
        else if (is_edge_load(scene.loads[i]))
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

}  // namespace abut
