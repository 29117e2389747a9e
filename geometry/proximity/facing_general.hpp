// SPDX-License-Identifier: GPL-3.0-or-later
// Facing zones of parts with ellipses and splines.
#pragma once
#include <vector>

#include "geometry/proximity/facing.hpp"

namespace abut::geometry {

/// The facing zones of parts with curves of any kind, in three steps:
/// 1. Every chain is followed by arcs, within arc_spline_fraction of its own size.               (arc_spline)
/// 2. Zones of the arcs, at a distance larger by their error.                                    (facing_search)
/// 3. Each is carried over to the true chains: its breaks are paired again by pair_from_first; extrema of the gap are found
/// where
///    the normals are parallel; ends are the true corners, the true images of corners, or where the true gap reaches the
///    distance and the true normals 60 degrees. Only where a nearer partner or material in between takes over, and near centres
///    of curvature, ends are those of the arcs (off by their error, there of their curvature).      (facing_carry)
std::vector<FacingZone> general_facing_zones(const Part& part1, const Part& part2, double distance, bool own);

}  // namespace abut::geometry
