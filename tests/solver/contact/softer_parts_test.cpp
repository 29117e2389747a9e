// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that yield more, beside the same parts of a softer material.
#include "solver/contact/softer_parts.hpp"

#include <gtest/gtest.h>

#include "tests/solver/contact/two_blocks.hpp"

namespace abut::solver::softer_parts_test {
namespace {

using Eigen::VectorXd;
using test::TwoBlocks;

/// A block held at its right side and pressed down on its top, over one on rollers that it nearly misses.
AssemblyProblem nearly_missed(double lower_modulus, double upper_modulus) {
    TwoBlocks blocks;
    blocks.lower.elasticity = plane_stress(lower_modulus, 0.3);
    blocks.upper.elasticity = plane_stress(upper_modulus, 0.25);
    blocks.gap = 1.5e-3;
    const PartInput above = part_of(blocks.upper, blocks.degree);
    for (const Vec2& way : {Vec2(1, 0), Vec2(0, 1)})
        blocks.upper_supports.push_back(test::support_on(above.space, {1, 1}, {1, 2}, {1, 0}, way));
    return blocks.problem();
}

constexpr double modulus = 1000;

TEST(SofterParts, PressOnEachOtherAsThoseOfASofterMaterialDo) {
    constexpr double more = 1e-3;
    const AssemblyProblem problem = nearly_missed(modulus, modulus);
    const AssemblySolution as_is = solve_assembly(problem);
    ASSERT_TRUE(as_is.converged);
    ASSERT_GT(as_is.pressure[0].maxCoeff(), 0);
    for (const std::array<double, 2>& which : {std::array{1.0, 0.0}, std::array{0.0, 1.0}, std::array{1.0, 1.0}}) {
        const AssemblySolution told = solve_with_softer_parts(problem, as_is, {more * which[0], more * which[1]}, 1);
        const AssemblySolution softer =
            solve_assembly(nearly_missed(modulus / (1 + more * which[0]), modulus / (1 + more * which[1])));
        ASSERT_TRUE(told.converged && softer.converged);
        const VectorXd change = softer.pressure[0] - as_is.pressure[0];
        EXPECT_GT(change.norm(), 0.1 * more * as_is.pressure[0].norm());
        EXPECT_LT((told.pressure[0] - softer.pressure[0]).norm(), 5 * more * change.norm());
    }
}

TEST(SofterParts, ThatYieldNoMorePressTheSame) {
    const AssemblyProblem problem = nearly_missed(modulus, modulus);
    const AssemblySolution as_is = solve_assembly(problem), told = solve_with_softer_parts(problem, as_is, {0, 0}, 1);
    EXPECT_LT((told.pressure[0] - as_is.pressure[0]).norm(), 1e-12 * as_is.pressure[0].norm());
}

}  // namespace
}  // namespace abut::solver::softer_parts_test
