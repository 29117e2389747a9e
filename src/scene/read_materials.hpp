// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "src/scene/scene.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Reads "parameters" into the reading; each may use those before it.
void read_parameters(SceneReading& reading, const JsonValue& parameters);

/// Reads "materials". Poisson's ratio 0.5 is possible in plane stress only.
std::vector<Material> read_materials(SceneReading& reading, const JsonValue& materials, Analysis analysis);

/// The material of rigid parts, which has no weight.
Material built_in_rigid();

/// Index of the material that a value names; nothing where there is none (reported).
std::optional<int> read_material_name(SceneReading& reading, const JsonValue& value, const std::vector<Material>& materials);

}  // namespace abut
