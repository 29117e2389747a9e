// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the hard cases: sizes of about 1, about or near the origin.
#pragma once
#include <string>
#include <vector>

#include "geometry/brep/part.hpp"

namespace abut::test {

using geometry::Vec2;

/// Edges e0 (from the first point to the second), e1, ... of a polygon, counter-clockwise.
geometry::Part polygon(const std::vector<Vec2>& points);
geometry::Part rectangle(const Vec2& min, const Vec2& max);
geometry::Part disc(const Vec2& center, double radius);
/// The L of E9, [-1, 1]^2 without its lower left quarter; corner at the origin. e0 and e5 meet there.
geometry::Part ell();
geometry::Part turned_square(const Vec2& center, double side, double degrees);

/// E3's quarter: [0, size]^2 without the unit disc about the origin. Edges: bottom, right, top, left, arc.
geometry::Part plate_quarter(double size);
/// E4's quarter ring about the origin. Edges: bottom, outer arc, left, inner arc.
geometry::Part ring_quarter(double inner, double outer);
geometry::Part ring(double inner, double outer);

/// A rectangle with its corner in the origin, with a round hole, a hole of two cubic Bezier curves, and a right side that is
/// one, curved inwards. Edges 0 bottom, 1 right, 2 top, 3 left.
geometry::Part plate_with_splines();

geometry::Part with_hole(geometry::Part part, const Vec2& center, double radius);

/// The parts of the sliver sweeps.
struct SweptShape {
    std::string name;
    geometry::Part part;
    int held;   ///< the edge that Nitsche's method holds
    bool tips;  ///< has it corners that poke into a cell with nothing beside them?
};
const std::vector<SweptShape>& swept_shapes();

}  // namespace abut::test
