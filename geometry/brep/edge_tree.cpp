// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/edge_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/curves/index.hpp"

namespace abut::geometry {

namespace {
constexpr int leaf_size = 4;
std::vector<Box2> boxes_of(const Part& part) {
    std::vector<Box2> boxes;
    for (const Edge& edge : part.edges) boxes.push_back(bounding_box(edge.curve));
    return boxes;
}
}  // namespace

EdgeTree::EdgeTree(const Part& part) : EdgeTree(boxes_of(part)) {}

EdgeTree::EdgeTree(std::vector<Box2> boxes) : boxes_(std::move(boxes)) {
    order_.resize(boxes_.size());
    std::iota(order_.begin(), order_.end(), 0);
    if (!order_.empty()) build(0, static_cast<int>(order_.size()));
}

int EdgeTree::build(int first, int last) {
    const int id = static_cast<int>(nodes_.size());
    nodes_.push_back({{}, first, last, -1, -1});
    Box2 box, centers;
    for (int i = first; i < last; ++i) {
        box.extend(boxes_[at(order_[at(i)])]);
        centers.extend(boxes_[at(order_[at(i)])].center());
    }
    nodes_[at(id)].box = box;
    if (last - first <= leaf_size) return id;
    const int axis = centers.size().x() >= centers.size().y() ? 0 : 1;
    const int middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](int a, int b) {
        const double ca = boxes_[at(a)].center()[axis], cb = boxes_[at(b)].center()[axis];
        return ca < cb || (ca == cb && a < b);
    });
    const int left = build(first, middle), right = build(middle, last);
    nodes_[at(id)].left = left;
    nodes_[at(id)].right = right;
    return id;
}

std::vector<int> EdgeTree::near(const Box2& box, double margin) const {
    std::vector<int> found, open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
        const Node& node = nodes_[at(open.back())];
        open.pop_back();
        if (!node.box.overlaps(box, margin)) continue;
        if (node.left >= 0) {
            open.push_back(node.left);
            open.push_back(node.right);
            continue;
        }
        for (int i = node.first; i < node.last; ++i)
            if (boxes_[at(order_[at(i)])].overlaps(box, margin)) found.push_back(order_[at(i)]);
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace abut::geometry
