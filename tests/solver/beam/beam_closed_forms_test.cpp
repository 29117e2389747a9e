// SPDX-License-Identifier: GPL-3.0-or-later
// Beams of every kind of ends on grids that cut them anywhere: closed forms, reciprocity, rates of convergence.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/solver/beam/test_beams.hpp"

namespace abut::solver::beam_closed_forms_test {

using test::cantilever;
using test::force_at;
using test::gauss;

namespace {

constexpr double pi = std::numbers::pi;

constexpr BeamEnd free_end = BeamEnd::free, pinned = BeamEnd::pinned, clamped = BeamEnd::clamped;

/// Deflection under uniform load 1 at length and rigidity 1: coefficients of s^0 to s^4.
struct ClosedForm {
    BeamEnd begin, end;
    std::array<double, 5> c;
};
const std::vector<ClosedForm>& closed_forms() {
    static const std::vector<ClosedForm> all{{clamped, free_end, {0, 0, 6. / 24, -4. / 24, 1. / 24}},
                                             {pinned, pinned, {0, 1. / 24, 0, -2. / 24, 1. / 24}},
                                             {clamped, pinned, {0, 0, 3. / 48, -5. / 48, 2. / 48}},
                                             {clamped, clamped, {0, 0, 1. / 24, -2. / 24, 1. / 24}}};
    return all;
}

BeamState polynomial(const std::array<double, 5>& c, double s) {
    BeamState v{0, 0, 0};
    for (int k = 4; k >= 0; --k) {
        v.curvature = v.curvature * s + 2 * v.slope;
        v.slope = v.slope * s + v.deflection;
        v.deflection = v.deflection * s + c[static_cast<std::size_t>(k)];
    }
    return v;
}

/// Largest difference of deflections, slopes and curvatures, each over its size.
double state_error(const Beam& beam, const BeamSolution& solution, double size, const std::function<BeamState(double)>& exact) {
    const double l = beam.end - beam.begin;
    double worst = 0;
    for (double s : {0.0, 1e-7, 0.2, 0.5, 0.77, 1.0}) {
        const BeamState v = beam_state(beam, solution, s < 1 ? beam.begin + s * l : beam.end), e = exact(s);
        worst =
            std::max({worst, std::abs(v.deflection - size * e.deflection) / size, std::abs(v.slope * l - size * e.slope) / size,
                      std::abs(v.curvature * l * l - size * e.curvature) / size});
    }
    return worst;
}

/// The closed form, or its mirror image, on a beam under p.
double uniform_load_error(Beam beam, const ClosedForm& form, bool mirrored, double p) {
    beam.holds[mirrored ? 1 : 0].end = form.begin;
    beam.holds[mirrored ? 0 : 1].end = form.end;
    BeamLoad load;
    load.per_length = [p](double) { return p; };
    const BeamSolution solution = solve_beam(beam, assemble_beam(beam, load));
    EXPECT_EQ(solution.failure, "");
    if (!solution.failure.empty()) return std::numeric_limits<double>::infinity();
    const double size = p * std::pow(beam.end - beam.begin, 4) / beam.rigidity;
    return state_error(beam, solution, size, [&](double s) {
        BeamState v = polynomial(form.c, mirrored ? 1 - s : s);
        if (mirrored) v.slope = -v.slope;
        return v;
    });
}

struct Random {
    std::mt19937 engine{5};
    double number(double a, double b) { return a + (b - a) * (static_cast<double>(engine()) + 0.5) * 0x1p-32; }
    int integer(int a, int b) { return a + static_cast<int>(number(0, b - a + 1)); }
};

/// Uniform or graded, unclamped or clamped, with double knots; from -0.7 to 1.6, the beam somewhere in it. Half of them begin
/// or end just beside a grid line.
Beam random_beam_of_any_length(Random& random) {
    const int p = random.integer(2, 6), cells = random.integer(1, 12);
    const bool is_uniform = random.integer(0, 1) == 0;
    std::vector<double> lines = test::grid_lines(-0.7, 1.6, cells, is_uniform);
    Beam beam = cantilever(random.number(-0.7, 0.2), clamped_knots(lines, p));
    if (p > 2) {
        std::vector<int> multiplicity(lines.size(), 1);
        multiplicity[lines.size() / 2] = 2;
        beam.knots = clamped_knots(lines, p, multiplicity);
    }
    if (is_uniform) beam.knots = uniform_knots(0.23, -4, 12, p);
    lines = beam.knots.breakpoints;
    beam.end = random.number(0.4, 1.6);
    for (double* end : {&beam.begin, &beam.end}) {
        const double line = lines[static_cast<std::size_t>(interval_of(beam.knots, *end))];
        if (random.integer(0, 1) == 0) *end = line + std::pow(10.0, random.number(-12, -2));
    }
    return beam;
}

/// Of the cells that the beam meets.
double largest_cell(const Beam& beam) {
    double largest = 0;
    const std::vector<double>& lines = beam.knots.breakpoints;
    for (std::size_t k = 0; k + 1 < lines.size(); ++k)
        if (lines[k] < beam.end && lines[k + 1] > beam.begin) largest = std::max(largest, lines[k + 1] - lines[k]);
    return largest;
}

/// At least as long as its largest cell.
Beam random_beam(Random& random) {
    for (;;) {
        const Beam beam = random_beam_of_any_length(random);
        if (beam.end - beam.begin >= largest_cell(beam)) return beam;
    }
}

/// Rounding times the condition number of the scaled stiffness, at most 2e6 (degree 6); measured over 10 000 beams: 3e-11.
constexpr double closed_form_bound = 1e-9;

void expect_closed_forms(int n_beams) {
    Random random;
    for (int k = 0; k < n_beams; ++k) {
        Beam beam = random_beam(random);
        beam.rigidity = std::pow(10.0, random.number(-3, 12));
        for (const ClosedForm& form : closed_forms())
            for (bool mirrored : {false, true})
                ASSERT_LT(uniform_load_error(beam, form, mirrored, 3), closed_form_bound)
                    << "beam " << k << ", degree " << beam.knots.degree << ", from " << beam.begin << " to " << beam.end;
    }
}

}  // namespace

TEST(Beam, ClosedFormsOnGridsThatCutItAnywhere) {
    expect_closed_forms(150);
}

TEST(LongBeam, ClosedFormsOnGridsThatCutItAnywhere) {
    expect_closed_forms(10000);
}

TEST(Beam, MuchShorterThanItsCellIsAsGoodAsTheConditionNumberOrRefused) {
    Random random;
    int n_refused = 0;
    for (int k = 0; k < 300; ++k) {
        Beam beam = cantilever(0, uniform_knots(1, 0, 2, 2 + k % 5));
        beam.begin = random.number(0, 1);
        beam.end = beam.begin + std::pow(10.0, random.number(-4, 0));
        beam.holds[1].end = pinned;
        const BeamSystem system = assemble_beam(beam, {});
        const BeamSolution solution = solve_beam(beam, system);
        const double condition = condition_numbers(system.stiffness).two;
        EXPECT_EQ(solution.failure.empty(), std::isfinite(condition));
        if (solution.failure.empty()) {
            EXPECT_LT(uniform_load_error(beam, closed_forms()[2], false, 3),
                      50 * std::numeric_limits<double>::epsilon() * condition);
        } else {
            ++n_refused;
            EXPECT_NE(solution.failure.find("shorter than a cell"), std::string::npos);
        }
    }
    EXPECT_GT(n_refused, 10);
    EXPECT_LT(n_refused, 200);
}

TEST(Beam, ClosedFormsOfOtherEndsDoNotFit) {
    Random random;
    const Beam beam = random_beam(random);
    ClosedForm form = closed_forms()[2];
    form.c[3] *= 1 + 1e-6;
    EXPECT_GT(uniform_load_error(beam, form, false, 3), closed_form_bound);
    form = closed_forms()[3];
    form.end = pinned;
    EXPECT_GT(uniform_load_error(beam, form, false, 3), closed_form_bound);
}

TEST(Beam, TakesPrescribedDeflectionsAndSlopes) {
    Random random;
    for (int k = 0; k < 100; ++k) {
        Beam beam = random_beam(random);
        const double l = beam.end - beam.begin;
        const double v = random.number(-1, 1), g = random.number(-1, 1), w = random.number(-1, 1), h = random.number(-1, 1);
        const auto error = [&](BeamEnd begin, BeamEnd end, const std::array<double, 5>& c) {
            beam.holds = {BeamHold{begin, v, g / l}, BeamHold{end, w, h / l}};
            const BeamSolution solution = solve_beam(beam, assemble_beam(beam, {}));
            EXPECT_EQ(solution.failure, "");
            return state_error(beam, solution, 1, [&](double s) { return polynomial(c, s); });
        };
        EXPECT_LT(error(clamped, free_end, {v, g}), closed_form_bound);
        EXPECT_LT(error(free_end, clamped, {w - h, h}), closed_form_bound);
        EXPECT_LT(error(pinned, pinned, {v, w - v}), closed_form_bound);
        const double d = w - v - g;
        EXPECT_LT(error(clamped, pinned, {v, g, 1.5 * d, -0.5 * d}), closed_form_bound);
        EXPECT_LT(error(clamped, clamped, {v, g, 3 * d - (h - g), (h - g) - 2 * d}), closed_form_bound);
        EXPECT_GT(error(clamped, clamped, {v, g, 3 * d - (h - g), (h - g) - 2.001 * d}), closed_form_bound);
    }
}

TEST(Beam, EndMomentBendsItToAParabola) {
    Random random;
    for (int k = 0; k < 50; ++k) {
        Beam beam = random_beam(random);
        beam.rigidity = 7;
        const double l = beam.end - beam.begin;
        const BeamSolution solution = solve_beam(beam, assemble_beam(beam, {{}, {{beam.end, 0, 2}}}));
        EXPECT_LT(state_error(beam, solution, 2 * l * l / 7,
                              [](double s) {
                                  return BeamState{s * s / 2, s, 1};
                              }),
                  closed_form_bound);
    }
}

TEST(Beam, ForcesAndMomentsAreReciprocal) {
    // Maxwell: of the discrete solution, too; a force does work on the deflection, a moment on the slope
    Random random;
    for (int k = 0; k < 50; ++k) {
        Beam beam = random_beam(random);
        beam.holds = {BeamHold{clamped}, BeamHold{pinned}};
        const double a = random.number(beam.begin, beam.end), b = random.number(beam.begin, beam.end);
        const BeamSolution force = solve_beam(beam, assemble_beam(beam, force_at(a, 1)));
        const BeamSolution moment = solve_beam(beam, assemble_beam(beam, {{}, {{b, 0, 1}}}));
        EXPECT_NEAR(beam_state(beam, force, b).slope, beam_state(beam, moment, a).deflection, 1e-11);
        EXPECT_GT(beam_state(beam, force, a).deflection, 0);
    }
}

namespace {

struct Errors {
    double deflection = 0, curvature = 0;
};

/// L2 errors for v = sin(pi x), supported at both ends, on a grid that does not fit.
Errors sine_errors(int degree, int n_cells) {
    const double h = 1.0 / n_cells, begin = (n_cells + 0.37) * h;
    Beam beam = cantilever(begin, uniform_knots(h, n_cells, n_cells + 1, degree));
    beam.rule = gauss(degree + 5);  // the sine too
    beam.holds = {BeamHold{pinned}, BeamHold{pinned}};
    BeamLoad load;
    load.per_length = [begin](double x) { return std::pow(pi, 4) * std::sin(pi * (x - begin)); };
    const BeamSolution solution = solve_beam(beam, assemble_beam(beam, load));
    EXPECT_EQ(solution.failure, "");
    const LineRule rule = gauss(100);
    Errors e;
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
        const BeamState v = beam_state(beam, solution, begin + rule.points[q]);
        const double exact = std::sin(pi * rule.points[q]);
        e.deflection += rule.weights[q] * std::pow(v.deflection - exact, 2);
        e.curvature += rule.weights[q] * std::pow(v.curvature + pi * pi * exact, 2);
    }
    return {std::sqrt(e.deflection), std::sqrt(e.curvature)};
}

}  // namespace

TEST(Beam, ConvergesAtTheRatesOfItsDegree) {
    for (int degree = 2; degree <= 5; ++degree) {
        const Errors coarse = sine_errors(degree, 8), fine = sine_errors(degree, 16);
        // fourth order: curvature h^(p-1), deflection twice that at most
        EXPECT_NEAR(std::log2(coarse.curvature / fine.curvature), degree - 1, 0.3) << "degree " << degree;
        EXPECT_NEAR(std::log2(coarse.deflection / fine.deflection), std::min(degree + 1, 2 * (degree - 1)), 0.4)
            << "degree " << degree;
    }
}

}  // namespace abut::solver::beam_closed_forms_test
