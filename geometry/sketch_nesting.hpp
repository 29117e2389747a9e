// SPDX-License-Identifier: GPL-3.0-or-later
// Closed outlines sorted by nesting into parts.
#pragma once
#include <vector>

#include "geometry/sketch_chains.hpp"

namespace abut::geometry {

struct NestedParts {
    std::vector<Part> parts;              ///< unnamed, in order of their first entities
    std::vector<int> first_entity;        ///< of each part
    std::vector<SketchProblem> problems;  ///< outlines that cross or touch themselves or each other
};

/// An outline inside an even number of others bounds a part (material on its left when run counter-clockwise), one inside an
/// odd number is a hole of the smallest of those around it. Outlines of which one crosses another are left out. Cost
/// O(outlines^2) box tests, and O(n log n) for finding crossings.
NestedParts nest(const std::vector<SketchEntity>& entities, const std::vector<std::vector<ChainLink>>& chains,
                 double tolerance);

}  // namespace abut::geometry
