// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/splines/bspline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::bspline_test {
namespace {

std::vector<KnotVector> all_knots() {
    std::vector<KnotVector> all;
    for (int degree = 1; degree <= max_degree; ++degree)
        for (bool uniform : {true, false})
            for (int cells : {1, 2, 6}) all.push_back(clamped_knots(test::grid_lines(-0.7, 1.6, cells, uniform), degree));
    return all;
}

std::vector<double> points_of(const KnotVector& k, int interval) {
    const double a = k.breakpoints[static_cast<std::size_t>(interval)],
                 b = k.breakpoints[static_cast<std::size_t>(interval) + 1];
    return {a, a + 0.21 * (b - a), a + 0.5 * (b - a), a + 0.93 * (b - a), b};
}

double at(const LocalValues& v, int i) {
    return v[static_cast<std::size_t>(i)];
}

/// Largest difference between derivatives and central differences with step d: truncation d^2/6 f''', rounding 1e-16/d.
double derivative_error(const KnotVector& k, int interval, double x, double d, double scale = 1) {
    LocalValues value, slope, before, after;
    evaluate(k, interval, x, value, slope);
    evaluate(k, interval, x - d, before);
    evaluate(k, interval, x + d, after);
    double worst = 0;
    for (int i = 0; i <= k.degree; ++i)
        worst = std::max(worst, std::abs(scale * at(slope, i) - (at(after, i) - at(before, i)) / (2 * d)));
    return worst;
}

/// Largest difference, over the whole line, between the continued pieces of one interval and their B-spline form elsewhere.
double extension_error(const KnotVector& k, int from, double perturbation = 0) {
    double worst = 0;
    for (int to = 0; to < k.n_intervals(); ++to)
        for (double x : points_of(k, to)) {
            LocalValues continued, local;
            evaluate(k, from, x, continued);
            evaluate(k, to, x, local);
            for (int a = 0; a <= k.degree; ++a) {
                double sum = 0, terms = std::abs(at(continued, a));
                for (int j = 0; j <= k.degree; ++j) {
                    const double e = at(extension_coefficients(k, from, to + j), a) * (1 + perturbation);
                    sum += e * at(local, j);
                    terms += std::abs(e * at(local, j));
                }
                worst = std::max(worst, std::abs(sum - at(continued, a)) / terms);
            }
        }
    return worst;
}

/// Largest jump of the periodic functions' values and (from degree 2 on) slopes across the seam; function i + n is function i.
double seam_error(const KnotVector& k, double perturbation = 0) {
    const int n = k.n_intervals();
    std::vector<double> value(static_cast<std::size_t>(n)), slope(value);
    const auto add = [&](int interval, double x, double sign) {
        LocalValues v, g;
        evaluate(k, interval, x, v, g);
        for (int a = 0; a <= k.degree; ++a) {
            value[static_cast<std::size_t>((interval + a) % n)] += sign * at(v, a);
            slope[static_cast<std::size_t>((interval + a) % n)] += sign * at(g, a);
        }
    };
    add(0, k.breakpoints.front() + perturbation, 1);
    add(n - 1, k.breakpoints.back(), -1);
    double worst = 0;
    for (double jump : value) worst = std::max(worst, std::abs(jump));
    for (double jump : slope) worst = std::max(worst, k.degree > 1 ? std::abs(jump) : 0.0);
    return worst;
}

void expect_periodic(int cells, bool uniform, int degree) {
    SCOPED_TRACE("degree " + std::to_string(degree) + ", cells " + std::to_string(cells));
    const KnotVector k = periodic_knots(test::grid_lines(-0.7, 1.6, cells, uniform), degree);
    const auto n = static_cast<std::size_t>(cells), p = static_cast<std::size_t>(degree);
    ASSERT_EQ(k.knots.size(), n + 1 + 2 * p);
    for (std::size_t i = 0; i + 1 < k.knots.size(); ++i) EXPECT_LT(k.knots[i], k.knots[i + 1]);
    for (std::size_t i = 0; i + n < k.knots.size(); ++i) EXPECT_NEAR(k.knots[i + n] - k.knots[i], 2.3, 1e-14);
    for (int i = 0; i < cells; ++i)
        for (double x : points_of(k, i)) {
            LocalValues v;
            evaluate(k, i, x, v);
            EXPECT_NEAR(std::accumulate(v.begin(), v.begin() + degree + 1, 0.0), 1, 1e-14);
        }
    EXPECT_LT(seam_error(k), 1e-11);
}

/// Largest jump of derivatives of the functions at a breakpoint, of those two intervals that meet there.
double slope_jump(const KnotVector& k, int interval) {
    const double x = k.breakpoints[static_cast<std::size_t>(interval)];
    std::vector<double> jump(static_cast<std::size_t>(k.n_functions()));
    const auto add = [&](int i, double sign) {
        LocalValues v, g;
        evaluate(k, i, x, v, g);
        for (int a = 0; a <= k.degree; ++a)
            jump[static_cast<std::size_t>(k.first[static_cast<std::size_t>(i)] + a)] += sign * at(g, a);
    };
    add(interval, 1);
    add(interval - 1, -1);
    double worst = 0;
    for (double j : jump) worst = std::max(worst, std::abs(j));
    return worst;
}

}  // namespace

