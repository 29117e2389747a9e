// SPDX-License-Identifier: GPL-3.0-or-later
// abut batch: many scenes or drawings, each in a process and a folder of its own.
#include <csignal>
#include <filesystem>
#include <iostream>
#include <set>

#include "apps/accuracy_option.hpp"
#include "apps/batch_call.hpp"
#include "apps/batch_end.hpp"
#include "apps/batch_job.hpp"
#include "apps/batch_options.hpp"
#include "apps/batch_progress.hpp"
#include "apps/commands.hpp"
#include "apps/drawing_options.hpp"
#include "apps/output_folder.hpp"
#include "apps/print_text.hpp"
#include "geometry/brep/input_error.hpp"
#include "solver/linear_algebra/blas_threads.hpp"
#include "src/batch/batch_run.hpp"
#include "src/batch/batch_summary.hpp"
#include "src/batch/batch_template.hpp"
#include "src/io/build_id.hpp"
#include "src/io/write_file.hpp"
#include "src/results/result.hpp"

namespace abut {

namespace {

volatile std::sig_atomic_t stopped_by = 0;

extern "C" void note_signal(int signal) {
    stopped_by = signal;
}

/// "draft", or a number: the same words for every shard. Throws where --accuracy is wrong, before any job meets it.
std::string accuracy_setting(const Arguments& arguments) {
    Accuracy checked;
    override_accuracy(checked, arguments);
    return value_or(arguments, "--accuracy", "");
}

std::map<std::string, std::string> settings_of(const Arguments& arguments) {
    std::map<std::string, std::string> settings{{"version", program_build()}, {"--accuracy", accuracy_setting(arguments)}};
    for (const char* name : {"--only", "--distance"}) settings[name] = value_or(arguments, name, "");
    std::vector<OptionSpec> of_drawings = drawing_option_specs();
    of_drawings.push_back(strict_option_spec());
    for (const OptionSpec& option : of_drawings) {
        const std::string value = value_or(arguments, option.name, "");
        settings[option.name] = has(arguments, option.name) && value.empty() ? "given" : value;
    }
    return settings;
}

std::string expectation_setting(const JobSettings& settings, const BatchJob& job) {
    const std::vector<ExpectedPair>* pairs = expected_for(settings, job);
    std::string text = pairs ? "expected" : "";
    if (pairs)
        for (const ExpectedPair& pair : *pairs)
            text += "\n" + pair.names[0] + "\t" + pair.names[1] + "\t" + pair.status + "\t" + pair.interface;
    return text;
}

JobSettings job_settings(const Arguments& arguments) {
    JobSettings job;
    job.template_file = value_or(arguments, "--template", "");
    if (has(arguments, "--template"))
        for (const OptionSpec& option : drawing_option_specs())
            if (has(arguments, option.name))
                throw InputError(option.name, "the template says how drawings are read", "set it in the template instead");
    job.arguments = arguments;
    job.import_options = import_options(arguments);
    job.distance = positive_number(arguments, "--distance");
    const std::string only = value_or(arguments, "--only", "");
    if (has(arguments, "--only") && only != "contacts")
        throw InputError("--only", "'" + only + "' is not supported", "the one choice is contacts");
    job.contacts_only = only == "contacts";
    if (has(arguments, "--expect") && !job.contacts_only)
        throw InputError("--expect", "expected pairs are compared with contact detection", "give --only contacts with it");
    if (has(arguments, "--expect")) job.expectations = read_expectation_table(arguments.options.at("--expect"));
    return job;
}

BatchCall read_call(const Arguments& arguments) {
    BatchCall call;
    call.out = value_or(arguments, "-o", "out");
    call.job = job_settings(arguments);
    if (has(arguments, "--template")) call.scene_template = read_template(call.job.template_file);
    call.source = read_batch_source(arguments.operand, {call.out, call.scene_template.has_value()});
    check_template(call.source, call.scene_template ? &*call.scene_template : nullptr);
    call.run.shard = shard_of(arguments);
    set_run_options(arguments, call);
    return call;
}

void say_what_is_done(const BatchCall& call, bool quiet) {
    if (quiet) return;
    std::string left_out;
    for (const auto& [ending, n] : call.source.left_out)
        left_out += (left_out.empty() ? "" : ", ") + std::to_string(n) + " " + (ending.empty() ? "without an ending" : ending);
    if (!left_out.empty()) std::cerr << "abut: left out, since they are neither scenes nor drawings: " << left_out << "\n";
    for (const std::string& folder : call.source.folders_left_out)
        std::cerr << "abut: left out: " << one_line_text(folder) << "\n";
    if (call.run.shard.count > 1) std::cerr << "abut: shard " << call.run.shard.index << " of " << call.run.shard.count << "\n";
}

/// Files of --expect that no job has: a name written wrong would make detection look better than it is.
void say_what_is_not_there(const BatchCall& call) {
    if (!call.job.expectations) return;
    std::set<const std::vector<ExpectedPair>*> used;
    for (const BatchJob& job : call.source.jobs) used.insert(expected_for(call.job, job));
    std::vector<std::string> unused;
    for (const auto& [file, pairs] : *call.job.expectations)
        if (!used.contains(&pairs)) unused.push_back(file);
    if (!unused.empty())
        std::cerr << "abut: --expect names " << unused.size() << " that are not in the batch, the first of them "
                  << unused.front() << "\n";
}

BatchEnd run_call(BatchCall& call, bool quiet) {
    BatchProgressText text(quiet);
    const JobSettings& job = call.job;
    call.run.work = [&job](const BatchJob& which, const std::string& folder) { return do_batch_job(job, which, folder); };
    call.run.interrupted = [] { return stopped_by != 0; };
    call.run.progress = [&text](const BatchProgress& progress) { text.show(progress); };
    solver::usable_threads(1);  // before workers are copied: none of them makes threads of its own
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, note_signal) == SIG_IGN) std::signal(signal, SIG_IGN);  // nohup means it
    return run_batch(call.source.jobs, call.out, call.run);
}

}  // namespace

