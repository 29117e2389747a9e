// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/loads.hpp"

#include <cmath>

#include "geometry/curves/gauss.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

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

}  // namespace abut
