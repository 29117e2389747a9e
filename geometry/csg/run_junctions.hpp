// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the ends of a loop's runs where the true curves meet, and leaves out runs that are too short to be edges.
#pragma once
#include <string>
#include <vector>

#include "geometry/csg/boundary_runs.hpp"

namespace abut::geometry {

/// What the runs refer to, and what is one point.
struct RunContext {
    const std::vector<PlacedSource>& sources;
    const std::vector<double>& arc_tolerance;  ///< by source
    MergeLengths lengths;

    const Curve& curve(const Run& run) const { return sources[static_cast<std::size_t>(run.source)].curve; }
    double tolerance(const Run& run) const { return arc_tolerance[static_cast<std::size_t>(run.source)]; }
    std::string name(int source) const;
};

/// Puts the ends of a loop's runs where the true curves meet. Lines and circles meet in the exact vertex as it is, or where
/// they touch if it is only rounding that they cross. Ends of anything else are put at a source's end where the vertex is one,
/// otherwise at the curves' crossing or touching point next to the vertex. What cannot be solved is a problem that names both
/// edges and the place.
void solve_junctions(std::vector<Run>& loop, const RunContext& context, std::vector<GeometryProblem>& unsolved);

/// Appends a problem for each run whose ends have been moved past each other.
void check_directions(const std::vector<Run>& loop, const RunContext& context, std::vector<GeometryProblem>& unsolved);

/// Appends a problem for each end of a run that the next one does not begin at, whatever the reason.
void check_gaps(const std::vector<Run>& loop, const RunContext& context, std::vector<GeometryProblem>& unsolved);

/// Leaves out runs shorter than the merge length. Their neighbours' ends are moved together: to the curves' crossing where
/// there is one, else the end of a line to the other one's. Each is a repair. Runs that stand out from one and the same source
/// before and behind them by a rounding go without a word. The loop is empty if nothing else was in it.
void remove_tiny(std::vector<Run>& loop, const RunContext& context, std::vector<Repair>& repairs);

}  // namespace abut::geometry
