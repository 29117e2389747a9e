// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that go far in a solution: the contacts of a part that is free to move are paired anew where it has gone.
#pragma once
#include <optional>
#include <vector>

#include "src/motion/placement.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// What a part's free motions make up of its displacement in a solution, by amplitude; none of what a support of means or of
/// points holds.
Eigen::VectorXd rigid_amplitudes_of(const SolvedAssembly& solved, std::size_t grid);
/// A part's rigid motion in a solution: what its free motions make up of its displacement, in assembly coordinates.
solver::RigidMotion rigid_motion_of(const SolvedAssembly& solved, std::size_t grid);

/// The coefficients (2n x 3) of the rigid motions along x and y of a part's frame and about its centre.
Eigen::MatrixXd unit_motions(const PartOnGrid& grid);

/// The rigid motion that comes nearest to all of a part's displacement (2n), in assembly coordinates, whatever holds the part,
/// and the rest (2n): how it bends.
struct FittedMotion {
    solver::RigidMotion motion;
    Eigen::VectorXd rest;
    double bending() const { return rest.lpNorm<Eigen::Infinity>(); }  ///< no point moves farther by the rest
};
FittedMotion fitted_motion(const PartOnGrid& grid, const Eigen::VectorXd& displacement);
FittedMotion fitted_motion_of(const SolvedAssembly& solved, std::size_t grid);

/// Where a solution has the parts that move by more than `placed_fraction` of their own size, by part of the scene that was
/// solved; others stay: what they move by belongs to the answer, as bending does, and so do bonded parts. Nothing where no part
/// moves so far, or parts are not followed (why_not_followed).
std::optional<std::vector<Placement>> placements_of(const Scene& scene, const ResolvedConditions& conditions,
                                                    const SolvedAssembly& solved);
/// What placements_of finds where parts are followed.
std::optional<std::vector<Placement>> far_placements_of(const Scene& scene, const SolvedAssembly& solved);

}  // namespace abut
