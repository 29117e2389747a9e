// SPDX-License-Identifier: GPL-3.0-or-later
// abut sweep: a scene at many values of its parameters, and what comes out as curves.
#include "src/batch/sweep.hpp"

#include <algorithm>
#include <iostream>

#include "apps/batch_call.hpp"
#include "apps/commands.hpp"
#include "apps/output_folder.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/io/json_document.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/write_file.hpp"

namespace abut {

namespace {

std::vector<SweptParameter> swept_parameters(const Arguments& arguments, const BatchTemplate& scene) {
    if (arguments.operands.size() < 2)
        throw InputError("", "a sweep takes a scene and the values of at least one of its parameters",
                         "write, for instance: abut sweep " +
                             (arguments.operand.empty() ? "scene.json" : shortened(arguments.operand)) + " F=2000:20000:10");
    std::vector<SweptParameter> parameters;
    for (std::size_t k = 1; k < arguments.operands.size(); ++k) {
        parameters.push_back(parse_swept(arguments.operands[k]));
        const std::string& name = parameters.back().name;
        const std::vector<std::string>& known = scene.parameters;
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw InputError(
                shortened(arguments.operands[k]), "'" + shortened(name) + "' is no parameter of " + scene.file,
                known.empty() ? "give the scene \"parameters\" and use them in its numbers" : nearest_name_hint(name, known));
        if (std::find(scene.unused.begin(), scene.unused.end(), name) != scene.unused.end())
            throw InputError(shortened(arguments.operands[k]),
                             "nothing in " + scene.file + " uses its parameter '" + name + "'",
                             "write it where its value counts, as in \"force\": [0, \"" + name + "\"]");
    }
    return parameters;
}

/// What else is wrong with the scene may depend on its parameters: its jobs say so.
void refuse_cases_of(const std::string& scene) {
    const JsonDocument document = read_json(scene);
    if (const JsonValue* cases = find_member(document.root, "cases"))
        throw InputError(scene + " " + cases->pointer, "a sweep takes scenes without load cases",
                         "leave the cases out, and give the loads parameters as factors");
}

}  // namespace

CommandSpec sweep_spec() {
    CommandSpec spec{
        "sweep", "SCENE NAME=VALUES...", "Analyses one scene at many values of its parameters, and draws curves.", {}, {}};
    spec.operands = Operands::any;
    spec.options = {{"-o", "OUT", "folder for sweep.html, sweep.csv and the files of a batch (default: out)"},
                    {"-j", "N", "so many jobs at a time (default: one for each processor)"},
                    {"--memory", "M", "a job that needs more fails: 500M, 2G (default: no limit)"},
                    {"--timeout", "SECONDS", "a job that takes longer fails (default: no limit)"},
                    {"--force", "", "do all jobs again, also those that are finished"},
                    {"--accuracy", "A", "draft, standard, fine, or an error to aim at; instead of the scene's"},
                    {"--quiet", "", "print nothing but errors"}};
    spec.notes =
        "VALUES are FROM:TO:COUNT, evenly spaced, or VALUE,VALUE,... in the scene's units; of several parameters all\n"
        "combinations are analysed, and the first is what curves are drawn over. The jobs are a batch, which the same\n"
        "command goes on with where it was stopped.\n";
    return spec;
}

int sweep_command(const Arguments& arguments) {
    if (arguments.operands.empty()) throw InputError("", "no scene is given", "write: abut sweep SCENE NAME=VALUES...");
    BatchCall call;
    call.out = value_or(arguments, "-o", "out");
    call.job.template_file = arguments.operand;
    call.job.arguments = arguments;
    call.scene_template = read_template(arguments.operand);
    refuse_cases_of(arguments.operand);
    const std::vector<SweptParameter> parameters = swept_parameters(arguments, *call.scene_template);
    call.source = sweep_jobs(parameters);
    check_template(call.source, &*call.scene_template);
    set_run_options(arguments, call);
    const int status = do_batch(call, arguments.operand, has(arguments, "--quiet"));
    const Sweep sweep = read_sweep(read_batch_file(call.out), parameters, call.out);
    write_file(call.out, "sweep.csv", sweep_csv(sweep));
    write_file(call.out, "sweep.html", sweep_html(sweep));
    if (!has(arguments, "--quiet")) std::cout << "curves: " << path_in(call.out, "sweep.html") << "\n";
    return status;
}

}  // namespace abut
