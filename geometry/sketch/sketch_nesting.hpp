// SPDX-License-Identifier: GPL-3.0-or-later
// Closed outlines sorted by nesting into parts.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_material.hpp"

namespace abut::geometry {

/// The parts that outlines bound, with the entities of their edges.
struct NestedParts {
    std::vector<Part> parts;               ///< unnamed, in order of their first entities
    std::vector<int> first_entity;         ///< of each part
    std::vector<std::string> name;         ///< of each part where the user gave one
    std::vector<std::vector<int>> entity;  ///< by part and edge
    std::vector<SketchProblem> problems;   ///< outlines that cross or touch themselves or each other
    std::vector<SketchProblem> warnings;   ///< what was left out, overlaps, and what was guessed about material
    std::vector<SketchRegion> regions;     ///< all areas that outlines bound; the parts have no names yet
    std::vector<int> part_of_region;       ///< -1: no material
};

/// An outline in the open, or inside a hole, bounds a part (material on its left when run counter-clockwise); one inside a part
/// is a hole of it, but for what the hints say (sketch_material). Of a divided outline every area that is filled is a part
/// (walk_faces); where it lies inside a part, its contour is a hole of that, and an even-odd one is filled the other way round.
/// What crosses is told (sketch_conflicts). Cost O(n log n) where not very many outlines lie one around the other. `tolerance`:
/// outlines that overlap by less only touch; `coincidence`: what is closer than this to an outline lies on it.
NestedParts nest(const Outlines& outlines, double tolerance, double coincidence, const MaterialHints& hints);

}  // namespace abut::geometry
