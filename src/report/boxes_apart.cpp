// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/boxes_apart.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace abut {

namespace {

using geometry::Box2;
using geometry::Vec2;

Box2 moved(const Box2& box, const Vec2& d) {
    return {box.min + d, box.max + d};
}

std::vector<std::size_t> largest_first(const std::vector<Box2>& boxes) {
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return !boxes[a].empty() && (boxes[b].empty() || boxes[a].size().prod() > boxes[b].size().prod());
    });
    return order;
}

/// The way along an axis past all that stands there. A full gap beyond what is in the way, where half of one is asked for: so
/// rounding never stops it twice at the same box, and every step leaves one box behind.
Vec2 way_out(const Box2& box, const std::vector<Box2>& placed, int axis, bool forwards, double gap) {
    Vec2 shift(0, 0);
    for (;;) {
        const Box2 here = moved(box, shift);
        const auto in_the_way =
            std::find_if(placed.begin(), placed.end(), [&](const Box2& other) { return here.overlaps(other, 0.5 * gap); });
        if (in_the_way == placed.end()) return shift;
        shift[axis] += forwards ? in_the_way->max[axis] + gap - here.min[axis] : in_the_way->min[axis] - gap - here.max[axis];
    }
}

Vec2 shortest_way_out(const Box2& box, const std::vector<Box2>& placed, double gap) {
    std::array<Vec2, 4> ways;
    for (int axis : {0, 1})
        for (const bool forwards : {true, false})
            ways[static_cast<std::size_t>(2 * axis + (forwards ? 0 : 1))] = way_out(box, placed, axis, forwards, gap);
    return *std::min_element(ways.begin(), ways.end(),
                             [](const Vec2& a, const Vec2& b) { return a.lpNorm<1>() < b.lpNorm<1>(); });
}

}  // namespace

std::vector<Vec2> shifts_apart(const std::vector<Box2>& boxes, double gap) {
    std::vector<Vec2> shifts(boxes.size(), Vec2(0, 0));
    std::vector<Box2> placed;
    for (const std::size_t i : largest_first(boxes)) {
        if (boxes[i].empty()) continue;
        shifts[i] = shortest_way_out(boxes[i], placed, gap);
        placed.push_back(moved(boxes[i], shifts[i]));
    }
    return shifts;
}

}  // namespace abut
