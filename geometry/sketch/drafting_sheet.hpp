// SPDX-License-Identifier: GPL-3.0-or-later
// The sheet around parts.
#pragma once
#include <vector>

#include "geometry/sketch/drafting_shapes.hpp"

namespace abut::geometry {

/// Finds tables and frames, as find_drafting says, and sets them aside. Returns a warning for a rectangle around all else that
/// may be a frame as well as a plate.
std::vector<SketchProblem> find_sheet(DraftingSearch& found);

}  // namespace abut::geometry
