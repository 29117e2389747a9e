// SPDX-License-Identifier: GPL-3.0-or-later
// Which point of the second body faces a point of the first, and along which normal their gap and pressure act.
#pragma once
#include "geometry/proximity/facing.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// Finds the pair of the point at s1 of zone.chain1, started at `guess2` for the other arc length. `length_rate` is measured
/// along the curve that `pairing` integrates over: the middle curve, or the first body's own (1). `slope` is the middle
/// pairing's.
geometry::FacingPair paired(const geometry::Part& part1, const geometry::Part& part2, const geometry::FacingZone& zone,
                            Pairing pairing, double s1, double guess2);

}  // namespace abut
