// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary walked through the grid: the first half of cut_cells.
#pragma once
#include <span>
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

/// Walks the boundary inside one cell, its contours of edges in their order, through the cell's four quarters: contours of
/// quarters 0 to 3, x fastest, and crossings of the line between them, which is line 1. middle: the quarters' common corner.
GridWalk walk_quarters(const Part& part, std::span<const ContourPiece> edges, const std::vector<int>& loop_of,
                       const Vec2& middle);

/// Walks a part's boundary through a grid. Cost O(edges x (log lines) + contours).
GridWalk walk_boundary(const Part& part, const Grid& grid);

}  // namespace abut::geometry
