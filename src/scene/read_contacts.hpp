// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/scene/scene.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Reads the value of "contacts". warnings: what is taken, but doubted, is added.
ContactOptions read_contacts(SceneReading& reading, const JsonValue& contacts, std::vector<std::string>& warnings);

/// Reports friction where contact is by penalty, or supports by a solution structure, which have none.
void refuse_friction_where_unknown(SceneReading& reading, const Scene& scene);

}  // namespace abut
