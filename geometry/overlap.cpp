// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/overlap.hpp"

#include <algorithm>

#include "geometry/curve_meetings.hpp"
#include "geometry/edge_tree.hpp"
#include "geometry/monotone.hpp"

namespace abut::geometry {

namespace {

/// How a piece of one boundary lies to the other part.
enum class Side { inside, outside, along, against };

/// Parameters, ascending from 0 to 1, between which the curve does not meet the boundary of the other part.
std::vector<double> cuts_of(const Curve& curve, const Part& other, const std::vector<int>& near, double tolerance) {
    std::vector<double> cuts{0, 1};
    for (const int e : near)
        for (const Vec2& p : meeting_points(curve, other.edges[static_cast<std::size_t>(e)].curve, tolerance))
            cuts.push_back(closest_parameter(curve, p));
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

Side side_of(const Curve& curve, double t, const Part& other, const std::vector<MonotonePiece>& material,
             const std::vector<int>& near, double tolerance) {
    const Vec2 p = point(curve, t);
    for (const int e : near) {
        const Curve& candidate = other.edges[static_cast<std::size_t>(e)].curve;
        const double u = closest_parameter(candidate, p);
        if ((point(candidate, u) - p).norm() > tolerance) continue;
        return unit_tangent(candidate, u).dot(unit_tangent(curve, t)) > 0 ? Side::along : Side::against;
    }
    return contains(material, p) ? Side::inside : Side::outside;
}

/// Appends the pieces of the boundary of `part` that bound the common region. A piece along both boundaries is to be counted
/// once; one where the boundaries run against each other has material on either side, and bounds nothing in common.
void add_pieces(const Part& part, const Part& other, bool count_shared, double tolerance, Part& region) {
    const Box2 reach = bounding_box(other);
    const EdgeTree tree(other);
    const std::vector<MonotonePiece> material = monotone_pieces(other);
    for (const Edge& edge : part.edges) {
        const Box2 box = bounding_box(edge.curve);
        if (!box.overlaps(reach, tolerance)) continue;
        const std::vector<int> near = tree.near(box, tolerance);
        const std::vector<double> cuts = cuts_of(edge.curve, other, near, tolerance);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if (length(edge.curve, cuts[i], cuts[i + 1]) <= tolerance) continue;
            const Side side = side_of(edge.curve, 0.5 * (cuts[i] + cuts[i + 1]), other, material, near, tolerance);
            if (side != Side::inside && !(side == Side::along && count_shared)) continue;
            Edge piece;
            piece.curve = trimmed(edge.curve, cuts[i], cuts[i + 1]);
            region.edges.push_back(piece);
        }
    }
}

}  // namespace

Overlap overlap(const Part& part1, const Part& part2, double tolerance) {
    if (!bounding_box(part1).overlaps(bounding_box(part2), 0)) return {};
    Part region;  // its edges are the boundary of the common region, in no particular order: all that areas need
    add_pieces(part1, part2, true, tolerance, region);
    add_pieces(part2, part1, false, tolerance, region);
    if (region.edges.empty()) return {};
    return {std::max(0.0, area(region)), perimeter(region)};
}

}  // namespace abut::geometry
