// SPDX-License-Identifier: GPL-3.0-or-later
// The condensed contact problem: a small convex quadratic program over the multipliers.
//
//   min 1/2 l'C l + g'l   subject to  G'l + h = 0,  l_k >= 0 for unilateral k,
//
// whose conditions are: gap = g + C l + G a >= 0, l >= 0, gap . l = 0 (gap = 0 for bilateral rows); a are the amplitudes of the
// rigid motions that no support holds, G'l + h = 0 their equilibrium.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace abut::solver {

struct ContactQp {
    Eigen::MatrixXd compliance;    ///< C, symmetric positive semidefinite (m x m)
    Eigen::VectorXd gap;           ///< g (m)
    Eigen::MatrixXd modes;         ///< G (m x n)
    Eigen::VectorXd mode_load;     ///< h (n)
    std::vector<char> unilateral;  ///< (m)
    Eigen::VectorXd foundation;    ///< stiffness of a Winkler foundation for every row, for the starting guess (m)
    Eigen::VectorXd drawn_gap;     ///< gap of the undeformed bodies, for the same (m)
    double load_scale = 0;         ///< the largest load on any body: what equilibrium is measured against
};

struct ContactQpResult {
    Eigen::VectorXd multipliers, amplitudes, gap;
    std::vector<char> active;
    int iterations = 0;
    bool converged = false;
    bool used_fallback = false;  ///< the monotone active set had to finish
    bool feasible = true;        ///< false: no pressures >= 0 balance the loads
    Eigen::VectorXd mechanism;   ///< with !feasible: the motion (amplitudes) that the loads drive
};

/// 1. Non-negative least squares on the equilibrium alone: its residual is the motion of a mechanism.
/// 2. A rigid settle on a Winkler foundation gives the first active set.
/// 3. Primal-dual active set (Hueber and Wohlmuth 2005) under a proximal term on the amplitudes that is reduced tenfold a pass.
/// 4. Where that cycles or loses every contact: the monotone primal active set, which always ends.
ContactQpResult solve_contact_qp(const ContactQp& qp);

/// Multipliers and amplitudes with the gaps of `active` closed and all other multipliers zero; false where the set leaves them
/// open. With residuals in place of gap and mode_load: the correction of a step of iterative refinement.
bool solve_on_set(const ContactQp& qp, const std::vector<char>& active, Eigen::VectorXd& multipliers,
                  Eigen::VectorXd& amplitudes);

}  // namespace abut::solver
