// SPDX-License-Identifier: GPL-3.0-or-later
// What does not close: outlines that nearly do, which are faults of the drawing, and lines that bound nothing by intention.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_chains.hpp"

namespace abut::geometry {

/// The lines that bound nothing, told.
struct OpenLines {
    std::vector<SketchProblem> problems;  ///< outlines that nearly close, at most max_open_ends; a last one tells how many more
    std::vector<SketchProblem> warnings;  ///< what was set aside, by layer
    double length = 0;                    ///< of all that was set aside
};
inline constexpr std::size_t max_open_ends = 20;  ///< problems listed per group

/// Tells outlines that nearly close from lines that bound nothing. What hangs together is a node, and a free end that comes
/// near a curve joins two of them (or one to itself); where such joints make a ring whose gaps are all below
/// nearly_closed_fraction of the loose length in it, the ring is an outline with gaps: a problem each, with place, gap and file
/// line. All else is set aside: a warning for each layer, with names and places. `leave_open`: rings are set aside, too. Cost
/// O(n log n).
OpenLines tell_open_lines(const std::vector<SketchPiece>& entities, const EntityChains& chains, double tolerance,
                          bool leave_open);

}  // namespace abut::geometry
