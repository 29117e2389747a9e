// SPDX-License-Identifier: GPL-3.0-or-later
// Joins what a Boolean leaves behind (halves of circles, split lines, arcs of splines) to whole pieces of the primitives'
// edges, and puts their ends where the true curves meet.
#pragma once
#include <limits>
#include <vector>

#include "geometry/csg/csg_names.hpp"

namespace abut::geometry {

/// Numbers that stand for sources that are no primitive's edge.
inline constexpr int bridge_source = std::numeric_limits<int>::max();   ///< joins two tangential edges, see boolean.hpp
inline constexpr int far_source = std::numeric_limits<int>::max() - 1;  ///< the artificial end of a half plane

/// A monotone piece of a boundary as the exact arithmetic gives it, rounded.
struct RawPiece {
    int source = -1;
    Vec2 from{0, 0}, to{0, 0};
    int from_vertex = -1;   ///< equal numbers: the same point exactly
    bool along = true;      ///< does it run in the source's own direction?
    double t0 = 0, t1 = 1;  ///< portion of the source that it lies on, t0 < t1: of ellipses and splines what one arc follows
};

/// Ends nearer than this fraction of the size (plus distance from the origin) are one point; loops thinner than it in the mean
/// are what rounding leaves between two edges meant to coincide, and are dropped.
inline constexpr double sliver_width_fraction = 1e-12;

/// The boundary of a Boolean as pieces of the sources' own curves.
struct MergedBoundary {
    std::vector<std::vector<Piece>> loops;
    std::vector<Repair> repairs;            ///< tiny edges and slivers that were left out
    std::vector<GeometryProblem> unsolved;  ///< places where the arcs do not show how the true curves meet
    bool uncertain = false;                 ///< would finer arcs decide something that these could not?
};

/// Splits loops where they touch themselves, drops bridges and slivers, merges adjacent pieces of one source edge, and restores
/// the curves from their sources: lines and circles between the exact vertices, ellipses and splines (and what meets them)
/// between the true curves' crossings. A circle or ellipse that survives as a whole is one piece from its own angle 0; closed
/// splines are cut where they begin. Edges shorter than merge_fraction of the size are left out, their neighbours' ends moved
/// together. `arc_tolerance`, by source: how far its arcs may be from it, 0 for lines and circles; loops thinner than that are
/// slivers too, and are reported.
MergedBoundary merge_pieces(const std::vector<std::vector<RawPiece>>& loops, const std::vector<PlacedSource>& sources,
                            const std::vector<double>& arc_tolerance);

}  // namespace abut::geometry
