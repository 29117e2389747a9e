// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/report_table.hpp"

#include "src/io/escape_xml.hpp"

namespace abut::report {

namespace {

constexpr std::size_t short_word = 16;  ///< letters: up to here a word is not broken at its hyphens

std::string cell(const std::string& tag, bool number, const std::string& words) {
    const bool is_word =
        words.find('-') != std::string::npos && words.size() <= short_word && words.find(' ') == std::string::npos;
    return "<" + tag +
           (number    ? " class=\"n\""
            : is_word ? " class=\"word\""
                      : "") +
           ">" + escape_xml(words) + "</" + tag + ">";
}

}  // namespace

std::string html_table(const std::vector<Column>& columns, const std::vector<std::vector<std::string>>& rows) {
    std::string html = "<div class=\"table\"><table>\n<thead><tr>";
    for (const Column& column : columns) html += cell("th", column.number, column.heading);
    html += "</tr></thead>\n<tbody>\n";
    for (const auto& row : rows) {
        html += "<tr>";
        for (std::size_t i = 0; i < columns.size(); ++i) html += cell("td", columns[i].number, i < row.size() ? row[i] : "");
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

}  // namespace abut::report
