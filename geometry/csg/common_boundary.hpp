// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of what two parts have in common, by exact arithmetic.
#pragma once
#include <vector>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// A portion [t0, t1] of an edge of one of two parts (0, 1).
struct BoundaryStretch {
    int part = 0, edge = -1;
    double t0 = 0, t1 = 1;
};

/// The stretches of both boundaries that bound what the parts have in common, in no particular order, all with the common
/// material on their left: those inside the other part, and once each those along which both boundaries run the same way. Which
/// these are is decided exactly, for lines and arcs between doubles as exact_outline.hpp has them; ends are rounded, and
/// stretches that are no longer than rounding are left out. Ellipses and splines are taken by arc splines within `tolerance`;
/// where they cross other edges is found on the curves themselves. Cost O((n + pairs that come near) log n): some microseconds
/// an edge, and 10 to 100 for each two that meet elsewhere than at corners.
std::vector<BoundaryStretch> common_boundary(const Part& part1, const Part& part2, double tolerance);

}  // namespace abut::geometry
