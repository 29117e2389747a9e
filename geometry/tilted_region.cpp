// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/tilted_region.hpp"

#include <cmath>

namespace abut::geometry {

namespace {

constexpr double angle = 0.7324081924454066;  // radians, no fraction of a turn
const double cosine = std::cos(angle), sine = std::sin(angle);

}  // namespace

TiltedRegion::TiltedRegion(const Part& region) : turned_(transformed(region, cosine, sine, Vec2(0, 0))) {}

bool TiltedRegion::contains(const Vec2& p) const {
    return geometry::contains(turned_, Vec2(cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y()));
}

}  // namespace abut::geometry
