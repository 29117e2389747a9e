// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/stress.hpp"

#include "solver/dilatation.hpp"
#include "solver/ring.hpp"

namespace abut::solver {

StressOf::StressOf(const PartInput& input, const Eigen::VectorXd& displacement) : input_(input), displacement_(displacement) {
    if (input.is_projected) pressure_ = pressure(dilatation_of(input), displacement);
}

Eigen::Vector3d StressOf::operator()(int element, const Vec2& x) const {
    return (*this)(element, x, displacement_at(input_, displacement_, element, x));
}

void StressOf::add_pressure(int element, const Vec2& x, double* stress, int n) const {
    const PointBasis b = evaluate(input_.dilatation->space, element, x);
    for (std::size_t i = 0; i < b.functions.size(); ++i)
        for (int k = 0; k < n; ++k) stress[k] += b.value[static_cast<Eigen::Index>(i)] * pressure_[b.functions[i]];
}

Eigen::Vector3d StressOf::operator()(int element, const Vec2& x, const DisplacementAt& u) const {
    const Elasticity d = local_elasticity(input_);
    Eigen::Vector3d s = stress_of(d, u.gradient);
    if (input_.axis) s.head<2>().array() += d.d12 * hoop_strain(input_, x, u);
    if (input_.free_strain) s.head<2>().array() -= d.expansion * input_.free_strain(x);
    if (input_.is_projected) add_pressure(element, x, s.data(), 2);
    return s;
}

double StressOf::zz(int element, const Vec2& x) const {
    const DisplacementAt u = displacement_at(input_, displacement_, element, x);
    const double free = input_.free_strain ? input_.free_strain(x) : 0;
    if (!input_.axis) {
        const Eigen::Vector3d s = (*this)(element, x, u);
        return input_.elasticity.out_of_plane * (s[0] + s[1]) - input_.elasticity.expansion_zz * free;
    }
    const Elasticity d = local_elasticity(input_);
    double s = d.d11 * hoop_strain(input_, x, u) + d.d12 * u.gradient.trace() - d.expansion * free;
    if (input_.is_projected) add_pressure(element, x, &s, 1);
    return s;
}

}  // namespace abut::solver
