// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that are copies of one: along a line or around a point.
#pragma once
#include <vector>

#include "geometry/csg/csg.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Reads a part's `array`: how each copy is placed, the first one as drawn. Nothing where it is wrong.
std::vector<geometry::Placed> read_array(SceneReading& reading, const JsonValue& array);

}  // namespace abut
