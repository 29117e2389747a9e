// SPDX-License-Identifier: GPL-3.0-or-later
// abut study: one scene at many settings; what accuracy costs in time.
#include "src/study/study.hpp"

#include <algorithm>
#include <iostream>

#include "apps/commands.hpp"
#include "apps/data_folder.hpp"
#include "apps/output_folder.hpp"
#include "apps/print_text.hpp"
#include "apps/progress_line.hpp"
#include "apps/thread_option.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/write_file.hpp"
#include "src/scene/budget.hpp"

namespace abut {

namespace {

/// Closed forms are an extra: a program without its data studies all the same, and says what it compares with.
std::string known_answers_folder(const Arguments& arguments) {
    if (has(arguments, "--data")) return data_folder(arguments);
    try {
        return data_folder(arguments);
    } catch (const InputError&) { return ""; }
}

/// Seconds as a number, or a time with its unit, as analyze takes it.
std::optional<double> seconds_of(const Arguments& arguments, const std::string& name) {
    if (!has(arguments, name)) return std::nullopt;
    const std::string& text = arguments.options.at(name);
    if (to_number(text)) return positive_number(arguments, name);
    try {
        const Budget budget = parse_budget(text);
        if (budget.seconds && !budget.bytes) return budget.seconds;
    } catch (const InputError&) {}
    throw InputError(name, "'" + shortened(text) + "' is no time", "give seconds, or a time with its unit: 90, 90s, 5min");
}

Study study_with_progress(const Arguments& arguments) {
    ProgressLine line(!has(arguments, "--quiet"));
    StudyOptions options;
    options.budget = seconds_of(arguments, "--budget").value_or(options.budget);
    if (has(arguments, "--once")) options.repeated_seconds = 0;
    options.threads = threads_of(arguments);
    options.data_folder = known_answers_folder(arguments);
    options.progress = [&line](const std::string& message) { line.show(message); };
    return run_study(arguments.operand, options);
}

void write_study(const Study& study, const std::string& folder) {
    write_file(folder, "study.csv", study_csv(study));
    write_file(folder, "study.json", study_json(study));
    write_file(folder, "study.html", study_html(study));
}

bool has_answer(const StudyRun& run) {
    return run.status == StudyRun::Status::ok;
}

}  // namespace

CommandSpec study_spec() {
    return {
        "study",
        "SCENE",
        "Shows what accuracy costs in time: one scene at many settings of its grids. (Values of its parameters: abut sweep.)",
        {{"-o", "DIR", "folder for study.html, study.csv and study.json (default: out)"},
         {"--budget", "TIME", "seconds, or as 5min: runs that would not fit into this are left out and listed (default: 60)"},
         {"--once", "", "solve each setting once: quick, and times are rough"},
         {"--threads", "N", "of the levels' second runs (default: one for each processor; 1: no second runs)"},
         {"--data", "DIR", "folder with the known answers of verify (default: the one the program came with)"},
         {"--json", "", "print study.json instead of a table"},
         {"--quiet", "", "print nothing but errors"}},
        "Solved are the accuracy levels; degrees 1 to 4 and two bases with seven cell sizes, on one grid graded like that of\n"
        "the level standard; equal cells. Errors are against the known answer where the scene is a problem of verify, else\n"
        "against a run at a fifth of the target of \"fine\". The exit status is 1 where no level gives an answer.\n"};
}

int study_command(const Arguments& arguments) {
    const std::string folder = value_or(arguments, "-o", "out");
    prepare_output_folder(folder);
    const Study study = study_with_progress(arguments);
    write_study(study, folder);
    if (has(arguments, "--json")) {
        print_text(study_json(study));
    } else if (!has(arguments, "--quiet")) {
        print_text(study_table(study));
        std::cout << "study: " << path_in(folder, "study.html") << "\n";
    }
    if (std::any_of(study.runs.begin(), study.runs.end(), has_answer)) return exit_done;
    std::cout.flush();
    std::cerr << "abut: " << arguments.operand << ": the analysis failed: " << one_line_text(study.runs.front().message)
              << "\n";
    return exit_failed;
}

}  // namespace abut
