// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings that a scene refers to: found relative to the scene's folder, brought to the scene's length unit, sorted into parts.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/sketch.hpp"
#include "src/scene.hpp"
#include "src/scene_fields.hpp"

namespace abut {

/// A drawing in the scene's length unit.
struct ImportedDrawing {
    geometry::Drawing drawing;
    double factor = 1;  ///< from the file's unit to the scene's
};

/// What the imports of one scene share.
struct Imports {
    std::string length_unit;                          ///< the scene's, may be empty
    std::map<std::string, ImportedDrawing> drawings;  ///< by the name in the scene: each file is read once
    std::vector<ImportRecord> records;
};

/// Reads the drawing that `file` (a text, relative to the scene's folder) names; nothing where it cannot be read (reported
/// there).
const ImportedDrawing* import_drawing(SceneReading& reading, Imports& imports, const JsonValue& file);

/// The parts of those layers that are wanted. Every problem found in them is reported at `at`; nothing then.
std::optional<geometry::SketchParts> import_parts(SceneReading& reading, Imports& imports, const ImportedDrawing& import,
                                                  const JsonValue& at, double tolerance,
                                                  const std::function<bool(const std::string& layer)>& wanted);

/// The one part that a `dxf` node stands for.
std::optional<geometry::Part> import_part(SceneReading& reading, Imports& imports, const JsonValue& node);

/// The layers that have entities, in order of first appearance.
std::vector<std::string> layers_of(const geometry::Drawing& drawing);

/// What was read, repaired and left out.
ImportRecord import_record(const geometry::Drawing& drawing, double factor, std::vector<geometry::Repair> repairs);

}  // namespace abut
