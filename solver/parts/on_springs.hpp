// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid motions of a part that springs alone hold.
//
// The stiffness K of the material has digits for them only where springs are about as stiff: r with K r = 0 is rounding of K
// against the stiffness S of soft springs. So they are split off. With (K + S) pinned at as many coefficients as there are such
// r, which is as well conditioned as the material's,
//
//   (K + S)^-1 = (K + S)_pinned^-1 + w w',   w = (r - (K + S)_pinned^-1 S r) (r'S r - r'S (K + S)_pinned^-1 S r)^-1/2,
//
// and of a body that does not deform w w' is all there is.
#pragma once
#include "solver/parts/part_system.hpp"

namespace abut::solver {

/// The springs' stiffness times motions (2n x any), which are given by their coefficients.
Eigen::MatrixXd springs_times(const PartSystem& system, const Eigen::MatrixXd& motions);

/// Finds, of rigid motions that springs alone hold, those (2n x some) against which they are softer than the material is
/// against a coefficient; stiffer ones stay in the factor.
Eigen::MatrixXd soft_motions(const PartSystem& system, const std::vector<RigidMotion>& on_springs);

/// w (2n x motions), of a part whose factor is that of K + S pinned, or of a rigid one.
Eigen::MatrixXd sprung_motions(const PartSystem& system, const Eigen::MatrixXd& motions);

}  // namespace abut::solver
