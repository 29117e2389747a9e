// SPDX-License-Identifier: GPL-3.0-or-later
// From loose entities to closed outlines.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_nesting.hpp"
#include "geometry/sketch/sketch_splits.hpp"

namespace abut::geometry {

/// The outlines that entities close to, after mending.
struct ClosedOutlines {
    Outlines outlines;
    std::vector<Repair> repairs;
    std::vector<LooseEntities> loose;     ///< what bounds nothing, among `outlines.entities`
    std::vector<SketchProblem> problems;  ///< outlines that nearly close
    std::vector<SketchProblem> warnings;  ///< what was set aside since it bounds nothing
    double open_length = 0;               ///< of all that
    double tolerance = 0;                 ///< ends within this were joined
    double coincidence = 0;               ///< curves within this count as one
};

/// Closes the outlines of entities that may belong together; ends of others are none of their business. The tolerance asked for
/// (or joining_fraction of the smaller of diagonal and total length) is lowered to half the shortest entity, but never below
/// `rounding`: what the coordinates' own rounding amounts to in the file.
/// `cut_at_crossings`: upright lines that share areas are cut where they cross, as in tables; or all lines are.
ClosedOutlines close_outlines(const std::vector<SketchEntity>& entities, const SketchOptions& options, double rounding,
                              CrossingLines cut_at_crossings = CrossingLines::none);

}  // namespace abut::geometry
