// SPDX-License-Identifier: GPL-3.0-or-later
// Where the boundaries of two parts face each other, and the pairing of their points along the normal of the middle curve.
//
// A pair (x1, x2) of facing points lies on one line that makes equal angles with both outward normals:
//   (x2 - x1) x N = 0,   N = n1 - n2,   n = N / |N|,   gap = (x2 - x1) . n   (positive: open).
// Neither body is preferred, and equal and opposite forces along n leave no couple. Where the bodies touch, x1 = x2.
// m = (x1 + x2) / 2 runs along the middle curve.
//
// Forces act along another mean of the normals, weighted by the other side's curvature kappa (acting_zone):
//   N = 2 (w1 n1 - w2 n2),   w1 = |kappa2| / (|kappa1| + |kappa2|),   w2 = 1 - w1.
// For two circles its direction is the same all along the contact, that of the line of centres; a straight side lends its own
// normal to anything curved, and a flat to the corner that stands on it, so that a body that slides along it does no work. A
// round part in a hollow has w1 = 2 |kappa2| / kappa1 (at most 1): where it fits, forces pass through its centre, and turning
// it does no work. That holds beside the hollow, too, on the sides of a slot at whose end a pin rests: it cannot slide along
// them there, and forces that miss its centre on one side only would have nothing to balance them.
#pragma once
#include <array>
#include <vector>

#include "geometry/brep/part.hpp"
#include "geometry/curves/length_table.hpp"

namespace abut::geometry {

/// Consecutive edges of one loop that join with a continuous tangent (within chain_angle), as one curve over its arc length s.
/// A closed loop without any corner is a closed chain: s is then periodic.
struct Chain {
    std::vector<int> edges;
    std::vector<double> begin;           ///< arc length where each edge begins; begin[0] = 0
    std::vector<LengthTable> lengths{};  ///< by edge; without entries for segments and arcs
    double length = 0;
    bool closed = false;
};
inline constexpr double chain_angle = 1e-3;  ///< radians; a sharper turn is a corner

/// The boundary of a part as chains; every edge is in one.
std::vector<Chain> smooth_chains(const Part& part);

/// Is the point at parameter t of an edge a convex corner of the part (a turn above chain_angle)?
bool is_convex_corner(const Part& part, int edge, double t);

/// A point of a chain with the boundary's frame and curvature there.
struct ChainPoint {
    int edge = -1;
    double t = 0;                               ///< parameter of that edge's curve
    Vec2 x{0, 0}, tangent{0, 0}, normal{0, 0};  ///< unit; normal outward
    double curvature = 0;                       ///< signed, positive turning left
};
/// The point of a chain at arc length s, which is taken modulo the length on closed chains and clamped to the ends on open
/// ones.
ChainPoint chain_point(const Part& part, const Chain& chain, double s);

/// A stretch of a chain of part 1 that faces a stretch of a chain of part 2, with one pair for every point.
struct FacingZone {
    Chain chain1, chain2;
    double begin1 = 0, end1 = 0;  ///< arc length on chain 1, begin1 < end1; may run past the length of a closed chain
    double begin2 = 0, end2 = 0;  ///< the partners' on chain 2: begin2 pairs with begin1; begin2 > end2 (chains run opposite)
    double gap_min = 0, gap_max = 0;
    bool closed = false;  ///< a full turn on both closed chains
    bool begin_is_limit = false,
         end_is_limit = false;  ///< ends where the gap exceeds the distance (the zone could be longer), not at a corner
    /// Does N above weigh the normals by curvature? Else both count alike. sharpness: added to the curvatures of both sides;
    /// at_corner: the nearest point of that side is a corner; in_hollow: that side is round, and rests in a hollow that it
    /// fits.
    bool is_acting = false;
    std::array<double, 2> sharpness{0, 0};
    std::array<bool, 2> at_corner{false, false}, in_hollow{false, false};
};

/// A pair of facing points; arc lengths on the zone's chains.
struct FacingPair {
    double s1 = 0, s2 = 0;
    ChainPoint on1, on2;
    Vec2 normal{0, 0};  ///< n above: from body 1 towards body 2
    double gap = 0;
    double slope = 0;        ///< ds2/ds1, negative
    double length_rate = 0;  ///< d(middle curve's length)/ds1, measured across n
    bool found = false;
};

/// The pair of the point at s1 of zone.chain1 (or at s2 of zone.chain2), by safeguarded Newton on the condition above, started
/// at `guess` for the other arc length.
FacingPair pair_from_first(const Part& part1, const Part& part2, const FacingZone& zone, double s1, double guess2);
FacingPair pair_from_second(const Part& part1, const Part& part2, const FacingZone& zone, double s2, double guess1);

/// Rounding of the ends of a zone, as a fraction of the chain: this close to the chain's end, or a partner this little beyond
/// it, is there.
inline constexpr double end_slack = 1e-9;

/// All zones where the gap is at most `distance` (overlaps: gaps down to -distance) and the normals oppose each other within
/// 60 degrees; the nearest partner where there are several, nothing that material lies between. Ordered along part 1.
std::vector<FacingZone> find_facing_zones(const Part& part1, const Part& part2, double distance);

/// The zones where a part faces itself across a gap, within the same limits: each once, along the edge that comes first. Left
/// out are zones all of whose points are nearer to their partners along the boundary than `least_way` gaps: the faces of a
/// notch meet by strains of order one only.
inline constexpr double least_way = 3;
std::vector<FacingZone> find_own_facing_zones(const Part& part, double distance);

/// The zone with pairs along the lines that contact forces act on, its ends paired anew. Where its gap is least at a corner of
/// one side the other side lends its normal to all of it: a corner's curvature has no bound. Where both sides are straight, the
/// side that is nowhere curved in the zone does. A zone beside a corner that these lines pass by, so that its ends would pass
/// each other, stays as it was found.
FacingZone acting_zone(const Part& part1, const Part& part2, FacingZone zone);

}  // namespace abut::geometry
