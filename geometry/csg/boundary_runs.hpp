// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of raw pieces along one source edge: the step between what a Boolean leaves behind and a part's edges.
#pragma once
#include <vector>

#include "geometry/csg/merge_pieces.hpp"

namespace abut::geometry {

/// One end of a run.
struct RunEnd {
    Vec2 at{0, 0};
    double t = 0;       ///< parameter on the source; of ellipses and splines only
    Vec2 vertex{0, 0};  ///< where the Boolean put it
};

/// A run: consecutive pieces of one source in one direction.
struct Run {
    int source = -1;
    bool along = true;
    RunEnd from, to;
    int seams = 0;       ///< how often it passes the seam of a closed ellipse, negative against its direction
    bool whole = false;  ///< the run is the whole loop
};

/// The lengths below which things are one.
struct MergeLengths {
    double rounding = 0;   ///< sliver_width_fraction of the size plus the distance from the origin
    double merge = 0;      ///< merge_fraction of the size
    double joint_gap = 0;  ///< what the ends of primitives' edges may be apart: merge_fraction of the size of all sources
};

/// Has the curve no closed form (ellipses and splines)?
bool is_general(const Curve& curve);

/// Has the curve no ends: a full circle or ellipse?
bool is_full(const Curve& curve);

/// Shifts a portion of a full circle or ellipse by whole turns so that its lower end lies in [0, 1); within rounding of the
/// seam it lies on it.
void shift_into_first_turn(double& t_begin, double& t_end);

/// The runs of a loop, head to tail. Runs of closed splines end where the spline begins.
std::vector<Run> runs_of(std::vector<RawPiece> loop, const std::vector<PlacedSource>& sources, double rounding);

/// May b go on where a ends, as one run? Not over the place where a closed spline begins.
bool goes_on(const Run& a, const Run& b, const Curve& source);

/// The signed arc length of a run, negative where its ends have been moved past each other.
double run_length(const Run& run, const Curve& source);

/// The run's curve, along the boundary, and its portion of the source.
Piece restored(const Run& run, const Curve& source, const MergeLengths& lengths);

}  // namespace abut::geometry