TEST(BSpline, PeriodicKnotsHaveNoSeam) {
    for (int degree = 1; degree <= 4; ++degree)
        for (bool uniform : {true, false})
            for (int cells : {degree + 1, degree + 2, 9}) expect_periodic(cells, uniform, degree);
    EXPECT_GT(seam_error(periodic_knots(test::grid_lines(-0.7, 1.6, 5, false), 3), 1e-6), 1e-11);
    EXPECT_GT(seam_error(clamped_knots(test::grid_lines(-0.7, 1.6, 5, false), 3)), 1e-11);
}

TEST(BSpline, PeriodicKnotsMayBeFewerThanTheDegree) {
    for (int degree = 1; degree <= 4; ++degree)
        for (int cells = 1; cells <= degree; ++cells) expect_periodic(cells, false, degree);
}

TEST(BSpline, PeriodicKnotsOfHigherMultiplicity) {
    for (int degree = 2; degree <= 4; ++degree)
        for (int doubled = 0; doubled < 7; ++doubled) {
            SCOPED_TRACE("degree " + std::to_string(degree) + ", breakpoint " + std::to_string(doubled));
            std::vector<int> multiplicity(8, 1);
            multiplicity[static_cast<std::size_t>(doubled)] = degree;  // no more than continuous
            const KnotVector k = periodic_knots(test::grid_lines(-0.7, 1.6, 7, false), degree, multiplicity);
            const auto n = static_cast<std::size_t>(7 + degree - 1);  // functions of a period
            ASSERT_EQ(k.knots.size(), n + 1 + 2 * static_cast<std::size_t>(degree));
            for (std::size_t i = 0; i + n < k.knots.size(); ++i) EXPECT_NEAR(k.knots[i + n] - k.knots[i], 2.3, 1e-14);
            for (int i = 0; i < 7; ++i)
                for (double x : points_of(k, i)) {
                    LocalValues v;
                    evaluate(k, i, x, v);
                    EXPECT_NEAR(std::accumulate(v.begin(), v.begin() + degree + 1, 0.0), 1, 1e-13);
                }
            for (int i = 1; i < 7; ++i) {
                if (i == doubled) {
                    EXPECT_GT(slope_jump(k, i), 0.1) << i;
                } else {
                    EXPECT_LT(slope_jump(k, i), 1e-11) << i;
                }
            }
        }
}

TEST(BSpline, SimplePeriodicKnotsAreThoseOfMultiplicityOne) {
    const std::vector<double> lines = test::grid_lines(-0.7, 1.6, 5, false);
    const KnotVector simple = periodic_knots(lines, 2), ones = periodic_knots(lines, 2, std::vector<int>(6, 1));
    EXPECT_EQ(simple.knots, ones.knots);
    EXPECT_EQ(simple.first, ones.first);
}

