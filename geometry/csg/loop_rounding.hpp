// SPDX-License-Identifier: GPL-3.0-or-later
// What rounding may do to a primitive's loops on their way into exact arithmetic.
#pragma once
#include "geometry/csg/boolean.hpp"

namespace abut::geometry {

/// Extent and distance from the origin: what rounding is relative to.
double size_of(const Primitive& primitive);

/// Only arcs that meet other edges, and arc splines, are moved by rounding; everything else is valid as it was checked.
bool may_be_invalid(const Primitive& primitive, const BoundaryLoop& loop);

/// For a loop that rounding made cross itself.
GeometryProblem self_crossing(const Primitive& primitive, const BoundaryLoop& loop);

}  // namespace abut::geometry
