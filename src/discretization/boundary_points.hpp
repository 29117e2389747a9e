// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a part as its grid sees it.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "src/discretization/discretize.hpp"
#include "src/scene/selection.hpp"

namespace abut {

/// The axis of the grid that a unit vector is parallel to, but for rounding.
std::optional<int> grid_axis(const Vec2& local);

/// The quadrature points of a portion of an edge, fit for loads and supports; around an axis weights carry the radius.
std::vector<geometry::BoundaryPoint> boundary_points(const PartOnGrid& on_grid, const EdgePortion& portion);

/// A traction or a displacement along an edge, of a place and the outward normal there; all in the part's frame.
using EdgeField = std::function<Vec2(const Vec2& x, const Vec2& normal)>;

/// The portion, cut where the field changes within its pieces, so that quadrature between the cuts has its integral to a
/// millionth; a field that is smooth over the portion cuts nothing. What is narrower than a thousandth of the portion may be
/// missed. Cost: 4000 values of the field and more where it is rough.
std::vector<EdgePortion> cut_where_rough(const PartOnGrid& on_grid, const EdgePortion& portion, const EdgeField& field);

}  // namespace abut
