// SPDX-License-Identifier: GPL-3.0-or-later
// sweep.csv and sweep.html.
#include <algorithm>
#include <cmath>

#include "src/batch/sweep.hpp"
#include "src/io/build_id.hpp"
#include "src/io/csv_field.hpp"
#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_page.hpp"
#include "src/report/svg_elements.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

using geometry::Vec2;

constexpr double width = 548, height = 320, left = 74, top = 34, bottom = 44;
/// Right of the curves: room for half a number, and for the names of lines, whose letters are about as wide as this.
constexpr double curve_margin = 20, letter_width = 7;

/// Told apart by the colour-blind, and dark enough on white.
constexpr const char* line_colors[] = {"#1348b0", "#d98200", "#0a7d55", "#d3102b", "#7a3db8", "#5b5b5b"};

constexpr const char* sweep_style = R"(
.curves { display: flex; flex-wrap: wrap; gap: 16px; }
.curves svg { width: auto; max-width: 100%; background: #fff; }
.curves text { fill: #333; }
.title { font-weight: 600; }
.grid { stroke: #e2e2e2; }
.axis { stroke: #777; }
.failed { stroke: #d3102b; stroke-width: 2; }
)";

/// The values of all parameters but the first: what makes a line.
std::vector<double> line_of(const Sweep& sweep, const SweepPoint& point) {
    std::vector<double> values;
    for (std::size_t k = 1; k < sweep.parameters.size(); ++k) values.push_back(point.parameters.at(sweep.parameters[k].name));
    return values;
}

/// With as many digits as tell a parameter's values apart.
std::string value_text(const SweptParameter& parameter, double value) {
    for (int digits = 4; digits < 17; ++digits) {
        const std::string text = number_text(value, digits);
        if (std::none_of(parameter.values.begin(), parameter.values.end(),
                         [&](double other) { return other != value && number_text(other, digits) == text; }))
            return text;
    }
    return number_text(value, 17);
}

std::string line_name(const Sweep& sweep, const std::vector<double>& line) {
    std::string name;
    for (std::size_t k = 0; k < line.size(); ++k)
        name += (k == 0 ? "" : ", ") + sweep.parameters[k + 1].name + " = " + value_text(sweep.parameters[k + 1], line[k]);
    return name;
}

double abscissa(const Sweep& sweep, const SweepPoint& point) {
    return point.parameters.at(sweep.parameters.front().name);
}

/// A quantity's range over all points, error bars included, from 0 on where it is not far from there.
struct Axis {
    double low, high;
    std::vector<double> ticks;
};

Axis axis_of(double low, double high) {
    if (low > 0 && low < 0.5 * high) low = 0;
    if (!(high > low)) {
        const double half = high == 0 ? 1 : 0.1 * std::abs(high);
        low -= half;
        high += half;
    }
    Axis axis{low, high, nice_ticks(low, high, 5)};
    axis.low = axis.ticks.front();
    axis.high = axis.ticks.back();
    return axis;
}

class Chart {
public:
    Chart(const Sweep& sweep, std::size_t quantity) : sweep_(sweep), quantity_(quantity) {
        double low = INFINITY, high = -INFINITY;
        for (const SweepPoint& p : sweep.points)
            if (const auto& v = p.values[quantity]) {
                low = std::min(low, v->value - v->error.value_or(0));
                high = std::max(high, v->value + v->error.value_or(0));
            }
        y_ = axis_of(low, high);
        const std::vector<double>& values = sweep.parameters.front().values;
        x_ = axis_of(values.front(), values.back());
        for (const SweepPoint& p : sweep.points)
            right_ =
                std::max(right_, curve_margin + letter_width * static_cast<double>(line_name(sweep, line_of(sweep, p)).size()));
        right_ = std::min(right_, 0.4 * width);
    }

    std::string svg() const {
        std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number_text(width, 4) + "\" height=\"" +
                           number_text(height, 4) + "\" viewBox=\"0 0 " + number_text(width, 4) + " " + number_text(height, 4) +
                           "\" role=\"img\">\n" + axes();
        std::vector<std::vector<double>> lines;
        for (const SweepPoint& p : sweep_.points)
            if (const std::vector<double> own = line_of(sweep_, p); std::find(lines.begin(), lines.end(), own) == lines.end())
                lines.push_back(own);
        std::vector<double> labels;
        for (std::size_t k = 0; k < lines.size(); ++k) text += line(lines[k], line_colors[k % std::size(line_colors)], labels);
        return text + "</svg>\n";
    }

private:
    Vec2 at(double x, double y) const {
        return {left + (width - left - right_) * (x - x_.low) / (x_.high - x_.low),
                height - bottom - (height - top - bottom) * (y - y_.low) / (y_.high - y_.low)};
    }

    std::string axes() const {
        const SweepQuantity& q = sweep_.quantities[quantity_];
        std::string text = report::text({left, 18}, "start", q.of + ": " + heading(q.quantity, q.unit), "class=\"title\"");
        for (double t : y_.ticks)
            text += report::line(at(x_.low, t), at(x_.high, t), "class=\"grid\"") +
                    report::text(at(x_.low, t) + Vec2(-6, 4), "end", number_text(t, 4));
        for (double t : x_.ticks)
            text += report::line(at(t, y_.low), at(t, y_.low) + Vec2(0, 4), "class=\"axis\"") +
                    report::text(at(t, y_.low) + Vec2(0, 18), "middle", number_text(t, 4));
        return text + report::line(at(x_.low, y_.low), at(x_.high, y_.low), "class=\"axis\"") +
               report::text({0.5 * (left + width - right_), height - 6}, "middle", sweep_.parameters.front().name);
    }

    /// Between points that failed or have no such answer there is no line; those that failed are crosses below.
    std::string line(const std::vector<double>& of, const std::string& color, std::vector<double>& labels) const {
        std::string text;
        std::vector<Vec2> run;
        Vec2 last(0, 0);
        const auto end_run = [&] {
            if (run.size() > 1) text += report::polyline(run, "fill=\"none\" stroke=\"" + color + "\" stroke-width=\"1.6\"");
            run.clear();
        };
        for (const SweepPoint& p : sweep_.points) {
            if (line_of(sweep_, p) != of) continue;
            const double x = abscissa(sweep_, p);
            const std::optional<SweepValue>& v = p.values[quantity_];
            if (!v) {
                end_run();
                if (p.status != "ok" && p.status != "solved_but") text += cross(at(x, y_.low), p);
                continue;
            }
            run.push_back(last = at(x, v->value));
            if (v->error)
                text += report::line(at(x, v->value - *v->error), at(x, v->value + *v->error), "stroke=\"" + color + "\"");
            text += "<g><title>" + escape_xml(p.job + ": " + line_name(sweep_, of) + ": " + number_text(v->value, 5)) +
                    "</title>" +
                    report::circle(last, 3,
                                   p.status == "ok" ? "fill=\"" + color + "\""
                                                    : "fill=\"#fff\" stroke=\"" + color + "\" stroke-width=\"1.6\"") +
                    "</g>\n";
        }
        end_run();
        if (of.empty() || last.isZero(0)) return text;
        const double label = free_height(last.y() + 4, labels);
        if (label > height - bottom) return text;  // no room: the points tell their values
        return text + report::text({width - right_ + 8, label}, "start", line_name(sweep_, of), "style=\"fill:" + color + "\"");
    }

    /// Where a label covers no other: as high as wanted, or below what is there.
    static double free_height(double y, std::vector<double>& labels) {
        constexpr double line_height = 13;
        const auto covers = [&](double other) { return std::abs(other - y) < line_height; };
        for (auto it = labels.begin(); (it = std::find_if(labels.begin(), labels.end(), covers)) != labels.end();)
            y = *it + line_height;
        labels.push_back(y);
        return y;
    }

    static std::string cross(const Vec2& at, const SweepPoint& p) {
        return "<g><title>" + escape_xml(p.job + ": " + p.status + ": " + p.message) + "</title>" +
               report::line(at + Vec2(-4, -4), at + Vec2(4, 4), "class=\"failed\"") +
               report::line(at + Vec2(-4, 4), at + Vec2(4, -4), "class=\"failed\"") + "</g>\n";
    }

    const Sweep& sweep_;
    std::size_t quantity_;
    Axis x_{}, y_{};
    double right_ = curve_margin;
};

std::string failures(const Sweep& sweep) {
    std::string rows;
    for (const SweepPoint& p : sweep.points) {
        if (p.status == "ok") continue;
        rows += p.has_report ? "<tr><td><a href=\"jobs/" + p.job + "/report.html\">" + p.job + "</a></td>"
                             : "<tr><td>" + p.job + "</td>";
        for (const SweptParameter& parameter : sweep.parameters)
            rows += "<td>" + number_text(p.parameters.at(parameter.name), 6) + "</td>";
        rows += "<td>" + escape_xml(p.status) + "</td><td>" + escape_xml(p.message) + "</td></tr>\n";
    }
    if (rows.empty()) return "";
    std::string head = "<tr><th>job</th>";
    for (const SweptParameter& parameter : sweep.parameters) head += "<th>" + escape_xml(parameter.name) + "</th>";
    return "<h2>Not without reservations</h2>\n<div class=\"table\"><table>" + head + "<th>status</th><th></th></tr>\n" + rows +
           "</table></div>\n";
}

bool has_values(const Sweep& sweep, std::size_t quantity) {
    return std::any_of(sweep.points.begin(), sweep.points.end(),
                       [&](const SweepPoint& p) { return p.values[quantity].has_value(); });
}

}  // namespace

std::string sweep_csv(const Sweep& sweep) {
    std::string text = "job,status";
    for (const SweptParameter& p : sweep.parameters) text += "," + csv_field(p.name);
    for (const SweepQuantity& q : sweep.quantities)
        text += "," + csv_field(q.of + ": " + heading(q.quantity, q.unit)) + "," +
                csv_field(q.of + ": " + heading("error of " + q.quantity, q.unit));
    text += "\n";
    for (const SweepPoint& point : sweep.points) {
        text += point.job + "," + point.status;
        for (const SweptParameter& p : sweep.parameters) text += "," + csv_field(point.parameters.at(p.name));
        for (const std::optional<SweepValue>& v : point.values) {
            text += "," + (v ? csv_field(v->value) : "");
            text += "," + (v && v->error ? csv_field(*v->error) : "");
        }
        text += "\n";
    }
    return text;
}

std::string sweep_html(const Sweep& sweep) {
    const std::string title = escape_xml("Sweep of " + sweep.scene);
    std::string body;
    for (std::size_t k = 0; k < sweep.quantities.size(); ++k)
        if (has_values(sweep, k)) body += Chart(sweep, k).svg();
    body = body.empty() ? "<p>No job has an answer.</p>\n" : "<div class=\"charts curves\">\n" + body + "</div>\n";
    return report::html_page(
        title, body + failures(sweep),
        "Made by abut " + program_build() +
            ". Bars are estimated errors; hollow points are solved with reservations, crosses have no answer. "
            "<a href=\"index.html\">All jobs</a>, <a href=\"sweep.csv\">as a table</a>.",
        "", sweep_style);
}

}  // namespace abut
