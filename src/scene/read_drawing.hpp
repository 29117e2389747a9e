// SPDX-License-Identifier: GPL-3.0-or-later
// Files that parts can be imported from, whatever their format: drawings (DXF), and solids (STEP) and meshes (STL, OBJ, 3MF,
// ...), which are cut by a plane into one.
#pragma once
#include <map>
#include <optional>
#include <string>

#include "geometry/dxf/dxf.hpp"
#include "geometry/mesh/section.hpp"
#include "geometry/sketch/sketch.hpp"

namespace abut {

/// What a scene's keys, or a command's options, say about an import.
struct ImportOptions {
    double tolerance = 0;     ///< joining and recognising, 0: the default
    std::string length_unit;  ///< of the tolerance; empty: the file's
    std::string units;        ///< overrides or supplies the file's unit; empty: the file's own
    geometry::PartsBy parts_by = geometry::PartsBy::automatic;
    geometry::SectionChoice section;  ///< its place in the file's unit
    bool recognise_arcs = true;       ///< facets and splines that are arcs, or stand for a curve, become arcs
    geometry::LayerFilter layers;     ///< of drawings
    bool leave_open = false, keep_drafting = false;
    std::vector<std::string> block_outline;      ///< blocks of which the outline around everything is taken, as patterns
    std::map<std::string, std::string> regions;  ///< what regions are (geometry::SketchOptions)
};

/// Are there bodies in space in the file, by its ending? Their section has its lines and arcs already.
bool is_solid_file(const std::string& path);
/// Is the file one that read_drawing takes, by its ending?
bool is_importable(const std::string& path);
/// A text for messages: "a drawing (.dxf), solids (.step, ...) or a mesh (.stl, ...)".
std::string importable_kinds();

/// Reads a drawing, or the section of solids or a mesh as one. Throws InputError where nothing can be read; problems of single
/// entities or bodies are in the drawing.
geometry::Drawing read_drawing(const std::string& path, const ImportOptions& options);

/// What these options mean for the making of parts.
geometry::SketchOptions sketch_options(const geometry::Drawing& drawing, const ImportOptions& options);

/// A warning about an import as one line: what, where in the drawing and the file, what to do.
std::string warning_text(const std::string& file, const geometry::SketchProblem& warning);

/// The word of scenes for a way to tell parts apart: "layer", "block", "loop", "color"; "auto" for automatic.
std::string parts_by_name(geometry::PartsBy parts_by);
/// The way that a word of scenes means; "node" stands for bodies in space, which are the layers of their drawing. Unset for
/// other words.
std::optional<geometry::PartsBy> parts_by_of(const std::string& name);

}  // namespace abut
