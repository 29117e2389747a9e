// SPDX-License-Identifier: GPL-3.0-or-later
// What is in a file: parts, edges with their names, entities read and ignored, repairs, problems.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/scene/read_drawing.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// What `abut inspect` finds in a file.
struct Inspection {
    std::string file, format, unit;
    Scene scene;                     ///< with the parts that could be read
    std::vector<std::string> notes;  ///< of drawings: how the parts were told apart; units that are missing, or replaced
    std::vector<ImportRecord> imports;
    std::vector<geometry::SketchRegion> regions;  ///< of drawings: the areas that lines bound
    std::vector<geometry::SketchProblem> problems;
    std::vector<geometry::Curve> loose;  ///< lines and arcs of a drawing that belong to no part, for the picture
};

/// Inspects a scene (.json), which states the options itself, or anything that can be imported. What is wrong with single
/// outlines of a drawing becomes `problems`; throws InputError where nothing can be read at all.
Inspection inspect_file(const std::string& path, const ImportOptions& options);
/// The repairs of the geometry of the scene's own parts; their texts begin with the part's name.
std::vector<geometry::Repair> geometry_repairs(const Scene& scene);
/// All repairs: those of imports, then those of the scene's own parts.
std::vector<geometry::Repair> all_repairs(const Inspection& inspection);
/// The text that `inspect --json` prints (data/schema/inspect.schema.json).
std::string inspection_json(const Inspection& inspection);
std::string inspection_table(const Inspection& inspection);
/// A picture of all parts with the names and directions of their edges, a scale, and numbered marks at repairs and problems.
std::string inspection_svg(const Inspection& inspection);
/// The picture of inspection_svg as a page: an edge under the pointer is named with its length, a click copies its selector
/// ("jaw/left").
std::string inspection_html(const Inspection& inspection);

/// A picture and the name of its file.
struct InspectionPicture {
    std::string file, svg;
};
/// Draws what an analysis would begin with, where there are parts: inspect_cells.svg, cells of the first grids by class;
/// inspect_pieces.svg, the boundary clipped to them; and, of two parts or more, inspect_candidates.svg, where parts face each
/// other within the first search distance. Drawn overlaps are no fault here. Throws InputError where the scene asks for an
/// impossible grid.
std::vector<InspectionPicture> stage_pictures(const Inspection& inspection);

}  // namespace abut
