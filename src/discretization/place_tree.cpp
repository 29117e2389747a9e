// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/place_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut {

namespace {

using geometry::Box2;

constexpr std::size_t places_of_leaf = 8;

double distance(const Box2& box, const Vec2& p) {
    return (p - p.cwiseMax(box.min).cwiseMin(box.max)).norm();
}

double distance(const Box2& a, const Box2& b) {
    return (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(0).norm();
}

/// Does the segment from a to b meet a box?
bool meets(const Box2& box, const Vec2& a, const Vec2& b) {
    double from = 0, to = 1;
    for (int axis : {0, 1}) {
        const double d = b[axis] - a[axis], low = box.min[axis] - a[axis], high = box.max[axis] - a[axis];
        if (d == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        from = std::max(from, std::min(low / d, high / d));
        to = std::min(to, std::max(low / d, high / d));
    }
    return from <= to;
}

/// Exactly: points along the segment, however dense, let cells in that are too large beside it.
double distance(const Box2& box, const Vec2& a, const Vec2& b) {
    if (meets(box, a, b)) return 0;
    double least = std::min(distance(box, a), distance(box, b));
    const Vec2 along = b - a;
    for (const Vec2& corner : {box.min, box.max, Vec2(box.min.x(), box.max.y()), Vec2(box.max.x(), box.min.y())}) {
        const double squared = along.squaredNorm();
        const double t = squared > 0 ? std::clamp((corner - a).dot(along) / squared, 0.0, 1.0) : 0.0;
        least = std::min(least, (a + t * along - corner).norm());
    }
    return least;
}

/// Cells with such a side are too large nearer than this.
double reach_of(double side, double size, double growth) {
    return (side - size) / growth;
}

bool wants_smaller(const SizeFeature& place, const Box2& cell, double side) {
    const double reach = reach_of(side, place.size, place.growth);
    if (reach <= 0 || distance(cell, place.box) >= reach) return false;
    if (place.line.size() < 2) return true;
    for (std::size_t k = 0; k + 1 < place.line.size(); ++k)
        if (distance(cell, place.line[k], place.line[k + 1]) < reach) return true;
    return false;
}

}  // namespace

PlaceTree::PlaceTree(std::vector<SizeFeature> places) : places_(std::move(places)) {
    if (!places_.empty()) add_node(0, places_.size());
}

std::size_t PlaceTree::add_node(std::size_t begin, std::size_t end) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Node node{{}, infinite, infinite, begin, end, 0};
    for (std::size_t k = begin; k < end; ++k) {
        node.box.extend(places_[k].box);
        node.size = std::min(node.size, places_[k].size);
        node.growth = std::min(node.growth, places_[k].growth);
    }
    const std::size_t number = nodes_.size();
    nodes_.push_back(node);
    if (end - begin <= places_of_leaf) return number;
    const int axis = node.box.size().x() > node.box.size().y() ? 0 : 1;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto place = [&](std::size_t k) { return places_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(place(begin), place(middle), place(end), [&](const SizeFeature& a, const SizeFeature& b) {
        return a.box.min[axis] + a.box.max[axis] < b.box.min[axis] + b.box.max[axis];
    });
    add_node(begin, middle);
    const std::size_t second = add_node(middle, end);
    nodes_[number].second = second;
    return number;
}

bool PlaceTree::is_too_large(const Box2& cell) const {
    return !nodes_.empty() && is_too_large_for(0, cell, cell.size().maxCoeff() * (1 - 1e-9));
}

bool PlaceTree::is_too_large_for(std::size_t number, const Box2& cell, double side) const {
    const Node& node = nodes_[number];
    const double reach = reach_of(side, node.size, node.growth);
    if (reach <= 0 || distance(cell, node.box) >= reach) return false;
    if (node.second != 0) return is_too_large_for(number + 1, cell, side) || is_too_large_for(node.second, cell, side);
    for (std::size_t k = node.begin; k < node.end; ++k)
        if (wants_smaller(places_[k], cell, side)) return true;
    return false;
}

}  // namespace abut
