// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/load_vector.hpp"

#include <algorithm>
#include <cmath>

#include "solver/assembly/ring.hpp"
#include "solver/terms/free_strain.hpp"
#include "solver/terms/solution_structure.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/discretization/boundary_points.hpp"
#include "src/plan/loads.hpp"

namespace abut {

namespace {

using geometry::BoundaryPoint;

void add_edge_load(const Scene& scene, const Load& load, const std::vector<EdgePortion>& portions, const PartOnGrid& g,
                   PartLoad& result) {
    std::vector<solver::TractionPoint> points;
    double magnitude = 0;
    const auto is_here = [&](const EdgePortion& portion) { return portion.part == g.part; };
    if (std::none_of(portions.begin(), portions.end(), is_here)) return;
    MeteredCall call(result.uses, effect_of(load));
    const EdgeTraction spread = edge_traction(scene, load, portions);
    const EdgeField traction = [&](const Vec2& x, const Vec2& normal) -> Vec2 {
        return g.frame.vector_to_local(traction_at(load, spread, g.frame.to_global(x), g.frame.vector_to_global(normal)));
    };
    const bool is_even = load.value[0].is_constant() && load.value[1].is_constant();
    for (const EdgePortion& whole : portions) {
        if (!is_here(whole)) continue;
        for (const EdgePortion& portion : is_even ? std::vector{whole} : cut_where_rough(g, whole, traction))
            for (const BoundaryPoint& p : boundary_points(g, portion)) {
                points.push_back({p.element, p.x, p.weight, traction(p.x, p.normal)});
                magnitude += p.weight * g.input.thickness * points.back().traction.norm();
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
    const PartMeasure measure = part_measure(scene.parts[at(g.part)].part, load, volume);
    const auto at_point = [&](const Vec2& local) -> Vec2 {
        call.count(1);
        const Vec2 force = volume_force(scene, load, g.part, measure, g.frame.to_global(local));
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

PartLoad load_vector(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& on_grid) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    ENSURE(on_grid.part >= 0 && at(on_grid.part) < scene.parts.size(), "the part is one of the scene");
    PartLoad result;
    result.vector = Eigen::VectorXd::Zero(2 * on_grid.input.space.n_functions);
    if (on_grid.input.structure) result.weighted = result.vector;
    for (std::size_t i = 0; i < scene.loads.size(); ++i) {
        if (scene.loads[i].kind == Load::Kind::temperature)
            check_temperature(scene, scene.loads[i], on_grid, result);
        else if (scene.loads[i].kind == Load::Kind::preload)
            continue;  // shortens the part, after it is put together
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
