// SPDX-License-Identifier: GPL-3.0-or-later
// Closed outlines that cross themselves or another outline of their layer.
#pragma once
#include <vector>

#include "geometry/sketch_chains.hpp"

namespace abut::geometry {

/// Removes the outlines that take part in a crossing: which side of them is material cannot be told. One problem for each pair
/// of outlines (or outline with itself), at one of their meetings. Two outlines may touch each other; none may touch itself.
std::vector<SketchProblem> remove_crossing(const std::vector<SketchEntity>& entities,
                                           std::vector<std::vector<ChainLink>>& chains, double tolerance);

}  // namespace abut::geometry
