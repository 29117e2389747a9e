// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons cut off at lines, for oracles that owe nothing to any walk along a boundary.
#pragma once
#include "tests/geometry/cells/random_grids.hpp"

namespace abut::geometry::test {

/// What of `polygon` lies left of the line from a to b [Sutherland, Hodgman 1974]; of a non-convex one with bridges of no area.
inline Corners left_half(const Corners& polygon, const Vec2& a, const Vec2& b) {
    Corners kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
        if (at_p >= 0) kept.push_back(p);
        if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.emplace_back(p + at_p / (at_p - at_q) * (q - p));
    }
    return kept;
}

/// What of `polygon` lies in the convex one; may be empty.
inline Corners common(Corners polygon, const Corners& convex) {
    for (std::size_t i = 0; i < convex.size() && !polygon.empty(); ++i)
        polygon = left_half(polygon, convex[i], convex[(i + 1) % convex.size()]);
    return polygon;
}

}  // namespace abut::geometry::test
