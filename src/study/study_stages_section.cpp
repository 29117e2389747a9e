// SPDX-License-Identifier: GPL-3.0-or-later
// Where the time goes: a bar of stages for each of the runs that tell most.
#include <algorithm>

#include "src/io/number_text.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_svg.hpp"
#include "src/study/study_page.hpp"

namespace abut::report {

namespace {

using Kind = StudySetting::Kind;

/// By stage, after M. Okabe and K. Ito; neighbours differ in lightness, too.
constexpr std::array<const char*, 8> stage_colors{"#999999", "#56b4e9", "#0072b2", "#e69f00",
                                                  "#d55e00", "#009e73", "#cc79a7", "#d9d9d9"};
/// Black or white, whichever reads better on it.
constexpr std::array<const char*, 8> stage_ink{"#000", "#000", "#fff", "#000", "#fff", "#fff", "#000", "#000"};

constexpr double name_width = 210, total_width = 90, bar_height = 18, row_height = 24, group_height = 30;
constexpr double bars_left = name_width, bars_right = page_width - total_width;

struct BarGroup {
    std::string title;
    std::vector<const StudyRun*> runs;
};

template <class Is>
BarGroup group_of(const Study& study, const std::string& title, Is is) {
    BarGroup group{title, {}};
    for (const StudyRun& run : study.runs)
        if (run.status == StudyRun::Status::ok && is(run.setting)) group.runs.push_back(&run);
    return group;
}

std::vector<BarGroup> groups_of(const Study& study) {
    std::vector<BarGroup> groups{
        group_of(study, "accuracy levels", [](const StudySetting& s) { return s.kind == Kind::level; }),
        group_of(study, "degree 2, one given grid, by cell size",
                 [](const StudySetting& s) { return s.kind == Kind::graded && s.degree == 2 && s.basis == "web"; }),
        group_of(study, "degrees, on the grids of standard",
                 [](const StudySetting& s) { return s.kind == Kind::graded && s.size == 1 && s.basis == "web"; })};
    for (BarGroup& g : groups)
        std::stable_sort(g.runs.begin(), g.runs.end(), [](const StudyRun* a, const StudyRun* b) {
            return a->setting.threads != b->setting.threads ? a->setting.threads < b->setting.threads
                                                            : a->unknowns < b->unknowns;
        });
    std::erase_if(groups, [](const BarGroup& g) { return g.runs.empty(); });
    return groups;
}

std::string segment(double x, double width, double y, std::size_t stage, double seconds, double share) {
    const std::string percent = number_text(100 * share, 2) + " %";
    std::string svg = "<g><title>" + std::string(study_stages[stage]) + ": " + duration_text(seconds) + ", " + percent +
                      "</title>" +
                      rectangle({x, y}, {width, bar_height},
                                std::string("fill=\"") + stage_colors[stage] + "\" stroke=\"#fff\" stroke-width=\"0.7\"");
    const std::string words = number_text(std::round(100 * share), 2);
    if (width > text_pixels(words, 11) + 6)
        svg += text({x + width / 2, y + bar_height - 5}, "middle", words,
                    std::string("style=\"font-size:11px;fill:") + stage_ink[stage] + "\"");
    return svg + "</g>\n";
}

std::string bar(const StudyRun& run, double y) {
    std::string svg = text({name_width - 8, y + bar_height - 5}, "end", setting_text(run.setting));
    double sum = 0;
    for (double seconds : run.stage) sum += seconds;
    double x = bars_left;
    for (std::size_t s = 0; sum > 0 && s < run.stage.size(); ++s) {
        const double width = (bars_right - bars_left) * run.stage[s] / sum;
        if (width > 0) svg += segment(x, width, y, s, run.stage[s], run.stage[s] / sum);
        x += width;
    }
    return svg + text({bars_right + 8, y + bar_height - 5}, "start", duration_text(run.seconds));
}

std::string stage_legend() {
    std::string html = "<ul class=\"legend\">\n";
    for (std::size_t s = 0; s < study_stages.size(); ++s)
        html += std::string("<li><span class=\"swatch\" style=\"background:") + stage_colors[s] + "\"></span>" +
                study_stages[s] + "</li>\n";
    return html + "</ul>\n";
}

}  // namespace

std::string stages_section(const Study& study) {
    const std::vector<BarGroup> groups = groups_of(study);
    if (groups.empty()) return "";
    std::string bars;
    double y = 0;
    for (const BarGroup& group : groups) {
        bars += text({0, y + 20}, "start", group.title, "style=\"font-weight:600\"");
        y += group_height;
        for (const StudyRun* run : group.runs) {
            bars += bar(*run, y);
            y += row_height;
        }
    }
    return "<section>\n<h2>Where the time goes</h2>\n<p>Shares of the whole run, in per cent; beside each bar its seconds. "
           "Solver time "
           "is geometry, assembly, factorisation and contact.</p>\n" +
           stage_legend() + open_svg(page_width, y + 4, "shares of the stages") + bars + "</svg>\n</section>\n";
}

}  // namespace abut::report
