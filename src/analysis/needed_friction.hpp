// SPDX-License-Identifier: GPL-3.0-or-later
// Supports that stand in for friction.
#pragma once
#include "src/plan/boundary_conditions.hpp"
#include "src/results/result.hpp"

namespace abut {

/// Notes of each part that supports hold in one direction the coefficient of friction that its contacts would need in their
/// place: the supports' force over the sum of the forces that press across it, which statics ask for at least. Nothing is noted
/// where the supports carry next to nothing, a contact holds with them, or the contacts have friction. Call with reactions and
/// contacts filled in.
void note_needed_friction(const Scene& scene, const ResolvedConditions& conditions, Result& result);

}  // namespace abut
