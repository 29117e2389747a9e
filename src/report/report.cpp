// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/report.hpp"

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
    for (const auto& [name, factor] : c.factors) loads.push_back(number_text(factor, 6) + " x " + name);
    return loads.empty() ? "no load that has a name" : joined(loads, ", ");
}

std::string case_box(const CaseResult& c, std::size_t k) {
    return "<h2><a href=\"" + case_folder(k) + "/report.html\">" + escape_xml(c.name) + "</a></h2>\n<p>" +
           escape_xml(loads_text(c)) + "</p>\n" + report::verdict_box(c.result) + report::warnings_box(c.result);
}

std::string envelope_table(const std::vector<CaseResult>& cases) {
    const double size = model_size(cases.front().result);
    std::vector<std::vector<std::string>> rows;
    for (const EnvelopeLine& line : envelope_lines(cases)) {
        const bool is_something = line.largest.value > 0;
        rows.push_back({line.of, line.quantity, with_unit(line.largest.value, 5, line.unit),
                        is_something ? cases[line.largest.in_case].name : "–",
                        line.has_place && is_something ? place_text(line.largest.at, size) : "–"});
    }
    return "<h2>Largest of all cases</h2>\n" +
           report::html_table({{"of"}, {"quantity"}, {"value", true}, {"case"}, {"at", true}}, rows);
}

}  // namespace

std::string report_data(const Result& result, const ModelFacts& model) {
    return result.geometry.empty() ? "" : report::page_data(result, model);
}

std::string report_html(const Result& result, const ModelFacts& model) {
    return report_html(result, model, report_data(result, model));
}

std::string report_html(const Result& result, const ModelFacts& model, const std::string& data) {
    // The script shows its instrument instead of the pictures, which remain for paper and for browsers without scripts.
    const std::string pictures = "<div class=\"pictures\">\n" + report::assembly_section(result) +
                                 report::fields_section(result) + report::contacts_section(result) + "</div>\n";
    return page(result,
                report::verdict_box(result) + report::warnings_box(result) + "<div id=\"instrument\"></div>\n" + pictures +
                    report::model_section(result, model) + report::tables_section(result),
                data.empty() ? "" : report::instrument(data));
}

std::string cases_html(const std::vector<CaseResult>& cases, const std::vector<std::string>& data) {
    std::string body = "<div id=\"instrument\"></div>\n" + envelope_table(cases);
    std::vector<report::CaseTab> tabs;
    for (std::size_t k = 0; k < cases.size(); ++k) {
        const Result& result = cases[k].result;
        body += case_box(cases[k], k);
        if (data[k].empty()) continue;
        tabs.push_back(
            {cases[k].name, loads_text(cases[k]), verdict_word(verdict_of(result)), verdict_sentence(result), data[k]});
    }
    const bool in_steps = cases.front().result.solver.increments.has_value();
    return page(cases.front().result, body, tabs.empty() ? "" : report::instrument(report::tabs_data(tabs, in_steps)));
}

}  // namespace abut
