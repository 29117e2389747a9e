// SPDX-License-Identifier: GPL-3.0-or-later
// Which point of the second body faces a point of the first, and along which normal their gap and pressure act.
#pragma once
#include "geometry/proximity/facing.hpp"

namespace abut {

enum class Pairing {
    middle,   ///< on the normal of the middle curve: no body preferred, no couple left over (geometry/proximity/facing.hpp)
    master,   ///< along the first body's own normal n1 [Grishin10, eqs 4.28 and 4.34]; x2 is where that line meets the second
              ///< body, not the point of the same x or y as in eq 4.34: no couple left over, no axis preferred
    bisector  ///< x2 the closest point [Grishin10, eq 4.20], gap along the bisector of n1 and -n2: a couple is left over where
              ///< there is a gap
};

/// The pair of the point at s1 of zone.chain1, started at `guess` for the other arc length. `stretch` is measured along the
/// curve that `pairing` integrates over: the middle curve, or the first body's own (1). `slope` is the middle pairing's.
geometry::FacingPair paired(const geometry::Part& part1, const geometry::Part& part2, const geometry::FacingZone& zone,
                            Pairing pairing, double s1, double guess2);

}  // namespace abut
