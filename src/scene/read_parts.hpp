// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/scene/import_drawing.hpp"
#include "src/scene/scene.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Reads the entries of "parts" and evaluates their geometry; appends those that are right to scene.parts, and their names
/// (also of those that are not) to reading.part_names. Uses scene.materials.
void read_parts(SceneReading& reading, Imports& imports, const JsonValue& parts, double thickness, Scene& scene);

/// Reads "assembly": a drawing with one part per layer. Appends like read_parts.
void read_assembly(SceneReading& reading, Imports& imports, const JsonValue& assembly, double thickness, Scene& scene);

/// Notes a part's name; reports at `at` where another part has it.
void note_part_name(SceneReading& reading, const JsonValue& at, const std::string& name);

/// A part's name as the user may choose it: not empty, without '/', '#' and '*'.
std::optional<std::string> read_new_part_name(SceneReading& reading, const JsonValue& value);

}  // namespace abut
