// SPDX-License-Identifier: GPL-3.0-or-later
// What accuracy was aimed at and reached, grid by grid, and what more would cost.
#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_table.hpp"
#include "src/results/result_units.hpp"

namespace abut::report {

namespace {

std::string aimed_and_reached(const Result& result) {
    const auto& a = result.accuracy;
    std::string words = "Estimated error of the " + a.of + ": " + percent_beside(*a.estimate, a.target) +
                        "; aimed at: " + percent_text(a.target) + ".";
    if (!a.why.empty()) words += " Not reached: " + a.why + ".";
    if (a.of == "contact pressure")
        words +=
            " Relative, root of the mean square over each contact, by the strongest contact's pressure; the largest of the "
            "contacts, or of the largest pressures if that is more. ";
    else
        words += " Relative: of the stress in the energy norm over all parts, or of its largest value if that is more. ";
    if (result.error_estimate.energy) words += "Strain energy: " + percent_text(*result.error_estimate.energy) + ". ";
    words += "Method: " + result.error_estimate.method + ".";
    if (result.next_level)
        words += " An error of " + percent_text(result.next_level->target) + " (--accuracy " + result.next_level->accuracy +
                 ") would take about " + seconds_text(result.next_level->seconds) + ".";
    return words;
}

}  // namespace

std::string accuracy_table(const Result& result) {
    if (!result.accuracy.estimate || result.passes.empty()) return "";
    std::vector<std::vector<std::string>> rows;
    for (std::size_t k = 0; k < result.passes.size(); ++k) {
        const PassSummary& p = result.passes[k];
        rows.push_back({std::to_string(k + 1), std::to_string(p.unknowns), std::to_string(p.multipliers),
                        p.estimated_error ? percent_text(*p.estimated_error) : "–", seconds_text(p.seconds)});
    }
    return "<h3>Accuracy</h3>\n<p>" + escape_xml(aimed_and_reached(result)) + "</p>\n" +
           html_table(
               {{"grids", true}, {"unknowns", true}, {"multipliers", true}, {"estimated error", true}, {"time so far", true}},
               rows);
}

}  // namespace abut::report
