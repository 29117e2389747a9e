// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/stress.hpp"

#include "solver/assembly/ring.hpp"
#include "solver/splines/local_spline.hpp"
#include "solver/terms/dilatation.hpp"
#include "solver/terms/solution_structure.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

Eigen::VectorXd elastic_displacement(const PartInput& input, const Eigen::VectorXd& displacement) {
    return input.stress_free.size() > 0 ? Eigen::VectorXd(displacement - input.stress_free) : Eigen::VectorXd();
}

StressOf::StressOf(const PartInput& input, const Eigen::VectorXd& displacement)
    : input_(input),
      elastic_(elastic_displacement(input, displacement)),
      displacement_(elastic_.size() > 0 ? elastic_ : displacement) {
    ENSURE(displacement.size() == 2 * input.space.n_functions, "a displacement has two numbers for every function");
    if (input.is_projected) pressure_ = pressure(dilatation_of(input), displacement_);
}

StressOf::OnElement::OnElement(const StressOf& stress, int element) : stress_(stress), element_(element) {
    if (!stress.input_.structure) displacement_.emplace(local_displacement(stress.input_.space, stress.displacement_, element));
}

Eigen::Vector3d StressOf::OnElement::operator()(const Vec2& x) const {
    if (!displacement_) return stress_(element_, x);
    const SplineAt<2> u = displacement_->at(x);
    return stress_(element_, x, {u.value, u.gradient});
}

Eigen::Vector3d StressOf::OnElement::operator()(const Vec2& x, const LineValues& along_x, const LineValues& along_y) const {
    const SplineAt<2> u = displacement_->at(along_x, along_y);
    return stress_(element_, x, {u.value, u.gradient});
}

Eigen::Vector3d StressOf::operator()(int element, const Vec2& x) const {
    return (*this)(element, x, displacement_at(input_, displacement_, element, x));
}

double StressOf::volume_pressure(int element, const Vec2& x) const {
    const LocalSpline<1> pressure(input_.dilatation->space, element,
                                  [&](int function) { return pressure_.segment<1>(function); });
    return pressure.value(x)[0];
}

Eigen::Vector3d StressOf::operator()(int element, const Vec2& x, const DisplacementAt& u) const {
    const Elasticity d = local_elasticity(input_);
    Eigen::Vector3d s = stress_of(d, u.gradient);
    if (input_.axis) s.head<2>().array() += d.d12 * hoop_strain(input_, x, u);
    if (input_.free_strain) s.head<2>().array() -= d.expansion * input_.free_strain(x);
    if (input_.is_projected) s.head<2>().array() += volume_pressure(element, x);
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
    if (input_.is_projected) s += volume_pressure(element, x);
    return s;
}

}  // namespace abut::solver
