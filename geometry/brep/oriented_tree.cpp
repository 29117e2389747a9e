// SPDX-License-Identifier: GPL-3.0-or-later
// Edges are halved at the median of their centres along the line of these centres' largest spread. A node's box lies along the
// largest spread of the corners of its halves' boxes. Two boxes are apart if they are along a side of one of them.
#include "geometry/brep/oriented_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

constexpr std::size_t most_in_leaf = 4;

std::array<Vec2, 4> corners_of(const OrientedBox& box) {
    const Vec2 u = box.half.x() * box.along, v = box.half.y() * left_of(box.along);
    return {box.center + u + v, box.center + u - v, box.center - u + v, box.center - u - v};
}

OrientedBox box_along_axes(const Box2& box) {
    return {box.center(), {1, 0}, 0.5 * box.size()};
}

/// The box from `min` to `max`, counted along a unit vector and across it from a point.
OrientedBox turned_box(const Box2& box, const Vec2& along, const Vec2& from) {
    const Vec2 center = box.center();
    return {from + center.x() * along + center.y() * left_of(along), along, 0.5 * box.size()};
}

/// Sums for the mean and the direction of the largest spread of points.
class Spread {
public:
    explicit Spread(const Vec2& from) : from_(from) {}
    void add(const Vec2& p) {
        const Vec2 d = p - from_;
        n_ += 1;
        sum_ += d;
        squares_ += d.cwiseProduct(d);
        product_ += d.x() * d.y();
    }
    Vec2 direction() const {
        const Vec2 s = squares_ - sum_.cwiseProduct(sum_) / n_;
        const double angle = 0.5 * std::atan2(2 * (product_ - sum_.x() * sum_.y() / n_), s.x() - s.y());
        return {std::cos(angle), std::sin(angle)};
    }

private:
    Vec2 from_, sum_{0, 0}, squares_{0, 0};
    double n_ = 0, product_ = 0;
};

/// The box along the largest spread of points.
OrientedBox spread_box(const std::vector<Vec2>& points) {
    const Vec2& from = points.front();
    Spread spread(from);
    for (const Vec2& p : points) spread.add(p);
    const Vec2 along = spread.direction();
    Box2 box;
    for (const Vec2& p : points) box.extend(Vec2(along.dot(p - from), cross(along, p - from)));
    return turned_box(box, along, from);
}

void append_corners(const OrientedBox& box, std::vector<Vec2>& points) {
    const std::array<Vec2, 4> corners = corners_of(box);
    points.insert(points.end(), corners.begin(), corners.end());
}

bool are_apart(const OrientedBox& a, const OrientedBox& b, double distance) {
    const Vec2 d = b.center - a.center;
    const double c = std::abs(a.along.dot(b.along)), s = std::abs(cross(a.along, b.along));
    const auto apart = [&](const OrientedBox& along, const OrientedBox& other) {
        return std::abs(along.along.dot(d)) > along.half.x() + c * other.half.x() + s * other.half.y() + distance ||
               std::abs(cross(along.along, d)) > along.half.y() + s * other.half.x() + c * other.half.y() + distance;
    };
    return apart(a, b) || apart(b, a);
}

/// Of coordinates as large as these, through some ten operations on each of some twenty levels.
double rounding_of(const OrientedBox& box) {
    return 1024 * std::numeric_limits<double>::epsilon() * (box.center.cwiseAbs().maxCoeff() + box.half.sum());
}

std::vector<OrientedTree::Item> items_of(const Part& part) {
    std::vector<OrientedTree::Item> items;
    items.reserve(part.edges.size());
    for (const Edge& edge : part.edges) items.push_back({bounding_box(edge.curve), oriented_box(edge.curve)});
    return items;
}

}  // namespace

OrientedBox oriented_box(const Curve& curve) {
    if (const auto* line = std::get_if<Segment>(&curve)) {
        const double length = (line->to - line->from).norm();
        if (length > 0) return {0.5 * (line->from + line->to), (line->to - line->from) / length, {0.5 * length, 0}};
    } else if (const auto* arc = std::get_if<Arc>(&curve); arc && std::abs(arc->sweep) <= std::numbers::pi) {
        const double half = 0.5 * arc->sweep, middle = arc->start + half, flat = arc->radius * std::cos(half);
        const Vec2 outwards(std::cos(middle), std::sin(middle));
        // Its points are as exact as centre and radius let them be.
        const double rounding = 8 * std::numeric_limits<double>::epsilon() * (arc->radius + arc->center.cwiseAbs().maxCoeff());
        return {arc->center + 0.5 * (arc->radius + flat) * outwards,
                left_of(outwards),
                {arc->radius * std::abs(std::sin(half)) + rounding, 0.5 * (arc->radius - flat) + rounding}};
    }
    return box_along_axes(bounding_box(curve));
}

