// SPDX-License-Identifier: GPL-3.0-or-later
// Closed outlines sorted by nesting into parts.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_faces.hpp"

namespace abut::geometry {

/// All that closes among some entities.
struct Outlines {
    std::vector<SketchPiece> entities;
    std::vector<EntityChain> closed;
    std::vector<DividedOutline> divided;
};

/// The parts that outlines bound, with the entities of their edges.
struct NestedParts {
    std::vector<Part> parts;               ///< unnamed, in order of their first entities
    std::vector<int> first_entity;         ///< of each part
    std::vector<std::vector<int>> entity;  ///< by part and edge
    std::vector<SketchProblem> problems;   ///< outlines that cross or touch themselves or each other
    std::vector<Repair> remarks;           ///< what was decided about divided outlines and crossing circles
};

/// An outline in the open, or inside a hole, bounds a part (material on its left when run counter-clockwise); one inside a part
/// is a hole of it. Of a divided outline every area that is filled is a part (walk_faces); where it lies inside a part, its
/// contour is a hole of that, and an even-odd one is filled the other way round. Outlines of which one crosses another are left
/// out; of a circle and another outline only the circle, and that is no problem but a remark. Cost O(n log n) where not very
/// many outlines lie one around the other. `tolerance`: outlines that overlap by less only touch; `coincidence`: what is closer
/// than this to an outline lies on it.
NestedParts nest(const Outlines& outlines, double tolerance, double coincidence);

}  // namespace abut::geometry
