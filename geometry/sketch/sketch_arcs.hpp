// SPDX-License-Identifier: GPL-3.0-or-later
// Entities that stand for lines and circular arcs: splines, ellipses, chains of facets.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_joints.hpp"

namespace abut::geometry {

/// A spline or ellipse that is a line or an arc keeps to it within this fraction of its own size: exporters write the control
/// points with about seven digits, and curves that are none are off by far more.
inline constexpr double arc_likeness = 2e-6;

/// Replaces splines and ellipses by the lines and arcs that they stand for; each is a repair (size: arc_likeness of the entity
/// at most).
void recognise_curves(std::vector<SketchPiece>& entities, std::vector<Repair>& repairs);

/// Replaces chains of segments by arcs where their joints lie on one within the tolerance (arc_fit.hpp). An arc stands where
/// its first segment stood, and has its name. Each is a repair at the middle of the arc; its size is the largest distance of a
/// joint from it. Returns whether any was found: the joints are out of date then.
/// written: what rounding moves the joints by, if known.
bool recognise_facets(std::vector<SketchPiece>& entities, const Joints& joints, double tolerance, double written,
                      std::vector<Repair>& repairs);

}  // namespace abut::geometry
