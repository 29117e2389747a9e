// SPDX-License-Identifier: GPL-3.0-or-later
// Boolean operations on primitives in exact arithmetic.
#pragma once
#include <vector>

#include "geometry/csg/carriers.hpp"
#include "geometry/csg/merge_pieces.hpp"
#include "geometry/csg/primitives.hpp"

namespace abut::geometry {

/// The disc that nothing bounded lies outside of; half planes stand for polygons that reach beyond it.
struct BoundingDisc {
    Vec2 center{0, 0};
    double radius = 1;
};

/// The boundary of an evaluated tree as raw pieces.
struct BooleanBoundary {
    std::vector<std::vector<RawPiece>> loops;  ///< head to tail, material on the left
    std::vector<GeometryProblem> problems;     ///< a boundary that could not be made exact
};

/// Evaluates the tree, whose leaves in reading order are `primitives` and their edges `sources`. Lines and circles of the
/// primitives are taken exactly (their doubles as rational numbers, moved by rational rotations), so coincident and tangent
/// edges are recognised as such. Ellipses and splines are taken as the arcs of their carriers, through three points each whose
/// doubles are taken exactly; consecutive arcs, and a run of arcs and the line or circle that it meets, share an exact point.
/// Corners of loops where a line or circle meets another at an angle are their exact crossing; where they meet tangentially
/// (closer than tangent_sine), the doubles need not cross at all: the corner is then bridged by a line that runs forward along
/// the common tangent, at most bridge_fraction of the size (plus 8 times the gap there) long.
BooleanBoundary boolean_boundary(const CsgNode& tree, const std::vector<Primitive>& primitives,
                                 const std::vector<PlacedSource>& sources, const Carriers& carriers, const BoundingDisc& disc);

inline constexpr double tangent_sine = 1e-3;
inline constexpr double bridge_fraction = 1e-13;

}  // namespace abut::geometry
