// SPDX-License-Identifier: GPL-3.0-or-later
// From mended lines to closed outlines.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_mended.hpp"

namespace abut::geometry {

/// The outlines that entities close to, after mending.
struct ClosedOutlines {
    Outlines outlines;
    std::vector<Repair> repairs;
    std::vector<LooseEntities> loose;     ///< what bounds nothing, among `outlines.entities`
    std::vector<SketchProblem> problems;  ///< outlines that nearly close, lines that share areas and cross
    std::vector<SketchProblem> warnings;  ///< what was set aside since it bounds nothing
    double open_length = 0;               ///< of all that
    double tolerance = 0;                 ///< ends within this were joined
    double coincidence = 0;               ///< curves within this count as one
};

/// Closes the outlines of what was mended: facets become arcs, curves are moved to their joints, and what is open is told.
ClosedOutlines close_outlines(MendedLines lines, const SketchOptions& options);

}  // namespace abut::geometry
