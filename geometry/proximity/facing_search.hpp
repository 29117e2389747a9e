// SPDX-License-Identifier: GPL-3.0-or-later
// The search for facing zones on parts of lines and circles.
#pragma once
#include <vector>

#include "geometry/proximity/facing.hpp"

namespace abut::geometry {

/// A zone and where the stretches that it is joined from meet: between two breaks the gap is monotone. The first break is the
/// zone's beginning, the last its end; arc lengths as in FacingZone (on closed chains they run on past the length).
struct FoundZone {
    struct Break {
        double s1 = 0, s2 = 0;
    };
    FacingZone zone;
    int chain1 = -1, chain2 = -1;  ///< index into the lists of chains
    std::vector<Break> breaks;
};

/// The facing zones of parts of lines and circles, as find_facing_zones has them. The chains are given: what counts as a corner
/// was decided on the true curves, if these are their arc splines. Where edges of a chain join, the tangent may turn by up to
/// `joint_angle` (radians): partners may jump by that times the gap. own: both are the same part, which faces itself across
/// gaps only (the far side of a wall is none of its partners), each zone once.
std::vector<FoundZone> search_zones(const Part& part1, const std::vector<Chain>& chains1, const Part& part2,
                                    const std::vector<Chain>& chains2, double distance, double joint_angle, bool own);

/// The joint_angle of arc splines (radians): their joints turn by far less than chain_angle, but where a side is concave and
/// the gap nears its radius, partners jump by up to 1 / least_spread times as much. Zones closer than this times twice the gap
/// are one.
inline constexpr double arc_joint_angle = 10 * chain_angle;

/// Zones shorter than this fraction of both parts' size are rounding of drawn corners.
inline constexpr double shortest_zone_fraction = 1e-7;

}  // namespace abut::geometry
