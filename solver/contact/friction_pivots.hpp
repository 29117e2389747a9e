// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of states of the contact problem with friction by pivots: one row changes its state at a time.
#pragma once
#include "solver/contact/friction.hpp"

namespace abut::solver {

/// The states and the point of a solution under a proximal term that is positive definite, from `states` on. The point on these
/// is moved into the cones of friction; there it solves a problem with other gaps and loads, and from that problem the path of
/// solutions is followed to the one posed, as gaps and loads change evenly. It is piecewise linear, with one row that changes
/// its state at each bend, and may turn back on its way: a parametric linear complementarity problem [Murty88, Klarbring86].
/// States near those of the solution take few pivots, and what slides, rolls or falls far on the way does no harm. iterations:
/// the pivots are added. False, with nothing changed: the path leads back to where it began, or to infinity, or is too long.
bool pivot_states(const ShiftedQp& shifted, const Proximal& proximal, ActiveSet& states, ContactState& state, int& iterations);

}  // namespace abut::solver
