// SPDX-License-Identifier: GPL-3.0-or-later
// The stage "proximity": which edges of different parts come close to each other face to face, one pair of points for each pair
// of edges.
//
// When to use which: this stage is the quick and complete list of what could touch, corners that point at a face or at each
// other included; it takes each pair of edges at its closest points only and joins nothing. Facing zones (facing.hpp) follow
// the boundaries over all the length on which they face each other, which is what contact is computed on, but need some length
// to exist. closest_points (closest_points.hpp) gives the one closest pair of two parts, whichever way they face.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

struct EdgePairCandidate {
    int part1 = -1, edge1 = -1, part2 = -1, edge2 = -1;  ///< part1 < part2
    double t1 = 0, t2 = 0;                               ///< parameters of the edges' curves
    Vec2 x1{0, 0}, x2{0, 0};
    double distance = 0;  ///< |x2 - x1|; 0 where the edges cross or touch
};

/// Normals oppose each other where the cosine of the angle between them lies below minus this: perpendicular ones do not,
/// however the last digits fall.
inline constexpr double opposed_cosine = 1e-9;

/// The directions that count as outward at a point of a part's boundary. Inside an edge: its outward normal. At an edge's end:
/// the outward normals of both edges that meet there, and where the corner is convex (a spike's tip too) all directions between
/// them. Two points oppose each other if any direction of the one opposes any of the other. Trying `normals` decides that: each
/// direction of a convex corner lies between two of them at most a right angle apart, hence is a sum of these with positive
/// factors, and its cosines with the other point's directions cannot all be at least 0 for the two and negative for the sum.
struct OutwardDirections {
    std::array<Vec2, 3> normals;  ///< unit: the edge's own, the other edge's, the middle one
    int n_normals = 0;
};
bool oppose(const OutwardDirections& first, const OutwardDirections& second);

/// The edges before and after each edge in its loop: what meets at corners.
struct EdgeNeighbours {
    explicit EdgeNeighbours(const Part& part);
    std::vector<int> before, after;
};
OutwardDirections outward_directions(const Part& part, const EdgeNeighbours& neighbours, int edge, double t);

/// The candidate of one pair of edges (part numbers left at -1): closest points by closest_points(curve, curve), where these
/// are within `distance` and the boundaries oppose each other there.
std::optional<EdgePairCandidate> close_edge_pair(const Part& part1, const EdgeNeighbours& neighbours1, int edge1,
                                                 const Part& part2, const EdgeNeighbours& neighbours2, int edge2,
                                                 double distance);

/// All of them, for all pairs of edges of different parts, ordered by part1, part2, edge1, edge2. Cost O(n log n) and one
/// close_edge_pair for each pair whose boxes come within the distance.
std::vector<EdgePairCandidate> close_edge_pairs(const std::vector<Part>& parts, double distance);

}  // namespace abut::geometry
