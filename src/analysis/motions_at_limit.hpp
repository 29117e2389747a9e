// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of parts that only friction at its limit is in the way of: they are left open within bounds.
#pragma once
#include "src/results/result.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// May any part move on in such a way? How far parts go is open then.
bool any_at_limit(const Scene& scene, const SolvedAssembly& solved);

/// Warns of parts that could move on in some way along contacts that all slip, or are about to: a disc pressed into a groove
/// slides down both sides, and whether it turns as it does so nothing says. Forces are the same however far it does; slip and
/// the work done in it are not.
void warn_of_motions_at_limit(const Scene& scene, const SolvedAssembly& solved, Result& result);

}  // namespace abut
