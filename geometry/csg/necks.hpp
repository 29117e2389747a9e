// SPDX-License-Identifier: GPL-3.0-or-later
// Loops that hang together by a neck that is only rounding.
#pragma once
#include <vector>

#include "geometry/csg/run_junctions.hpp"

namespace abut::geometry {

/// Two curves that should touch cross by a rounding error instead, and the loop changes over from one to the other and back
/// where it should pass through a point twice: a hole that touches the boundary is open by a few nanometres, two discs that
/// touch hang together. Cuts such loops in two, as exactly touching ones are: each curve goes on over the lens that both
/// enclose, which must be thinner than `rounding`. Call it when all junctions are solved.
std::vector<std::vector<Run>> cut_necks(std::vector<Run> loop, const RunContext& context);

}  // namespace abut::geometry
