// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary walked through the grid: the first half of cut_cells.
#pragma once
#include <vector>

#include "geometry/cells/cut_cells.hpp"

namespace abut::geometry {

/// Where the boundary passes from one side of a vertical grid line to the other. Material lies above a crossing to the right.
struct LineCrossing {
    int line;
    double y;
    int turn;  ///< +1: to the right (material begins above), -1: to the left (material ends)
};

/// What the walk of a boundary through a grid has met.
struct GridWalk {
    std::vector<LineCrossing> crossings;  ///< in the order of the walk
    std::vector<ContourPiece> contours;   ///< of edges, inside the grid, in the order of the walk
    std::vector<BoundaryPiece> pieces;    ///< all of every edge, in the order of the walk; cells not yet given (-1)
};

/// The loop of each edge. A part without loops counts as one loop of all its edges in order.
std::vector<int> loops_of_edges(const Part& part);

/// Walks a part's boundary through a grid. Cost O(edges x (log lines) + contours).
GridWalk walk_boundary(const Part& part, const Grid& grid);

}  // namespace abut::geometry
