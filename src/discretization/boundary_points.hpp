// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a part as its grid sees it.
#pragma once
#include <optional>
#include <vector>

#include "src/discretization/discretize.hpp"
#include "src/scene/selection.hpp"

namespace abut {

/// The axis of the grid that a unit vector is parallel to, but for rounding.
std::optional<int> grid_axis(const Vec2& local);

/// The quadrature points of a portion of an edge, fit for loads and supports; around an axis weights carry the radius.
std::vector<geometry::BoundaryPoint> boundary_points(const PartOnGrid& on_grid, const EdgePortion& portion);

}  // namespace abut
