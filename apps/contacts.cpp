// SPDX-License-Identifier: GPL-3.0-or-later
// abut contacts: contact detection alone.
#include <filesystem>
#include <iostream>
#include <optional>

#include "apps/commands.hpp"
#include "apps/drawing_options.hpp"
#include "apps/drawing_problems.hpp"
#include "apps/output_folder.hpp"
#include "apps/print_text.hpp"
#include "src/contact/detect.hpp"
#include "src/contact/guessed_levels.hpp"
#include "src/inspection/detect_pictures.hpp"
#include "src/io/write_file.hpp"
#include "src/results/result.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"

namespace abut {

namespace {

Scene read_model(const Arguments& arguments) {
    if (kind_of_file(arguments.operand) == FileKind::scene) {
        drawing_options(arguments);
        return read_scene(arguments.operand);
    }
    Scene scene = read_whole_sketch(arguments).scene;
    tell_guessed_levels(scene);
    return scene;
}

/// Without any pair there is no picture, and none of an earlier run is left.
void write_cells(const std::string& folder, const std::string& svg) {
    std::error_code ignored;
    if (svg.empty())
        std::filesystem::remove(std::filesystem::path(folder) / "cells.svg", ignored);
    else
        write_file(folder, "cells.svg", svg);
}

int report_differences(const Detection& detection, const std::string& expectation_file) {
    const std::vector<std::string> differences = compare_detection(detection, expectation_file);
    for (const std::string& line : differences) std::cerr << "abut: " << expectation_file << ": " << line << "\n";
    return differences.empty() ? exit_done : exit_failed;
}

}  // namespace

CommandSpec contacts_spec() {
    CommandSpec spec{"contacts",
                     "FILE",
                     "Finds the pairs of parts that touch, overlap or nearly touch in a scene, drawing, mesh or STEP file.",
                     {},
                     {}};
    spec.options = {{"--distance", "D", "largest gap of a pair (default: 2 % of the smaller part's extent)"},
                    {"--expect", "FILE", "compare with the pairs of this file; exit status 1 on any difference"},
                    {"-o", "DIR", "folder for contacts.json, contacts.svg and cells.svg (default: out)"}};
    for (const OptionSpec& option : drawing_option_specs()) spec.options.push_back(option);
    spec.options.push_back(strict_option_spec());
    return spec;
}

int contacts_command(const Arguments& arguments) {
    const std::optional<double> distance = positive_number(arguments, "--distance");
    const Scene scene = read_model(arguments);
    refuse_guesses(scene, arguments);
    const std::string folder = value_or(arguments, "-o", "out");
    prepare_output_folder(folder);
    const Detection detection = detect_contacts(scene, distance);
    print_text(detection_table(scene, detection));
    write_file(folder, "contacts.json", detection_json(scene, detection));
    write_file(folder, "contacts.svg", detection_svg(scene, detection));
    write_cells(folder, detection_cells_svg(scene, detection));
    return has(arguments, "--expect") ? report_differences(detection, arguments.options.at("--expect")) : exit_done;
}

}  // namespace abut
