// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/pressed_stretches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "solver/contact/interface.hpp"

namespace abut::pressed_stretches_test {
namespace {

using Pressure = std::function<double(double)>;

solver::KnotVector uniform(int cells) {
    std::vector<double> lines;
    for (int i = 0; i <= cells; ++i) lines.push_back(static_cast<double>(i) / cells);
    return solver::clamped_knots(lines, 2);
}

/// A spline near a pressure: its values at the Greville points as coefficients.
Eigen::VectorXd coefficients_of(const solver::KnotVector& knots, const Pressure& pressure) {
    Eigen::VectorXd c(knots.n_functions());
    for (int i = 0; i < knots.n_functions(); ++i) c[i] = std::max(0.0, pressure(solver::greville(knots, i)));
    return c;
}

std::vector<PressedStretch> stretches_of(int cells, const Pressure& pressure) {
    const solver::KnotVector knots = uniform(cells);
    return pressed_stretches(knots, coefficients_of(knots, pressure));
}

Pressure half_ellipse(double end) {
    return [=](double s) { return s < end ? std::sqrt(1 - s * s / (end * end)) : 0.0; };
}

Pressure bump(double middle, double half_width) {
    return [=](double s) {
        const double x = (s - middle) / half_width;
        return std::abs(x) < 1 ? std::sqrt(1 - x * x) : 0.0;
    };
}

}  // namespace

TEST(PressedStretches, NothingPressedIsNoRun) {
    EXPECT_TRUE(stretches_of(10, [](double) { return 0.0; }).empty());
}

TEST(PressedStretches, RoundingIsNoRun) {
    const solver::KnotVector knots = uniform(20);
    Eigen::VectorXd c = coefficients_of(knots, bump(0.25, 0.2));
    ASSERT_EQ(pressed_stretches(knots, c).size(), 1u);
    c[18] = 1e-10;
    EXPECT_EQ(pressed_stretches(knots, c).size(), 1u);
    c[18] = 1e-8;
    EXPECT_EQ(pressed_stretches(knots, c).size(), 2u);
}

TEST(PressedStretches, ASymmetryPlaneIsPlainAndTheOtherEndFree) {
    for (int cells : {30, 60, 120})
        for (double end : {0.5, 0.613, 0.7, 0.771}) {
            SCOPED_TRACE(std::to_string(cells) + " cells, end " + std::to_string(end));
            const std::vector<PressedStretch> stretches = stretches_of(cells, half_ellipse(end));
            ASSERT_EQ(stretches.size(), 1u);
            EXPECT_TRUE(stretches[0].from_start);
            EXPECT_FALSE(stretches[0].to_end);
            EXPECT_EQ(stretches[0].at_begin.kind, StretchEnd::Kind::plain);
            EXPECT_EQ(stretches[0].at_end.kind, StretchEnd::Kind::free);
            // half a knot interval: what a spline whose coefficients are samples of the root can tell
            EXPECT_NEAR(stretches[0].end, end, 0.5 / cells);
            EXPECT_DOUBLE_EQ(stretches[0].at_begin.error, 0);
            EXPECT_NEAR(stretches[0].at_end.reach, error_reach / cells, 1e-12);
        }
}

/// The end's error is what it says: the distance between the spline and the exact pressure there.
TEST(PressedStretches, TheErrorOfAFreeEndIsTheDistanceToTheRoot) {
    for (int cells : {40, 80, 160})
        for (double end : {0.5, 0.613, 0.7, 0.771}) {
            const solver::KnotVector knots = uniform(cells);
            const Pressure exact = half_ellipse(end);
            const Eigen::VectorXd c = coefficients_of(knots, exact);
            const std::vector<PressedStretch> stretches = pressed_stretches(knots, c);
            ASSERT_EQ(stretches.size(), 1u);
            double square = 0;
            const int steps = 4000;
            const double from = end - error_reach / cells, h = (2 + error_reach) / cells / steps;
            for (int i = 0; i < steps; ++i) {
                const double s = from + (i + 0.5) * h, d = solver::pressure_at(knots, c, s) - exact(s);
                square += h * d * d;
            }
            EXPECT_GT(stretches[0].at_end.error, 0.5 * std::sqrt(square)) << cells << " " << end;
            EXPECT_LT(stretches[0].at_end.error, 2 * std::sqrt(square)) << cells << " " << end;
        }
}

TEST(PressedStretchs, APressureThatRisesToTheEndStandsAtACorner) {
    const auto corner = [](double s) { return 1 / std::sqrt(s + 1e-3); };
    const std::vector<PressedStretch> stretches = stretches_of(60, [&](double s) { return corner(s) + corner(1 - s); });
    ASSERT_EQ(stretches.size(), 1u);
    EXPECT_EQ(stretches[0].at_begin.kind, StretchEnd::Kind::corner);
    EXPECT_EQ(stretches[0].at_end.kind, StretchEnd::Kind::corner);
    EXPECT_GT(stretches[0].at_begin.reach, 0);
    EXPECT_LT(stretches[0].at_begin.reach, 0.1);
    EXPECT_EQ(stretches_of(60, [](double) { return 1.0; })[0].at_begin.kind, StretchEnd::Kind::plain);
}

/// Wherever a zone that goes all the way round begins, there is no end.
TEST(PressedStretches, ASeamIsNoCorner) {
    std::vector<double> lines;
    for (int k = 0; k <= 40; ++k) lines.push_back(k / 40.0);
    const solver::KnotVector knots = solver::periodic_knots(lines, 2);
    Eigen::VectorXd c(knots.n_functions());
    for (int i = 0; i < c.size(); ++i) c[i] = 2 + std::cos(2 * std::numbers::pi * solver::greville(knots, i));
    const std::vector<PressedStretch> stretches = pressed_stretches(knots, c);
    ASSERT_EQ(stretches.size(), 1U);
    EXPECT_EQ(stretches[0].at_begin.kind, StretchEnd::Kind::plain);
    EXPECT_EQ(stretches[0].at_end.kind, StretchEnd::Kind::plain);
}

TEST(PressedStretches, TwoStretches) {
    const std::vector<PressedStretch> stretches =
        stretches_of(80, [](double s) { return bump(0.25, 0.15)(s) + bump(0.7, 0.2)(s); });
    ASSERT_EQ(stretches.size(), 2u);
    EXPECT_NEAR(stretches[0].begin, 0.1, 0.5 / 80);
    EXPECT_NEAR(stretches[0].end, 0.4, 0.5 / 80);
    EXPECT_NEAR(stretches[1].begin, 0.5, 0.5 / 80);
    EXPECT_NEAR(stretches[1].end, 0.9, 0.5 / 80);
    for (const PressedStretch& stretch : stretches) {
        EXPECT_EQ(stretch.at_begin.kind, StretchEnd::Kind::free);
        EXPECT_EQ(stretch.at_end.kind, StretchEnd::Kind::free);
    }
}

}  // namespace abut::pressed_stretches_test
