// SPDX-License-Identifier: GPL-3.0-or-later
// Families of runs as curves: their colours, marks and titles, the same in every chart.
#include <array>

#include "src/io/escape_xml.hpp"
#include "src/report/report_sections.hpp"
#include "src/study/study_page.hpp"

namespace abut::report {

namespace {

using Kind = StudySetting::Kind;

/// Colours of M. Okabe and K. Ito that are told apart by the colour-blind, on white; by degree.
constexpr std::array<const char*, 4> degree_colors{"#d55e00", "#0072b2", "#009e73", "#b65a94"};
constexpr std::array<Mark, 4> degree_marks{Mark::triangle, Mark::disc, Mark::square, Mark::diamond};

void dress_as_level(const StudySetting& s, ChartSeries& series) {
    series.color = "#1c1c1c";
    series.mark = Mark::disc;
    series.line_width = 2.6;
    if (s.threads == 1) return;
    series.hollow = true;
    series.dashes = "6 3";
    series.line_width = 1.6;
}

void dress_as_grid(const StudySetting& s, ChartSeries& series) {
    const auto k = static_cast<std::size_t>(s.degree - 1) % degree_colors.size();
    series.color = degree_colors[k];
    series.mark = degree_marks[k];
    if (s.basis == "web") return;
    if (s.basis == basis_of_dissertation) series.color = "#1c1c1c";
    series.hollow = true;
    series.dashes = "2 3";
    series.line_width = 1.2;
}

ChartSeries dressed(const StudyFamily& family) {
    ChartSeries series;
    if (family.like.kind == Kind::level) {
        dress_as_level(family.like, series);
    } else if (family.like.kind == Kind::uniform) {
        series.color = "#777";
        series.mark = Mark::cross;
        series.label = "equal cells";
    } else {
        dress_as_grid(family.like, series);
        if (family.like.basis == "web") series.label = "p = " + std::to_string(family.like.degree);
    }
    return series;
}

std::string point_title(const StudyRun& run, const RunValue& x, const RunValue& y) {
    return setting_text(run.setting) + ": " + x.text(x.value(run)) + ", " + y.title + " " + y.text(y.value(run));
}

ChartSeries series_of(const Study& study, const StudyFamily& family, const RunValue& x, const RunValue& y) {
    ChartSeries series = dressed(family);
    for (std::size_t i : family.runs) {
        const StudyRun& run = study.runs[i];
        const bool has_name = family.like.kind == Kind::level && family.like.threads == 1;
        series.points.push_back({x.value(run), y.value(run), point_title(run, x, y), has_name ? run.setting.level : ""});
    }
    return series;
}

/// Levels last, above all others; what is there to compare with first.
int layer(const StudyFamily& family) {
    if (family.like.kind == Kind::uniform) return 0;
    if (family.like.kind == Kind::graded) return family.like.basis == "web" ? 2 : 1;
    return family.like.threads > 1 ? 3 : 4;
}

std::vector<StudyFamily> families_by_layer(const Study& study) {
    std::vector<StudyFamily> families = families_of(study);
    std::stable_sort(families.begin(), families.end(),
                     [](const StudyFamily& a, const StudyFamily& b) { return layer(a) < layer(b); });
    return families;
}

std::string legend_words(const StudyFamily& family) {
    if (family.like.kind == Kind::level) return "accuracy " + family.name + ", grids and all";
    if (family.like.kind == Kind::uniform) return "equal cells, degree " + std::to_string(family.like.degree);
    if (family.like.basis == basis_of_dissertation) return family.name + "'s method";
    return family.name + (family.like.basis == "web" ? "" : " basis");
}

}  // namespace

RunValue unknowns_of_run() {
    return {[](const StudyRun& r) { return static_cast<double>(r.unknowns); }, count_text, "unknowns"};
}

std::vector<ChartSeries> study_series(const Study& study, const RunValue& x, const RunValue& y) {
    std::vector<ChartSeries> list;
    for (const StudyFamily& family : families_by_layer(study)) list.push_back(series_of(study, family, x, y));
    return list;
}

std::string study_legend(const Study& study) {
    std::string html = "<ul class=\"legend\">\n";
    std::vector<StudyFamily> families = families_by_layer(study);
    std::stable_sort(families.begin(), families.end(),
                     [](const StudyFamily& a, const StudyFamily& b) { return layer(a) > layer(b); });
    for (const StudyFamily& family : families)
        html += "<li>" + series_sign(dressed(family)) + escape_xml(legend_words(family)) + "</li>\n";
    return html + "</ul>\n";
}

}  // namespace abut::report
