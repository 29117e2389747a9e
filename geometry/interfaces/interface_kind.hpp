// SPDX-License-Identifier: GPL-3.0-or-later
// What kind of contact two boundaries make, in an engineer's words.
#pragma once
#include <string>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// The kind of a contact from the edges that carry it, the first part's named first: "flat-on-flat", "flat-on-round",
/// "round-on-flat", "round-on-round", "pin-in-hole" (a convex arc in a concave one of which more than half a turn exists),
/// "round-in-groove" (less than that), "general" (a concave side with anything else). Of an ellipse or a spline the curvature
/// where the edges come closest counts, and half a turn is counted along its chain; one that turns by less than chain_angle is
/// flat.
std::string interface_kind(const Part& part1, int edge1, const Part& part2, int edge2);

/// The kind of a contact at closest points of which at least one is a corner: "edge-on-flat" for a corner on a straight edge,
/// else "general".
std::string corner_interface(const Part& part1, int edge1, double t1, const Part& part2, int edge2, double t2);

}  // namespace abut::geometry
