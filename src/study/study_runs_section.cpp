// SPDX-License-Identifier: GPL-3.0-or-later
// The list of all runs, of those that failed or were left out, too.
#include <cmath>

#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_table.hpp"
#include "src/study/study_page.hpp"

namespace abut::report {

namespace {

std::string status_words(const StudyRun& run) {
    if (run.status == StudyRun::Status::ok && run.setting.kind == StudySetting::Kind::level && !run.reasons.empty())
        return "solved, but: " + run.reasons + (run.message.empty() ? "" : "; " + run.message);
    if (run.status == StudyRun::Status::ok) return run.message;
    return (run.status == StudyRun::Status::failed ? "failed: " : "left out: ") + run.message;
}

std::string error_words(const StudyRun& run, std::optional<std::size_t> measure) {
    return measure && std::isfinite(run.error[*measure]) ? percent_text(run.error[*measure]) : "";
}

std::vector<std::string> run_row(const StudyRun& run, std::optional<std::size_t> measure) {
    if (run.status != StudyRun::Status::ok)
        return {setting_text(run.setting), "", "", "", "", "", "", "", "", "", status_words(run)};
    return {setting_text(run.setting),
            std::to_string(run.unknowns),
            std::to_string(run.multipliers),
            error_words(run, measure),
            run.estimated_error ? percent_text(*run.estimated_error) : "",
            duration_text(run.solver_seconds),
            duration_text(run.seconds),
            duration_text(run.cpu_seconds),
            run.peak_bytes > 0 ? memory_text(run.peak_bytes) : "",
            std::to_string(run.repeats),
            status_words(run)};
}

}  // namespace

std::string runs_section(const Study& study) {
    const std::optional<std::size_t> measure = main_measure(study);
    std::vector<std::vector<std::string>> rows;
    for (const StudyRun& run : study.runs) rows.push_back(run_row(run, measure));
    const std::string error = measure ? "<p>Error of " + escape_xml(study.measures[*measure].what) +
                                            "; study.csv has those of the other quantities.</p>\n"
                                      : "";
    return "<section class=\"runs\">\n<h2>All runs</h2>\n" + error +
           html_table({{"setting"},
                       {"unknowns", true},
                       {"multipliers", true},
                       {"error", true},
                       {"estimated", true},
                       {"solver", true},
                       {"whole run", true},
                       {"processor", true},
                       {"memory", true},
                       {"repeats", true},
                       {"remarks"}},
                      rows) +
           "</section>\n";
}

}  // namespace abut::report
