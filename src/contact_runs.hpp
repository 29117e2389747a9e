// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "solver/bspline.hpp"

namespace abut {

/// A stretch of an interface's middle curve under pressure.
struct ContactRun {
    double begin, end;        ///< arc lengths
    bool from_start, to_end;  ///< reaches the interface's own ends
};

/// Stretches where the pressure spline is positive. Ends inside the interface by fitting the force near them: pressures
/// end like the root of the distance, so the last active coefficient alone would put the end up to a knot too far.
std::vector<ContactRun> contact_runs(const solver::KnotVector& pressure, const Eigen::VectorXd& coefficients);

}  // namespace abut
