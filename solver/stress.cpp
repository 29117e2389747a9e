// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/stress.hpp"

#include "solver/dilatation.hpp"
#include "solver/local_spline.hpp"
#include "solver/solution_structure.hpp"

namespace abut::solver {

StressOf::StressOf(const PartInput& input, const Eigen::VectorXd& displacement) : input_(input), displacement_(displacement) {
    if (input.is_projected) pressure_ = pressure(dilatation_of(input), displacement);
}

StressOf::OnElement::OnElement(const StressOf& stress, int element) : stress_(stress), element_(element) {
    if (!stress.input_.structure) displacement_.emplace(local_displacement(stress.input_.space, stress.displacement_, element));
}

Eigen::Vector3d StressOf::OnElement::operator()(const Vec2& x) const {
    return displacement_ ? stress_(element_, x, displacement_->at(x).gradient) : stress_(element_, x);
}

Eigen::Vector3d StressOf::operator()(int element, const Vec2& x) const {
    return (*this)(element, x, displacement_at(input_, displacement_, element, x).gradient);
}

Eigen::Vector3d StressOf::operator()(int element, const Vec2& x, const Eigen::Matrix2d& gradient) const {
    Eigen::Vector3d s = stress_of(local_elasticity(input_), gradient);
    if (!input_.is_projected) return s;
    const LocalSpline<1> pressure(input_.dilatation->space, element,
                                  [&](int function) { return pressure_.segment<1>(function); });
    s.head<2>().array() += pressure.value(x)[0];
    return s;
}

}  // namespace abut::solver
