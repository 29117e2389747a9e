// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/study_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/label_placement.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_svg.hpp"

namespace abut::report {

namespace {

constexpr double height = 400, left = 62, right = half_width - 14, top = 30, bottom = height - 48;
constexpr double room = 0.045;  ///< on either side of the points, of the axis
constexpr double label_font = 12, mark_radius = 3.6;
constexpr double least_decades = 0.3;  ///< an axis spans at least a factor of two

bool can_be_drawn(const ChartPoint& p) {
    return p.x > 0 && p.y > 0 && std::isfinite(p.x) && std::isfinite(p.y);
}

/// A logarithmic axis on a stretch of the picture.
struct Axis {
    double low, high;   ///< values at its ends
    double begin, end;  ///< pixels
    double operator()(double v) const { return begin + (end - begin) * std::log(v / low) / std::log(high / low); }
};

Axis axis_over(double low, double high, double begin, double end) {
    double decades = std::log10(high / low);
    double middle = 0.5 * (std::log10(low) + std::log10(high));
    decades = std::max(decades, least_decades) * (1 + 2 * room);
    return {std::pow(10, middle - decades / 2), std::pow(10, middle + decades / 2), begin, end};
}

struct Axes {
    Axis x, y;
    Vec2 operator()(const ChartPoint& p) const { return {x(p.x), y(p.y)}; }
};

/// False: there is nothing to draw.
bool find_axes(const LogChart& chart, Axes& axes) {
    constexpr double none = std::numeric_limits<double>::infinity();
    double x0 = none, x1 = 0, y0 = none, y1 = 0;
    int n = 0;
    for (const ChartSeries& s : chart.series)
        for (const ChartPoint& p : s.points) {
            if (!can_be_drawn(p)) continue;
            ++n;
            x0 = std::min(x0, p.x);
            x1 = std::max(x1, p.x);
            y0 = std::min(y0, p.y);
            y1 = std::max(y1, p.y);
        }
    if (n < 2) return false;
    axes = {axis_over(x0, x1, left, right), axis_over(y0, y1, bottom, top)};
    return true;
}

std::string grid_lines(const LogChart& chart, const Axes& axes) {
    std::string svg = "<g class=\"axes\">\n";
    for (double v : log_ticks(axes.x.low, axes.x.high)) {
        const double x = axes.x(v);
        svg += line({x, top}, {x, bottom}, "class=\"grid\"") + text({x, bottom + 16}, "middle", chart.x_text(v));
    }
    for (double v : log_ticks(axes.y.low, axes.y.high)) {
        const double y = axes.y(v);
        svg += line({left, y}, {right, y}, "class=\"grid\"") + text({left - 7, y + 4}, "end", chart.y_text(v));
    }
    svg += line({left, bottom}, {right, bottom}, "") + line({left, top}, {left, bottom}, "") + "</g>\n";
    return svg + text({8, 15}, "start", chart.y_title, "class=\"axis-title\"") +
           text({right, height - 10}, "end", chart.x_title, "class=\"axis-title\"");
}

std::string stroke(const ChartSeries& s) {
    return "fill=\"" + (s.hollow ? std::string("#fff") : s.color) + "\" stroke=\"" + s.color + "\" stroke-width=\"1.4\"";
}

std::string mark(const ChartSeries& s, const Vec2& at) {
    const double r = mark_radius;
    const auto moved = [&](double x, double y) { return Vec2(at.x() + r * x, at.y() + r * y); };
    switch (s.mark) {
        case Mark::square:
            return rectangle(moved(-0.9, -0.9), {1.8 * r, 1.8 * r}, stroke(s));
        case Mark::triangle:
            return polygon({moved(0, -1.25), moved(1.15, 0.85), moved(-1.15, 0.85)}, stroke(s));
        case Mark::diamond:
            return polygon({moved(0, -1.35), moved(1.35, 0), moved(0, 1.35), moved(-1.35, 0)}, stroke(s));
        case Mark::cross:
            return line(moved(-1, -1), moved(1, 1), stroke(s)) + line(moved(-1, 1), moved(1, -1), stroke(s));
        default:
            return circle(at, r, stroke(s));
    }
}

std::string line_style(const ChartSeries& s) {
    return "fill=\"none\" stroke=\"" + s.color + "\" stroke-width=\"" + coordinate_text(s.line_width) +
           "\" stroke-linejoin=\"round\"" + (s.dashes.empty() ? "" : " stroke-dasharray=\"" + s.dashes + "\"");
}

std::vector<Vec2> drawn_points(const ChartSeries& s, const Axes& axes) {
    std::vector<Vec2> points;
    for (const ChartPoint& p : s.points)
        if (can_be_drawn(p)) points.push_back(axes(p));
    return points;
}

std::string curve(const ChartSeries& s, const Axes& axes) {
    const std::vector<Vec2> points = drawn_points(s, axes);
    return points.size() < 2 || s.line_width == 0 ? "" : polyline(points, line_style(s));
}

std::string marks(const ChartSeries& s, const Axes& axes) {
    std::string svg;
    for (const ChartPoint& p : s.points)
        if (can_be_drawn(p)) svg += "<g><title>" + escape_xml(p.title) + "</title>" + mark(s, axes(p)) + "</g>\n";
    return svg;
}

Box2 box_around(const Vec2& at, double radius) {
    Box2 box;
    box.extend(Vec2(at - Vec2::Constant(radius)));
    box.extend(Vec2(at + Vec2::Constant(radius)));
    return box;
}

/// Finds places for labels: clear of marks, curves and each other, else of marks and labels only.
class Labels {
public:
    Labels() : clear_(area()), loose_(area()) {}

