// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of parts that do not interact are problems of their own, on grids of their own: as if each were a scene.
#pragma once
#include <vector>

#include "src/analysis/outcome.hpp"

namespace abut {

/// Which of the scene's parts a group has.
using PartGroup = std::vector<bool>;

/// Groups that something acts on, in the order of their first parts: parts hang together that a candidate joins. Parts that
/// nothing acts on go with the first group, where they are left out. At least one group, of all parts where there is no other.
std::vector<PartGroup> part_groups(const Scene& scene, const ResolvedConditions& conditions,
                                   const std::vector<Candidate>& candidates);

/// The groups' outcomes as one: contacts in the order of their parts, passes side by side (a group that ended before the others
/// stays as it was). The uses of effects are not merged.
Outcome merged(std::vector<Outcome> groups);

}  // namespace abut