TEST(BSpline, KnotsAreClampedAndCounted) {
    const KnotVector k = clamped_knots({0, 1, 3}, 2);
    EXPECT_EQ(k.knots, (std::vector<double>{0, 0, 0, 1, 3, 3, 3}));
    EXPECT_EQ(k.n_intervals(), 2);
    EXPECT_EQ(k.n_functions(), 4);
}

TEST(BSpline, IntervalsAreClosedToTheRightAtTheEndOnly) {
    const KnotVector k = clamped_knots({0, 1, 3}, 3);
    EXPECT_EQ(interval_of(k, 0), 0);
    EXPECT_EQ(interval_of(k, 0.999), 0);
    EXPECT_EQ(interval_of(k, 1), 1);
    EXPECT_EQ(interval_of(k, 3), 1);
    EXPECT_EQ(interval_of(k, -5), 0);
    EXPECT_EQ(interval_of(k, 5), 1);
}

TEST(BSpline, ValuesArePositiveAndSumToOne) {
    for (const KnotVector& k : all_knots())
        for (int i = 0; i < k.n_intervals(); ++i)
            for (double x : points_of(k, i)) {
                LocalValues v, w, slope;
                evaluate(k, i, x, v);
                evaluate(k, i, x, w, slope);
                EXPECT_NEAR(std::accumulate(v.begin(), v.begin() + k.degree + 1, 0.0), 1, 1e-14);
                EXPECT_NEAR(std::accumulate(slope.begin(), slope.begin() + k.degree + 1, 0.0), 0, 1e-12);
                for (int a = 0; a <= k.degree; ++a) {
                    EXPECT_GE(at(v, a), 0);
                    EXPECT_EQ(at(v, a), at(w, a));
                }
            }
}

TEST(BSpline, QuadraticOnUniformKnotsHasTheTextbookValues) {
    const KnotVector k = clamped_knots({0, 1, 2, 3, 4, 5}, 2);
    LocalValues v, slope;
    evaluate(k, 2, 2.5, v, slope);
    EXPECT_DOUBLE_EQ(v[0], 0.125);
    EXPECT_DOUBLE_EQ(v[1], 0.75);
    EXPECT_DOUBLE_EQ(v[2], 0.125);
    EXPECT_DOUBLE_EQ(slope[0], -0.5);
    EXPECT_DOUBLE_EQ(slope[1], 0);
    EXPECT_DOUBLE_EQ(slope[2], 0.5);
}

TEST(BSpline, OnlyTheOutermostFunctionsReachTheEnds) {
    for (const KnotVector& k : all_knots()) {
        LocalValues first, last;
        evaluate(k, 0, k.breakpoints.front(), first);
        evaluate(k, k.n_intervals() - 1, k.breakpoints.back(), last);
        for (int a = 0; a <= k.degree; ++a) {
            EXPECT_NEAR(at(first, a), a == 0 ? 1 : 0, a == 0 ? 1e-15 : 0);
            EXPECT_NEAR(at(last, a), a == k.degree ? 1 : 0, a == k.degree ? 1e-15 : 0);
        }
    }
}

TEST(BSpline, DerivativesAreThoseOfTheValues) {
    constexpr double d = 1e-5, bound = 1e-5;  // third derivatives up to 6 7 8 / h^3 with h = 0.1: d^2/6 of that
    for (const KnotVector& k : all_knots())
        for (int i = 0; i < k.n_intervals(); ++i)
            for (double x : points_of(k, i)) EXPECT_LT(derivative_error(k, i, x, d), bound) << "degree " << k.degree;
    EXPECT_GT(derivative_error(all_knots().back(), 2, 0.1, d, 1.001), bound);
}

