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

/// Index of the material that a value names; nothing where there is none (reported). One of the library that the scene does not
/// define joins the scene's, with a note of its values.
std::optional<int> read_material_name(SceneReading& reading, const JsonValue& value, Scene& scene);

/// Can stresses be converted into these units? Then materials of the library can.
bool knows_stress(const SceneUnits& units);

/// A material of the library in these units. Throws InputError where there is none of this name, or the units are not known.
Material material_from_library(const std::string& name, const SceneUnits& units);

/// Takes the built-in rigid out of the scene's materials where no part is of it.
void drop_unused_rigid(Scene& scene);

/// Why a material's E or density, or the size of a gravity, looks as if it were in other units than the scene's; empty where it
/// does not, or where the scene names no units.
std::string implausible_stiffness(const Material& material, const SceneUnits& units);
std::string implausible_density(const Material& material, const SceneUnits& units);
std::string implausible_gravity(double gravity, const SceneUnits& units);

}  // namespace abut
