// SPDX-License-Identifier: GPL-3.0-or-later
// Closed boundaries from lists of edges in any order and direction.
#pragma once
#include <string>
#include <vector>

#include "geometry/csg/csg.hpp"

namespace abut::geometry {

/// An edge as a boundary runs through it; `edge` counts the edges of all loops in file order.
struct OrientedEdge {
    int edge = -1;
    bool along = true;  ///< in the edge's own direction?
};

/// A closed chain, head to tail, with the material on its left.
struct BoundaryLoop {
    std::vector<OrientedEdge> edges;
    int hole_of = -1;  ///< index of the outer loop whose hole this is, -1 for an outer loop
};

/// The closed boundaries that lists of edges make, or what is wrong with them.
struct Boundary {
    std::vector<BoundaryLoop> loops;  ///< in order of their first edges; empty if there are problems
    std::vector<GeometryProblem> problems;
    std::vector<Repair> repairs;  ///< one for each edge that was left out
    std::vector<int> dropped;     ///< these edges, ascending: none of the loops holds them
};

/// Chains the edges of each loop (ends join within merge_fraction of the size, and so near an edge counts as touching it),
/// turns outer loops counter-clockwise and holes clockwise; what lies inside an odd number of others is a hole.
/// Edges shorter than merge_fraction of the size are left out: their neighbours' ends, within that length of each other, are
/// then one corner like all ends that join; the curves stay as they were given.
/// Problems: edges that are not finite, have no length at all, run more than once around or meet themselves (name, both
/// parameters, place), open loops (names both edges, distance, place), loops that cross or touch themselves or each other,
/// spikes (edges that run back over each other from their corner), edges or loops drawn twice, vertices touched twice, loops
/// without area or shorter than the tolerance, a name given twice.
/// `where` is the place of the whole, for what concerns no single edge. Cost O(n log n) for drawings whose edges are short.
Boundary boundary_of(const Loops& loops, const std::string& where);

}  // namespace abut::geometry
