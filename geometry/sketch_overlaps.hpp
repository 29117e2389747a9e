// SPDX-License-Identifier: GPL-3.0-or-later
// Entities that a drawing holds twice, or that lie wholly on another one.
#pragma once
#include <vector>

#include "geometry/sketch.hpp"

namespace abut::geometry {

/// Removes every entity that covers another one and is covered by it, within the tolerance over all its length: of such two the
/// one that comes first in the file stays. Each removal is a repair (at the middle of the entity, size its length).
/// Cost O(n log n) for drawings whose entities are spread out.
void remove_duplicates(std::vector<SketchEntity>& entities, double tolerance, std::vector<Repair>& repairs);

/// Removes the loose entities that lie on a longer one. Those that are not loose stay: on one layer two parts may touch along
/// edges of different lengths. Returns whether any was removed.
bool remove_covered(std::vector<SketchEntity>& entities, const std::vector<bool>& is_loose, double tolerance,
                    std::vector<Repair>& repairs);

}  // namespace abut::geometry
