// SPDX-License-Identifier: GPL-3.0-or-later
// What rounding may do to a primitive's loops on their way into exact arithmetic.
#pragma once
#include "geometry/csg/boolean.hpp"

namespace abut::geometry {

/// The length that rounding is relative to: a primitive's extent plus its distance from the origin, where it is placed.
double size_of(const Primitive& primitive);

/// May rounding have made the loop invalid? It moves only arcs that meet other edges, and arc splines; everything else is valid
/// as it was checked.
bool may_be_invalid(const Primitive& primitive, const BoundaryLoop& loop);

/// The problem that tells the user of a loop that rounding made cross itself.
GeometryProblem self_crossing(const Primitive& primitive, const BoundaryLoop& loop);

}  // namespace abut::geometry
