// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/boundary_points.hpp"

#include <algorithm>
#include <cmath>

#include "solver/assembly/ring.hpp"

namespace abut {

std::optional<int> grid_axis(const Vec2& local) {
    constexpr double parallel = 1e-12;  // sine of the angle that rounding leaves between a direction and a grid axis
    const int axis = std::abs(local.x()) > std::abs(local.y()) ? 0 : 1;
    return std::abs(local[1 - axis]) <= parallel ? std::optional<int>(axis) : std::nullopt;
}

std::vector<geometry::BoundaryPoint> boundary_points(const PartOnGrid& g, const EdgePortion& portion) {
    const int degree = std::max(g.input.space.x.degree, g.input.space.y.degree);
    auto points = boundary_rule(g.local, g.cells, g.elements, portion.edge, portion.t0, portion.t1, degree + 2);
    if (g.input.axis)
        for (geometry::BoundaryPoint& p : points) p.weight *= std::max(0.0, solver::radius(g.input, p.x));
    return points;
}

}  // namespace abut
