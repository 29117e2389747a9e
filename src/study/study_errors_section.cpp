// SPDX-License-Identifier: GPL-3.0-or-later
// What errors cost, for each quantity. Which one is shown is the reader's choice, by radio buttons: no script.
#include <algorithm>

#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_svg.hpp"
#include "src/report/report_table.hpp"
#include "src/study/study_page.hpp"

namespace abut::report {

namespace {

RunValue solver_time() {
    return {[](const StudyRun& r) { return r.solver_seconds; }, duration_text, "solver time"};
}

RunValue error_of(std::size_t measure) {
    return {[measure](const StudyRun& r) { return r.error[measure]; }, percent_text, "error"};
}

/// The passes on the way to the last level, by the analysis' own estimates.
std::optional<ChartSeries> estimated_passes(const Study& study, bool over_time) {
    const StudyRun* longest = nullptr;
    for (const StudyRun& r : study.runs)
        if (r.setting.threads == 1 && (!longest || r.passes.size() > longest->passes.size())) longest = &r;
    if (!longest) return std::nullopt;
    ChartSeries series;
    series.color = "#1c1c1c";
    series.mark = Mark::cross;
    series.dashes = "1 4";
    series.line_width = 1.2;
    for (const PassSummary& p : longest->passes)
        if (p.estimated_error)
            series.points.push_back({over_time ? p.seconds : p.unknowns + p.multipliers, *p.estimated_error,
                                     "pass of " + longest->setting.level + ", estimated: " + percent_text(*p.estimated_error) +
                                         " after " + duration_text(p.seconds)});
    if (series.points.empty()) return std::nullopt;
    return series;
}

std::string error_chart(const Study& study, std::size_t measure, bool over_time) {
    const RunValue x = over_time ? solver_time() : unknowns_of_run();
    LogChart chart{
        "error against " + x.title, x.title, "error", x.text, percent_text, study_series(study, x, error_of(measure))};
    if (const auto passes = estimated_passes(study, over_time)) chart.series.push_back(*passes);
    return figure(log_chart(chart), over_time ? "Error against solver time" : "Error against unknowns", half_width);
}

std::string cheapest_cell(const Study& study, std::optional<std::size_t> run) {
    if (!run) return "not reached";
    return duration_text(study.runs[*run].solver_seconds) + "  " + setting_text(study.runs[*run].setting);
}

std::string cheapest_table(const Study& study, std::size_t measure) {
    std::vector<std::vector<std::string>> rows;
    for (const CheapestSetting& c : cheapest_settings(study, measure))
        rows.push_back({percent_text(c.error), cheapest_cell(study, c.level), cheapest_cell(study, c.grid)});
    return "<div><h3>The cheapest setting for an error</h3>\n" +
           html_table({{"error", true}, {"accuracy levels"}, {"one grid that is given"}}, rows) + "</div>\n";
}

std::string halving_table(const Study& study, std::size_t measure) {
    std::vector<std::vector<std::string>> rows;
    for (const PriceOfHalving& p : prices_of_halving(study, measure))
        rows.push_back({p.family, "x " + number_text(p.factor, 2),
                        percent_text(p.first_error) + " at " + duration_text(p.first_seconds),
                        percent_text(p.last_error) + " at " + duration_text(p.last_seconds)});
    if (rows.empty()) return "";
    return "<div><h3>What half the error costs</h3>\n" + html_table({{"settings"}, {"time", true}, {"from"}, {"to"}}, rows) +
           "</div>\n";
}

std::string pane(const Study& study, std::size_t measure) {
    return "<div class=\"pane pane" + std::to_string(measure) + "\">\n<div class=\"row\">" + error_chart(study, measure, true) +
           error_chart(study, measure, false) + "</div>\n" + study_legend(study) + "<div class=\"row\">" +
           cheapest_table(study, measure) + halving_table(study, measure) + "</div>\n</div>\n";
}

std::string button(const Study& study, std::size_t measure, bool is_chosen) {
    const std::string id = "measure" + std::to_string(measure);
    return "<input type=\"radio\" name=\"measure\" id=\"" + id + "\"" + (is_chosen ? " checked" : "") + "/><label for=\"" + id +
           "\">" + escape_xml(study.measures[measure].what) + "</label>\n";
}

std::string show_rule(std::size_t measure) {
    const std::string k = std::to_string(measure);
    return "#measure" + k + ":checked ~ .pane" + k + " { display: block; }\n";
}

std::string held_note(const Study& study) {
    std::string names;
    for (const StudyMeasure& m : study.measures)
        if (m.held) names += (names.empty() ? "" : ", ") + m.what;
    return names.empty() ? "" : "<p class=\"note\">Right in every run but for rounding: " + escape_xml(names) + ".</p>\n";
}

}  // namespace

std::string errors_section(const Study& study) {
    const std::optional<std::size_t> first = main_measure(study);
    if (!first) return "";
    std::string rules, buttons, panes;
    for (std::size_t k = 0; k < study.measures.size(); ++k) {
        if (study.measures[k].held) continue;
        rules += show_rule(k);
        buttons += button(study, k, k == *first);
        panes += pane(study, k);
    }
    return "<section>\n<h2>What an error costs</h2>\n<p>Error of the chosen quantity, against " + escape_xml(study.reference) +
           ".</p>\n<style>\n.pane { display: none; }\n" + rules + "</style>\n<div class=\"choice\">\n" + buttons + panes +
           "</div>\n" + held_note(study) + "</section>\n";
}

}  // namespace abut::report
