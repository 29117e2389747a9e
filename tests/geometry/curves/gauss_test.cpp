// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/gauss.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

namespace gauss_test {

namespace {

using abut::geometry::gauss_rule;
using abut::geometry::GaussRule;

double integral_of_power(const GaussRule& rule, int degree) {
    double sum = 0;
    for (std::size_t i = 0; i < rule.points.size(); ++i) sum += rule.weights[i] * std::pow(rule.points[i], degree);
    return sum;
}

/// All summands are positive: the error is a few roundings of the points, times the degree.
constexpr double tolerance = 1e-14;

/// Largest relative error of x^k over [0, 1], k up to 2n - 1.
double exactness_error(const GaussRule& rule) {
    double worst = 0;
    for (int k = 0; k < 2 * static_cast<int>(rule.points.size()); ++k)
        worst = std::max(worst, std::abs((k + 1) * integral_of_power(rule, k) - 1));
    return worst;
}

TEST(Gauss, ExactToDegree2nMinus1) {
    for (int n = 1; n <= 30; ++n) EXPECT_LT(exactness_error(gauss_rule(n)), tolerance) << n;
}

/// The error of x^2n is (n!)^4 / ((2n + 1) (2n)!^2) on [0, 1]: no rule with n points does better, and none that is right does
/// worse.
TEST(Gauss, ErrorAtDegree2nIsTheKnownOne) {
    for (int n = 1; n <= 8; ++n) {
        const double expected = std::pow(std::tgamma(n + 1), 4) / ((2 * n + 1) * std::pow(std::tgamma(2 * n + 1), 2));
        EXPECT_NEAR(1.0 / (2 * n + 1) - integral_of_power(gauss_rule(n), 2 * n), expected, 1e-15) << n;
    }
}

TEST(Gauss, PointsAscendInsideSymmetricallyWithPositiveWeights) {
    for (int n = 1; n <= 128; ++n) {
        const GaussRule& rule = gauss_rule(n);
        const auto size = static_cast<std::size_t>(n);
        ASSERT_EQ(rule.points.size(), size);
        ASSERT_EQ(rule.weights.size(), size);
        for (std::size_t i = 0; i < size; ++i) {
            EXPECT_GT(rule.points[i], i == 0 ? 0.0 : rule.points[i - 1]);
            EXPECT_LT(rule.points[i], 1);
            EXPECT_GT(rule.weights[i], 0);
            EXPECT_NEAR(rule.points[i] + rule.points[size - 1 - i], 1, 4e-16);
            EXPECT_NEAR(rule.weights[i], rule.weights[size - 1 - i], 1e-13 * rule.weights[i]);
        }
    }
}

TEST(Gauss, LongestRuleIntegratesWhatNeedsIt) {
    const GaussRule& rule = gauss_rule(128);
    EXPECT_NEAR(integral_of_power(rule, 0), 1, 1e-13);
    EXPECT_NEAR(integral_of_power(rule, 255) * 256, 1, 1e-12);  // 255 roundings of the power, and those of the points 255 times
    double wave = 0;
    for (std::size_t i = 0; i < rule.points.size(); ++i) wave += rule.weights[i] * std::cos(100 * rule.points[i]);
    EXPECT_NEAR(wave, std::sin(100.0) / 100, 1e-14);
}

TEST(Gauss, TwoAndThreePointsInClosedForm) {
    EXPECT_NEAR(gauss_rule(2).points[0], 0.5 - std::sqrt(3.0) / 6, 1e-16);
    EXPECT_NEAR(gauss_rule(2).weights[0], 0.5, 1e-15);
    EXPECT_NEAR(gauss_rule(3).points[2], 0.5 + std::sqrt(0.15), 2e-16);
    EXPECT_NEAR(gauss_rule(3).weights[1], 4.0 / 9, 1e-15);
}

TEST(Gauss, SharedBetweenThreads) {
    std::vector<const GaussRule*> seen(4);
    std::vector<std::thread> threads;
    for (const GaussRule*& rule : seen) threads.emplace_back([&rule] { rule = &gauss_rule(77); });
    for (std::thread& thread : threads) thread.join();
    for (const GaussRule* rule : seen) EXPECT_EQ(rule, &gauss_rule(77));
    EXPECT_EQ(seen[0]->points.size(), 77u);
}

TEST(Gauss, RefusesWhatItDoesNotHave) {
    EXPECT_THROW(gauss_rule(0), std::logic_error);
    EXPECT_THROW(gauss_rule(129), std::logic_error);
}

TEST(GaussChecks, NoticeAFault) {
    GaussRule rule = gauss_rule(5);
    rule.weights[2] *= 1 + 1e-12;
    EXPECT_GT(exactness_error(rule), tolerance);
    rule = gauss_rule(5);
    rule.points[3] += 1e-12;
    EXPECT_GT(exactness_error(rule), tolerance);
}

}  // namespace

}  // namespace gauss_test
