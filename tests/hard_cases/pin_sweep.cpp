// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard_cases/pin_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/hard_cases/curve_plot.hpp"

namespace abut::test {

namespace {

constexpr double radius = 1, solved_tolerance = 1e-9;
constexpr double smallest_sliver = 10;  // powers of ten below a cell

Vec2 load_direction(const PinSetup& setup) {
    return {std::sin(setup.load_angle), -std::cos(setup.load_angle)};
}

Vec2 pin_center(const PinSetup& setup) {
    switch (setup.drawn) {
        case Drawn::concentric:
            return {0, 0};
        case Drawn::half_way:
            return 0.5 * setup.clearance * load_direction(setup);
        case Drawn::wrong_side:
            return -setup.clearance * load_direction(setup);
    }
    return {0, 0};
}

/// A line of the grid lies so many cells inside the left and lower extreme points of a circle.
void set_circle_grid(ContactCase& c, int part, const PinSetup& setup, std::size_t which, const Vec2& center, double r) {
    const double angle = setup.grid_angle[which];
    const Vec2 turned = Frame{std::cos(angle), std::sin(angle), {0, 0}}.turned(center);
    set_even_grid(c, part, setup.cell, turned - Vec2::Constant(r) + setup.cell * setup.sliver[which], angle);
}

double fraction_part_of(double v) {
    return v - std::floor(v);
}

/// Angles and slivers of the k-th setup: a sequence in six dimensions without gaps (Roberts 2018).
void place_grids(PinSetup& setup, int k) {
    constexpr double root = 1.1347241384015194;  // of x^7 = x + 1
    std::array<double, 6> u;
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = fraction_part_of(0.5 + k * std::pow(root, -static_cast<double>(i + 1)));
    for (std::size_t part = 0; part < 2; ++part) {
        setup.grid_angle[part] = 0.25 * std::numbers::pi * u[3 * part];
        for (int axis : {0, 1})
            setup.sliver[part][axis] = std::pow(10, -smallest_sliver * u[3 * part + 1 + static_cast<std::size_t>(axis)]);
    }
}

std::string name_of(Drawn drawn) {
    if (drawn == Drawn::concentric) return "concentric";
    return drawn == Drawn::half_way ? "half way" : "wrong side";
}

PinAnswer answer_of(const SolvedAssembly& solved, double load) {
    PinAnswer a{load};
    a.iterations = solved.solution.iterations;
    a.fallback = solved.solution.used_fallback;
    a.residual = solved.solution.residual;
    if (!solved.solution.mechanism.empty()) {
        a.failure = "mechanism";
        return a;
    }
    a.unbalance = unbalance(solved, 2 * radius);
    a.force_error = std::abs(force_on_first(solved, 0).force.norm() / load - 1);
    a.peak = radius * peak_pressure(solved, 0) / load;
    if (!solved.stretches[0].empty()) {
        const PressedStretch &first = solved.stretches[0].front(), &last = solved.stretches[0].back();
        a.half_angle = 90 / std::numbers::pi * (last.end - first.begin) / radius;
    }
    if (!solved.solution.converged) a.failure = "not converged";
    // gaps have the rounding of coordinates, which is measured against a closing of the size of the load (the ring's E is 1)
    const double rounding = std::numeric_limits<double>::epsilon() * radius / load;
    if (a.failure.empty() && !(a.residual < std::max(solved_tolerance, rounding))) a.failure = "residual";
    if (a.failure.empty() && !(a.unbalance < solved_tolerance && a.force_error < solved_tolerance)) a.failure = "unbalanced";
    a.solved = a.failure.empty();
    return a;
}

}  // namespace

ContactCase pin_case(const PinSetup& setup) {
    ContactCase c;
    const Vec2 center = pin_center(setup);
    const double pin_radius = radius - setup.clearance;
    const int plate = add_part(c, ring(radius, setup.outer), 1), pin = add_part(c, disc(center, pin_radius), setup.modulus);
    set_circle_grid(c, plate, setup, 0, {0, 0}, radius);
    set_circle_grid(c, pin, setup, 1, center, pin_radius);
    const geometry::Part& ring_part = c.scene.parts[0].part;
    for (std::size_t e = 0; e < ring_part.edges.size(); ++e)
        if (point(ring_part.edges[e].curve, 0).norm() > 0.5 * (radius + setup.outer)) clamp(c, plate, static_cast<int>(e));
    push(c, pin, load_direction(setup));
    return c;
}

std::vector<PinAnswer> solve_pin(const PinSetup& setup, const std::vector<double>& loads) {
    return solve_pin_case(pin_case(setup), loads);
}

std::vector<PinAnswer> solve_pin_case(const ContactCase& c, const std::vector<double>& loads) {
    std::vector<PinAnswer> answers;
    SolvedAssembly solved;
    try {
        solved = solve_case(c);
    } catch (const InputError& error) {
        for (double load : loads) answers.push_back({load, false, error.what()});
        return answers;
    }
    double now = 1;
    for (double load : loads) {
        if (!solved.failure.empty()) {
            answers.push_back({load, false, solved.failure});
            continue;
        }
        scale_loads(solved, load / now);
        now = load;
        answers.push_back(answer_of(solved, load));
    }
    return answers;
}

std::vector<double> pin_loads() {
    return {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3};
}

std::vector<PinSetup> pin_setups(const std::vector<double>& cells, const std::vector<double>& moduli, int variants) {
    std::vector<PinSetup> setups;
    const auto add = [&](const PinSetup& setup) {
        setups.push_back(setup);
        place_grids(setups.back(), static_cast<int>(setups.size()));
    };
    for (double cell : cells)
        for (double modulus : moduli)
            for (int variant = 0; variant < variants; ++variant) {
                add({cell, 0, modulus});
                for (double clearance : {1e-9, 1e-7, 1e-5, 1e-3, 1e-2})
                    for (Drawn drawn : {Drawn::concentric, Drawn::half_way, Drawn::wrong_side})
                        add({cell, clearance, modulus, drawn});
            }
    return setups;
}

std::vector<PinCase> sweep_pins(const std::vector<PinSetup>& setups) {
    std::vector<PinCase> cases;
    for (const PinSetup& setup : setups)
        for (PinAnswer& answer : solve_pin(setup, pin_loads())) cases.push_back({setup, std::move(answer)});
    return cases;
}

void write_pins(const std::string& name, const std::vector<PinCase>& cases) {
    Table table{{"cell", "clearance", "modulus", "ring_angle", "pin_angle", "load", "solved", "residual", "unbalance",
                 "force_error", "peak", "half_angle", "iterations", "fallback"},
                {},
                {}};
    LogPlot plot{"A pin held by contact alone: clearance E dR / Q from 1e-6 to 1e7 and none",
                 "load Q / (E R)",
                 "residual of the contact conditions (marks); 1e-16 is drawn for less",
                 {-10, -2},
                 {-17, -8},
                 {},
                 3};
    for (const PinCase& c : cases) {
        const PinAnswer& a = c.answer;
        table.labels.push_back(name_of(c.setup.drawn) + (a.solved ? "" : " (" + a.failure + ")"));
        table.rows.push_back({c.setup.cell, c.setup.clearance, c.setup.modulus, c.setup.grid_angle[0], c.setup.grid_angle[1],
                              a.load, a.solved ? 1.0 : 0.0, a.residual, a.unbalance, a.force_error, a.peak, a.half_angle,
                              static_cast<double>(a.iterations), a.fallback ? 1.0 : 0.0});
        const std::string title = "h = R/" + std::to_string(std::lround(radius / c.setup.cell));
        if (plot.panels.empty() || plot.panels.back().title != title)
            plot.panels.push_back({title, {{"a case", "#1348b0", {}, {}, true, true}}, {}});
        plot.panels.back().series[0].points.emplace_back(a.load, std::max(a.residual, 1e-16));
    }
    write_csv(name, table);
    write_plot(name, plot);
}

}  // namespace abut::test
