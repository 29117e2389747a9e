// SPDX-License-Identifier: GPL-3.0-or-later
// Which edges of an outline come near each other, by a tree of boxes that are turned with what they hold [Gottschalk96].
// Boxes along the axes of a long slanted edge meet those of all its neighbours, however thin the gaps are; turned ones do not.
#pragma once
#include <vector>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// A rectangle turned any way. Half its size is counted along its unit vector and across it.
struct OrientedBox {
    Vec2 center{0, 0}, along{1, 0}, half{0, 0};
};

/// Along the chord, for lines and arcs of at most half a turn; all else along the axes.
OrientedBox oriented_box(const Curve& curve);
/// Holds all corners of the boxes, and lies along the line from the first to the last.
OrientedBox oriented_box(const std::vector<Box2>& corners);

/// Built in O(n log n) and asked in O(log n + found) where edges run as in drawings; keeps boxes only.
class OrientedTree {
public:
    struct Item {
        Box2 box;
        OrientedBox turned;
    };
    explicit OrientedTree(const std::vector<Item>& items);
    explicit OrientedTree(const Part& part);

    /// Edges after edge i, ascending, whose bounding box comes within `margin` of its own (Box2::overlaps), but for those that
    /// are proved by their turned boxes to be more than twice the margin away.
    std::vector<int> near_after(std::size_t i, double margin) const;

private:
    struct Numbered {
        Item item;
        int number;
    };
    /// The left half of a node follows it.
    struct Node {
        Box2 box;
        OrientedBox turned;
        std::size_t begin = 0, end = 0, right = 0;  ///< right: 0 of a leaf
        int last = 0;                               ///< number of an edge
    };
    std::size_t add_node(std::size_t begin, std::size_t end);
    std::size_t add_leaf(std::size_t begin, std::size_t end);
    void find(std::size_t node, const Numbered& asked, double margin, std::vector<int>& found) const;

    std::vector<Numbered> items_;  ///< in the order of the leaves
    std::vector<std::size_t> place_;
    std::vector<Node> nodes_;
    double rounding_ = 0;
};

}  // namespace abut::geometry
