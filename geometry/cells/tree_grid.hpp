// SPDX-License-Identifier: GPL-3.0-or-later
// Grids whose cells are halved where it is asked for: quadtrees of cells, cut at the cost of what they hold.
//
// A cell's quarters are cut from what the cell holds: its contours of edges are walked over its two middle lines by the walk
// that takes the whole boundary through a grid (grid_walk.hpp), with the same half-open rule. Quarters 1 and 3 share the cell's
// right side; the material along the right side of 0 and 2, the upright middle line, goes from crossing to crossing. Whether it
// begins with material follows from the contours on the right of the line, which are closed by it: the sum of their dy is the
// length of material on the line.
#pragma once
#include <functional>

#include "geometry/cells/cut_cells.hpp"

namespace abut::geometry {

/// Is a cell that has been halved so many times to be halved again?
using WantsHalving = std::function<bool(const Box2& cell, int level)>;

/// The base's cells, halved as wanted and so that of two cells that share a side or a corner none has been halved more than
/// once more than the other. Cells without material are not halved, and ask for nothing. The base has no tree.
Grid tree_grid(const Part& part, const Grid& base, const WantsHalving& wants);

/// cut_cells() of a grid with a tree.
CutCells cut_tree(const Part& part, const Grid& grid);

}  // namespace abut::geometry
