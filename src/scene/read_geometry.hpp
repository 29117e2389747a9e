// SPDX-License-Identifier: GPL-3.0-or-later
// The "geometry" of a part, as a tree for geometry::evaluate.
#pragma once
#include <optional>

#include "geometry/csg/csg.hpp"
#include "src/scene/import_drawing.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Reads a geometry node with all its children; nothing where a part of it is wrong (reported).
std::optional<geometry::CsgNode> read_geometry(SceneReading& reading, Imports& imports, const JsonValue& node);

/// Reads the value of a "place" that moves `child` (the "of" of a node, or a whole part).
std::optional<geometry::CsgNode> read_place(SceneReading& reading, const JsonValue& place, geometry::CsgNode child);

/// The keys that a "place" may have beside "of".
const Words& place_keys();

}  // namespace abut
