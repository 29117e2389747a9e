// SPDX-License-Identifier: GPL-3.0-or-later
// Coulomb friction in the condensed contact problem:
//
//   gap = g + C l + G a,  G'l + h = 0,  and by pair (n, t) of a pressure's row and its tangential one, mu its coefficient:
//   l_n >= 0, gap_n >= 0, l_n gap_n = 0,  |l_t| <= mu l_n,  l_t = -mu l_n sign(gap_t) where gap_t != 0.
//
// gap_t is the slip since the loads before; the bound is by coefficient, and B-splines keep it pointwise. On a set of states
// the conditions are linear, with an unsymmetric matrix, since pressure drives slip's traction but not the other way round: no
// energy falls, so there is no descending set here.
#pragma once
#include "solver/contact/active_set.hpp"
#include "solver/contact/contact_qp.hpp"

namespace abut::solver {

/// The states of rows. Rows of pressure and bilateral ones are closed or open; tangential ones open, closed (they stick), or
/// slip one way or the other.
namespace row_state {
inline constexpr char open = 0, closed = 1, slips_forward = 2 /* slip > 0 */, slips_backward = 3;
}

/// Solves the contact problem with friction, in these steps:
/// 0. Where multipliers are expected, step 1 from their states. Usually the end; else pivots from there (friction_pivots.hpp),
///    which are where they leave bodies near to where they were. They need a proximal term on the amplitudes: one that is a
///    trifle, and what it bears is taken away in a few passes.
/// 1. Semismooth Newton steps (the primal-dual active set with four states [Hueber05, Alart91]) from the bodies at rest on
///    a Winkler foundation, everything that is pressed sticking.
/// 2. Where that does not end: are there any pressures and tractions within the cones of friction that balance the loads?
///    Non-negative least squares over the cones' edges; if there are none, their residual is a motion.
/// 3. Forces within the cones may balance, and elastic bodies not press on each other so, or not there (a shrink fit, round
///    bodies). Passes of step 1 under a proximal term, a brake that gives way from pass to pass (creep): where it bears as much
///    of the loads in the end, the bodies slide. That motion is the mechanism, and the same is tried with larger coefficients
///    until they rest. What is led far, tilted by where it sticks as it begins, creeps back for long, and is none such where
///    pivots from the bodies at rest find an answer. Finer rows may press elsewhere: the state in which they slide is given as
///    well (feasible, not converged, with a mechanism).
/// 4. Step 1 from where the creep ended, else pivots as in step 0 from the bodies at rest.
/// Newton steps are cut where whole ones do not bring the residual of all conditions down; where they do not end in 3, pivots
/// from the pass before do. Converged is what meets all conditions. Coefficients above those of any materials (rough faces) are
/// taken as 5, or ten times as much and so on: the least that lets next to nothing slip, else the one that lets least. The
/// result says what was taken, and what slips.
ContactQpResult solve_with_friction(const ContactQp& qp);

/// Solves the contact problem with friction where rows that are bilateral hold all motions, by their springs, so that nothing
/// slides on and on: Newton steps from the bodies at rest without friction, else pivots from there.
ContactQpResult solve_held_with_friction(const ContactQp& qp);

/// Several answers are possible where coefficients are large: is there another one, found from everything slipping?
bool has_another_answer(const ContactQp& qp, const ContactQpResult& answer);

/// The largest violation of the conditions, scaled like contact_residual. Tractions beyond their bound are relative to the
/// largest multiplier, slips that no traction at its bound goes with to the largest elastic closing, whichever is smaller.
double friction_residual(const ContactQp& qp, const ContactConditions& conditions);

/// The state on a set without a proximal term; a motion that the set leaves free stays at zero. False: there is none.
bool state_with_friction(const ContactQp& qp, const ActiveSet& states, ContactState& state);

}  // namespace abut::solver