OrientedBox oriented_box(const std::vector<Box2>& corners) {
    Box2 all;
    for (const Box2& corner : corners) all.extend(corner);
    if (corners.empty()) return {};
    const Vec2 from = corners.front().center(), chord = corners.back().center() - from;
    if (!(chord.norm() > 0)) return box_along_axes(all);
    const Vec2 along = chord.normalized();
    Box2 box;
    for (const Box2& corner : corners)
        for (const Vec2& p : corners_of(box_along_axes(corner))) box.extend(Vec2(along.dot(p - from), cross(along, p - from)));
    return turned_box(box, along, from);
}

OrientedTree::OrientedTree(const Part& part) : OrientedTree(items_of(part)) {}

OrientedTree::OrientedTree(const std::vector<Item>& items) : place_(items.size()) {
    items_.reserve(items.size());
    for (const Item& item : items) {
        items_.push_back({item, static_cast<int>(items_.size())});
        rounding_ = std::max(rounding_, rounding_of(item.turned));
    }
    if (items.empty()) return;
    add_node(0, items_.size());
    for (std::size_t k = 0; k < items_.size(); ++k) place_[at(items_[k].number)] = k;
}

std::size_t OrientedTree::add_leaf(std::size_t begin, std::size_t end) {
    Node leaf{{}, {}, begin, end, 0, 0};
    std::vector<Vec2> corners;
    for (std::size_t i = begin; i < end; ++i) {
        append_corners(items_[i].item.turned, corners);
        leaf.box.extend(items_[i].item.box);
        leaf.last = std::max(leaf.last, items_[i].number);
    }
    leaf.turned = spread_box(corners);
    nodes_.push_back(leaf);
    return nodes_.size() - 1;
}

std::size_t OrientedTree::add_node(std::size_t begin, std::size_t end) {
    if (end - begin <= most_in_leaf) return add_leaf(begin, end);
    Spread spread(items_[begin].item.turned.center);
    for (std::size_t i = begin; i < end; ++i) spread.add(items_[i].item.turned.center);
    const Vec2 along = spread.direction();
    const std::size_t middle = begin + (end - begin) / 2, made = nodes_.size();
    const auto place = [&](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(place(begin), place(middle), place(end), [&](const Numbered& a, const Numbered& b) {
        return along.dot(a.item.turned.center) < along.dot(b.item.turned.center);
    });
    nodes_.emplace_back();
    const Node left = nodes_[add_node(begin, middle)];
    const std::size_t right = add_node(middle, end);
    Node node{left.box, {}, begin, end, right, std::max(left.last, nodes_[right].last)};
    node.box.extend(nodes_[right].box);
    std::vector<Vec2> corners;
    append_corners(left.turned, corners);
    append_corners(nodes_[right].turned, corners);
    node.turned = spread_box(corners);
    nodes_[made] = node;
    return made;
}

void OrientedTree::find(std::size_t node, const Numbered& asked, double margin, std::vector<int>& found) const {
    const Node& n = nodes_[node];
    const double distance = 2 * margin + rounding_;
    if (n.last <= asked.number || !n.box.overlaps(asked.item.box, distance) || are_apart(asked.item.turned, n.turned, distance))
        return;
    if (n.right > 0) {
        find(node + 1, asked, margin, found);
        find(n.right, asked, margin, found);
        return;
    }
    for (std::size_t k = n.begin; k < n.end; ++k) {
        const Numbered& other = items_[k];
        if (other.number > asked.number && other.item.box.overlaps(asked.item.box, margin) &&
            !are_apart(asked.item.turned, other.item.turned, distance))
            found.push_back(other.number);
    }
}

std::vector<int> OrientedTree::near_after(std::size_t i, double margin) const {
    std::vector<int> found;
    find(0, items_[place_[i]], margin, found);
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace abut::geometry
