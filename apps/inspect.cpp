// SPDX-License-Identifier: GPL-3.0-or-later
// abut inspect: what is in a file.
#include "src/inspection/inspect.hpp"

#include "apps/commands.hpp"
#include "apps/drawing_options.hpp"
#include "apps/drawing_problems.hpp"
#include "apps/output_folder.hpp"
#include "apps/print_text.hpp"
#include "src/io/write_file.hpp"
#include "src/results/result.hpp"

namespace abut {

CommandSpec inspect_spec() {
    CommandSpec spec{
        "inspect", "FILE", "Shows what is in a scene or drawing: parts, edges with their names, repairs and problems.", {}, {}};
    spec.options = {{"--json", "", "print it as JSON instead of a table"},
                    {"-o", "DIR", "write pictures and a page with one into DIR"}};
    for (const OptionSpec& option : drawing_option_specs()) spec.options.push_back(option);
    spec.options.push_back(strict_option_spec());
    spec.notes =
        "Pictures: inspect.svg, parts with names and directions of edges, repairs and problems; inspect.html, the same as a "
        "page in\n"
        "which a click on an edge copies its selector; and what an analysis would begin with: inspect_cells.svg, cells of the "
        "first grids by class; inspect_pieces.svg, the boundary clipped to them;\n"
        "inspect_candidates.svg, where parts face each other, with some pairs of points.\n"
        "Problems are also listed on standard error, one a line; the exit status is 2 then, and 0 without any.\n";
    return spec;
}

namespace {

/// The plain picture first: it is there whatever is wrong with the grids that the scene asks for.
void write_pictures(const Inspection& inspection, const std::string& folder) {
    write_file(folder, "inspect.svg", inspection_svg(inspection));
    write_file(folder, "inspect.html", inspection_html(inspection));
    for (const InspectionPicture& picture : stage_pictures(inspection)) write_file(folder, picture.file, picture.svg);
}

}  // namespace

int inspect_command(const Arguments& arguments) {
    const auto options = drawing_options(arguments);
    if (has(arguments, "-o")) prepare_output_folder(arguments.options.at("-o"));
    const Inspection inspection = inspect_file(arguments.operand, options);
    print_text(has(arguments, "--json") ? inspection_json(inspection) : inspection_table(inspection));
    if (has(arguments, "-o")) write_pictures(inspection, arguments.options.at("-o"));
    throw_if_any(arguments.operand, inspection.problems);
    refuse_guesses(inspection.scene, arguments);
    return exit_done;
}

}  // namespace abut
