// SPDX-License-Identifier: GPL-3.0-or-later
// abut init: a starter scene for a drawing or mesh.
#include <filesystem>

#include "apps/begun_scene.hpp"
#include "apps/commands.hpp"
#include "apps/drawing_options.hpp"
#include "apps/print_text.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/io/write_file.hpp"

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
    spec.options = begun_scene_option_specs();
    spec.options.push_back({"-o", "SCENE", "write the scene to this file, which must not be there yet"});
    spec.notes = "abut init clamp.dxf -o clamp.json, then fill in a support and a load, where the scene says so.\n";
    return spec;
}

int init_command(const Arguments& arguments) {
    if (kind_of_file(arguments.operand) == FileKind::scene)
        throw InputError(arguments.operand, "this is a scene already", "give a drawing, a mesh or a STEP file");
    const fs::path file = value_or(arguments, "-o", "");
    StarterChoice choice;
    if (!file.empty()) choice.folder = file.has_parent_path() ? file.parent_path().string() : ".";
    const std::string scene = begun_scene(arguments, choice);
    if (file.empty())
        print_text(scene);
    else
        write_new_scene(file, scene);
    return exit_done;
}

}  // namespace abut
