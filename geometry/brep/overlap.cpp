// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/overlap.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/monotone.hpp"
#include "geometry/curves/curve_meetings.hpp"

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

/// The boundary of the common region: its edges in no particular order (all that areas need), and whose they are.
struct Region {
    Part boundary;
    std::vector<std::array<int, 2>> source;  ///< part (0, 1) and its edge
};

/// Appends the pieces of the boundary of `part` that bound the common region. A piece along both boundaries is to be counted
/// once; one where the boundaries run against each other has material on either side, and bounds nothing in common.
void add_pieces(const std::array<const Part*, 2>& parts, int which, double tolerance, Region& region) {
    const Part &part = *parts[static_cast<std::size_t>(which)], &other = *parts[static_cast<std::size_t>(1 - which)];
    const bool count_shared = which == 0;
    const Box2 reach = bounding_box(other);
    const EdgeTree tree(other);
    const std::vector<MonotonePiece> material = monotone_pieces(other);
    for (std::size_t e = 0; e < part.edges.size(); ++e) {
        const Edge& edge = part.edges[e];
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
            region.boundary.edges.push_back(piece);
            region.source.push_back({which, static_cast<int>(e)});
        }
    }
}

double distance_to(const Box2& box, const Vec2& p) {
    return (box.min - p).cwiseMax(p - box.max).cwiseMax(0.0).norm();
}

struct NearestEdge {
    int edge = -1;
    double distance = std::numeric_limits<double>::infinity();
};
NearestEdge nearest_edge(const Part& part, const std::vector<Box2>& boxes, const Vec2& p) {
    NearestEdge nearest;
    for (std::size_t e = 0; e < part.edges.size(); ++e) {
        if (distance_to(boxes[e], p) >= nearest.distance) continue;
        const Curve& curve = part.edges[e].curve;
        const double distance = (point(curve, closest_parameter(curve, p)) - p).norm();
        if (distance < nearest.distance) nearest = {static_cast<int>(e), distance};
    }
    return nearest;
}

/// The deepest point of the region's boundary, as far as the parts' edges know it.
void find_deepest(const std::array<const Part*, 2>& parts, const Region& region, Overlap& found) {
    constexpr int samples = 32;  // even: the middle is one
    std::array<std::vector<Box2>, 2> boxes;
    for (std::size_t side = 0; side < 2; ++side)
        for (const Edge& edge : parts[side]->edges) boxes[side].push_back(bounding_box(edge.curve));
    double deepest = -1;
    for (std::size_t k = 0; k < region.source.size(); ++k) {
        const auto [which, edge] = region.source[k];
        const auto other = static_cast<std::size_t>(1 - which);
        for (int i = 1; i < samples; ++i) {
            const Vec2 p = point(region.boundary.edges[k].curve, static_cast<double>(i) / samples);
            const NearestEdge nearest = nearest_edge(*parts[other], boxes[other], p);
            if (nearest.distance <= deepest) continue;
            deepest = nearest.distance;
            found.edge1 = which == 0 ? edge : nearest.edge;
            found.edge2 = which == 0 ? nearest.edge : edge;
            found.at = p;
        }
    }
    found.depth = deepest;
}

}  // namespace

Overlap overlap(const Part& part1, const Part& part2, double tolerance) {
    if (!bounding_box(part1).overlaps(bounding_box(part2), 0)) return {};
    const std::array<const Part*, 2> parts{&part1, &part2};
    Region region;
    for (const int which : {0, 1}) add_pieces(parts, which, tolerance, region);
    if (region.source.empty()) return {};
    Overlap found;
    found.area = std::max(0.0, area(region.boundary));
    find_deepest(parts, region, found);
    if (found.depth <= tolerance) found.depth = 2 * found.area / perimeter(region.boundary);
    return found;
}

}  // namespace abut::geometry
