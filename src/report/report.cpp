// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/report.hpp"

#include <array>

#include "solver/linear_algebra/parallel_for.hpp"
#include "src/io/build_id.hpp"
#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/page_data.hpp"
#include "src/report/report_page.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_table.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

std::string page(const Result& result, const std::string& body, const std::string& end = "") {
    return report::html_page(escape_xml(result.title.empty() ? "Contact analysis" : result.title), body,
                             "Made by abut " + program_build() +
                                 ". Forces and moments are totals over the thickness; counter-clockwise moments about the "
                                 "origin are positive; pressures push.",
                             end);
}

std::string loads_text(const CaseResult& c) {
    std::vector<std::string> loads;
    for (const auto& [name, factor] : c.factors) loads.push_back(number_text(factor, 6) + " × " + name);
    return "Loads: " + (loads.empty() ? "none that has a name" : joined(loads, ", "));
}

/// model: the loads with the values that they have in this case.
std::string case_box(const CaseResult& c, std::size_t k, const ModelFacts& model) {
    std::vector<std::string> values;
    for (const LoadFacts& load : model.loads) values.push_back(load_words(load) + " on " + joined(load.on, ", "));
    return "<h2><a href=\"" + case_folder(k) + "/report.html\">" + escape_xml(c.name) + "</a></h2>\n<p>" +
           escape_xml(loads_text(c) + (values.empty() ? "" : ": " + joined(values, "; "))) + "</p>\n" +
           report::verdict_box(c.result) + report::warnings_box(c.result);
}

/// A part of the yield is shown as the tables of one result have it.
std::string largest_text(const EnvelopeLine& line) {
    return line.quantity == "utilisation" ? percent_beside(line.largest.value, 1) : with_unit(line.largest.value, 5, line.unit);
}

std::string envelope_table(const std::vector<CaseResult>& cases) {
    const double size = model_size(cases.front().result);
    std::vector<std::vector<std::string>> rows;
    for (const EnvelopeLine& line : envelope_lines(cases)) {
        const bool is_something = line.largest.value > 0;
        rows.push_back({line.of, line.quantity, largest_text(line), is_something ? cases[line.largest.in_case].name : "–",
                        line.has_place && is_something ? place_text(line.largest.at, size) : "–"});
    }
    return "<h2>Largest of all cases</h2>\n" +
           report::html_table({{"of"},
                               {"quantity"},
                               {"value", true},
                               {"case"},
                               {heading("at", result_units(cases.front().result).length), true}},
                              rows);
}

}  // namespace

std::string report_data(const Result& result, const ModelFacts& model) {
    return result.geometry.empty() ? "" : report::page_data(result, model);
}

std::string report_html(const Result& result, const ModelFacts& model, int threads, const std::string* data) {
    std::array<std::string, 4> made;
    auto& [script, fields, contacts, tables] = made;
    solver::parallel_for(static_cast<int>(made.size()), threads, [&](int k) {
        if (k == 0) script = data ? *data : report_data(result, model);
        if (k == 1) fields = report::fields_section(result);
        if (k == 2) contacts = report::contacts_section(result);
        if (k == 3) tables = report::tables_section(result);
    });
    // The script shows its instrument instead of the pictures, which remain for paper and for browsers without scripts.
    const auto pictures = [](const std::string& sections) { return "<div class=\"pictures\">\n" + sections + "</div>\n"; };
    return page(result,
                report::verdict_box(result) + report::warnings_box(result) + "<div id=\"instrument\"></div>\n" +
                    pictures(report::assembly_section(result, model) + fields) + report::model_section(result, model) +
                    pictures(contacts) + tables,
                script.empty() ? "" : report::instrument(script));
}

std::string cases_html(const std::vector<CaseResult>& cases, const std::vector<ModelFacts>& models,
                       const std::vector<std::string>& data) {
    ModelFacts common = models.front();
    common.loads.clear();  // each case has its own
    std::string body =
        "<div id=\"instrument\"></div>\n" + envelope_table(cases) + report::model_section(cases.front().result, common);
    std::vector<report::CaseTab> tabs;
    for (std::size_t k = 0; k < cases.size(); ++k) {
        const Result& result = cases[k].result;
        body += case_box(cases[k], k, models[k]);
        if (data[k].empty()) continue;
        tabs.push_back(
            {cases[k].name, loads_text(cases[k]), verdict_word(verdict_of(result)), verdict_sentence(result), data[k]});
    }
    const bool in_steps = cases.front().is_step;
    return page(cases.front().result, body, tabs.empty() ? "" : report::instrument(report::tabs_data(tabs, in_steps)));
}

}  // namespace abut
