// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/support_components.hpp"

#include <algorithm>
#include <cmath>

#include "solver/assembly/ring.hpp"

namespace abut {

std::vector<HeldComponent> components_of(const Support& support) {
    using Kind = Support::Kind;
    if (support.kind == Kind::symmetry) return {HeldComponent{}};
    std::vector<HeldComponent> list;
    if (support.kind != Kind::fix && support.kind != Kind::displacement && support.kind != Kind::points) return list;
    const bool prescribed = support.kind == Kind::displacement;
    if (support.x) list.push_back({Vec2(1, 0), prescribed ? &support.value[0] : nullptr});
    if (support.y) list.push_back({Vec2(0, 1), prescribed ? &support.value[1] : nullptr});
    return list;
}

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
