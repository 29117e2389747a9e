// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_drawing.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "geometry/brep/input_error.hpp"
#include "geometry/brep/message_text.hpp"
#include "geometry/dxf/dxf.hpp"
#include "geometry/step/step.hpp"

namespace abut {

namespace {

using geometry::PartsBy;

bool is_dxf_file(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension == ".dxf";
}

/// Meshes are cut before they are converted to the scene's unit.
double tolerance_in_file(const geometry::MeshFile& mesh, const ImportOptions& options) {
    const std::string& unit = options.units.empty() ? mesh.unit : options.units;
    const double factor = geometry::unit_factor(options.length_unit, unit);
    return factor > 0 ? options.tolerance * factor : options.tolerance;
}

}  // namespace

bool is_solid_file(const std::string& path) {
    return geometry::is_mesh_file(path) || geometry::is_step_file(path);
}

bool is_importable(const std::string& path) {
    return is_dxf_file(path) || is_solid_file(path);
}

std::string importable_kinds() {
    return "a drawing (.dxf), solids (.step, .stp) or a mesh (.stl, .obj, .3mf, .ply, .gltf, .glb, .dae)";
}

geometry::Drawing read_drawing(const std::string& path, const ImportOptions& options) {
    geometry::Drawing drawing;
    if (geometry::is_mesh_file(path)) {
        const geometry::MeshFile mesh = geometry::read_mesh_file(path);
        geometry::Section section =
            geometry::cut(mesh, geometry::plane_of(options.section, mesh.bodies),
                          geometry::SectionOptions{tolerance_in_file(mesh, options), options.recognise_arcs});
        drawing = std::move(section.drawing);
        drawing.repairs = std::move(section.repairs);
    } else if (geometry::is_step_file(path)) {
        drawing = geometry::read_step_file(path, options.section);
    } else if (is_dxf_file(path)) {
        drawing = geometry::read_dxf(path, options.layers);
    } else {
        const std::string extension = std::filesystem::path(path).extension().string();
        throw InputError(
            path, extension.empty() ? "the name has no extension" : "files of the kind '" + extension + "' cannot be read",
            "give " + importable_kinds());
    }
    if (!drawing.cut_at.empty() && (options.section.axis < 0 || !options.section.at))
        drawing.warnings.push_back({"cut at " + drawing.cut_at + ", where nobody asked for another plane",
                                    {0, 0},
                                    {},
                                    0,
                                    "--section (in a scene \"section\") gives axis and place"});
    if (!options.units.empty()) {
        if (drawing.unit != options.units) drawing.replaced_unit = drawing.unit;
        drawing.unit = options.units;
    }
    return drawing;
}

geometry::SketchOptions sketch_options(const geometry::Drawing& drawing, const ImportOptions& options) {
    geometry::SketchOptions sketch;
    sketch.tolerance = options.tolerance;
    sketch.parts_by = options.parts_by;
    sketch.recognise_arcs = options.recognise_arcs && !is_solid_file(drawing.file);  // the section has done that
    sketch.leave_open = options.leave_open;
    sketch.keep_drafting = options.keep_drafting;
    sketch.block_outline = options.block_outline;
    sketch.regions = options.regions;
    return sketch;
}

std::string warning_text(const std::string& file, const geometry::SketchProblem& warning) {
    std::string text = file + (warning.line > 0 ? ":" + std::to_string(warning.line) : "") + ": " + warning.what;
    if (warning.line > 0 || !warning.entity.empty()) text += ", at " + geometry::place_text(warning.at);
    return warning.hint.empty() ? text : text + "; " + warning.hint;
}

std::string parts_by_name(PartsBy parts_by) {
    switch (parts_by) {
        case PartsBy::layer:
            return "layer";
        case PartsBy::block:
            return "block";
        case PartsBy::loop:
            return "loop";
        case PartsBy::color:
            return "color";
        case PartsBy::automatic:
            break;
    }
    return "auto";
}

std::optional<PartsBy> parts_by_of(const std::string& name) {
    if (name == "node") return PartsBy::layer;
    for (const PartsBy way : {PartsBy::automatic, PartsBy::layer, PartsBy::block, PartsBy::loop, PartsBy::color})
        if (name == parts_by_name(way)) return way;
    return std::nullopt;
}

}  // namespace abut
