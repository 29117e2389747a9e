// SPDX-License-Identifier: GPL-3.0-or-later
// What two parts have in common.
#pragma once
#include "geometry/part.hpp"

namespace abut::geometry {

struct Overlap {
    double area = 0;
    double perimeter = 0;  ///< of the common region, its holes included
    /// Mean thickness of the common region, 2 area / perimeter: a depth that does not depend on which way one looks.
    double depth() const { return perimeter > 0 ? 2 * area / perimeter : 0; }
};

/// The region common to both parts by Green's theorem over its boundary: the boundary of each part inside the other. Boundaries
/// closer than `tolerance` count as coincident, so that parts that only touch have nothing in common; the error of the area is
/// below the tolerance times the perimeter. Cost O(edges near the other part x its edges).
Overlap overlap(const Part& part1, const Part& part2, double tolerance);

}  // namespace abut::geometry
