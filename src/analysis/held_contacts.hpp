// SPDX-License-Identifier: GPL-3.0-or-later
// Supports on edges that are also contacts, or loaded: what presses there goes into the support, and the part behind it carries
// nothing.
#pragma once
#include "src/analysis/outcome.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/results/result.hpp"

namespace abut {

/// Warns of each support that holds, along the normal, a stretch of an edge where its part touches another as drawn or in the
/// answer: one line a support and pair of parts. Edges that meet the contact in a corner only, held along the contact, of
/// rigid parts (which are held as a whole) or bonded are as they should be.
void warn_of_held_contacts(const Scene& scene, const ResolvedConditions& conditions, const Outcome& out, Result& result);

/// Warns of each load all of whose edges supports hold along x and y; what acts on rigid parts goes into their supports anyway.
void warn_of_held_loads(const Scene& scene, const ResolvedConditions& conditions, const Outcome& out, Result& result);

}  // namespace abut