void set_run_options(const Arguments& arguments, BatchCall& call) {
    call.run.workers = workers_of(arguments);
    call.run.limits = {memory_of(arguments), timeout_of(arguments)};
    call.run.force = has(arguments, "--force");
    call.run.request = {settings_of(arguments), call.job.template_file, {}};
}

int do_batch(BatchCall& call, const std::string& name, bool quiet) {
    const Stopwatch watch;
    prepare_output_folder(call.out);
    call.run.request.own_settings = [&job = call.job](const BatchJob& which) { return expectation_setting(job, which); };
    const BatchFile batch = batch_file(name, call.run.request, call.source.jobs);
    write_file(call.out, "batch.json", batch_json(batch));
    say_what_is_done(call, quiet);
    say_what_is_not_there(call);
    try {
        const BatchEnd end = run_call(call, quiet);
        return end_batch(call.out, batch, end, {watch.seconds(), quiet, static_cast<int>(stopped_by)});
    } catch (const StoreError& error) {
        throw InputError("", error.what(), "free the place or choose another folder with -o, and run the same command again");
    }
}

CommandSpec batch_spec() {
    CommandSpec spec{
        "batch", "SOURCE", "Analyses many scenes or drawings, each in a folder of its own, with a summary.", {}, {}};
    spec.options = {
        {"--template", "SCENE", "what to do with each drawing: a scene whose file \"*\" is the drawing"},
        {"-o", "OUT", "folder for jobs/, index.html, summary.csv and summary.json (default: out)"},
        {"-j", "N", "so many jobs at a time (default: one for each processor)"},
        {"--memory", "M", "a job that needs more fails: 500M, 2G (default: no limit)"},
        {"--timeout", "SECONDS", "a job that takes longer fails (default: no limit)"},
        {"--shard", "I/N", "only every N-th job, from the I-th on: for several machines (default in a Slurm array: its task)"},
        {"--force", "", "do all jobs again, also those that are finished"},
        {"--only", "contacts", "find contacts, analyse nothing"},
        {"--expect", "TABLE", "with --only contacts: compare with the pairs of a table file,part_1,part_2"},
        {"--distance", "D", "largest gap of a pair in contact detection (default: 2 % of the smaller part's extent)"},
        {"--accuracy", "A", "draft, standard, fine, or an error to aim at; instead of each scene's"}};
    for (const OptionSpec& option : drawing_option_specs()) spec.options.push_back(option);
    spec.options.push_back(strict_option_spec());
    spec.options.push_back({"--quiet", "", "print nothing but errors"});
    spec.notes =
        "SOURCE is a folder of scenes, drawings, STEP files and meshes; a list of files (.txt); or a table (.csv, .jsonl) with "
        "the "
        "columns\n"
        "\"file\", \"name\" and the scene's parameters. Drawings without a template are searched for contacts. The same "
        "command again\n"
        "goes on where it was stopped. The exit status is 1 if any job did not end well, 130 after Ctrl-C.\n";
    return spec;
}

int batch_command(const Arguments& arguments) {
    BatchCall call = read_call(arguments);
    return do_batch(call, arguments.operand, has(arguments, "--quiet"));
}

}  // namespace abut
