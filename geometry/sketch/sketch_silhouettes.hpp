// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of which only the outline around everything counts: fasteners drawn with their inner lines.
#pragma once
#include <vector>

#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// A drawing's entities with the outlines around blocks in place of what these hold.
struct Silhouettes {
    std::vector<SketchEntity> entities;
    std::vector<Repair> repairs;
    std::vector<SketchProblem> problems;  ///< blocks without a closed outline, and patterns that no block fits
    std::vector<SketchProblem> warnings;  ///< what was left out, for each block
};

/// Replaces what stands in an insertion of a block named in options.block_outline, blocks within it included, by the outline
/// around all of it: its lines are cut wherever they meet, and of the areas that they bound the contour stays. It lies on the
/// layer that most of it was on, in that block, so that nothing else divides it. Several outlines that lie apart stay several.
/// Lines inside are left out, and counted; those that stand out are told by themselves.
Silhouettes block_silhouettes(const Drawing& drawing, const SketchOptions& options);

}  // namespace abut::geometry
