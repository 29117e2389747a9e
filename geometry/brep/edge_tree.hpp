// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a part that are near a place, by an R-tree of their bounding boxes.
#pragma once
#include <memory>
#include <vector>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// Built in O(n log n), asked in O(log n + found). Keeps boxes and edge numbers only, no reference to the part; copies share
/// them.
class EdgeTree {
public:
    explicit EdgeTree(const Part& part);
    /// Over anything that has boxes: "edges" are their numbers then.
    explicit EdgeTree(std::vector<Box2> boxes);
    /// Edges, ascending, whose bounding box comes within `margin` of the box (Box2::overlaps, to the last bit).
    std::vector<int> near(const Box2& box, double margin) const;

private:
    struct Boxes;
    std::shared_ptr<const Boxes> boxes_;
};

}  // namespace abut::geometry
