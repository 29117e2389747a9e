// SPDX-License-Identifier: GPL-3.0-or-later
// Closed boundaries out of edges in any order and orientation, and what can be wrong with them.
#pragma once
#include <string>
#include <vector>

#include "geometry/csg.hpp"

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

struct Boundary {
    std::vector<BoundaryLoop> loops;  ///< in order of their first edges; empty if there are problems
    std::vector<GeometryProblem> problems;
};

/// Chains the edges of each loop (ends join within merge_fraction of the size, and so near an edge counts as touching it),
/// turns outer loops counter-clockwise and holes clockwise; what lies inside an odd number of others is a hole.
/// Problems: edges that are not finite or have no length, open loops (names both edges, distance, place), loops that cross
/// or touch themselves or each other, edges drawn twice, vertices touched twice, loops without area, a name given twice.
/// `where` is the place of the whole, for what concerns no single edge. Cost O(n log n) for drawings whose edges are short.
Boundary boundary_of(const Loops& loops, const std::string& where);

}  // namespace abut::geometry
