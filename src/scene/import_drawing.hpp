// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings that a scene refers to: found relative to the scene's folder, brought to the scene's length unit, sorted into parts.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/sketch/sketch.hpp"
#include "src/scene/read_drawing.hpp"
#include "src/scene/scene.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// A drawing in the scene's length unit.
struct ImportedDrawing {
    geometry::Drawing drawing;
    double factor = 1;  ///< from the file's unit to the scene's
};

/// What the imports of one scene share.
struct Imports {
    std::string length_unit;                          ///< the scene's, may be empty
    std::map<std::string, ImportedDrawing> drawings;  ///< by name in the scene and section plane: each is read once
    std::vector<ImportRecord> records;
};

/// Reads the drawing, solids or mesh that `file` (a text, relative to the scene's folder) names; nothing where it cannot be
/// read (reported there). Section of the options matters for solids and meshes, tolerance for meshes only.
const ImportedDrawing* import_drawing(SceneReading& reading, Imports& imports, const JsonValue& file,
                                      const ImportOptions& options);

/// Reads the keys "tolerance", "parts_by", "section" and those about layers, open lines and regions of an assembly or of a
/// `dxf`, `mesh` or `step` node, those that are there.
ImportOptions read_import_options(SceneReading& reading, const JsonValue& object);

/// The parts of those entities that are wanted. Every problem found in them is reported at `at`; nothing then.
std::optional<geometry::SketchParts> import_parts(SceneReading& reading, Imports& imports, const ImportedDrawing& import,
                                                  const JsonValue& at, const ImportOptions& options,
                                                  const std::function<bool(const geometry::SketchEntity&)>& wanted);

/// What bodies are made of: triangles, which have facets to recognise, or exact faces.
enum class BodiesOf { mesh, step };

/// The one part that a `dxf` node (import_part), or a `mesh` or `step` node (import_body) stands for; nothing where there is
/// none (reported).
std::optional<geometry::Imported> import_part(SceneReading& reading, Imports& imports, const JsonValue& node);
std::optional<geometry::Imported> import_body(SceneReading& reading, Imports& imports, const JsonValue& node, BodiesOf bodies);

/// The layers that have entities, in order of first appearance.
std::vector<std::string> layers_of(const geometry::Drawing& drawing);

/// The record of what was read, repaired and left out.
ImportRecord import_record(const geometry::Drawing& drawing, double factor, std::vector<geometry::Repair> repairs,
                           const std::vector<geometry::SketchProblem>& warnings);

}  // namespace abut
