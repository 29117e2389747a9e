// SPDX-License-Identifier: GPL-3.0-or-later
// Is a point inside a region whose edges were drawn along the axes?
#pragma once
#include "geometry/part.hpp"

namespace abut::geometry {

/// The region turned by an angle that no drawing uses. `contains` sends a ray along x; in a drawing the rays through its own
/// points pass exactly through other vertices, where the two edges' ends differ by rounding errors and may be counted twice or
/// not at all.
class TiltedRegion {
public:
    explicit TiltedRegion(const Part& region);
    bool contains(const Vec2& p) const;

private:
    Part turned_;
};

}  // namespace abut::geometry
