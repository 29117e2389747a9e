// SPDX-License-Identifier: GPL-3.0-or-later
// abut inspect: what is in a file.
#include "src/inspect.hpp"

#include "apps/commands.hpp"
#include "apps/drawing_options.hpp"
#include "apps/drawing_problems.hpp"
#include "apps/output_folder.hpp"
#include "apps/print_text.hpp"
#include "src/result.hpp"

namespace abut {

CommandSpec inspect_spec() {
    CommandSpec spec{
        "inspect", "FILE", "Shows what is in a scene or drawing: parts, edges with their names, repairs and problems.", {}, {}};
    spec.options = {{"--json", "", "print it as JSON instead of a table"}, {"-o", "DIR", "write a picture, DIR/inspect.svg"}};
    for (const OptionSpec& option : drawing_option_specs()) spec.options.push_back(option);
    spec.notes = "Problems are also listed on standard error, one a line; the exit status is 2 then, and 0 without any.\n";
    return spec;
}

int inspect_command(const Arguments& arguments) {
    const DrawingOptions options = drawing_options(arguments);
    if (has(arguments, "-o")) prepare_output_folder(arguments.options.at("-o"));
    const Inspection inspection = inspect_file(arguments.operand, options.tolerance, options.units);
    print_text(has(arguments, "--json") ? inspection_json(inspection) : inspection_table(inspection));
    if (has(arguments, "-o")) write_file(arguments.options.at("-o"), "inspect.svg", inspection_svg(inspection));
    throw_if_any(arguments.operand, inspection.problems);
    return exit_done;
}

}  // namespace abut
