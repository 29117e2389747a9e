// SPDX-License-Identifier: GPL-3.0-or-later
// abut init: a starter scene for a drawing or mesh, on standard output.
#include "apps/commands.hpp"
#include "apps/drawing_options.hpp"
#include "apps/drawing_problems.hpp"
#include "apps/print_text.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/contact/detect.hpp"
#include "src/inspection/starter_scene.hpp"
#include "src/scene/read_sketch.hpp"

namespace abut {

CommandSpec init_spec() {
    CommandSpec spec{"init", "FILE", "Writes a starter scene for a drawing or mesh to standard output.", {}, {}};
    spec.options = drawing_option_specs();
    spec.notes = "abut init clamp.dxf > clamp.json, then fill in a support and a load, where the scene says so.\n";
    return spec;
}

int init_command(const Arguments& arguments) {
    if (kind_of_file(arguments.operand) == FileKind::scene)
        throw InputError(arguments.operand, "this is a scene already", "give a drawing or a mesh");
    const SketchReading reading = read_whole_sketch(arguments);
    print_text(starter_scene(reading, drawing_options(arguments), detect_contacts(reading.scene, std::nullopt)));
    return exit_done;
}

}  // namespace abut
