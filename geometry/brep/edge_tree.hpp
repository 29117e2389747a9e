// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a part that are near a place, by an R-tree of their bounding boxes.
#pragma once
#include <memory>
#include <vector>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// A tree of boxes, built in O(n log n) and asked in O(log n + found). It keeps boxes and edge numbers only, no reference to
/// the part; copies share them.
class EdgeTree {
public:
    explicit EdgeTree(const Part& part);
    /// A tree over any boxes in place of a part's edges; the edges that near() gives are their numbers.
    explicit EdgeTree(std::vector<Box2> boxes);
    /// Edges, ascending, whose bounding box comes within `margin` of the box (Box2::overlaps, to the last bit).
    std::vector<int> near(const Box2& box, double margin) const;

private:
    struct Boxes;
    std::shared_ptr<const Boxes> boxes_;
};

}  // namespace abut::geometry
