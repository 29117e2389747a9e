// SPDX-License-Identifier: GPL-3.0-or-later
// Entities that a drawing holds twice, or that lie wholly on another one.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_joints.hpp"

namespace abut::geometry {

/// Removes every entity that covers another one and is covered by it, within the tolerance over all its length: of such two the
/// one that comes first in the file stays, and counts how often it was drawn. Segments of one polyline that run there and back
/// both go. Each removal is a repair (at the middle of the
/// entity, size its length). Cost O(n log n) for drawings whose entities are spread out.
bool remove_duplicates(std::vector<SketchPiece>& entities, double tolerance, std::vector<Repair>& repairs);

/// Removes one of two entities that run between the same joints, within the (wider) tolerance of these; otherwise as
/// remove_duplicates.
bool remove_twins(std::vector<SketchPiece>& entities, const Joints& joints, double tolerance, std::vector<Repair>& repairs);

/// Removes the loose entities with an end of no use (where nothing continues it, or where two others meet already) that lie on
/// another one, longer or, if both are loose, as long. Those that are not loose stay: on one layer two parts may touch along
/// edges of different lengths. Returns whether any was removed.
bool remove_covered(std::vector<SketchPiece>& entities, const Joints& joints, const std::vector<bool>& is_loose,
                    double tolerance, std::vector<Repair>& repairs);

}  // namespace abut::geometry
