// SPDX-License-Identifier: GPL-3.0-or-later
// Interior point method for the contact problem, Mehrotra's predictor and corrector [Nocedal06, section 16.6]. Its number of
// steps hardly depends on how many contacts there are, nor on how they hang together: it finds the closed rows where active
// sets come back to where they were.
#pragma once
#include "solver/contact/active_set.hpp"

namespace abut::solver {

/// The outcome of the interior point method.
struct InteriorPoint {
    ActiveSet active;    ///< closed at the end: pressed more than open, each in its own unit
    ContactState state;  ///< to `complementarity` of the largest force times length
    bool converged = false;
    int iterations = 0;
};

/// How near the iteration comes to the end: mean of l gap over the largest force times the largest closing C l, and violations
/// over their scales, or what rounding leaves of them.
inline constexpr double complementarity = 1e-11;

/// Solves the contact problem. C must be positive definite but for redundant rows, and some multipliers >= 0 have to balance
/// the loads. start: of the multipliers, their order of magnitude. Cost: a factor of C and of G'C^-1 G each step; at most 100
/// steps.
InteriorPoint interior_point(const ShiftedQp& shifted, const Eigen::VectorXd& start);

}  // namespace abut::solver
