// SPDX-License-Identifier: GPL-3.0-or-later
// Boundaries that are given edge by edge: the value of a `loops` node.
#pragma once
#include <optional>
#include <string>

#include "geometry/csg/csg.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Reads edges in the file's own direction and order, named `e0`, `e1`, ... over all loops where they have no name of their
/// own. A NURBS that falls into several smooth pieces becomes as many edges, `e3#0`, `e3#1`, ... Nothing where an edge is wrong
/// (reported). It is for geometry::evaluate to say that edges do not meet.
std::optional<geometry::Loops> read_loops(SceneReading& reading, const JsonValue& value);

/// Reads the optional "name" of a node or an edge; empty where it is absent or wrong (reported).
std::string read_edge_prefix(SceneReading& reading, const JsonValue& object);

}  // namespace abut
