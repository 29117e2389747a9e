// SPDX-License-Identifier: GPL-3.0-or-later
// Levels of parts that lie above each other in the plan: which parts can meet at all.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/scene/scene.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Do parts on these levels lie side by side, or in each other, anywhere? They do where they have a level in common, or one of
/// them lies on all.
bool have_common_level(const Levels& a, const Levels& b);

/// Reads "level": a whole number from 1, or a list of such numbers.
std::optional<Levels> read_levels(SceneReading& reading, const JsonValue& value);

/// "1", "1, 2"; "all" of none.
std::string levels_text(const Levels& levels);
/// "link 1; pin 1, 2" of the parts that are given levels; empty where none is.
std::string levels_text(const Scene& scene);

}  // namespace abut
