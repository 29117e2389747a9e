// SPDX-License-Identifier: GPL-3.0-or-later
// Layers whose names may mean a part or lines of drafting: an axis, a frame, a section.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "geometry/sketch/sketch.hpp"

namespace abut::geometry::dxf {

/// Those of the layers of the entities that hold lines of drafting: no two of their lines are joined, and none is closed.
std::set<std::string> layers_of_loose_lines(const std::vector<SketchEntity>& entities);

}  // namespace abut::geometry::dxf
