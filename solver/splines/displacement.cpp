// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/splines/displacement.hpp"

namespace abut::solver {

DisplacementAt displacement_at(const SplineSpace& space, const Eigen::VectorXd& displacement, int element, const Vec2& x) {
    const SplineAt<2> u = local_displacement(space, displacement, element).at(x);
    return {u.value, u.gradient};
}

}  // namespace abut::solver
