// SPDX-License-Identifier: GPL-3.0-or-later
// A part of as many edges as wanted, of every kind of curve.
#pragma once
#include <cstdint>

#include "geometry/cells/cut_cells.hpp"

namespace abut::benchmarks {

enum EdgeKind : std::int64_t { lines, arcs, ellipses, cubics };

/// Flat enough for neighbours not to cross.
geometry::Curve edge_between(EdgeKind kind, const geometry::Vec2& p, const geometry::Vec2& q);

/// A wheel of radius 1 with waves, of n edges.
geometry::Part wheel(EdgeKind kind, int n);

/// n x n cells, not uniform, with the part's box and a little more.
geometry::Grid grid_around(const geometry::Part& part, int n);

}  // namespace abut::benchmarks
