// SPDX-License-Identifier: GPL-3.0-or-later
// The table that `abut study` prints.
#include <cmath>

#include "src/io/number_text.hpp"
#include "src/io/text_table.hpp"
#include "src/results/result_units.hpp"
#include "src/study/study_prices.hpp"

namespace abut {

namespace {

std::string error_text(const StudyRun& run, std::optional<std::size_t> measure) {
    if (!measure || std::isnan(run.error[*measure])) return "";
    return percent_text(run.error[*measure]);
}

TextRow run_row(const StudyRun& run, std::optional<std::size_t> measure) {
    if (run.status != StudyRun::Status::ok)
        return {setting_text(run.setting), run.status == StudyRun::Status::failed ? "failed" : "skipped"};
    return {setting_text(run.setting),  std::to_string(run.unknowns),
            error_text(run, measure),   duration_text(run.solver_seconds),
            duration_text(run.seconds), run.peak_bytes > 0 ? memory_text(run.peak_bytes) : ""};
}

std::string cell(const Study& study, std::optional<std::size_t> run) {
    if (!run) return "-";
    return duration_text(study.runs[*run].solver_seconds) + "  " + setting_text(study.runs[*run].setting);
}

std::string cheapest_table(const Study& study, std::size_t measure) {
    std::vector<TextRow> rows{{"error", "levels", "one given grid"}};
    for (const CheapestSetting& c : cheapest_settings(study, measure))
        rows.push_back({percent_text(c.error), cell(study, c.level), cell(study, c.grid)});
    return "Cheapest setting by error, solver time:\n" + aligned(rows);
}

/// Levels, and degree 2 on given grids; study.csv has all.
bool is_shown(const StudySetting& s) {
    return s.kind == StudySetting::Kind::level || (s.kind == StudySetting::Kind::graded && s.degree == 2 && s.basis == "web");
}

}  // namespace

std::string study_table(const Study& study) {
    const std::optional<std::size_t> measure = main_measure(study);
    std::string text = "What accuracy costs in time: " + (study.title.empty() ? study.file : study.title) + "\n";
    if (measure) text += "error: " + study.measures[*measure].what + ", against " + study.reference + "\n";
    std::vector<TextRow> rows{{"setting", "unknowns", "error", "solver", "whole run", "memory"}};
    for (const StudyRun& run : study.runs)
        if (is_shown(run.setting)) rows.push_back(run_row(run, measure));
    text += "\n" + aligned(rows) + "\n";
    if (measure) {
        text += cheapest_table(study, *measure) + "\n";
        for (const std::string& sentence : study_sentences(study, *measure)) text += sentence + "\n";
    }
    for (const std::string& note : study.notes) text += note + "\n";
    return text;
}

}  // namespace abut
