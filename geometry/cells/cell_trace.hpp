// SPDX-License-Identifier: GPL-3.0-or-later
// The connected components of one cell and the part: the inner loop of find_elements.
//
// The boundary comes into a cell and leaves it in strands of contours. Material lies on its left: from where a strand leaves,
// counter-clockwise along the cell's perimeter, there is material up to where the next strand enters. Strands joined by these
// stretches are closed curves, each the outline of one component; so is every loop wholly inside that runs counter-clockwise.
// Clockwise ones are holes of what is around them. A perimeter without strands is all material or none.
//
//       +---<-----x-------+     leaves at x, enters at e: the stretches from x to e, and the strand from e to x, bound one
//       |         |       |     component here (with a hole, o)
//       |   o     |       |
//       |         ^       |
//       +---------e-->----+
#pragma once
#include <vector>

#include "geometry/cells/cell_strands.hpp"

namespace abut::geometry {

/// A stretch of a cell's side with material on the inner side of it: coordinates along the side, from < to.
struct SideStretch {
    int component;
    CellSide side;
    double from, to;
};

/// The components of one cell and the part. Component 0 is the largest; those below sliver_fraction do not count and are called
/// -1.
struct CellTrace {
    std::vector<double> fraction;        ///< of the cell's area, by component; where there is one, not given
    std::vector<int> of_contour;         ///< component of each of the cell's contours
    std::vector<SideStretch> stretches;  ///< by side, then ascending
    bool unclear = false;                ///< rounding does not tell the components apart: taken as one, with all four sides
    CellContours cell;                   ///< what it was made from
    Strands strands;
    int n_components() const { return fraction.empty() ? 1 : static_cast<int>(fraction.size()); }
};

/// Finds the components of a boundary cell. loop_of: loops_of_edges(part). `trace` is overwritten; keep it over cells, so that
/// it allocates nothing. Cost O(contours of the cell), with holes in a cell of several components O(holes x contours).
void trace_cell(CellTrace& trace, const Part& part, const CutCells& cells, const std::vector<int>& loop_of, int cell);

}  // namespace abut::geometry