TEST(BSpline, PiecesMeetWithAllButOneDerivative) {
    // from degree 2 on the first derivative is continuous across an inner breakpoint; function a of the left is a - 1 of the
    // right
    for (const KnotVector& k : all_knots())
        for (int i = 0; i + 1 < k.n_intervals(); ++i) {
            LocalValues left, right, left_slope, right_slope;
            const double x = k.breakpoints[static_cast<std::size_t>(i) + 1];
            evaluate(k, i, x, left, left_slope);
            evaluate(k, i + 1, x, right, right_slope);
            for (int a = 1; a <= k.degree; ++a) {
                EXPECT_NEAR(at(left, a), at(right, a - 1), 1e-14);
                const double jump = at(left_slope, a) - at(right_slope, a - 1);
                EXPECT_TRUE(k.degree == 1 || std::abs(jump) < 1e-11) << jump;
            }
        }
}

TEST(BSpline, GrevilleAbscissasAreTheCoefficientsOfX) {
    for (const KnotVector& k : all_knots())
        for (int i = 0; i < k.n_intervals(); ++i)
            for (double x : points_of(k, i)) {
                LocalValues v;
                evaluate(k, i, x, v);
                double sum = 0;
                for (int a = 0; a <= k.degree; ++a) sum += greville(k, i + a) * at(v, a);
                EXPECT_NEAR(sum, x, 1e-14);
            }
}

TEST(BSpline, BlossomsAreTheCoefficientsOfEveryMonomial) {
    // the tests of the spaces rely on these coefficients
    for (const KnotVector& k : all_knots())
        for (int power = 0; power <= k.degree; ++power)
            for (int i = 0; i < k.n_intervals(); ++i)
                for (double x : points_of(k, i)) {
                    LocalValues v;
                    evaluate(k, i, x, v);
                    double sum = 0;
                    for (int a = 0; a <= k.degree; ++a) sum += test::monomial_coefficient(k, i + a, power) * at(v, a);
                    EXPECT_NEAR(sum, std::pow(x, power), 1e-13 * std::pow(1.6, power));
                }
}

TEST(BSpline, ExtensionContinuesThePolynomialsOverTheWholeLine) {
    constexpr double bound = 1e-12;  // rounding of up to six blossom steps, of terms that may cancel
    for (const KnotVector& k : all_knots())
        for (int from = 0; from < k.n_intervals(); ++from)
            EXPECT_LT(extension_error(k, from), bound) << "degree " << k.degree << " interval " << from;
    EXPECT_GT(extension_error(all_knots().back(), 2, 1e-9), bound);
}

TEST(BSpline, ExtensionWithinTheIntervalIsTheFunctionItself) {
    for (const KnotVector& k : all_knots())
        for (int i = 0; i < k.n_intervals(); ++i)
            for (int j = 0; j <= k.degree; ++j) {
                const LocalValues e = extension_coefficients(k, i, i + j);
                for (int a = 0; a <= k.degree; ++a) EXPECT_NEAR(at(e, a), a == j ? 1 : 0, 1e-13);
            }
}

TEST(BSpline, ExtensionOnUniformKnotsIsLagrangeInterpolation) {
    // [Grishin10, eq 3.17]: e_a(j) = product over b != a of (j - i - b) / (a - b)
    for (int p = 1; p <= 4; ++p) {
        std::vector<double> lines(20);
        std::iota(lines.begin(), lines.end(), 0.0);
        const KnotVector k = clamped_knots(lines, p);
        const int i = 9;
        for (int j = i - 3; j <= i + p + 3; ++j) {
            const LocalValues e = extension_coefficients(k, i, j);
            for (int a = 0; a <= p; ++a) {
                double lagrange = 1;
                for (int b = 0; b <= p; ++b)
                    if (b != a) lagrange *= static_cast<double>(j - i - b) / (a - b);
                EXPECT_NEAR(at(e, a), lagrange, 1e-12 * std::max(1.0, std::abs(lagrange)));
            }
        }
    }
}

TEST(BSpline, ExtensionOfTheFirstDegreeByHand) {
    // the last piece of {0, 1, 3}: 1 - (x - 1) / 2 and (x - 1) / 2, at x = 0
    const LocalValues e = extension_coefficients(clamped_knots({0, 1, 3}, 1), 1, 0);
    EXPECT_DOUBLE_EQ(e[0], 1.5);
    EXPECT_DOUBLE_EQ(e[1], -0.5);
}

}  // namespace abut::solver::bspline_test
