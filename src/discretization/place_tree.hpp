// SPDX-License-Identifier: GPL-3.0-or-later
// Places that want small cells, as a tree of boxes: a cell is compared with those near it, of thousands.
#pragma once
#include <cstddef>
#include <vector>

#include "src/discretization/grid_design.hpp"

namespace abut {

/// Places with finite boxes. Cost: n log n to make.
class PlaceTree {
public:
    explicit PlaceTree(std::vector<SizeFeature> places);

    /// Is a cell larger than some place allows where that is nearest to it? Cost: logarithmic, where few places ask for less.
    bool is_too_large(const geometry::Box2& cell) const;

private:
    /// Places begin to end. Its first half is the node after it; second: its other half, 0: it has no halves.
    struct Node {
        geometry::Box2 box;
        double size, growth;  ///< the least
        std::size_t begin, end, second;
    };
    /// Returns its number.
    std::size_t add_node(std::size_t begin, std::size_t end);
    bool is_too_large_for(std::size_t number, const geometry::Box2& cell, double side) const;

    std::vector<SizeFeature> places_;
    std::vector<Node> nodes_;
};

}  // namespace abut
