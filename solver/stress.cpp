// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/stress.hpp"

#include "solver/dilatation.hpp"
#include "solver/solution_structure.hpp"

namespace abut::solver {

StressOf::StressOf(const PartInput& input, const Eigen::VectorXd& displacement) : input_(input), displacement_(displacement) {
    if (input.is_projected) pressure_ = pressure(dilatation_of(input), displacement);
}

Eigen::Vector3d StressOf::operator()(int element, const Vec2& x) const {
    return (*this)(element, x, displacement_at(input_, displacement_, element, x).gradient);
}

Eigen::Vector3d StressOf::operator()(int element, const Vec2& x, const Eigen::Matrix2d& gradient) const {
    Eigen::Vector3d s = stress_of(local_elasticity(input_), gradient);
    if (!input_.is_projected) return s;
    const PointBasis b = evaluate(input_.dilatation->space, element, x);
    for (std::size_t i = 0; i < b.functions.size(); ++i)
        s.head<2>().array() += b.value[static_cast<Eigen::Index>(i)] * pressure_[b.functions[i]];
    return s;
}

}  // namespace abut::solver
