// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "src/scene/scene.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// These read "supports" and "loads". Entries that are wrong are reported and left out.
std::vector<Support> read_supports(SceneReading& reading, const JsonValue& supports);
std::vector<Load> read_loads(SceneReading& reading, const JsonValue& loads);

}  // namespace abut
