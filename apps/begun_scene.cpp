// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/begun_scene.hpp"

#include <iostream>

#include "apps/drawing_options.hpp"
#include "apps/drawing_problems.hpp"
#include "src/contact/detect.hpp"
#include "src/contact/guessed_levels.hpp"

namespace abut {

std::vector<OptionSpec> begun_scene_option_specs() {
    std::vector<OptionSpec> specs = drawing_option_specs();
    specs.push_back(strict_option_spec());
    specs.push_back({"--material", "NAME", "material of all parts, of the library: steel (default), aluminium, POM, ..."});
    specs.push_back({"--thickness", "T", "thickness of all parts, in the scene's unit of length (default: 1)"});
    return specs;
}

std::string begun_scene(const Arguments& arguments, StarterChoice choice) {
    choice.material = value_or(arguments, "--material", choice.material);
    choice.thickness = positive_number(arguments, "--thickness");
    SketchReading reading = read_whole_sketch(arguments);
    take_guessed_levels(reading.scene);
    refuse_guesses(reading.scene, arguments);
    for (const std::string& warning : reading.scene.warnings) std::cerr << "warning: " << warning << "\n";
    return starter_scene(reading, drawing_options(arguments), detect_contacts(reading.scene, std::nullopt), choice);
}

}  // namespace abut
