// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid motions of a part that nothing holds.
#pragma once
#include "solver/parts/part_system.hpp"

namespace abut::solver {

/// The rigid motions of a part that supports do not hold: those that nothing holds, and those that springs do, however soft
/// they are.
struct UnheldMotions {
    std::vector<RigidMotion> free, on_springs;
};

/// Those of a part whose supports and springs are known; center, size: as in make_part_system. Around an axis the only rigid
/// motion is the one along it: all others stretch the hoops.
UnheldMotions unheld_motions(const PartSystem& system, const Vec2& center, double size);

/// Splits motions that supports do not hold.
UnheldMotions split_by_springs(std::vector<RigidMotion> unheld, const std::vector<SpringSet>& springs);

/// The sum of motions, each times its share, about the centre of the first.
RigidMotion sum_of_motions(const std::vector<RigidMotion>& motions, const Eigen::VectorXd& shares);

/// Integrals over the part of its functions times its free motions (2n x free motions): products with coefficients are mean
/// products of displacements. Those of a rigid part are the motions themselves. Cost: two load vectors.
const Eigen::MatrixXd& motion_integrals(const PartSystem& system);

}  // namespace abut::solver
