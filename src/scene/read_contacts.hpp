// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/scene/scene.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Reads the value of "contacts".
ContactOptions read_contacts(SceneReading& reading, const JsonValue& contacts);

}  // namespace abut
