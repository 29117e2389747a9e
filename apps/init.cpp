// SPDX-License-Identifier: GPL-3.0-or-later
// abut init: a starter scene for a drawing or mesh.
#include <filesystem>
#include <iostream>

#include "apps/commands.hpp"
#include "apps/drawing_options.hpp"
#include "apps/drawing_problems.hpp"
#include "apps/print_text.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/contact/detect.hpp"
#include "src/contact/guessed_levels.hpp"
#include "src/inspection/starter_scene.hpp"
#include "src/io/write_file.hpp"
#include "src/scene/read_sketch.hpp"

namespace abut {

namespace {

namespace fs = std::filesystem;

/// What someone has filled in is not written over.
void write_new_scene(const fs::path& file, const std::string& text) {
    if (fs::exists(file)) throw InputError(file.string(), "is there already", "give another name, or remove it");
    write_file(file.parent_path().string(), file.filename().string(), text);
}

}  // namespace

CommandSpec init_spec() {
    CommandSpec spec{"init", "FILE", "Writes a starter scene for a drawing, mesh or STEP file to standard output.", {}, {}};
    spec.options = drawing_option_specs();
    spec.options.push_back(strict_option_spec());
    spec.options.push_back({"-o", "SCENE", "write the scene to this file, which must not be there yet"});
    spec.options.push_back(
        {"--material", "NAME", "material of all parts, of the library: steel (default), aluminium, POM, ..."});
    spec.options.push_back({"--thickness", "T", "thickness of all parts, in the scene's unit of length (default: 1)"});
    spec.notes = "abut init clamp.dxf -o clamp.json, then fill in a support and a load, where the scene says so.\n";
    return spec;
}

int init_command(const Arguments& arguments) {
    if (kind_of_file(arguments.operand) == FileKind::scene)
        throw InputError(arguments.operand, "this is a scene already", "give a drawing, a mesh or a STEP file");
    const fs::path file = value_or(arguments, "-o", "");
    StarterChoice choice;
    choice.material = value_or(arguments, "--material", choice.material);
    choice.thickness = positive_number(arguments, "--thickness");
    if (!file.empty()) choice.folder = file.has_parent_path() ? file.parent_path().string() : ".";
    SketchReading reading = read_whole_sketch(arguments);
    take_guessed_levels(reading.scene);
    refuse_guesses(reading.scene, arguments);
    for (const std::string& warning : reading.scene.warnings) std::cerr << "warning: " << warning << "\n";
    const std::string scene =
        starter_scene(reading, drawing_options(arguments), detect_contacts(reading.scene, std::nullopt), choice);
    if (file.empty())
        print_text(scene);
    else
        write_new_scene(file, scene);
    return exit_done;
}

}  // namespace abut
