// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard_cases/curve_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_svg.hpp"

namespace abut::test {

namespace {

using report::line;
using report::text;

constexpr double panel_width = 400, panel_height = 250;  // with its axis labels
constexpr double left = 58, right = 14, top = 26, bottom = 42, one_row_head = 56, legend_row = 18;

/// One panel's axes in pixels.
struct Axes {
    Vec2 corner;  ///< upper left of the panel
    Vec2 x, y;    ///< exponents
    double x0() const { return corner.x() + left; }
    double x1() const { return corner.x() + panel_width - right; }
    double y0() const { return corner.y() + top; }
    double y1() const { return corner.y() + panel_height - bottom; }
    /// Values beyond the axes are drawn at their ends.
    Vec2 operator()(const Vec2& v) const {
        const auto part = [](double value, const Vec2& range) {
            return std::clamp((std::log10(value) - range.x()) / (range.y() - range.x()), 0.0, 1.0);
        };
        return {x0() + part(v.x(), x) * (x1() - x0()), y1() - part(v.y(), y) * (y1() - y0())};
    }
};

/// Values that are labelled: at most about seven powers of ten; of short ranges the 2, 3 and 5 between them, too.
std::vector<double> labelled_values(const Vec2& range) {
    const int low = static_cast<int>(std::floor(range.x())), high = static_cast<int>(std::floor(range.y()));
    const int step = 1 + (high - low) / 8;
    const bool is_short = range.y() - range.x() < 2;
    std::vector<double> values;
    for (int k = low; k <= high; ++k)
        for (double m : {1.0, 2.0, 3.0, 5.0}) {
            const double exponent = k + std::log10(m);
            if ((m == 1 ? k % step == 0 : is_short) && exponent >= range.x() && exponent <= range.y())
                values.push_back(m * std::pow(10.0, k));
        }
    return values;
}

/// "0.05", or as a power of ten.
std::string tick_text(const Vec2& at, const std::string& anchor, double value, bool as_power) {
    const std::string words =
        as_power ? "10<tspan dy=\"-4\" font-size=\"8\">" + std::to_string(std::lround(std::log10(value))) + "</tspan>"
                 : number_text(value, 2);
    return "<text x=\"" + coordinate_text(at.x()) + "\" y=\"" + coordinate_text(at.y()) + "\" text-anchor=\"" + anchor +
           "\" class=\"tick\">" + words + "</text>\n";
}

std::string frame(const Axes& a, const LogPlot& plot, const std::string& title) {
    const auto is_long = [](const Vec2& range) { return range.y() - range.x() >= 2; };
    std::string svg;
    for (double v : labelled_values(plot.x_range)) {
        const Vec2 p = a({v, 1});
        svg += line({p.x(), a.y0()}, {p.x(), a.y1()}, "stroke=\"#e2e2e2\" stroke-width=\"0.8\"");
        svg += tick_text({p.x(), a.y1() + 15}, "middle", v, is_long(plot.x_range));
    }
    for (double v : labelled_values(plot.y_range)) {
        const Vec2 p = a({1, v});
        svg += line({a.x0(), p.y()}, {a.x1(), p.y()}, "stroke=\"#e2e2e2\" stroke-width=\"0.8\"");
        svg += tick_text({a.x0() - 6, p.y() + 4}, "end", v, is_long(plot.y_range));
    }
    svg += report::rectangle({a.x0(), a.y0()}, {a.x1() - a.x0(), a.y1() - a.y0()},
                             "fill=\"none\" stroke=\"#777\" stroke-width=\"0.8\"");
    svg += text({0.5 * (a.x0() + a.x1()), a.y1() + 34}, "middle", plot.x_label, "class=\"axis\"");
    svg += "<text transform=\"translate(" + coordinate_text(a.corner.x() + 14) + " " +
           coordinate_text(0.5 * (a.y0() + a.y1())) + ") rotate(-90)\" text-anchor=\"middle\" class=\"axis\">" +
           escape_xml(plot.y_label) + "</text>\n";
    return svg + text({a.x0(), a.y0() - 7}, "start", title, "class=\"panel\"");
}

std::string drawn(const Axes& a, const PlotSeries& s) {
    std::string svg;
    std::vector<Vec2> outline, curve;
    for (std::size_t k = 0; k < s.band.size(); ++k) outline.push_back(a({s.points[k].x(), s.band[k].x()}));
    for (std::size_t k = s.band.size(); k-- > 0;) outline.push_back(a({s.points[k].x(), s.band[k].y()}));
    for (const Vec2& p : s.points) curve.push_back(a(p));
    if (!outline.empty()) svg += report::polygon(outline, "fill=\"" + s.color + "\" fill-opacity=\"0.18\"");
    svg += report::polyline(curve, "fill=\"none\" stroke=\"" + s.color + "\" stroke-width=\"" + (s.dashed ? "0.9" : "1.8") +
                                       "\" stroke-linejoin=\"round\"" + (s.dashed ? " stroke-dasharray=\"4 3\"" : ""));
    for (const Vec2& p : curve)
        if (s.with_marks) svg += report::circle(p, 2.6, "fill=\"" + s.color + "\"");
    return svg;
}

/// Entries in rows no wider than the picture; `rows` counts them.
std::string legend(const LogPlot& plot, double width, int& rows) {
    std::string svg;
    std::vector<std::string> known;
    double x = left, y = 40;
    rows = 1;
    for (const PlotPanel& panel : plot.panels)
        for (const PlotSeries& s : panel.series) {
            if (s.name.empty() || std::find(known.begin(), known.end(), s.name) != known.end()) continue;
            known.push_back(s.name);
            const double own = 48 + report::text_pixels(s.name, 12);
            if (x > left && x + own > width) {
                x = left;
                y += legend_row;
                ++rows;
            }
            svg += line({x, y}, {x + 22, y},
                        "stroke=\"" + s.color + "\" stroke-width=\"2.2\"" + (s.dashed ? " stroke-dasharray=\"4 3\"" : ""));
            svg += text({x + 28, y + 4}, "start", s.name);
            x += own;
        }
    return svg;
}

std::string short_text(double v) {
    std::array<char, 40> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.8g", v);
    return buffer.data();
}

constexpr const char* style =
    "<style>text { font: 12px system-ui, 'Segoe UI', 'Helvetica Neue', 'DejaVu Sans', Arial, sans-serif; fill: #1c1c1c; } "
    ".title { font-size: 15px; font-weight: 600; } .panel { font-size: 12px; font-weight: 600; } .axis { font-size: 11.5px; } "
    ".tick { font-size: 11px; fill: #444; } .note { font-size: 11px; fill: #444; paint-order: stroke; stroke: #fff; "
    "stroke-width: 3px; }"
    "</style>\n";

}  // namespace

std::string sweep_folder() {
    const char* given = std::getenv("ABUT_SWEEP_DIR");
    const std::filesystem::path folder =
        given ? std::filesystem::path(given) : std::filesystem::read_symlink("/proc/self/exe").parent_path() / "sweeps";
    std::filesystem::create_directories(folder);
    return folder.string();
}

void write_csv(const std::string& name, const Table& table) {
    std::ofstream file(sweep_folder() + "/" + name + ".csv");
    const bool labelled = !table.labels.empty();
    if (labelled) file << "case,";
    for (std::size_t c = 0; c < table.columns.size(); ++c) file << (c ? "," : "") << table.columns[c];
    file << '\n';
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        if (labelled) file << table.labels[r] << ',';
        for (std::size_t c = 0; c < table.rows[r].size(); ++c) file << (c ? "," : "") << short_text(table.rows[r][c]);
        file << '\n';
    }
}

