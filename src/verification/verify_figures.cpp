// SPDX-License-Identifier: GPL-3.0-or-later
// Fields and pressures of the dissertation's scenes as pictures.
#include "src/verification/verify_figures.hpp"

#include <algorithm>
#include <cmath>

#include "src/io/number_text.hpp"
#include "src/report/report_contours.hpp"
#include "src/report/report_field_layer.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_svg.hpp"

namespace abut {

namespace {

using report::FieldValue;

constexpr double panel_width = 420, panel_height = 420, panel_margin = 18, title_height = 34, bar_height = 46;
constexpr double heading_lines = 42;   // the title's, and that of what it is
constexpr double drawn_share = 0.995;  // of the area keeps its colours: the fields have singular places
constexpr const char* style =
    "text{font:12px sans-serif;fill:#222}.title{font-weight:bold}.note{fill:#555}.axes line,.axes path{stroke:#555}";

struct Panel {
    std::string title;
    FieldValue value;
    double exaggeration = 0;
};

Box2 box_of(const Result& result, double times) {
    Box2 box;
    for (std::size_t i = 0; i < result.geometry.size(); ++i) {
        box.extend(bounding_box(result.geometry[i]));
        if (times == 0 || i >= result.fields.size()) continue;
        for (const auto& loop : result.fields[i].boundary)
            for (const FieldSample& s : loop) box.extend(Vec2(s.at + times * s.displacement));
    }
    return box;
}

/// From the lowest to the highest value that most of the area has.
struct Limits {
    double low, high;
};
Limits limits_of(const Result& result, const FieldValue& value) {
    const auto negative = [&](const FieldSample& s) { return -value(s); };
    Limits limits{-report::field_range(result, negative, drawn_share, Box2{}).quantile,
                  report::field_range(result, value, drawn_share, Box2{}).quantile};
    if (!(limits.high > limits.low)) limits.high = limits.low + 1;
    return limits;
}

std::string scale_bar(const Limits& limits, double width, double top) {
    const double left = panel_margin, right = width - panel_margin, height = 12;
    std::string svg;
    for (int band = 0; band < report::n_bands; ++band)
        svg += report::rectangle({left + (right - left) * band / report::n_bands, top},
                                 {(right - left) / report::n_bands + 0.5, height}, "fill=\"" + report::band_color(band) + "\"");
    for (const double t : nice_ticks(limits.low, limits.high, 5)) {
        if (t < limits.low || t > limits.high) continue;
        const double x = left + (right - left) * (t - limits.low) / (limits.high - limits.low);
        svg += report::line({x, top + height}, {x, top + height + 4}, "stroke=\"#555\"") +
               report::text({x, top + height + 17}, "middle", number_text(t, 3));
    }
    return svg;
}

std::string panel_svg(const Result& result, const Panel& panel, const std::string& id, double& height) {
    View view = fit_view(box_of(result, panel.exaggeration), panel_width, panel_height, panel_margin);
    view.offset.y() += title_height;
    const Limits limits = limits_of(result, panel.value);
    const FieldValue shifted = [&](const FieldSample& s) { return panel.value(s) - limits.low; };
    height = title_height + view.height + bar_height;
    return report::text({panel_margin, 22}, "start", panel.title, "class=\"title\"") +
           report::field_layer(result, view, {shifted, limits.high - limits.low, panel.exaggeration, Box2{}, id}) +
           scale_bar(limits, panel_width, title_height + view.height);
}

std::string panels_svg(const Result& result, const std::string& title, const std::string& note,
                       const std::vector<Panel>& panels) {
    std::string inner;
    double height = 0;
    for (std::size_t k = 0; k < panels.size(); ++k)
        inner += "<g transform=\"translate(" + std::to_string(static_cast<int>(panel_width) * static_cast<int>(k)) + " " +
                 std::to_string(static_cast<int>(heading_lines)) + ")\">\n" +
                 panel_svg(result, panels[k], "p" + std::to_string(k), height) + "</g>\n";
    const double width = panel_width * static_cast<double>(panels.size());
    return report::open_picture(width, height + heading_lines, title, style) +
           report::text({panel_margin, 18}, "start", title, "class=\"title\"") +
           report::text({panel_margin, 36}, "start", note + ". 0.5 % of the area lies beyond either end of a scale.",
                        "class=\"note\"") +
           inner + "</svg>\n";
}

std::vector<Panel> stress_panels() {
    return {{"(a) stress yy", [](const FieldSample& s) { return s.stress.yy; }},
            {"(b) stress xx", [](const FieldSample& s) { return s.stress.xx; }},
            {"(c) stress xy", [](const FieldSample& s) { return s.stress.xy; }}};
}

std::vector<Panel> displacement_panels(double times) {
    return {{"(a) displacement x", [](const FieldSample& s) { return s.displacement.x(); }, times},
            {"(b) displacement y", [](const FieldSample& s) { return s.displacement.y(); }, times}};
}

// ---- pressure ----

struct PlottedCurve {
    std::string name, color, dash;
    std::vector<Vec2> points;
};

std::vector<Vec2> profile_of(const Result& result, double up_to) {
    std::vector<Vec2> points;
    for (const ContactResult& c : result.contacts)
        for (std::size_t k = 0; k < c.profile.x.size(); ++k)
            if (c.profile.x[k] <= up_to) points.emplace_back(c.profile.x[k], c.profile.pressure[k]);
    std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
    return points;
}

std::vector<PlottedCurve> curves_of(const SolvedTable& solved, double up_to) {
    const DissertationTable::Curve& reference = *solved.table.pressure;
    constexpr int n = 200;
    PlottedCurve exact{reference.name, "#222222", "6 4", {}};
    for (int k = 0; k <= n; ++k) {
        const double x = reference.half_width * k / n;
        exact.points.emplace_back(x, reference.pressure(x));
    }
    std::vector<PlottedCurve> curves{std::move(exact)};
    const std::array<PlottedCurve, 3> ours{{{"the method as it was written", "#d3102b", "", {}},
                                            {"ours, by penalty", "#d98200", "2 3", {}},
                                            {"ours, mortar", "#1348b0", "", {}}}};
    for (std::size_t k = 0; k < ours.size(); ++k) {
        const std::optional<Result>& answer = solved.answers[k];
        if (!answer || answer->status != "ok") continue;
        curves.push_back(ours[k]);
        curves.back().points = profile_of(*answer, up_to);
    }
    return curves;
}

std::string pressure_svg(const SolvedTable& solved, const std::string& title, const std::string& note) {
    const double width = 720, height = 460, left = 70, bottom = 400, right = 690, top = 76;
    const double up_to = 1.2 * solved.table.pressure->half_width;
    const std::vector<PlottedCurve> curves = curves_of(solved, up_to);
    double most = 0;
    for (const PlottedCurve& c : curves)
        for (const Vec2& p : c.points) most = std::max(most, p.y());
    const std::vector<double> ticks = nice_ticks(0, most, 6), places = nice_ticks(0, up_to, 6);
    const auto at = [&](const Vec2& p) -> Vec2 {
        return {left + (right - left) * p.x() / up_to, bottom - (bottom - top) * p.y() / ticks.back()};
    };
    std::string svg = report::open_picture(width, height, title, style) +
                      report::text({18, 18}, "start", title, "class=\"title\"") +
                      report::text({18, 36}, "start", note, "class=\"note\"") + "<g class=\"axes\">\n";
    svg += report::line({left, bottom}, {right, bottom}, "") + report::line({left, bottom}, {left, top}, "");
    for (const double t : ticks)
        svg += report::line(at({0, t}) - Vec2(4, 0), at({0, t}), "") +
               report::text(at({0, t}) + Vec2(-7, 4), "end", number_text(t, 4));
    for (const double t : places)
        if (t <= up_to)
            svg += report::line(at({t, 0}), at({t, 0}) + Vec2(0, 4), "") +
                   report::text(at({t, 0}) + Vec2(0, 18), "middle", number_text(t, 3));
    svg += report::text({right, bottom + 36}, "end", "x") + report::text({left - 50, top - 14}, "start", "contact pressure") +
           "</g>\n";
    for (std::size_t k = 0; k < curves.size(); ++k) {
        std::vector<Vec2> points;
        for (const Vec2& p : curves[k].points) points.push_back(at(p));
        const std::string pen = "fill=\"none\" stroke=\"" + curves[k].color + "\" stroke-width=\"1.8\"" +
                                (curves[k].dash.empty() ? "" : " stroke-dasharray=\"" + curves[k].dash + "\"");
        const double y = bottom - 24 - 18 * static_cast<double>(curves.size() - 1 - k);
        svg += report::polyline(points, pen) + report::line({left + 16, y}, {left + 52, y}, pen) +
               report::text({left + 60, y + 4}, "start", curves[k].name);
    }
    return svg + "</svg>\n";
}

}  // namespace

std::vector<Figure> answer_figures(const SolvedTable& solved) {
    const std::optional<Result>& answer = solved.answers[static_cast<std::size_t>(Ours::written)];
    if (!answer || answer->status != "ok" || !report::has_fields(*answer)) return {};
    const DissertationTable& t = solved.table;
    const std::string of = "By the dissertation's method" + (t.figures.empty() ? "" : "; its figures " + t.figures);
    const double times = report::drawn_exaggeration(*answer);
    const std::string deformed = "Displacements drawn " + number_text(times, 3) + " times as large" +
                                 (t.figures.empty() ? "" : "; the dissertation's figures " + t.figures);
    std::vector<Figure> figures{{t.name + "_stress.svg", panels_svg(*answer, t.title, of, stress_panels())},
                                {t.name + "_displacement.svg", panels_svg(*answer, t.title, of, displacement_panels(0))},
                                {t.name + "_deformed.svg", panels_svg(*answer, t.title, deformed, displacement_panels(times))}};
    if (t.pressure) figures.push_back({t.name + "_pressure.svg", pressure_svg(solved, t.title, of)});
    return figures;
}

}  // namespace abut
