// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of outlines that cross.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_material.hpp"

namespace abut::geometry {

/// Settles what becomes of two outlines that cross:
///   - a circle through the middles of two other circles or more is a pitch circle, and where all belongs to one part
///     (`is_one_part`: a layer's) any other circle is one of construction: left out, and told;
///   - another circle that crosses lines, and an outline that meets the other one only where it has corners itself, are drawn
///     over it: both are kept, the former `is_overlaid` (by closed chain of the result), and the overlap is told;
///   - all others are a problem, and both left out: which side is material cannot be told.
Outlines without_conflicts(const Outlines& outlines, double tolerance, bool is_one_part, std::vector<bool>& is_overlaid,
                           std::vector<SketchProblem>& problems, std::vector<SketchProblem>& warnings);

}  // namespace abut::geometry
