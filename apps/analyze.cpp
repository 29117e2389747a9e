// SPDX-License-Identifier: GPL-3.0-or-later
// abut analyze: one scene, from its file to the result files.
#include <iostream>

#include "apps/accuracy_option.hpp"
#include "apps/commands.hpp"
#include "apps/drawing_problems.hpp"
#include "apps/output_folder.hpp"
#include "apps/plan_text.hpp"
#include "apps/print_text.hpp"
#include "apps/progress_line.hpp"
#include "apps/result_files.hpp"
#include "apps/stopwatch.hpp"
#include "apps/thread_option.hpp"
#include "solver/linear_algebra/blas_threads.hpp"
#include "src/analysis/analysis.hpp"
#include "src/discretization/shared_grids.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/number_text.hpp"
#include "src/motion/settle.hpp"
#include "src/plan/left_out_parts.hpp"
#include "src/plan/plan.hpp"
#include "src/results/result.hpp"
#include "src/results/result_units.hpp"
#include "src/results/verdict.hpp"
#include "src/scene/load_cases.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"
#include "src/verification/expectations.hpp"

namespace abut {

namespace {

/// Parts left out show in a result by themselves.
std::vector<Effect> whole_plan(const Scene& scene) {
    const ResolvedConditions conditions = resolve_conditions(scene);
    std::vector<Effect> plan = plan_effects(scene, conditions);
    plan.push_back(shared_grids_effect(scene, conditions));
    plan.push_back(large_motion_effect(settle(scene, conditions)));
    plan.push_back(left_out_effect(scene, conditions));
    return plan;
}

/// What is taken from elsewhere and what is doubtful of a scene, before anything is computed.
std::string remarks(const Scene& scene) {
    std::string text;
    for (const std::string& note : scene.notes) text += "note: " + note + "\n";
    for (const std::string& warning : scene.warnings) text += "warning: " + warning + "\n";
    return text;
}

/// analysis: analyze or analyze_cases. Where it refuses the scene, what was made of its drawings may be why.
template <class Analysis>
auto with_progress(Analysis analysis, const Scene& scene, bool quiet, int threads) {
    ProgressLine line(!quiet);
    AnalyzeOptions options;
    options.threads = threads;
    options.progress = [&line](const std::string& message) { line.show(message); };
    try {
        return analysis(scene, options);
    } catch (const InputError&) {
        line.wipe();
        if (!quiet) std::cerr << remarks(scene);
        throw;
    }
}

void print_result(const Result& result, const ModelFacts& model, const std::string& folder, const Arguments& arguments,
                  const Output& output) {
    if (has(arguments, "--json")) {
        print_text(result_json(result, model));
    } else if (!has(arguments, "--quiet")) {
        print_text(result_table(result));
        std::cout << main_file_line(folder, output);
    }
}

/// Says whether the answers that the scene knows come out; true where they do, or where it knows none.
bool tell_expectations(const Scene& scene, const Result& result, const Arguments& arguments, const std::string& in_case = {}) {
    std::vector<VerifyRow> rows = compared_with_expectations(scene, result);
    for (VerifyRow& row : rows) row.seconds = stage_seconds(result, "total");
    if (!rows.empty() && !has(arguments, "--json") && !has(arguments, "--quiet"))
        print_text("\nexpected" + (in_case.empty() ? "" : " of " + in_case) + ":\n" + verify_table(rows));
    bool all_pass = true;
    std::string said;
    for (const VerifyRow& row : rows) {
        if (row.pass) continue;
        all_pass = false;
        if (!row.failure.empty() && row.failure == said) continue;
        said = row.failure;
        std::cout.flush();
        const std::string what =
            row.failure.empty() ? row.quantity + " is " + number_text(row.value, 6) + ", not " + number_text(row.reference, 6)
                                : row.failure;
        std::cerr << "abut: " << scene.file << ": not as expected: " << (in_case.empty() ? "" : in_case + ": ")
                  << one_line_text(what) << "\n";
    }
    return all_pass;
}

/// Says on standard error why the status is not 0. why: the reasons, or the message of a failure.
int exit_status(const Arguments& arguments, Verdict verdict, bool as_expected, const std::string& why) {
    if (verdict == Verdict::reached && (as_expected || !has(arguments, "--strict"))) return exit_done;
    if (verdict == Verdict::solved_but && !has(arguments, "--strict")) return exit_done;
    if (verdict == Verdict::reached) return exit_failed;
    std::cout.flush();
    std::cerr << "abut: " << arguments.operand << ": "
              << one_line_text((verdict == Verdict::failed ? "the analysis failed: " : "solved, but: ") + why) << "\n";
    return exit_failed;
}

/// What is said against the cases of the worst verdict, by case.
std::string why_not(const std::vector<CaseResult>& cases) {
    std::string why;
    for (const CaseResult& c : cases) {
        if (verdict_of(c.result) != verdict_of(cases)) continue;
        why +=
            (why.empty() ? "" : "; ") + c.name + ": " + (c.result.status == "ok" ? reasons_text(c.result) : c.result.message);
    }
    return why;
}

int analyze_all_cases(const Scene& scene, const ModelSources& sources, const std::string& folder, const Arguments& arguments,
                      const Stopwatch& watch) {
    const bool quiet = has(arguments, "--quiet");
    std::vector<CaseResult> cases = with_progress(analyze_cases, scene, quiet, threads_of(arguments));
    std::vector<ModelFacts> models;
    for (const LoadCase& c : scene.cases) models.push_back(facts_of_run(scene_of_case(scene, c), sources, watch));
    write_case_results(cases, models, folder, scene.output.formats, watch, solver::usable_threads(threads_of(arguments)));
    if (has(arguments, "--json"))
        print_text(cases_json(cases));
    else if (!quiet)
        print_text(cases_table(cases) + main_file_line(folder, scene.output, true));
    bool as_expected = true;
    for (std::size_t k = 0; k < cases.size(); ++k)
        as_expected =
            tell_expectations(scene_of_case(scene, scene.cases[k]), cases[k].result, arguments, cases[k].name) && as_expected;
    return exit_status(arguments, verdict_of(cases), as_expected, why_not(cases));
}

}  // namespace

CommandSpec analyze_spec() {
    return {
        "analyze",
        "SCENE",
        "Analyses one scene and writes its results.",
        {{"-o", "DIR", "folder for result.json, contact_<k>.csv and report.html (default: out)"},
         {"--accuracy", "A", "draft, standard, fine, or an error to aim at such as 0.01; instead of the scene's"},
         {"--budget", "B",
          "time and memory that finer grids may take, such as 30s, 2GB or 5min,2GB: where the next would take more, the last "
          "answer stands"},
         {"--case", "NAME", "the load case of this name alone, as if the scene had no others"},
         {"--format", "F", "also write these, with commas between: vtu (ParaView), svg, png (pictures), json, csv, html"},
         {"--threads", "N", "at most so many threads, with the same answer (default: one for each processor)"},
         {"--plan", "", "print which effects would be computed and why, and stop"},
         {"--json", "", "print the result (or the plan) as JSON instead of a table"},
         {"--strict", "",
          "end with status 1 also where it is solved with reservations, or not as the scene expects; what is left out, "
          "merged or guessed of drawings is an error"},
         {"--quiet", "", "print nothing but errors"}},
        "Which files are written is the scene's to say: /output/formats. A failed analysis writes them too, with what is "
        "known;\n"
        "the exit status is 1 then. An answer is \"reached\" (as accurate as asked for) or \"solved_but\", with reasons:\n"
        "\"verdict\" and \"reasons\" in result.json, the last lines of the table, the first of the report.\n"
        "Of a scene with load cases (/cases) all are solved together: cases.json and envelope.csv have what is largest in "
        "any,\n"
        "report.html leads to the cases, case_<k>/ has the files of each.\n"};
}

int analyze_command(const Arguments& arguments) {
    const Stopwatch watch;
    Scene scene = read_scene(arguments.operand);
    const ModelSources sources = model_sources(scene);
    if (has(arguments, "--case")) scene = scene_of_case(scene, case_named(scene, arguments.options.at("--case")));
    const double reading_seconds = watch.seconds();
    refuse_guesses(scene, arguments);
    override_accuracy(scene.accuracy, arguments);
    override_budget(scene.accuracy, arguments);
    add_formats(scene.output, value_or(arguments, "--format", ""));
    const int threads = threads_of(arguments);
    if (has(arguments, "--plan")) {
        const std::vector<Effect> plan = whole_plan(scene);
        print_text(has(arguments, "--json") ? plan_json(plan) : plan_table(plan) + remarks(scene));
        return exit_done;
    }
    check_formats(scene);
    const std::string folder = value_or(arguments, "-o", "out");
    prepare_output_folder(folder);
    if (!scene.cases.empty()) return analyze_all_cases(scene, sources, folder, arguments, watch);
    Result result = with_progress(analyze, scene, has(arguments, "--quiet"), threads);
    complete_import_time(result, reading_seconds);
    const ModelFacts model = facts_of_run(scene, sources, watch);
    write_results(result, model, folder, scene.output.formats, watch, solver::usable_threads(threads));
    print_result(result, model, folder, arguments, scene.output);
    const bool as_expected = tell_expectations(scene, result, arguments);
    return exit_status(arguments, verdict_of(result), as_expected,
                       result.status == "ok" ? reasons_text(result) : result.message);
}

}  // namespace abut
