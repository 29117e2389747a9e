// SPDX-License-Identifier: GPL-3.0-or-later
// Bounding-box tree over the edges of a part, for finding the edges near a place.
#pragma once
#include <vector>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// A tree of boxes, built in O(n log n) and asked in O(log n + found). It keeps boxes and edge numbers only, no reference to
/// the part.
class EdgeTree {
public:
    explicit EdgeTree(const Part& part);
    /// A tree over any boxes in place of a part's edges; the edges that near() gives are their numbers.
    explicit EdgeTree(std::vector<Box2> boxes);
    /// Edges, ascending, whose bounding box comes within `margin` of the box.
    std::vector<int> near(const Box2& box, double margin) const;

private:
    struct Node {
        Box2 box;
        int first = 0, last = 0;    ///< range of order_
        int left = -1, right = -1;  ///< children; -1: a leaf
    };
    int build(int first, int last);

    std::vector<Box2> boxes_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

}  // namespace abut::geometry
