// SPDX-License-Identifier: GPL-3.0-or-later
// E14: the beam element of [Grishin10, appendix A] and the condition numbers of its appendix B, with the figures that exact
// rational arithmetic gives. It has no scene: a beam is no part.
#include <algorithm>
#include <cmath>

#include "geometry/curves/gauss.hpp"
#include "solver/beam/beam.hpp"
#include "src/verification/verify_problem.hpp"

namespace abut {

namespace verify_spline_beam {

using namespace solver;

/// Of length and rigidity 1, on cells of its length, clamped where it begins.
Beam cantilever(double begin, double end) {
    const geometry::GaussRule& gauss = geometry::gauss_rule(4);
    Beam beam{uniform_knots(1, 0, 2, 3), begin, end, 1, {}, {gauss.points, gauss.weights}};
    beam.holds[0].end = BeamEnd::clamped;
    return beam;
}

double tip(const Beam& beam, BeamScaling scaling) {
    const BeamLoad load{{}, {{beam.end, -1}}};
    const BeamSolution solution = solve_beam(beam, assemble_beam(beam, load, scaling));
    return solution.failure.empty() ? beam_state(beam, solution, beam.end).deflection : NAN;
}

/// The largest, over 200 shifts from 0.1 to 1e-8 cells; NaN where one of them fails.
double worst_tip() {
    double worst = 0;
    for (int k = 0; k < 200; ++k) {
        const double shift = std::pow(10.0, -1 - 7.0 * k / 199);
        const double error = std::abs(tip(cantilever(1 - shift, 2 - shift), BeamScaling::jacobi) + 1. / 3);
        worst = error <= worst ? worst : error;
    }
    return worst;
}

/// Factors on the outermost functions of appendix B's beam.
ConditionNumbers condition(double first, double last) {
    Eigen::MatrixXd k = assemble_beam(cantilever(0.9, 1.9), {}, BeamScaling::none).stiffness;
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(k.rows());
    scale[0] = first;
    scale[k.rows() - 1] = last;
    return condition_numbers(scale.asDiagonal() * k * scale.asDiagonal());
}

Quantity quantity(std::string what, double (*value)(), double reference, double tolerance) {
    return {std::move(what), [value](const Answers&) { return value(); }, reference, tolerance, reference == 0 ? 1.0 : 0.0};
}

}  // namespace verify_spline_beam

std::vector<VerifyProblem> spline_beam_problems() {
    using namespace verify_spline_beam;
    constexpr double figures = 1e-4, exact = 1e-10;
    return {{"E14-fitting",
             "spline beam element, one cell that fits",
             {},
             {quantity(
                  "condition, 2-norm",
                  [] { return condition_numbers(assemble_beam(cantilever(1, 2), {}, BeamScaling::none).stiffness).two; },
                  441.1667, figures),
              quantity(
                  "tip deflection", [] { return tip(cantilever(1, 2), BeamScaling::none); }, -1. / 3, exact)}},
            {"E14-shifted",
             "spline beam element, shifted by a tenth of its cell and by less",
             {},
             {quantity(
                  "condition, 1-norm", [] { return condition(1, 1).one; }, 4.586001375e9, figures),
              quantity(
                  "condition, 2-norm", [] { return condition(1, 1).two; }, 3.665338161e9, figures),
              quantity(
                  "one function normalized, 1-norm", [] { return condition(6000, 1).one; }, 511.3450, figures),
              quantity(
                  "both normalized, 1-norm", [] { return condition(6000, 8.23).one; }, 8946.77, figures),
              quantity(
                  "tip deflection", [] { return tip(cantilever(0.9, 1.9), BeamScaling::corner); }, -1. / 3, exact),
              quantity("tip deflection, worst of 200 shifts", worst_tip, 0, 1e-8)}}};
}

}  // namespace abut
