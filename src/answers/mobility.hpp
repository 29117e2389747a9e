// SPDX-License-Identifier: GPL-3.0-or-later
// What the supports and contacts of an assembly leave its parts to do as rigid bodies [Grishin10, section 2.2].
#pragma once
#include <vector>

#include "src/contact/candidates.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/results/result.hpp"

namespace abut {

/// The mobility of the parts as drawn: every support counts, and every contact that is closer than a detected pair may be, as
/// two-sided.
MobilityResult mobility_as_drawn(const Scene& scene, const ResolvedConditions& conditions,
                                 const std::vector<Candidate>& candidates);

/// The mobility of the parts under the loads: supports count, and the contacts that carry force.
MobilityResult mobility_under_load(const Scene& scene, const ResolvedConditions& conditions,
                                   const std::vector<ContactResult>& contacts);

}  // namespace abut
