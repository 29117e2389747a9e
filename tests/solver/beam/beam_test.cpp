// SPDX-License-Identifier: GPL-3.0-or-later
// Beams on weighted B-splines: the matrices and condition numbers of [Grishin10, appendices A and B] (with the corrections that
// exact rational arithmetic shows), and the same beam on grids that cut it anywhere.
#include "solver/beam/beam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/solver/beam/test_beams.hpp"

namespace abut::solver::beam_test {
namespace {

using test::cantilever;
using test::force_at;
using test::gauss;
using test::Index;
using test::MatrixXd;
using test::tip_force;
using test::VectorXd;

Beam appendix_a() {
    return cantilever(1, uniform_knots(1, 1, 1, 3));
}
Beam appendix_b() {
    Beam beam = cantilever(0.9, uniform_knots(1, 0, 2, 3));
    beam.end = 1.9;
    return beam;
}

/// Largest difference relative to the entries' own rows and columns.
double difference(const MatrixXd& a, const MatrixXd& b) {
    double worst = 0;
    for (Index i = 0; i < b.rows(); ++i)
        for (Index j = 0; j < b.cols(); ++j)
            worst = std::max(worst, std::abs(a(i, j) - b(i, j)) / std::sqrt(b(i, i) * b(j, j)));
    return worst;
}

MatrixXd scaled(const MatrixXd& k, const VectorXd& scale) {
    return scale.asDiagonal() * k * scale.asDiagonal();
}

void expect_condition(const MatrixXd& k, double one, double two, double frobenius) {
    const ConditionNumbers c = condition_numbers(k);
    EXPECT_NEAR(c.one, one, 1e-4 * one);
    EXPECT_NEAR(c.two, two, 1e-4 * two);
    EXPECT_NEAR(c.frobenius, frobenius, 1e-4 * frobenius);
}

/// Exact, of appendix B's beam.
MatrixXd shifted_stiffness() {
    MatrixXd k(5, 5);
    k << 1 / 4.2e9, 1 / 1.3125e8, -67 / 4.2e9, 17 / 2.1e9, 0,                                     //
        1 / 1.3125e8, 28802017 / 6.3e9, 12919951 / 6.3e9, -19488229 / 1.26e9, 4557681 / 7e8,      //
        -67 / 4.2e9, 12919951 / 6.3e9, 343583813 / 1.26e9, -140016083 / 9e8, -266694741 / 1.4e9,  //
        17 / 2.1e9, -19488229 / 1.26e9, -140016083 / 9e8, 4212163393 / 6.3e9, 88238349 / 3.5e8,   //
        0, 4557681 / 7e8, -266694741 / 1.4e9, 88238349 / 3.5e8, 358225983 / 1.4e9;
    return k;
}

}  // namespace

TEST(BeamAppendixA, StiffnessAndLoadAreExact) {
    const BeamSystem system = assemble_beam(appendix_a(), tip_force(appendix_a()), BeamScaling::none);
    ASSERT_EQ(system.failure, "");
    MatrixXd k(4, 4);
    k << 1. / 420, 1. / 840, -1. / 105, 1. / 168,          //
        1. / 840, 68. / 315, -257. / 2520, -25. / 126,     //
        -1. / 105, -257. / 2520, 713. / 1260, 107. / 504,  //
        1. / 168, -25. / 126, 107. / 504, 25. / 63;
    EXPECT_LT(difference(system.stiffness, k), 1e-12);
    EXPECT_LT((system.load + Eigen::Vector4d(0, 1. / 12, 1. / 3, 1. / 12)).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_NEAR(condition_numbers(system.stiffness).two, 441.1667, 1e-4 * 441.1667);
    MatrixXd wrong = k;
    wrong(1, 2) *= 1 + 1e-10;
    EXPECT_GT(difference(system.stiffness, wrong), 1e-12) << "the comparison sees a relative 1e-10";
}

TEST(BeamAppendixA, SolutionIsTheCubic) {
    const Beam beam = appendix_a();
    for (BeamScaling scaling : {BeamScaling::none, BeamScaling::corner, BeamScaling::jacobi}) {
        const BeamSolution solution = solve_beam(beam, assemble_beam(beam, tip_force(beam), scaling));
        ASSERT_EQ(solution.failure, "");
        EXPECT_LT((solution.coefficient - Eigen::Vector4d(-4. / 3, -1, -2. / 3, -1. / 3)).cwiseAbs().maxCoeff(), 1e-10);
        for (double x : {1.0, 1.1, 1.5, 1.93, 2.0}) {
            const BeamState v = beam_state(beam, solution, x);
            EXPECT_NEAR(v.deflection, x * x * x / 6 - x * x + 1.5 * x - 2. / 3, 1e-10);
            EXPECT_NEAR(v.slope, x * x / 2 - 2 * x + 1.5, 1e-10);
            EXPECT_NEAR(v.curvature, x - 2, 1e-10);
        }
        EXPECT_NEAR(beam_state(beam, solution, 2).deflection, -1. / 3, 1e-10);
    }
}

TEST(BeamAppendixA, NoFunctionIsNormalizedWhereNoCellIsCut) {
    EXPECT_EQ(assemble_beam(appendix_a(), {}, BeamScaling::corner).scale, VectorXd::Ones(4));
}

TEST(BeamAppendixB, StiffnessIsExact) {
    const BeamSystem system = assemble_beam(appendix_b(), {}, BeamScaling::none);
    EXPECT_LT(difference(system.stiffness, shifted_stiffness()), 1e-12);
}

TEST(BeamAppendixB, ConditionNumbersAreThoseOfThePrint) {
    // the print's 4.586e9 and 511.35: 1-norm, and only the left function normalized
    const BeamSystem system = assemble_beam(appendix_b(), {}, BeamScaling::none);
    expect_condition(system.stiffness, 4.586001375e9, 3.665338161e9, 3.8397e9);
    VectorXd left = VectorXd::Ones(5);
    left[0] = 6000;
    const ConditionNumbers one = condition_numbers(scaled(system.stiffness, left));
    EXPECT_NEAR(one.one, 511.3450, 1e-4 * 511.3450);
    EXPECT_NEAR(one.two, 332.3545, 1e-4 * 332.3545);
    // both, with the print's rounded 8.23: worse
    left[4] = 8.23;
    const ConditionNumbers both = condition_numbers(scaled(system.stiffness, left));
    EXPECT_NEAR(both.one, 8946.77, 1e-4 * 8946.77);
    EXPECT_NEAR(both.two, 6633.97, 1e-4 * 6633.97);
    EXPECT_LT(condition_numbers(assemble_beam(appendix_b(), {}, BeamScaling::jacobi).stiffness).one, one.one / 5);
}

TEST(BeamAppendixB, CornerScalingDividesByTheLargestValues) {
    const VectorXd scale = assemble_beam(appendix_b(), {}, BeamScaling::corner).scale;
    VectorXd expected(5);
    expected << 6000, 1, 1, 1, 1 / 0.1215;
    EXPECT_LT((scale - expected).cwiseQuotient(expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(BeamAppendixB, SolutionIsTheSameCubic) {
    const Beam beam = appendix_b();
    VectorXd expected(5);
    expected << -49. / 30, -13. / 10, -29. / 30, -19. / 30, -3. / 10;
    for (BeamScaling scaling : {BeamScaling::none, BeamScaling::corner, BeamScaling::jacobi}) {
        const BeamSystem system = assemble_beam(beam, tip_force(beam), scaling);
        const BeamSolution solution = solve_beam(beam, system);
        EXPECT_LT((solution.coefficient - expected).cwiseAbs().maxCoeff(), 1e-10);
        EXPECT_NEAR(beam_state(beam, solution, beam.end).deflection, -1. / 3, 1e-10);
        const double normalized = -49. / 30 / system.scale[0];
        EXPECT_NEAR(solution.coefficient[0] / system.scale[0], normalized, 1e-10 * std::abs(normalized));
        if (scaling != BeamScaling::corner) continue;
        EXPECT_NEAR(solution.coefficient[0] / system.scale[0], -49. / 180000, 1e-14);
    }
}

namespace {

/// The cantilever on n cells of its own length / n whose lines lie `shift` cells from where they would fit.
Beam shifted(int degree, int n_cells, double shift) {
    const double h = 1.0 / n_cells;
    Beam beam = cantilever((n_cells - shift) * h, uniform_knots(h, n_cells - 1, n_cells + 2, degree));
    return beam;
}

/// 200 shifts from 1e-1 to 1e-8.
std::vector<double> shifts() {
    std::vector<double> list;
    for (int k = 0; k < 200; ++k) list.push_back(std::pow(10.0, -1 - 7.0 * k / 199));
    return list;
}

struct Sweep {
    double tip_error = 0, state_error = 0, least_condition = std::numeric_limits<double>::infinity(), largest_condition = 0;
};

void add(Sweep& sweep, const Beam& beam, BeamScaling scaling) {
    const BeamSystem system = assemble_beam(beam, tip_force(beam), scaling);
    const BeamSolution solution = solve_beam(beam, system);
    ASSERT_EQ(solution.failure, "");
    const double condition = condition_numbers(system.stiffness).two;
    sweep.least_condition = std::min(sweep.least_condition, condition);
    sweep.largest_condition = std::max(sweep.largest_condition, condition);
    sweep.tip_error = std::max(sweep.tip_error, std::abs(beam_state(beam, solution, beam.end).deflection + 1. / 3));
    for (double t : {1e-9, 1e-5, 0.3, 0.5, 1 - 1e-9}) {
        const BeamState v = beam_state(beam, solution, beam.begin + t);
        sweep.state_error = std::max({sweep.state_error, std::abs(v.deflection - t * t * (t - 3) / 6),
                                      std::abs(v.slope - t * (t - 2) / 2), std::abs(v.curvature - (t - 1))});
    }
}

Sweep sweep(int degree, int n_cells, BeamScaling scaling) {
    Sweep result;
    for (double shift : shifts())
        for (double side : {1.0, -1.0}) add(result, shifted(degree, n_cells, side * shift), scaling);
    return result;
}

class BeamSweep : public ::testing::TestWithParam<std::pair<int, int>> {};

}  // namespace

TEST_P(BeamSweep, SolutionStaysWhereverTheGridCuts) {
    const auto [degree, cells] = GetParam();
    const double fitting = condition_numbers(assemble_beam(shifted(degree, cells, 0), {}).stiffness).two;
    for (BeamScaling scaling : {BeamScaling::none, BeamScaling::corner, BeamScaling::jacobi}) {
        const Sweep result = sweep(degree, cells, scaling);
        EXPECT_LT(result.tip_error, 1e-8);
        EXPECT_LT(result.state_error, 1e-10) << "rounding times the condition number of the fitting grid, up to 1e4";
        if (scaling == BeamScaling::jacobi) {
            EXPECT_LT(result.largest_condition, 3 * fitting);
            EXPECT_GT(result.least_condition, fitting / 3);
        } else {
            EXPECT_GT(result.largest_condition, scaling == BeamScaling::none ? 1e50 : 1e20) << "then Jacobi's is not needed";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(DegreesAndCells, BeamSweep,
                         ::testing::Values(std::pair(3, 1), std::pair(3, 2), std::pair(3, 3), std::pair(3, 8), std::pair(4, 1),
                                           std::pair(4, 2), std::pair(4, 5), std::pair(4, 8), std::pair(5, 1), std::pair(5, 2),
                                           std::pair(5, 3), std::pair(5, 8)));

TEST(Beam, EndsOnGridLinesBringNoFunctionsByRounding) {
    constexpr double ulp = std::numeric_limits<double>::epsilon();
    for (int n : {-200, -4, 0, 4, 200}) {
        Beam beam = cantilever(2, uniform_knots(1, 0, 5, 3));
        beam.begin += n * ulp;
        beam.end += n * ulp;
        const BeamSystem system = assemble_beam(beam, tip_force(beam), BeamScaling::corner);
        EXPECT_EQ(system.load.size(), std::abs(n) < grid_line_units ? 4 : 5) << n;
        EXPECT_EQ(system.scale == VectorXd::Ones(system.scale.size()), std::abs(n) < grid_line_units) << n;
        const BeamSolution solution = solve_beam(beam, system);
        EXPECT_NEAR(beam_state(beam, solution, beam.end).deflection, -1. / 3, 1e-12) << n;
        EXPECT_NEAR(beam_state(beam, solution, beam.begin).curvature, -1, 1e-12) << n;
    }
}

TEST(Beam, SizeAndPlaceDoNotMatter) {
    for (double unit : {1e-3, 1.0, 1e3, 1e6}) {
        Beam beam = cantilever(1.37 * unit, uniform_knots(0.4 * unit, 3, 3, 4));
        beam.end = 2.37 * unit;
        const BeamSolution solution = solve_beam(beam, assemble_beam(beam, tip_force(beam)));
        EXPECT_NEAR(beam_state(beam, solution, beam.end).deflection / std::pow(unit, 3), -1. / 3, 1e-11);
    }
    Beam far = cantilever(1e6 + 0.375, uniform_knots(0.5, 2000000, 4, 4));
    const BeamSolution solution = solve_beam(far, assemble_beam(far, tip_force(far)));
    EXPECT_NEAR(beam_state(far, solution, far.end).deflection, -1. / 3, 1e-11);
}

TEST(Beam, SaysWhyThereIsNoSystem) {
    const Beam good = appendix_b();
    const auto expect = [](const Beam& beam, const BeamLoad& load, const std::string& words) {
        const BeamSystem system = assemble_beam(beam, load);
        EXPECT_NE(system.failure.find(words), std::string::npos) << words << ": " << system.failure;
        EXPECT_EQ(solve_beam(beam, system).failure, system.failure);
    };
    const auto changed = [&](auto&& change) {
        Beam beam = good;
        change(beam);
        return beam;
    };
    EXPECT_EQ(assemble_beam(good, tip_force(good)).failure, "");
    expect(changed([](Beam& b) { b.knots = uniform_knots(1, 0, 2, 1); }), {}, "degree");
    expect(changed([](Beam& b) { b.end = b.begin; }), {}, "no length");
    expect(changed([](Beam& b) { b.begin = std::nan(""); }), {}, "no length");
    expect(changed([](Beam& b) { b.rigidity = 0; }), {}, "rigidity");
    expect(changed([](Beam& b) { b.end = 2.1; }), {}, "leaves its grid");
    expect(changed([](Beam& b) { b.begin = -0.1; }), {}, "leaves its grid");
    expect(changed([](Beam& b) { b.holds[0].end = BeamEnd::pinned; }), {}, "rigid motion");
    expect(changed([](Beam& b) { b.holds[0].end = BeamEnd::free; }), {}, "rigid motion");
    expect(changed([](Beam& b) { b.rule = gauss(3); }), {}, "rule");
    expect(changed([](Beam& b) { b.knots = clamped_knots({0, 1, 2}, 3, {1, 3, 1}); }), {}, "hinge");
    expect(good, force_at(1.95, 1), "off the beam");
    EXPECT_EQ(assemble_beam(changed([](Beam& b) { b.rule = gauss(4); }), {}).failure, "") << "p + values held - 1 points do";
    BeamSystem broken = assemble_beam(good, {});
    broken.stiffness(1, 1) = -1;
    EXPECT_NE(solve_beam(good, broken).failure.find("positive definite"), std::string::npos);
}

TEST(Beam, UniformKnotsAreTranslatesOfOneSpline) {
    for (int p = 1; p <= max_degree; ++p) {
        const KnotVector k = uniform_knots(0.3, -2, 5, p);
        ASSERT_EQ(k.n_functions(), 5 + p);
        for (int interval = 0; interval < 5; ++interval)
            for (double t : {0.0, 0.3, 0.99}) {
                LocalValues v;
                evaluate(k, interval, k.breakpoints[static_cast<std::size_t>(interval)] + 0.3 * t, v);
                for (int a = 0; a <= p; ++a) {
                    // function interval + a began p - a cells before: sum of truncated powers
                    double value = 0, binomial = 1, factorial = 1;
                    for (int j = 1; j <= p; ++j) factorial *= j;
                    for (int j = 0; j <= p - a; ++j) {
                        value += binomial * std::pow(p - a + t - j, p) / factorial;
                        binomial *= -(p + 1.0 - j) / (j + 1);
                    }
                    EXPECT_NEAR(v[static_cast<std::size_t>(a)], value, 1e-12);
                }
            }
    }
}

TEST(BeamCondition, NumbersOfKnownMatrices) {
    MatrixXd hilbert(4, 4);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) hilbert(i, j) = 1.0 / (i + j + 1);
    const ConditionNumbers c = condition_numbers(hilbert);
    EXPECT_NEAR(c.one, 28375, 1e-6 * 28375);
    EXPECT_NEAR(c.two, 15513.73873892924, 1e-6 * 15513);
    EXPECT_NEAR(c.frobenius, 15613.79355966, 1e-6 * 15613);
    MatrixXd graded(2, 2);
    graded << 1, 0.5e-40, 0.5e-40, 1e-80;
    const ConditionNumbers g = condition_numbers(graded);
    for (double of : {g.one, g.two, g.frobenius}) EXPECT_NEAR(of / 1e80, 4. / 3, 1e-12);
}

TEST(BeamCondition, IsInfiniteWhereTheMatrixIsNotDefinite) {
    for (double side : {1.0, 2.0}) {
        MatrixXd k(2, 2);
        k << 1, side, side, 1;
        const ConditionNumbers c = condition_numbers(k);
        for (double of : {c.one, c.two, c.frobenius}) EXPECT_TRUE(std::isinf(of));
    }
}

}  // namespace abut::solver::beam_test