std::string log_plot_svg(const LogPlot& plot) {
    const auto n = static_cast<int>(plot.panels.size());
    const int columns = std::min(plot.columns, n), rows = (n + columns - 1) / columns;
    int legend_rows = 1;
    const double width = columns * panel_width;
    const std::string entries = legend(plot, width, legend_rows);
    const double head = one_row_head + (legend_rows - 1) * legend_row, height = head + rows * panel_height;
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + coordinate_text(width) + "\" height=\"" +
                      coordinate_text(height) + "\" viewBox=\"0 0 " + coordinate_text(width) + " " + coordinate_text(height) +
                      "\" role=\"img\" aria-label=\"" + escape_xml(plot.title) + "\">\n";
    svg += style + report::rectangle({0, 0}, {width, height}, "fill=\"#fff\"");
    svg += text({left, 22}, "start", plot.title, "class=\"title\"") + entries;
    for (int k = 0; k < n; ++k) {
        const PlotPanel& panel = plot.panels[static_cast<std::size_t>(k)];
        const Axes axes{{(k % columns) * panel_width, head + (k / columns) * panel_height}, plot.x_range, plot.y_range};
        svg += frame(axes, plot, panel.title);
        for (const PlotSeries& s : panel.series) svg += drawn(axes, s);
        for (std::size_t k_line = 0; k_line < panel.notes.size(); ++k_line)
            svg += text({axes.x0() + 8, axes.y1() - 5 - 12 * static_cast<double>(panel.notes.size() - 1 - k_line)}, "start",
                        panel.notes[k_line], "class=\"note\"");
    }
    return svg + "</svg>\n";
}

void write_plot(const std::string& name, const LogPlot& plot) {
    std::ofstream(sweep_folder() + "/" + name + ".svg") << log_plot_svg(plot);
}

}  // namespace abut::test
