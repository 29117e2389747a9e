// SPDX-License-Identifier: GPL-3.0-or-later
// A scene that is begun for a drawing, by the words of a command line.
#pragma once
#include <string>
#include <vector>

#include "apps/arguments.hpp"
#include "src/inspection/starter_scene.hpp"

namespace abut {

/// The options of the drawing (drawing_options.hpp), --strict, --material and --thickness.
std::vector<OptionSpec> begun_scene_option_specs();

/// The text of the scene for the operand, a drawing, mesh or STEP file, under these options. Says on standard error what is
/// doubtful. Throws InputError where the file or an option is wrong.
std::string begun_scene(const Arguments& arguments, StarterChoice choice);

}  // namespace abut
