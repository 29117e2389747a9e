// SPDX-License-Identifier: GPL-3.0-or-later
// Displacements as splines: two components to each function of a space.
#pragma once
#include "solver/splines/local_spline.hpp"

namespace abut::solver {

/// Displacement and its gradient (rows: components) at a point.
struct DisplacementAt {
    Vec2 value{0, 0};
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
};

/// A displacement without a structure, on one element.
inline LocalSpline<2> local_displacement(const SplineSpace& space, const Eigen::VectorXd& displacement, int element) {
    return {space, element, [&](int function) { return displacement.segment<2>(2 * Eigen::Index{function}); }};
}

/// The displacement and its gradient at a point of an element, without a structure.
DisplacementAt displacement_at(const SplineSpace& space, const Eigen::VectorXd& displacement, int element, const Vec2& x);

}  // namespace abut::solver
