// SPDX-License-Identifier: GPL-3.0-or-later
// Time and memory against unknowns.
#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_svg.hpp"
#include "src/study/study_page.hpp"

namespace abut::report {

namespace {

std::string growth_chart(const Study& study, const RunValue& y, const std::string& caption) {
    const RunValue x = unknowns_of_run();
    return figure(log_chart({caption, x.title, y.title, x.text, y.text, study_series(study, x, y)}), caption, half_width);
}

std::string exponents(const Study& study) {
    std::string words;
    for (const StudyFamily& family : families_of(study))
        if (const auto exponent = time_exponent(study, family))
            words += (words.empty() ? "" : "; ") + family.name + " " + number_text(*exponent, 3);
    return words.empty() ? "" : "<p>Solver time grows with the unknowns to the power: " + escape_xml(words) + ".</p>\n";
}

}  // namespace

std::string growth_section(const Study& study) {
    const RunValue time{[](const StudyRun& r) { return r.solver_seconds; }, duration_text, "solver time"};
    const RunValue memory{[](const StudyRun& r) { return r.peak_bytes; }, memory_text, "largest resident size"};
    return "<section>\n<h2>Time and memory against size</h2>\n<div class=\"row\">" +
           growth_chart(study, time, "Solver time against unknowns") +
           growth_chart(study, memory, "Memory against unknowns, report included") + "</div>\n" + study_legend(study) +
           exponents(study) + "</section>\n";
}

}  // namespace abut::report
