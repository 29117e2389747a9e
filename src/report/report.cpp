// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/report.hpp"

#include "src/io/build_id.hpp"
#include "src/io/escape_xml.hpp"
#include "src/report/report_sections.hpp"

namespace abut {

std::string report_html(const Result& result) {
    const std::string title = escape_xml(result.title.empty() ? "Contact analysis" : result.title);
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
           title + "</title>\n<style>" + report::style_sheet() + "</style>\n</head>\n<body>\n<main>\n<h1>" + title + "</h1>\n" +
           report::verdict_box(result) + report::warnings_box(result) + report::assembly_section(result) +
           report::fields_section(result) + report::contacts_section(result) + report::tables_section(result) +
           "<footer>Made by abut " + program_build() +
           ". Forces and moments are totals over the thickness; counter-clockwise moments about the origin "
           "are positive; "
           "pressures push.</footer>\n</main>\n</body>\n</html>\n";
}

}  // namespace abut
