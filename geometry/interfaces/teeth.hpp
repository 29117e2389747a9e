// SPDX-License-Identifier: GPL-3.0-or-later
// Is a boundary that of a gear or splined shaft? Told from the curves alone.
#pragma once
#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// Number of teeth of the loop that an edge belongs to: as often as the boundary, seen from the loop's centroid, goes out to
/// the tips and back to the roots, provided that the teeth are evenly spaced and the roots re-entrant (a hexagon has six
/// corners and no teeth). 0: no such boundary; racks, and fewer than least_teeth, are none. Cost O(edges of the loop).
int count_teeth(const Part& part, int edge);

inline constexpr int least_teeth = 6;

}  // namespace abut::geometry
