// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/free_strain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/assembly/ring.hpp"
#include "solver/terms/solution_structure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Weights of a rule times the stress that its free strain has when restrained.
VectorXd restrained(const PartInput& input, const CellRule& rule) {
    const double modulus = input.thickness * local_elasticity(input).expansion;
    VectorXd w(static_cast<Index>(rule.points.size()));
    for (std::size_t k = 0; k < rule.points.size(); ++k)
        w[static_cast<Index>(k)] = modulus * rule.weights[k] * input.free_strain(rule.points[k]);
    return w;
}

/// Twice the energy per volume.
double twice_density(const PartInput& input, const Vec2& x, const DisplacementAt& u) {
    const Elasticity d = local_elasticity(input);
    const bool has_zz = input.axis || d.expansion_zz != 0;
    const double free = input.free_strain ? input.free_strain(x) : 0;
    const double xx = u.gradient(0, 0) - free, yy = u.gradient(1, 1) - free, xy = u.gradient(0, 1) + u.gradient(1, 0);
    const double zz = has_zz ? (input.axis ? hoop_strain(input, x, u) : 0) - free : 0;
    return d.d11 * (xx * xx + yy * yy + zz * zz) + 2 * d.d12 * (xx * yy + yy * zz + zz * xx) + d.d33 * xy * xy;
}

}  // namespace

VectorXd free_strain_load(const PartInput& input) {
    VectorXd load = VectorXd::Zero(2 * input.space.n_functions);
    Sampled at;
    for_all_cells(input, [&](const CellRule& rule) {
        sample(input.space, rule.element, rule.points, at);
        const Extraction e = extraction(input.space, rule.element);
        const VectorXd w = restrained(input, rule);
        add_to_component(load, 0, e, at.dx.transpose() * w);
        add_to_component(load, 1, e, at.dy.transpose() * w);
        if (!input.axis) return;
        VectorXd over_r = w;
        for (std::size_t k = 0; k < rule.points.size(); ++k) over_r[static_cast<Index>(k)] /= radius(input, rule.points[k]);
        add_to_component(load, 0, e, at.value.transpose() * over_r);
    });
    return load;
}

double largest_restrained_stress(const PartInput& input) {
    double largest = 0;
    bool is_finite = true;
    for_all_cells(input, [&](const CellRule& rule) {
        for (const Vec2& x : rule.points) {
            const double strain = std::abs(input.free_strain(x));
            is_finite = is_finite && std::isfinite(strain);
            largest = std::max(largest, strain);
        }
    });
    return is_finite ? input.elasticity.expansion * largest : std::numeric_limits<double>::quiet_NaN();
}

double elastic_energy(const PartInput& input, const VectorXd& displacement) {
    double twice = 0;
    for_all_cells(input, [&](const CellRule& rule) {
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const DisplacementAt u = displacement_at(input, displacement, rule.element, rule.points[k]);
            twice += rule.weights[k] * twice_density(input, rule.points[k], u);
        }
    });
    return 0.5 * input.thickness * twice;
}

}  // namespace abut::solver
