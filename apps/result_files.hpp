// SPDX-License-Identifier: GPL-3.0-or-later
// The files of one analysis.
#pragma once
#include <string>
#include <vector>

#include "apps/stopwatch.hpp"
#include "src/plan/model_facts_of.hpp"
#include "src/results/case_result.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// Checks the scene's formats before the analysis, not after it: throws InputError if one cannot be written.
void check_formats(const Scene& scene);

/// Adds formats to the scene's own: words with commas between them. Throws InputError where one is not known.
void add_formats(Output& output, const std::string& words);

/// Adds the time of reading the scene to the timing, where the analysis has not stated it.
void complete_import_time(Result& result, double seconds);

/// What is known of the model; the run began when `since_start` did.
ModelFacts facts_of_run(const Scene& scene, const ModelSources& sources, const Stopwatch& since_start);

/// Writes the formats asked for; removes what an earlier run left in the folder and this one does not write. `since_start` runs
/// since the program's start: the timing "total" and "output" are completed with it, up to the writing of result.json, which
/// comes last. The sections of the report are made side by side on `threads` threads at most.
void write_results(Result& result, const ModelFacts& model, const std::string& folder, const std::vector<std::string>& formats,
                   const Stopwatch& since_start, int threads = 1);

/// Writes what is largest of all load cases (cases.json, envelope.csv, report.html), and the files of each case into a folder
/// of its own; cases.json is written whatever the formats. Removes what an earlier run wrote there. Cases are written side by
/// side on `threads` threads at most.
void write_case_results(std::vector<CaseResult>& cases, const std::vector<ModelFacts>& models, const std::string& folder,
                        const std::vector<std::string>& formats, const Stopwatch& since_start, int threads);

/// The line that names the report, "report: DIR/report.html", or the first file there is where no report is asked for; empty
/// where none is.
std::string main_file_line(const std::string& folder, const Output& output, bool has_cases = false);

}  // namespace abut
