// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/made_report.hpp"

#include "geometry/brep/input_error.hpp"
#include "src/io/build_id.hpp"
#include "src/io/escape_xml.hpp"
#include "src/report/page_data.hpp"
#include "src/report/report_page.hpp"
#include "src/report/report_table.hpp"

namespace abut {

namespace {

report::PagePieces read_page(const std::string& html, const std::string& name) {
    report::PagePieces page = report::pieces_of(html);
    if (page.title.empty() || page.body.empty() || page.footer.empty())
        throw InputError(name, "this is no report of abut", "give the folder of abut analyze");
    return page;
}

/// A page of cases has several results: none of them is compared.
report::CaseTab tab_of(const std::string& html, const std::string& name, const std::string& letter,
                       const std::string& verdict) {
    const report::PagePieces page = read_page(html, name);
    if (page.data.rfind("{\"steps\"", 0) == 0)
        throw InputError(name, "this is the report on several load cases or steps", "give the folder of one of them");
    if (page.data.empty()) throw InputError(name, "the report has no pictures: its analysis failed");
    return {letter, name, verdict, name, page.data};
}

}  // namespace

std::string remade_report(const std::string& html, const std::string& name) {
    const report::PagePieces page = read_page(html, name);
    constexpr const char* again = " This page was made anew by abut ";
    return report::html_page(page.title, page.body,
                             page.footer.substr(0, page.footer.find(again)) + again + program_build() + ".",
                             page.data.empty() ? "" : report::instrument(page.data));
}

std::string compare_html(const ResultDifference& difference, const std::string& html_a, const std::string& name_a,
                         const std::string& html_b, const std::string& name_b) {
    std::vector<std::vector<std::string>> rows = difference_rows(difference);
    rows.erase(rows.begin());
    const std::string body = "<p>A: " + escape_xml(name_a) + "<br/>B: " + escape_xml(name_b) +
                             "</p>\n<div id=\"instrument\"></div>\n<h2>Differences</h2>\n" +
                             report::html_table({{"of"}, {"quantity"}, {"A", true}, {"B", true}, {"change", true}, {""}}, rows);
    return report::html_page(
        "Two results", body, "Made by abut " + program_build() + ".",
        report::instrument(report::tabs_data(
            {tab_of(html_a, name_a, "A", difference.verdict_a), tab_of(html_b, name_b, "B", difference.verdict_b)}, false)));
}

}  // namespace abut
