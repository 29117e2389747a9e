// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary inside one cell as strands of contours, each from where the boundary comes in to where it leaves: the first step
// of trace_cell.
#pragma once
#include <span>
#include <vector>

#include "geometry/cells/cut_cells.hpp"

namespace abut::geometry {

/// Crossings of grid lines are known to this fraction of the part's merge length: where the boundary comes back this near to
/// where it left a cell without having been anywhere, it has not left it; stretches of a side that overlap by no more do not
/// connect what lies on both sides of it.
inline constexpr double crossing_fraction = 1e-3;

/// A cell and its contours, those of edges (the first n_edges) with their ends.
struct CellContours {
    const Part* part = nullptr;
    std::span<const ContourPiece> contours;
    std::size_t n_edges = 0;
    std::vector<Vec2> begin, end;  ///< by contour of an edge; contours that follow each other share them bit for bit
    Box2 box;
    double crossing_length = 0;  ///< crossing_fraction times the part's merge length

    const ContourPiece& operator[](std::size_t k) const { return contours[k]; }
    const Curve& curve(std::size_t k) const { return part->edges[static_cast<std::size_t>(contours[k].edge)].curve; }
    std::span<const ContourPiece> right_sides() const { return contours.subspan(n_edges); }
};
void set_cell(CellContours& cell, const Part& part, const CutCells& cells, int c);

/// Contours that continue each other inside the cell, from side to side of it or closed.
struct Strand {
    bool closed;
    double area = 0;     ///< of closed ones, positive where they run counter-clockwise
    int component = -1;  ///< -1: a hole whose component is not known yet
};

/// Where a strand enters or leaves: along the perimeter counter-clockwise, one unit a side, from the lower left corner.
struct StrandEnd {
    double at;
    std::size_t strand;
    bool leaves;
};

/// Contour of an edge that belongs to no strand: it runs along the cell's lower or left side with the material beyond.
inline constexpr std::size_t no_strand = static_cast<std::size_t>(-1);

/// A contour in the order of the walk, with the sides through which the boundary comes and goes: as the walk has noted them, or
/// where it touches a side or runs along it, as below.
struct WalkedContour {
    std::size_t contour;
    CellSide enters, leaves;
};

/// The strands end where the boundary leaves the cell: as the walk has noted it, but not where it comes back at once and from
/// rounding, past a tip of material that only reaches the side. They also end where
///   - a tip of the outside reaches a side, which parts the material on both sides of it;
///   - the boundary runs along the lower or left side with the material beyond: the half-open cell holds that contour, but it
///     bounds nothing in it.
struct Strands {
    std::vector<Strand> strands;
    std::vector<std::size_t> of_contour;  ///< of edges; no_strand
    std::vector<StrandEnd> ends;          ///< of those not closed, in no order
    std::vector<WalkedContour> walked;    ///< of the last loop; kept here so that it need not be allocated for each
};

/// Finds the strands of a cell's contours; `strands` is overwritten. loop_of: the loop of each edge (loops_of_edges).
void find_strands(Strands& strands, const CellContours& cell, const std::vector<int>& loop_of);

}  // namespace abut::geometry
