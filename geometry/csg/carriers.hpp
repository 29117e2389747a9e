// SPDX-License-Identifier: GPL-3.0-or-later
// The ellipses and splines of a model as Booleans see them: each whole ellipse and each spline shape is a carrier, followed by
// one arc spline, and the edges that lie on it are runs of that spline's arcs. Edges that are the same curve, or portions of
// one, share their arcs exactly, so that coincident edges are recognised as such.
#pragma once
#include <vector>

#include "geometry/csg/csg_names.hpp"

namespace abut::geometry {

/// One arc through three points, from points[i] over `middle` to points[i + 1]; straight where the curve is.
struct CarrierArc {
    Vec2 middle{0, 0};
    bool straight = false;
};

/// A whole ellipse or spline shape with the arcs that follow it.
struct Carrier {
    Curve curve;                   ///< the whole ellipse (from its own angle 0) or spline shape, placed
    bool closed = false;           ///< the last point is the first one
    std::vector<double> t;         ///< parameters of the arcs' ends, ascending from 0 to 1
    std::vector<Vec2> points;      ///< the arcs' ends
    std::vector<CarrierArc> arcs;  ///< points.size() - 1 of them
    double tolerance = 0;          ///< the arcs are nowhere farther than this from the curve
};

/// Where a source lies on its carrier.
struct CarrierRun {
    int carrier = -1;   ///< -1: a line or circle
    bool along = true;  ///< does the source run the carrier's way?
    int first = 0;      ///< the run's first arc in the carrier's direction; it passes the seam of closed ones
    int n_arcs = 0;
    std::vector<double> t;  ///< the source's parameters at the ends of the run's arcs, n_arcs + 1, in the source's direction
};

/// All carriers of a model, and where its sources lie on them.
struct Carriers {
    std::vector<Carrier> carriers;
    std::vector<CarrierRun> of_source;  ///< by source
};

/// Sources whose points lie within `same` (a length) of another one's carrier are put on it: the arcs are those of the longest
/// carrier, the first in reading order among equals. The arc splines' tolerance is `fraction` of each carrier's size.
Carriers carriers_of(const std::vector<PlacedSource>& sources, double same, double fraction);

}  // namespace abut::geometry
