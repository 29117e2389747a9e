// SPDX-License-Identifier: GPL-3.0-or-later
// Selections of edges, as the scene file writes them.
#pragma once
#include <optional>

#include "src/scene/scene.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Reads the value of "on", or a side of a rule: one selector or a list of them. Empty where it is wrong (reported).
std::optional<Selection> read_selection(SceneReading& reading, const JsonValue& value);

/// Reports every selector that matches no edge of the scene's parts.
void check_selections(SceneReading& reading, Scene& scene);

}  // namespace abut
