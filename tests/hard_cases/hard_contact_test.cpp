// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard_cases/hard_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace abut::test::hard_contact_test {
namespace {

constexpr int most_iterations = 30;
constexpr double most_error = 1.5;  // of the median

double median_error(const HardAnswers& answers) {
    std::vector<double> errors;
    for (const HardAnswer& a : answers) errors.push_back(a.error);
    std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
    return errors[errors.size() / 2];
}

/// rounding: errors below it are no errors of the method.
void expect_solved(const HardAnswers& answers, double rounding) {
    const double limit = std::max(rounding, most_error * median_error(answers));
    for (const HardAnswer& a : answers) {
        EXPECT_EQ(a.failure, "") << a.family << a.what;
        EXPECT_LE(a.error, limit) << a.family << a.what << ", median " << median_error(answers);
        EXPECT_LE(a.iterations, most_iterations) << a.family << a.what;
    }
}

TEST(HardContact, FloatingBlocks) {
    expect_solved(floating_blocks(), 1e-8);
}

TEST(HardContact, HeldBlocks) {
    expect_solved(held_blocks(), 1e-3);
}

TEST(HardContact, TiltedBlocks) {
    expect_solved(tilted_blocks(), 1e-8);
}

TEST(HardContact, ManyPairs) {
    expect_solved(many_pairs(), 1e-8);
}

TEST(HardContact, Stacks) {
    expect_solved(stacks(), 1e-8);
}

TEST(HardContact, Discs) {
    expect_solved(discs({1}), 0);
}

TEST(LongHardContact, EveryFamily) {
    const HardAnswers all_discs = discs({1e-4, 1e-2, 1, 1e2, 1e4});
    expect_solved(all_discs, 0);
    write_hard_contacts(
        {floating_blocks(), held_blocks(), tilted_blocks(), many_pairs(), stacks(), all_discs, conforming_discs()});
}

TEST(HardContact, ConformingDiscs) {
    expect_solved(conforming_discs(), 0);
}

TEST(HardContact, SwappingThePartsChangesNothing) {
    for (double angle : {0.0, 29.0})
        for (double modulus : {0.01, 1.0, 100.0}) {
            DiscOnBlock d{modulus, 0, 0.1, 6, angle};
            const SolvedAssembly one = solve_case(disc_on_block(d));
            d.disc_first = true;
            const SolvedAssembly other = solve_case(disc_on_block(d));
            ASSERT_TRUE(one.solution.converged && other.solution.converged);
            const double peak = peak_pressure(one, 0);
            EXPECT_NEAR(peak, peak_pressure(other, 0), 1e-8 * peak);
            const Eigen::VectorXd &p = pressure_of(one, 0), &q = pressure_of(other, 0);
            ASSERT_EQ(p.size(), q.size());
            EXPECT_LT((p - q.reverse()).cwiseAbs().maxCoeff(), 1e-8 * peak);
        }
}

TEST(HardContact, ALoadThatOpensEveryContactNamesTheMotion) {
    DiscOnBlock d;
    SolvedAssembly solved = solve_case(disc_on_block(d));
    ASSERT_TRUE(solved.solution.mechanism.empty());
    const double peak = peak_pressure(solved, 0);
    for (double factor : {1e-3, 1e-6}) {  // less and less, then the other way
        scale_loads(solved, factor);
        EXPECT_TRUE(solved.solution.converged);
        EXPECT_LT(peak_pressure(solved, 0), 0.1 * peak);
    }
    scale_loads(solved, -1);
    ASSERT_EQ(solved.solution.mechanism.size(), 1u);
    const solver::PartMotion& m = solved.solution.mechanism.front();
    EXPECT_EQ(solved.grids[static_cast<std::size_t>(m.part)].part, 1);
    EXPECT_GT(m.motion.translation.y(), 0.99 * m.motion.translation.norm());
    EXPECT_LT(std::abs(m.motion.rotation), 1e-6 * m.motion.translation.norm());
}

}  // namespace
}  // namespace abut::test::hard_contact_test