    void avoid(const std::vector<Vec2>& points, bool has_line) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            clear_.take(box_around(points[i], mark_radius + 1));
            loose_.take(box_around(points[i], mark_radius + 1));
            if (has_line && i + 1 < points.size()) avoid_line(points[i], points[i + 1]);
        }
    }

    /// Beside the first of the points where there is room, the nearer the better; nothing where there is none: the legend and
    /// the titles of the marks have it.
    std::string place(const std::string& words, const std::vector<Vec2>& points, const std::string& color) {
        if (words.empty()) return "";
        for (const LabelPlacement* placement : {&clear_, &loose_})
            for (double distance : {0.0, 6.0, 12.0})
                for (const Vec2& at : points)
                    for (const Vec2& way : ways())
                        if (const Vec2 middle = middle_of(words, at, way, distance); is_free(*placement, words, middle))
                            return written(words, middle, color);
        return "";
    }

private:
    static Box2 area() {
        Box2 box;
        box.extend(Vec2(left + 2, top - 8));
        box.extend(Vec2(right + 12, bottom - 2));
        return box;
    }
    static std::vector<Vec2> ways() {
        return {{1, 0}, {0.8, -0.8}, {0.8, 0.8}, {-0.8, 0.8}, {-0.8, -0.8}, {-1, 0}, {0, -1}, {0, 1}};
    }
    static Vec2 middle_of(const std::string& words, const Vec2& at, const Vec2& way, double distance) {
        const Vec2 half = 0.5 * text_box(words, label_font, at).size();
        const double gap = mark_radius + 3 + distance;
        return {at.x() + way.x() * (half.x() + gap), at.y() + way.y() * (half.y() + gap)};
    }
    static bool is_free(const LabelPlacement& placement, const std::string& words, const Vec2& middle) {
        return placement.is_free(text_box(words, label_font, middle), false);
    }
    std::string written(const std::string& words, const Vec2& middle, const std::string& color) {
        const Box2 box = text_box(words, label_font, middle);
        clear_.take(box);
        loose_.take(box);
        return text(middle + Vec2(0, 0.35 * label_font), "middle", words,
                    "class=\"halo\" style=\"fill:" + color + ";font-weight:600\"");
    }
    void avoid_line(const Vec2& a, const Vec2& b) {
        const int n = static_cast<int>((b - a).norm() / 5);
        for (int k = 1; k < n; ++k) clear_.take(box_around(a + (b - a) * (static_cast<double>(k) / n), 2));
    }

    LabelPlacement clear_, loose_;
};

std::string labels(const LogChart& chart, const Axes& axes) {
    Labels labels;
    for (const ChartSeries& s : chart.series) labels.avoid(drawn_points(s, axes), s.line_width > 0);
    std::string svg;
    for (auto s = chart.series.rbegin(); s != chart.series.rend(); ++s) {  // the uppermost choose first
        for (const ChartPoint& p : s->points)
            if (can_be_drawn(p)) svg += labels.place(p.label, {axes(p)}, s->color);
        std::vector<Vec2> points = drawn_points(*s, axes);
        std::reverse(points.begin(), points.end());  // the last one is where an eye that follows the curve ends
        svg += labels.place(s->label, points, s->color);
    }
    return svg;
}

}  // namespace

std::vector<double> log_ticks(double low, double high) {
    const double decades = std::log10(high / low);
    const std::vector<double> steps = decades >= 2.6   ? std::vector<double>{1}
                                      : decades >= 1.3 ? std::vector<double>{1, 3}
                                                       : std::vector<double>{1, 2, 5};
    std::vector<double> ticks;
    for (int decade = static_cast<int>(std::floor(std::log10(low))); decade <= static_cast<int>(std::ceil(std::log10(high)));
         ++decade)
        for (double step : steps)
            if (const double v = step * std::pow(10, decade); v >= low && v <= high) ticks.push_back(v);
    return ticks;
}

std::string log_chart(const LogChart& chart) {
    Axes axes{};
    if (!find_axes(chart, axes)) return "";
    std::string svg = open_svg(half_width, height, chart.title) + grid_lines(chart, axes);
    for (const ChartSeries& s : chart.series) svg += curve(s, axes);
    for (const ChartSeries& s : chart.series) svg += marks(s, axes);
    return svg + labels(chart, axes) + "</svg>\n";
}

std::string series_sign(const ChartSeries& s) {
    return "<svg class=\"sign\" viewBox=\"0 0 26 14\" aria-hidden=\"true\">" + line({1, 7}, {25, 7}, line_style(s)) +
           mark(s, {13, 7}) + "</svg>";
}

}  // namespace abut::report
