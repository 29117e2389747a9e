// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure and gap of a contact against arc length.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "src/io/number_text.hpp"
#include "src/report/report_labels.hpp"
#include "src/report/report_marks.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_svg.hpp"
#include "src/results/result_units.hpp"

namespace abut::report {

namespace {

constexpr double jump_tolerance = 0.1;  ///< relative difference of arc length and chord between neighbours: more is a jump of s

/// Where the profile's points are drawn along the abscissa, ascending.
struct Abscissa {
    std::vector<double> s;
    std::vector<std::size_t> order;  ///< of the points by s
    std::string name;
};

double chord(const ContactProfile& p, std::size_t i) {
    return std::hypot(p.x[i + 1] - p.x[i], p.y[i + 1] - p.y[i]);
}

/// Arc length of the edge if the profile stays on one edge and does not pass its beginning.
bool one_edge(const ContactProfile& p) {
    for (std::size_t i = 0; i + 1 < p.s.size(); ++i) {
        const double step = std::abs(p.s[i + 1] - p.s[i]);
        if (p.edge[i + 1] != p.edge[i] || std::abs(step - chord(p, i)) > jump_tolerance * std::max(step, chord(p, i)))
            return false;
    }
    return true;
}

Abscissa abscissa(const ContactProfile& p) {
    Abscissa a;
    if (one_edge(p)) {
        a.s = p.s;
        a.name = "arc length along " + (p.edge.empty() ? std::string("the edge") : p.edge[0]);
    } else {
        a.s.push_back(0);
        for (std::size_t i = 0; i + 1 < p.x.size(); ++i) a.s.push_back(a.s.back() + chord(p, i));
        a.name = "arc length along the contact";
    }
    a.order.resize(a.s.size());
    std::iota(a.order.begin(), a.order.end(), std::size_t{0});
    std::stable_sort(a.order.begin(), a.order.end(), [&](std::size_t i, std::size_t j) { return a.s[i] < a.s[j]; });
    return a;
}

/// Abscissa of a point of the plane: that of the nearest point of the profile's polyline.
double project(const ContactProfile& p, const Abscissa& a, const Vec2& at) {
    double best = a.s[0], nearest = (Vec2(p.x[0], p.y[0]) - at).norm();
    for (std::size_t i = 0; i + 1 < p.x.size(); ++i) {
        const Vec2 from(p.x[i], p.y[i]), along = Vec2(p.x[i + 1], p.y[i + 1]) - from;
        if (along.squaredNorm() == 0) continue;
        const double t = std::clamp((at - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const double distance = (from + t * along - at).norm();
        if (distance >= nearest) continue;
        nearest = distance;
        best = a.s[i] + t * (a.s[i + 1] - a.s[i]);
    }
    return best;
}

/// A rectangle of the picture with its two scales.
struct Panel {
    double left, right, top, bottom;
    double s0, s1, v0, v1;
    Vec2 operator()(double s, double v) const {
        return {left + (right - left) * (s - s0) / (s1 - s0), bottom - (bottom - top) * (v - v0) / (v1 - v0)};
    }
};

std::string value_axis(const Panel& panel, int n, const std::string& title) {
    std::string svg = "<g class=\"axes\">\n";
    const std::vector<double> ticks = nice_ticks(panel.v0, panel.v1, n);
    const double step = ticks[1] - ticks[0];
    for (double v : ticks) {
        if (v < panel.v0 - 1e-6 * step || v > panel.v1 + 1e-6 * step) continue;
        const Vec2 at = panel(panel.s0, v);
        svg += line(at, {panel.right, at.y()}, "class=\"grid\"") + line(at - Vec2(4, 0), at, "") +
               text(at + Vec2(-7, 4), "end", number_text(v, 5));
    }
    svg += line({panel.left, panel.top}, {panel.left, panel.bottom}, "");
    return svg + "</g>\n" + text({panel.left - 46, panel.top - 9}, "start", title, "class=\"axis-title\"");
}

std::string arc_axis(const Panel& panel, const std::string& title) {
    std::string svg = "<g class=\"axes\">\n" + line({panel.left, panel.bottom}, {panel.right, panel.bottom}, "");
    const std::vector<double> ticks = nice_ticks(panel.s0, panel.s1, 6);
    const double slack = 1e-9 * (panel.s1 - panel.s0);
    for (double s : ticks) {
        if (s < panel.s0 - slack || s > panel.s1 + slack) continue;
        const double x = panel(s, panel.v0).x();
        svg += line({x, panel.bottom}, {x, panel.bottom + 4}, "") + text({x, panel.bottom + 16}, "middle", number_text(s, 6));
    }
    return svg + "</g>\n" + text({(panel.left + panel.right) / 2, panel.bottom + 34}, "middle", title, "class=\"axis-title\"");
}

/// The ends of the contact across a panel.
std::string end_lines(const Panel& panel, const std::vector<double>& ends) {
    std::string svg;
    for (double s : ends) {
        const double x = panel(s, panel.v0).x();
        svg += line({x, panel.top}, {x, panel.bottom}, "stroke=\"#555\" stroke-width=\"0.9\" stroke-dasharray=\"3 3\"");
    }
    return svg;
}

std::vector<Vec2> curve(const Panel& panel, const Abscissa& a, const std::vector<double>& values) {
    std::vector<Vec2> points;
    for (std::size_t i : a.order)
        if (std::isfinite(values[i])) points.push_back(panel(a.s[i], values[i]));
    return points;
}

/// Pressure plus and minus the estimated error, where there is pressure.
std::string error_band(const Panel& panel, const Abscissa& a, const std::vector<double>& pressure, double error) {
    std::vector<Vec2> upper, lower;
    for (std::size_t i : a.order) {
        const double e = pressure[i] > 0 ? error : 0;
        upper.push_back(panel(a.s[i], pressure[i] + e));
        lower.push_back(panel(a.s[i], std::max(pressure[i] - e, 0.0)));
    }
    upper.insert(upper.end(), lower.rbegin(), lower.rend());
    return polygon(upper, "fill=\"" + std::string(contact_color) + "\" fill-opacity=\"0.22\"");
}

std::string maximum_mark(const Panel& panel, const ContactResult& c, const Abscissa& a, const std::string& unit) {
    const auto largest = std::max_element(c.profile.pressure.begin(), c.profile.pressure.end());
    if (!(*largest > 0)) return "";
    const auto i = static_cast<std::size_t>(largest - c.profile.pressure.begin());
    const Vec2 at = panel(a.s[i], *largest);
    const std::string words = "max " + with_unit(c.max_pressure.value, 4, unit);
    const bool right = at.x() + 8 + text_pixels(words, 12) < panel.right;
    return circle(at, 3.5, "fill=\"" + std::string(contact_color) + "\"") +
           text(at + Vec2(right ? 7 : -7, -6), right ? "start" : "end", words, "class=\"mark halo\"");
}

/// Limits that leave a little room, and that are never empty.
std::pair<double, double> limits(double low, double high, double room) {
    if (!(high > low)) return low == 0 ? std::pair(0.0, 1.0) : std::pair(low - 0.5 * std::abs(low), low + 0.5 * std::abs(low));
    return {low, high + room * (high - low)};
}

std::string end_texts(const Panel& panel, const std::vector<double>& ends) {
    std::string svg;
    double free_from = panel.left - 40;
    for (double s : ends) {
        const std::string words = number_text(s, 4);
        const double width = text_pixels(words, 11), x = panel(s, panel.v0).x();
        if (x - width / 2 < free_from) continue;  // two ends that coincide in the picture share a label
        svg += text({x, panel.top - 4}, "middle", words, "class=\"note halo\"");
        free_from = x + width / 2 + 4;
    }
    return svg;
}

}  // namespace

std::string contact_curves(const Result& result, std::size_t contact) {
    const ContactResult& c = result.contacts[contact];
    if (c.profile.s.size() < 2) return "";
    const ResultUnits units = result_units(result);
    const Abscissa a = abscissa(c.profile);
    const double error = c.error_estimate ? *c.error_estimate * c.max_pressure.value : 0;
    const double peak = *std::max_element(c.profile.pressure.begin(), c.profile.pressure.end());
    const auto [gap_low, gap_high] = std::minmax_element(c.profile.gap.begin(), c.profile.gap.end());
    const auto [s0, s1] = limits(a.s[a.order.front()], a.s[a.order.back()], 0);
    const auto [p0, p1] =
        limits(std::min(0.0, *std::min_element(c.profile.pressure.begin(), c.profile.pressure.end())), peak + error, 0.12);
    const auto [g0, g1] = limits(std::min(*gap_low, 0.0), *gap_high, 0.08);
    const Panel pressure{70, half_width - 16, 38, 240, s0, s1, p0, p1};
    const Panel gap{70, half_width - 16, 286, 380, s0, s1, g0, g1};
    std::vector<double> ends;
    for (const Vec2& end : c.ends) ends.push_back(project(c.profile, a, end));
    std::sort(ends.begin(), ends.end());

    const std::string number = contact_number(contact);
    std::string svg = open_svg(half_width, 422, "pressure and gap of contact " + number);
    svg += value_axis(pressure, 5, heading("pressure", units.stress)) + value_axis(gap, 4, heading("gap", units.length));
    svg += end_lines(pressure, ends) + end_lines(gap, ends) + end_texts(gap, ends);
    if (error > 0) svg += error_band(pressure, a, c.profile.pressure, error);
    svg += polyline(curve(pressure, a, c.profile.pressure), "fill=\"none\" stroke=\"" + std::string(contact_color) +
                                                                "\" stroke-width=\"1.8\" stroke-linejoin=\"round\"");
    svg += polyline(curve(gap, a, c.profile.gap),
                    "fill=\"none\" stroke=\"#1348b0\" stroke-width=\"1.6\" stroke-linejoin=\"round\"");
    svg += line({pressure.left, pressure.bottom}, {pressure.right, pressure.bottom}, "stroke=\"#555\" stroke-width=\"0.8\"");
    svg += maximum_mark(pressure, c, a, units.stress) + arc_axis(gap, heading(a.name, units.length)) + "</svg>\n";

    std::string caption = "Pressure and gap";
    if (!ends.empty()) caption += "; dashed: ends of the contact";
    if (error > 0) caption += "; band: estimated error, " + number_text(100 * *c.error_estimate, 2) + " % of the maximum";
    return figure(svg, caption, half_width);
}

}  // namespace abut::report
