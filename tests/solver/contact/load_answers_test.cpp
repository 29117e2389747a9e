// SPDX-License-Identifier: GPL-3.0-or-later
// Answers to factors of loads beside the solution of the same assembly under the same loads.
#include "solver/contact/load_answers.hpp"

#include <gtest/gtest.h>

#include "tests/solver/contact/two_blocks.hpp"

namespace abut::solver::load_answers_test {
namespace {

using Eigen::VectorXd;
using test::TwoBlocks;

constexpr double rounding = 1e-9;

/// The floating upper block under three loads: all over its top, on its left half alone, on its right half alone.
struct Loaded {
    AssemblyProblem problem;
    std::vector<UnitLoad> loads;
};

Loaded loaded(const TwoBlocks& blocks) {
    Loaded made{blocks.problem(), {}};
    const PartInput& above = made.problem.parts[1].input;
    const auto unit = [&](double from, double to) {
        const VectorXd load = top_load(above, blocks.upper, from, to, {0, -1});
        return UnitLoad{{VectorXd(), load}, resultant_of(above.space, load).force.norm()};
    };
    made.loads = {unit(0, 1), unit(0, 0.5), unit(0.5, 1)};
    return made;
}

/// The same assembly under the sum of its loads.
AssemblySolution solved(const Loaded& made, const VectorXd& factors) {
    AssemblyProblem problem = made.problem;
    for (std::size_t j = 0; j < made.loads.size(); ++j) {
        const double factor = factors[static_cast<Eigen::Index>(j)];
        problem.parts[1].load += factor * made.loads[j].on_part[1];
        problem.load_scale = std::max(problem.load_scale, std::abs(factor) * made.loads[j].scale);
    }
    return solve_assembly(problem);
}

/// Relative to the largest entry of b.
double difference(const std::vector<VectorXd>& a, const std::vector<VectorXd>& b) {
    double worst = 0, largest = 0;
    EXPECT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
        EXPECT_EQ(a[i].size(), b[i].size());
        worst = std::max(worst, (a[i] - b[i]).cwiseAbs().maxCoeff());
        largest = std::max(largest, b[i].cwiseAbs().maxCoeff());
    }
    return worst / largest;
}

const std::vector<Eigen::Vector3d> several_factors{{0, 0, 0}, {1, 0, 0}, {1, 0.3, 0}, {0, 2, 0.5}, {-0.5, 0, 1.5}, {1, 0, 0}};

TEST(LoadAnswers, AreThoseOfTheAssemblySolvedUnderTheSameLoads) {
    for (const double gap : {0.0, 0.02}) {
        TwoBlocks blocks;
        blocks.gap = gap;
        const Loaded made = loaded(blocks);
        LoadAnswers answers(made.problem, made.loads, {}, 1);
        for (const Eigen::Vector3d& factors : several_factors) {
            const LoadAnswer answer = answers.answer(factors);
            const AssemblySolution expected = solved(made, factors);
            ASSERT_TRUE(expected.mechanism.empty());
            ASSERT_TRUE(answer.mechanism.empty() && answer.converged) << factors.transpose();
            EXPECT_LE(difference(answer.pressure, expected.pressure), rounding) << factors.transpose();
            EXPECT_LE(difference(answers.displacements(factors, answer, 1), expected.displacement), rounding)
                << factors.transpose();
        }
    }
}

/// Sideways the upper block is free: the answer has the least displacement of all, and measures have it, too.
TEST(LoadAnswers, MeasuresAreTakenOfTheDisplacements) {
    const TwoBlocks blocks;
    const Loaded made = loaded(blocks);
    std::vector<DisplacementMeasure> measures;
    for (std::size_t part : {0U, 1U}) {
        const auto n = 2 * made.problem.parts[part].n();
        measures.emplace_back(2);
        measures.back()[part] = VectorXd::LinSpaced(n, -1, 2).array().cos();
    }
    LoadAnswers answers(made.problem, made.loads, measures, 1);
    for (const Eigen::Vector3d& factors : several_factors) {
        const LoadAnswer answer = answers.answer(factors);
        const std::vector<VectorXd> u = answers.displacements(factors, answer, 1);
        ASSERT_EQ(answer.measured.size(), 2);
        for (std::size_t part : {0U, 1U})
            EXPECT_NEAR(answer.measured[static_cast<Eigen::Index>(part)], measures[part][part].dot(u[part]),
                        rounding * u[part].cwiseAbs().sum())
                << part;
    }
}

TEST(LoadAnswers, NameTheMotionThatLoadsDrive) {
    const TwoBlocks blocks;
    const Loaded made = loaded(blocks);
    LoadAnswers answers(made.problem, made.loads, {}, 1);
    const LoadAnswer lifted = answers.answer(Eigen::Vector3d(-2, 0, 0));
    ASSERT_EQ(lifted.mechanism.size(), 1U);
    EXPECT_EQ(lifted.mechanism[0].part, 1);
    EXPECT_GT(lifted.mechanism[0].motion.translation.y(), 0);
    // and what comes after it is answered
    EXPECT_LE(difference(answers.answer(several_factors[2]).pressure, solved(made, several_factors[2]).pressure), rounding);
}

TEST(LoadAnswers, AFactorThatIsOffShows) {
    const Loaded made = loaded({});
    LoadAnswers answers(made.problem, made.loads, {}, 1);
    const Eigen::Vector3d off = several_factors[2] * (1 + 1e-6);
    EXPECT_GT(difference(answers.answer(off).pressure, solved(made, several_factors[2]).pressure), rounding);
}

}  // namespace
}  // namespace abut::solver::load_answers_test
