// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard_cases/sliver_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "src/io/number_text.hpp"
#include "tests/hard_cases/curve_plot.hpp"

namespace abut::test {

namespace {

constexpr double smallest_distance = 13;  // powers of ten below a cell

double fraction_of(double v) {
    return v - std::floor(v);
}

/// Coordinates at which a line that moves starts or ends to touch the part or one of its vertices.
std::vector<double> events(const geometry::Part& part, int axis) {
    std::vector<double> at;
    for (const geometry::Edge& e : part.edges) {
        at.push_back(point(e.curve, 0)[axis]);
        for (double t : axis_extrema(e.curve)) at.push_back(point(e.curve, t)[axis]);
    }
    std::sort(at.begin(), at.end());
    const double merge = geometry::merge_length(part);
    at.erase(std::unique(at.begin(), at.end(), [&](double a, double b) { return b - a < merge; }), at.end());
    return at;
}

/// Near an event, the k-th of n: from both sides in turn.
double near(const std::vector<double>& events, double h, int k, int n) {
    const double u = (k + 0.5) / n, side = k % 2 ? 1 : -1;
    return events[static_cast<std::size_t>(k / 2) % events.size()] + side * h * std::pow(10.0, -smallest_distance * u);
}

}  // namespace

std::vector<Vec2> sweep_offsets(const geometry::Part& part, double h, int n) {
    const std::vector<double> ex = events(part, 0), ey = events(part, 1);
    std::vector<Vec2> offsets;
    for (int k = 0; k < n; ++k) {
        // a sequence of two coordinates without gaps (Roberts 2018): powers of the plastic number
        Vec2 offset(h * fraction_of(0.5 + k * 0.7548776662466927), h * fraction_of(0.5 + k * 0.5698402909980532));
        const int kind = k % 4, quarter = std::max(1, n / 4);
        if (kind == 1 || kind == 3) offset.x() = near(ex, h, k / 4, quarter);
        if (kind == 2 || kind == 3) offset.y() = near(ey, h, k / 4, quarter);
        offsets.push_back(offset);
    }
    return offsets;
}

PartProblem sweep_problem(const SweptShape& shape, int degree, solver::Basis basis, Hold hold) {
    PartProblem p;
    p.part = shape.part;
    p.degree = degree;
    p.basis = basis;
    p.exact = plane_waves(elasticity_of(p), {{{1, 0.4}, {2.3, 1.1}, 0.4}, {{-0.5, 0.8}, {-1.2, 2.6}, 1.1}});
    p.hold = hold;
    p.held = {{shape.held, 0}, {shape.held, 1}};
    return p;
}

int SweepCurve::failures() const {
    return static_cast<int>(
        std::count_if(answers.begin(), answers.end(), [](const PartAnswer& a) { return !a.failure.empty(); }));
}

double SweepCurve::smallest_fraction() const {
    double smallest = 1;
    for (const PartAnswer& a : answers) smallest = std::min(smallest, a.smallest_fraction);
    return smallest;
}

double SweepCurve::median(double PartAnswer::*value) const {
    return median_within(*this, value, 0, 2);
}

double SweepCurve::worst_ratio(double PartAnswer::*value) const {
    double worst = 0;
    for (const PartAnswer& a : answers)
        if (a.failure.empty()) worst = std::max(worst, a.*value);
    return worst / median(value);
}

double median_within(const SweepCurve& curve, double PartAnswer::*value, double low, double high) {
    std::vector<double> values;
    for (const PartAnswer& a : curve.answers)
        if (a.failure.empty() && a.smallest_fraction >= low && a.smallest_fraction < high) values.push_back(a.*value);
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

SweepCurve sweep(const SweptShape& shape, int degree, solver::Basis basis, Hold hold, int n) {
    SweepCurve curve{sweep_offsets(shape.part, sweep_cell, n), {}};
    const PartProblem problem = sweep_problem(shape, degree, basis, hold);
    for (const Vec2& offset : curve.offsets)
        curve.answers.push_back(solve_part(problem, even_grid(problem, sweep_cell, offset)));
    return curve;
}

namespace {

/// Median and range of a value by the smallest fraction, two bins a decade.
PlotSeries binned(const SweepCurve& curve, double PartAnswer::*value, const std::string& name, const std::string& color,
                  bool with_band) {
    PlotSeries series{name, color, {}, {}, false, false};
    for (int k = -26; k < 0; ++k) {
        const double low = std::pow(10.0, 0.5 * k), high = std::pow(10.0, 0.5 * (k + 1));
        const double middle = median_within(curve, value, low, high);
        if (!(middle > 0)) continue;
        Vec2 range(middle, middle);
        for (const PartAnswer& a : curve.answers)
            if (a.failure.empty() && a.smallest_fraction >= low && a.smallest_fraction < high)
                range = {std::min(range.x(), a.*value), std::max(range.y(), a.*value)};
        series.points.emplace_back(std::sqrt(low * high), middle);
        if (with_band) series.band.push_back(range);
    }
    return series;
}

PlotPanel panel_of(const std::vector<NamedCurve>& curves, int degree) {
    PlotPanel panel{"degree " + std::to_string(degree), {}, {"not factorised:", "not factorised with weights:"}};
    for (const NamedCurve& c : curves) {
        if (c.degree != degree || (c.hold != Hold::nitsche && c.hold != Hold::dissertation)) continue;
        if (c.hold == Hold::dissertation)
            panel.series.push_back(
                binned(c.curve, &PartAnswer::unscaled_condition, "normalized, held by weights", "#2a8f4f", true));
        else if (c.basis == solver::Basis::web)
            panel.series.push_back(binned(c.curve, &PartAnswer::condition, "extended (web), scaled", "#1348b0", true));
        else if (c.basis == solver::Basis::normalized)
            panel.series.push_back(binned(c.curve, &PartAnswer::unscaled_condition, "normalized", "#d98200", true));
        else {
            panel.series.push_back(binned(c.curve, &PartAnswer::unscaled_condition, "plain", "#d3102b", true));
            panel.series.push_back(binned(c.curve, &PartAnswer::condition, "plain or normalized, scaled", "#777777", false));
        }
        const double share = static_cast<double>(c.curve.failures()) / static_cast<double>(c.curve.answers.size());
        std::string& note = panel.notes[c.hold == Hold::dissertation ? 1 : 0];
        note += (note.back() == ':' ? " " : ", ") + test::name_of(c.basis) + " " + number_text(100 * share, 2) + " %";
    }
    std::erase_if(panel.notes, [](const std::string& note) { return note.back() == ':'; });
    return panel;
}

}  // namespace

void write_sweep(const SweptShape& shape, const std::vector<NamedCurve>& curves) {
    std::string name = "sliver_sweep_" + shape.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    Table table{{"degree", "offset_x", "offset_y", "smallest_fraction", "factorised", "condition", "unscaled_condition",
                 "displacement_l2", "energy", "largest_displacement", "largest_stress", "largest_raw_stress"},
                {},
                {}};
    LogPlot plot{"Condition number as the grid moves through the part: " + shape.name + ", held by Nitsche's method",
                 "smallest filled fraction of a cut cell",
                 "condition number",
                 {-13, 0},
                 {0, 20},
                 {},
                 2};
    for (const NamedCurve& c : curves)
        for (std::size_t k = 0; k < c.curve.answers.size(); ++k) {
            const PartAnswer& a = c.curve.answers[k];
            table.labels.push_back(test::name_of(c.basis) + " " + name_of(c.hold));
            table.rows.push_back({static_cast<double>(c.degree), c.curve.offsets[k].x(), c.curve.offsets[k].y(),
                                  a.smallest_fraction, a.failure.empty() ? 1.0 : 0.0, a.condition, a.unscaled_condition,
                                  a.displacement, a.energy, a.largest_displacement, a.largest_stress, a.largest_raw_stress});
        }
    for (int degree = 1; degree <= 4; ++degree) plot.panels.push_back(panel_of(curves, degree));
    write_csv(name, table);
    write_plot(name, plot);
}

}  // namespace abut::test
