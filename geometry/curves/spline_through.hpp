// SPDX-License-Identifier: GPL-3.0-or-later
// The spline through given points, as CAD systems draw one of which only the points are known.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry {

/// Points that a spline is to pass through, and its tangents at the ends where they are given.
struct SplineThrough {
    std::vector<Vec2> points;  ///< to pass through, in order; the first is not repeated where it is closed
    bool closed = false;
    std::optional<Vec2> start_tangent, end_tangent;  ///< directions, of any length
};

/// What is wrong with the points or tangents, as one line for the user; empty if nothing.
std::string through_fault(const SplineThrough& through);

/// The cubic spline through the points, twice continuously differentiable in the chord-length parameter [de Boor, A Practical
/// Guide to Splines, ch. IV]. At the ends it has the given tangent, with speed 1 in that parameter, else no curvature
/// (natural); a closed one is periodic. Points equal to the one before are passed over. Linear cost. The numbers must be valid
/// (through_fault).
Nurbs spline_through(const SplineThrough& through);

}  // namespace abut::geometry
