// SPDX-License-Identifier: GPL-3.0-or-later
// Where the loops of one part touch each other.
#pragma once
#include <vector>

#include "geometry/brep/part.hpp"
#include "geometry/brep/repair.hpp"

namespace abut::geometry {

/// Places where two loops come within the merge length: holes that touch the boundary or each other, regions that touch in a
/// point. Nothing was changed there (size 0), but the part hangs together, or not, by a single point: worth knowing. Two edges
/// are named at one place at most. Cost O(n log n) where edges are short.
std::vector<Repair> touching_loops(const Part& part);

}  // namespace abut::geometry
