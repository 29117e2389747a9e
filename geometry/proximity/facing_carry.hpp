// SPDX-License-Identifier: GPL-3.0-or-later
// A facing zone of two arc splines carried over to the curves that they follow.
#pragma once
#include <vector>

#include "geometry/proximity/facing.hpp"

namespace abut::geometry {

/// A place of the zone on the true chains, from which a pair can be sought.
struct ZoneGuess {
    double s1 = 0, s2 = 0;
};

/// What to carry over: true chains, and the zone's breaks by arc length on them (FoundZone), exact to `error`.
struct CarriedZone {
    Chain chain1, chain2;
    bool closed = false;
    std::vector<ZoneGuess> breaks;
};

/// The lengths that zones are carried over by.
struct CarryLimits {
    double distance;
    double error;  ///< of lengths along the arcs' boundary
    double size;   ///< both parts' diagonals together
};

/// The zones of the true curves between the first and the last break: none, one, or several where the arcs' error hid that the
/// gap exceeds the distance in between.
std::vector<FacingZone> carried_over(const Part& part1, const Part& part2, const CarriedZone& found, const CarryLimits& limits);

}  // namespace abut::geometry
