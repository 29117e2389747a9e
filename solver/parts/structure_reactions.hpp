// SPDX-License-Identifier: GPL-3.0-or-later
// Reactions of supports that a solution structure imposes, from equilibrium.
#pragma once
#include "solver/parts/part_system.hpp"

namespace abut::solver {

/// Functions at least so far from one support, as a share of their distances to it and to the nearest other, are wholly the
/// other's; between, the share passes over smoothly.
inline constexpr double undivided_share = 0.25;

/// Sets the reactions of the structure's supports. The plain functions N sum up to the rigid motions: the residual of all of
/// them, internal forces less loads and less the other supports' forces, is what the structure exerts. Each function's goes to
/// the support that is nearest, in the component that this holds; together they balance the loads exactly.
/// plain: loads besides system.applied, on the plain functions (empty: none). Cost O(functions x points of the supports).
void add_structure_reactions(const PartSystem& system, const Eigen::VectorXd& displacement, const Eigen::VectorXd& plain,
                             std::vector<Resultant>& reactions);

}  // namespace abut::solver
