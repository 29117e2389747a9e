// SPDX-License-Identifier: GPL-3.0-or-later
// Active sets of the condensed contact problem under a proximal term on the rigid amplitudes:
//
//   gap = g + C l + G a,   G'l + h = E (a - anchor),   l_k >= 0, gap_k >= 0, l_k gap_k = 0 for unilateral k, else gap_k = 0.
//
// With E positive definite the amplitudes can be eliminated, which leaves a strictly convex problem in l >= 0 alone: the energy
// below. E = 0 is the contact problem itself, where the closed rows hold every motion.
#pragma once
#include "solver/contact/contact_qp.hpp"
#include "solver/linear_algebra/closed_factor.hpp"

namespace abut::solver {

using ActiveSet = std::vector<char>;

/// The problem with its amplitudes measured from others. All but the gap is looked at, not copied.
struct ShiftedQp {
    const ContactQp& qp;
    Eigen::VectorXd gap;  ///< under the amplitudes that these are measured from (m)
};

/// The proximal term 1/2 (a - anchor)'E (a - anchor) on the amplitudes.
struct Proximal {
    Eigen::MatrixXd stiffness;  ///< E (n x n)
    Eigen::VectorXd anchor;     ///< (n)
};

/// The unknowns of the contact problem at one point of a search.
struct ContactState {
    Eigen::VectorXd multipliers, amplitudes;
    Eigen::VectorXd closing;  ///< C l
};

/// The numbers of the rows in a set, ascending.
std::vector<Eigen::Index> members(const ActiveSet& set);
/// The set of the rows that are always closed.
ActiveSet bilateral_rows(const ContactQp& qp);

/// Finds the stationary point with the gaps of `active` closed and all other multipliers zero, those of redundant rows too;
/// false where C is indefinite on the set, redundant rows ask for other gaps than the rest, or the amplitudes' Schur complement
/// is singular. factor: of the problem's compliance, on any set before; so for all that follows.
bool solve_on(const ShiftedQp& shifted, const Proximal& proximal, const ActiveSet& active, ClosedFactor& factor,
              ContactState& state);

/// Finds the point of the problem itself, without a proximal term, where the set leaves a motion free: that motion stays at the
/// anchor, its balance as it is. False where C is indefinite on the set, redundant rows ask for other gaps than the rest, or no
/// closed row resists any motion.
bool solve_least_motion(const ShiftedQp& shifted, const Eigen::VectorXd& anchor, const ActiveSet& active, ClosedFactor& factor,
                        ContactState& state);

/// The gaps of all rows (m) in a state.
Eigen::VectorXd gap_of(const ShiftedQp& shifted, const ContactState& state);

/// The rounding of each row's gap (m), that of the terms that it is the sum of: a gap below it is closed.
Eigen::VectorXd gap_rounding(const ShiftedQp& shifted, const ContactState& state);

/// The set after a primal-dual step: closed where pressed, closing where penetrated.
ActiveSet next_set(const ShiftedQp& shifted, const ActiveSet& active, const ContactState& state);

/// How a search ended. repeated: a set came back, or none was final after 24 steps; singular: a set left a motion free.
enum class SetSearch { found, repeated, singular };

/// Primal-dual active set [Hueber05] from `active`; usually 2 to 6 steps.
SetSearch primal_dual(const ShiftedQp& shifted, const Proximal& proximal, ActiveSet& active, ClosedFactor& factor,
                      ContactState& state, int& iterations);

/// Active sets by block pivoting, with a proximal term that leaves no motion free, which always ends [Judice94]: all rows
/// change that want to as long as these become fewer, and for a few steps besides; then one row alone, from the set that had
/// the fewest, or, without `one_by_one`, `repeated` is answered.
SetSearch pivot_by_blocks(const ShiftedQp& shifted, const Proximal& proximal, bool one_by_one, ActiveSet& active,
                          ClosedFactor& factor, ContactState& state, int& iterations);

/// Primal-dual active set, as primal_dual, without a proximal term. Motions that a set leaves free stay where they are, or
/// clear the open rows that would penetrate there. singular: C is on a set.
SetSearch primal_dual_or_least_motion(const ShiftedQp& shifted, ActiveSet& active, ClosedFactor& factor, ContactState& state,
                                      int& iterations);

/// Primal active set with a projected step [Nocedal06, sections 16.5 and 16.7] from the multipliers of `state`, as far as they
/// are >= 0: the energy falls from one set to the next, so none comes back and it ends. E must be positive definite. False
/// where C is singular on a set, or rounding stops the descent before the conditions hold.
bool descend(const ShiftedQp& shifted, const Proximal& proximal, ActiveSet& active, ClosedFactor& factor, ContactState& state,
             int& iterations);

}  // namespace abut::solver
