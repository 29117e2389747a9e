// SPDX-License-Identifier: GPL-3.0-or-later
// Closed loops of curves, in order and head to tail, as tests of outlines draw them.
#pragma once
#include <numbers>
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry::outlines {

inline std::vector<Curve> closed(const std::vector<Vec2>& points) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < points.size(); ++i) curves.push_back(Segment{points[i], points[(i + 1) % points.size()]});
    return curves;
}
inline std::vector<Curve> box(double x0, double y0, double x1, double y1) {
    return closed({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}
/// turns: -1 runs clockwise.
inline std::vector<Curve> disc(double x, double y, double r, double turns = 1) {
    return {Arc{{x, y}, r, 0, 2 * std::numbers::pi * turns}};
}

}  // namespace abut::geometry::outlines
