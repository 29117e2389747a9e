// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/escape_xml.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_table.hpp"
#include "src/results/result_units.hpp"

namespace abut::report {

namespace {

std::string motions_cell(const std::vector<std::string>& motions) {
    return motions.empty() ? "held" : motions.size() == 3 ? "moves freely" : joined(motions, "; ");
}

std::string count_words(const MobilityResult& m) {
    return counted(static_cast<std::size_t>(m.degrees_of_freedom), "free motion") +
           (m.redundant > 0 ? ", over-constrained by " + std::to_string(m.redundant) : "");
}

}  // namespace

std::string mobility_table(const Result& result) {
    const MobilityResult& drawn = result.as_drawn;
    if (drawn.parts.empty()) return "";
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < drawn.parts.size(); ++i)
        rows.push_back({drawn.parts[i].part, motions_cell(drawn.parts[i].alone), motions_cell(drawn.parts[i].motions),
                        result.under_load ? motions_cell(result.under_load->parts[i].motions) : "–"});
    std::string words = "As rigid bodies, with contacts counted as if they held both ways. As drawn: " + count_words(drawn);
    if (result.under_load) words += "; with the contacts that carry force: " + count_words(*result.under_load);
    return "<h3>Mobility</h3>\n<p>" + escape_xml(words) + ".</p>\n" +
           html_table({{"part"}, {"by its supports alone"}, {"with all contacts"}, {"with those under force"}}, rows);
}

}  // namespace abut::report
