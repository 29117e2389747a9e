// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a study.
#include "src/io/escape_xml.hpp"
#include "src/report/report_page.hpp"
#include "src/results/result_units.hpp"
#include "src/study/study_page.hpp"

namespace abut {

namespace {

constexpr const char* study_style = R"(
.choice input { position: absolute; opacity: 0; }
.choice label { display: inline-block; margin: 2px 4px 10px 0; padding: 3px 11px; border: 1px solid var(--rule); border-radius: 12px; font-size: 13px; cursor: pointer; }
.choice input:checked + label { background: var(--accent); border-color: var(--accent); color: var(--paper); }
.choice input:focus-visible + label { outline: 2px solid var(--accent); }
.row h3 { margin-top: 12px; }
td { white-space: pre-wrap; }
.runs td:first-child { white-space: nowrap; }
section > svg, .legend svg { background: #fff; }
p.note { color: var(--soft); font-size: 13px; }
)";

std::string list_of(const std::vector<std::string>& sentences) {
    std::string html = "<ul>\n";
    for (const std::string& s : sentences) html += "<li>" + escape_xml(s) + "</li>\n";
    return html + "</ul>\n";
}

std::string capitalized(std::string words) {
    if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
    return words;
}

std::string verdict(const Study& study) {
    const std::optional<std::size_t> measure = main_measure(study);
    if (!measure) return "<p class=\"verdict failed\">No error can be told: no quantity changes from run to run.</p>\n";
    const std::vector<std::string> sentences = study_sentences(study, *measure);
    if (sentences.empty()) return "<p class=\"verdict failed\">No run was solved.</p>\n";
    return "<p class=\"verdict\">" + escape_xml(capitalized(study.measures[*measure].what) + ": " + sentences.front()) +
           "</p>\n" + list_of({sentences.begin() + 1, sentences.end()});
}

std::string notes_box(const Study& study) {
    return study.notes.empty() ? "" : "<div class=\"warnings\">" + list_of(study.notes) + "</div>\n";
}

constexpr const char* method =
    "Made by abut study. Each setting is solved in a process of its own, several times where that is short; times are medians "
    "of wall "
    "time on one thread unless the setting names threads. Accuracy levels begin with nothing but the scene: finding contact "
    "and its "
    "grids is in their time. Runs on one given grid are told the grids that the level standard ended with, with larger or "
    "smaller cells: "
    "what those cost to find is not in theirs, and their pressures have no knots put where contact ends, as those of levels "
    "do. A setting counts as reaching an error if all runs of its kind with more "
    "unknowns keep it.";

}  // namespace

std::string study_html(const Study& study) {
    const std::string title = escape_xml("What accuracy costs: " + (study.title.empty() ? study.file : study.title));
    return report::html_page(title,
                             verdict(study) + notes_box(study) + "<div class=\"charts\">\n" + report::errors_section(study) +
                                 report::stages_section(study) + report::growth_section(study) + "</div>\n" +
                                 report::runs_section(study),
                             method, "", study_style);
}

}  // namespace abut
