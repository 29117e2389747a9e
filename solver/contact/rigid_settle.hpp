// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid bodies on a Winkler foundation along the candidates: where they come to rest, and the pressures there.
#pragma once
#include <optional>

#include "solver/contact/contact_qp.hpp"

namespace abut::solver {

/// Forces balance where what is left of them is below this share of the loads.
inline constexpr double equilibrium_tolerance = 1e-10;

/// The bodies at rest on the foundation.
struct Settled {
    Eigen::VectorXd amplitudes, multipliers;
    Eigen::MatrixXd stiffness;  ///< of the whole foundation
    bool balanced = false;      ///< the multipliers balance the loads to rounding: no mechanism. False: not known
};

/// Finds where the bodies come to rest, by the gaps in drawn_gap. Newton steps on the energy of the foundation, which is convex
/// and once differentiable, each to the least energy along it. Cost: O(m n^2) a step; a few steps, and about two for each body
/// that closes after another.
Settled settle_rigidly(const ContactQp& qp);

/// The stiffness G'KG of the whole foundation against the rigid motions, as if every row were closed (n x n).
Eigen::MatrixXd foundation_stiffness(const ContactQp& qp);

/// The amplitudes at which the foundation of these rows alone, pressed or pulled, balances the loads: where the bodies would
/// settle if these were the rows under pressure. Nothing where they leave a motion (nearly) free. Cost: one step.
std::optional<Eigen::VectorXd> settle_on(const ContactQp& qp, const std::vector<char>& closed);

/// The force that equilibrium is measured against: the loads, or the contact forces where there are none (a press fit).
double force_scale(const ContactQp& qp, const Eigen::VectorXd& multipliers);

}  // namespace abut::solver
