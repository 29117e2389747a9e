// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/proximity/facing_general.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/curves/arc_spline.hpp"
#include "geometry/curves/curve_polish.hpp"
#include "geometry/curves/piece_pairs.hpp"
#include "geometry/proximity/facing_carry.hpp"
#include "geometry/proximity/facing_search.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// Where an arc lies on the part that it follows.
struct Origin {
    int edge;
    double t0, t1;
    double edge_begin;  ///< arc length on the true chain where the edge begins
};

/// A part as arcs, with the chains that the part itself has: small kinks between arcs are no corners.
struct ArcChains {
    Part part;
    std::vector<Origin> origin;  ///< by edge of `part`
    std::vector<Chain> arcs, curves;
    double tolerance = 0;  ///< the largest that was used
};

Box2 box_of(const Part& part, const Chain& chain) {
    Box2 box;
    for (const int e : chain.edges) box.extend(bounding_box(part.edges[at(e)].curve));
    return box;
}

/// Appends the arcs of one chain. A small hole in a large plate is followed as closely, for its size, as the plate itself:
/// kinks between arcs stay below chain_angle.
void append_chain(const Part& part, const Chain& chain, ArcChains& all) {
    const double tolerance = arc_spline_fraction * box_of(part, chain).diagonal();
    all.tolerance = std::max(all.tolerance, (1 + flat_fraction) * tolerance);
    Chain arcs;
    arcs.closed = chain.closed;
    for (std::size_t i = 0; i < chain.edges.size(); ++i)
        for (const ArcPiece& piece : calm_arc_spline(part.edges[at(chain.edges[i])].curve, tolerance)) {
            arcs.edges.push_back(static_cast<int>(all.part.edges.size()));
            arcs.begin.push_back(arcs.length);
            arcs.length += length(piece.curve);
            Edge edge;
            edge.curve = piece.curve;
            all.part.edges.push_back(edge);
            all.origin.push_back({chain.edges[i], piece.t0, piece.t1, chain.begin[i]});
        }
    all.arcs.push_back(arcs);
    all.curves.push_back(chain);
}

ArcChains arc_chains(const Part& part) {
    ArcChains all;
    for (const Chain& chain : smooth_chains(part)) append_chain(part, chain, all);
    return all;
}

/// Arc length on the true chain of the point closest to the one at s of its arcs. Ends of arcs are points of the curve.
double true_length(const Part& part, const ArcChains& all, int chain, double s) {
    const Chain &arcs = all.arcs[at(chain)], &curves = all.curves[at(chain)];
    const double turns = arcs.closed ? std::floor(s / arcs.length) : 0.0;
    const ChainPoint p = chain_point(all.part, arcs, s);
    const Origin& origin = all.origin[at(p.edge)];
    const Curve& curve = part.edges[at(origin.edge)].curve;
    const double start = origin.t0 + p.t * (origin.t1 - origin.t0);
    const double t = p.t == 0 ? origin.t0 : p.t == 1 ? origin.t1 : nearby_closest_parameter(curve, p.x, start);
    return turns * curves.length + origin.edge_begin + length(curve, 0, t);
}

}  // namespace

std::vector<FacingZone> general_facing_zones(const Part& part1, const Part& part2, double distance, bool own) {
    const ArcChains arcs1 = arc_chains(part1), arcs2 = arc_chains(part2);
    const double error = 2 * (arcs1.tolerance + arcs2.tolerance);
    const double size = bounding_box(part1).diagonal() + bounding_box(part2).diagonal();
    std::vector<FacingZone> zones;
    // tangents of arcs err by up to the kink between them, and so do gaps, relative to themselves: the arcs' zones are searched
    // a little farther, for the true ones to end inside them
    const double far_enough = (1 + most_arc_kink) * distance + error;
    const std::vector<FoundZone> all =
        search_zones(arcs1.part, arcs1.arcs, arcs2.part, arcs2.arcs, far_enough, arc_joint_angle, own);
    for (const FoundZone& found : all) {
        CarriedZone zone{arcs1.curves[at(found.chain1)], arcs2.curves[at(found.chain2)], found.zone.closed, {}};
        for (const FoundZone::Break& b : found.breaks)
            zone.breaks.push_back(
                {true_length(part1, arcs1, found.chain1, b.s1), true_length(part2, arcs2, found.chain2, b.s2)});
        for (const FacingZone& carried : carried_over(part1, part2, zone, {distance, error, size})) zones.push_back(carried);
    }
    return zones;
}

}  // namespace abut::geometry
