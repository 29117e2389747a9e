// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/bernstein.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace bernstein_test {

namespace {

using namespace abut::geometry;

constexpr double epsilon = 2.220446049250313e-16;

double binomial(std::size_t n, std::size_t k) {
    double value = 1;
    for (std::size_t i = 1; i <= k; ++i) value = value * static_cast<double>(n - k + i) / static_cast<double>(i);
    return value;
}

/// Product of two polynomials in Bernstein form.
std::vector<double> times(const std::vector<double>& p, const std::vector<double>& q) {
    const std::size_t m = p.size() - 1, n = q.size() - 1;
    std::vector<double> product(m + n + 1, 0.0);
    for (std::size_t i = 0; i <= m; ++i)
        for (std::size_t j = 0; j <= n; ++j)
            product[i + j] += binomial(m, i) * binomial(n, j) / binomial(m + n, i + j) * p[i] * q[j];
    return product;
}

/// prod (t - r).
std::vector<double> with_roots(const std::vector<double>& roots) {
    std::vector<double> p{1};
    for (const double r : roots) p = times(p, {-r, 1 - r});
    return p;
}

/// Roundings of the coefficients of with_roots(roots): a few of each summand, and they may cancel.
std::vector<double> errors_of(const std::vector<double>& roots) {
    std::vector<double> sum{4 * epsilon};
    for (const double r : roots) sum = times(sum, {std::abs(r), std::abs(1 - r)});
    return sum;
}

/// (t - m)^2 + h^2: no real root.
std::vector<double> without_roots(double m, double h) {
    return {m * m + h * h, m * m - m + h * h, (1 - m) * (1 - m) + h * h};
}

void expect_roots(const std::vector<double>& found, const std::vector<double>& expected, double tolerance,
                  const std::string& of) {
    ASSERT_EQ(found.size(), expected.size()) << of << testing::PrintToString(found);
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << of << " root " << i;
}

/// Displacement of a simple root by one rounding of each coefficient of the product and a few of its evaluation.
double displacement(const std::vector<double>& p, double root) {
    std::vector<double> slope, sizes;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) slope.push_back(static_cast<double>(p.size() - 1) * (p[i + 1] - p[i]));
    for (const double c : p) sizes.push_back(std::abs(c));
    return 4 * static_cast<double>(p.size()) * epsilon *
           (1 + bernstein_value(sizes, root) / std::abs(bernstein_value(slope, root)));
}

TEST(Bernstein, LinearRootsToRounding) {
    for (int k = 0; k <= 1000; ++k) {
        const double r = k / 1000.0;
        expect_roots(bernstein_roots({-r, 1 - r}), {r}, epsilon, "at " + std::to_string(r));
        expect_roots(bernstein_roots({r, r - 1}), {r}, epsilon, "falling, at " + std::to_string(r));
    }
}

TEST(Bernstein, RootsAtTheEndsAreExact) {
    for (int degree = 1; degree <= 15; ++degree) {
        std::vector<double> p(static_cast<std::size_t>(degree) + 1, 1.0);
        p.front() = 0;
        EXPECT_EQ(bernstein_roots(p), std::vector<double>{0}) << degree;
        p.front() = -2;
        p.back() = 0;
        if (degree > 1) p[1] = -1;
        EXPECT_EQ(bernstein_roots(p).back(), 1) << degree;
    }
    EXPECT_EQ(bernstein_roots({0, 1, 0}), (std::vector<double>{0, 1}));
    EXPECT_EQ(bernstein_roots({0, 0, 1, 0, 0, 0}), (std::vector<double>{0, 1}));
}

TEST(Bernstein, NothingVanishesNowhere) {
    EXPECT_TRUE(bernstein_roots({}).empty());
    EXPECT_TRUE(bernstein_roots({3}).empty());
    EXPECT_TRUE(bernstein_roots({0, 0, 0}).empty());
    EXPECT_TRUE(bernstein_roots({1e-300, 1, 1e-300}).empty());
    for (int k = 0; k <= 20; ++k)
        for (const double h : {1.0, 1e-2, 1e-4, 1e-6})
            EXPECT_TRUE(bernstein_roots(without_roots(k / 20.0, h)).empty()) << k << " " << h;
}

/// Random simple roots beside roots outside [0, 1] and complex pairs, in all degrees that splines lead to.
TEST(Bernstein, SimpleRootsOfRandomProducts) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    int n_checked = 0;
    for (int trial = 0; trial < 1500; ++trial) {
        const int n_roots = trial % 8;
        std::vector<double> roots;
        for (int k = 0; k < n_roots; ++k) roots.push_back(unit(random));
        std::sort(roots.begin(), roots.end());
        std::vector<double> p = with_roots(roots);
        if (trial % 3 == 1) p = times(p, {1 + unit(random), unit(random) + 0.1});
        if (trial % 5 == 2) p = times(p, without_roots(unit(random), 0.05 + unit(random)));
        // Roots whose displacements by rounding overlap are one for all we know
        bool apart = true;
        for (std::size_t k = 1; k < roots.size(); ++k)
            apart &= roots[k] - roots[k - 1] > 2 * (displacement(p, roots[k]) + displacement(p, roots[k - 1]));
        if (!apart) continue;
        ++n_checked;
        const std::vector<double> found = bernstein_roots(p);
        ASSERT_EQ(found.size(), roots.size()) << trial;
        for (std::size_t k = 0; k < roots.size(); ++k) EXPECT_NEAR(found[k], roots[k], displacement(p, roots[k])) << trial;
    }
    EXPECT_GT(n_checked, 1400);
}

TEST(Bernstein, CloseRootsAreToldApart) {
    for (const double distance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
        for (const double at : {0.1, 1.0 / 3, 0.5, 0.83}) {
            const std::vector<double> roots{at, at + distance}, p = with_roots(roots);
            expect_roots(bernstein_roots(p), roots, displacement(p, at), "distance " + std::to_string(distance));
        }
}

/// A root of multiplicity m is smeared over errors^(1/m). Odd ones are found, even ones need not be.
TEST(Bernstein, MultipleRootsWithinTheirSmear) {
    for (std::size_t multiplicity = 2; multiplicity <= 5; ++multiplicity)
        for (const double at : {0.0, 0.125, 0.2, 1.0 / 3, 0.5, 0.77, 1.0})
            for (const double other : {-0.5, 2.0}) {
                std::vector<double> roots(multiplicity, at);
                roots.push_back(other);
                const std::vector<double> found = bernstein_roots(with_roots(roots), errors_of(roots));
                const bool needed = multiplicity % 2 == 1 || at == 0 || at == 1;
                EXPECT_GE(found.size(), needed ? 1u : 0u) << multiplicity << " times " << at;
                EXPECT_LE(found.size(), 3u) << multiplicity << " times " << at;
                const double smear = std::pow(1000 * epsilon, 1 / static_cast<double>(multiplicity));
                for (const double r : found) EXPECT_NEAR(r, at, smear) << multiplicity;
            }
}

TEST(Bernstein, SimpleRootsBesideADoubleOne) {
    const std::vector<double> roots{0.2, 0.6, 0.6, 0.9}, found = bernstein_roots(with_roots(roots), errors_of(roots));
    ASSERT_GE(found.size(), 2u);
    EXPECT_NEAR(found.front(), 0.2, 1e-14);
    EXPECT_NEAR(found.back(), 0.9, 1e-14);
}

/// Of the roots the one thing that counts: between two of them the polynomial has one sign, where it can be told from zero
/// (de Casteljau's scheme adds two roundings of each level). Multiple, close and random roots.
TEST(Bernstein, OneSignBetweenRoots) {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<double> roots;
        while (roots.size() < 2 + static_cast<std::size_t>(trial % 10)) {
            const double r = 1.4 * unit(random) - 0.2;
            const int times = unit(random) < 0.3 ? 1 + static_cast<int>(3 * unit(random)) : 1;
            for (int k = 0; k < times; ++k) roots.push_back(unit(random) < 0.2 ? r + 1e-6 : r);
        }
        const std::vector<double> p = with_roots(roots), errors = errors_of(roots);
        std::vector<double> ends = bernstein_roots(p, errors);
        ends.insert(ends.begin(), 0);
        ends.push_back(1);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            double least = 0, most = 0;
            for (int k = 1; k < 40; ++k) {
                const double t = ends[i] + k / 40.0 * (ends[i + 1] - ends[i]), value = bernstein_value(p, t);
                if (std::abs(value) <= static_cast<double>(p.size()) * bernstein_value(errors, t)) continue;
                least = std::min(least, value);
                most = std::max(most, value);
            }
            EXPECT_TRUE(least == 0 || most == 0) << trial << ": " << ends[i] << " to " << ends[i + 1];
        }
    }
}

/// Coefficients of very different size (as weights make them): the error of each counts, not that of the largest.
TEST(Bernstein, SmallCoefficientsCountBesideLargeOnes) {
    // (1-t)^2 a - 2 t (1-t) b + t^2 for small t: t = b -+ sqrt(b^2 - a)
    EXPECT_TRUE(bernstein_roots({1e-18, -1e-10, 1}).empty());
    const std::vector<double> found = bernstein_roots({1e-18, -1e-8, 1});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0], 5.0126e-11, 1e-14);
    EXPECT_NEAR(found[1], 1.9950e-8, 1e-11);
}

TEST(Bernstein, ErrorsDecideWhatIsZero) {
    EXPECT_EQ(bernstein_roots({-1e-15, 1, 1}, {1e-14, 1e-14, 1e-14}), std::vector<double>{0});
    EXPECT_EQ(bernstein_roots({1e-15, 1, 1}, {1e-14, 1e-14, 1e-14}), std::vector<double>{0});
    EXPECT_TRUE(bernstein_roots({1e-15, 1, 1}).empty());
    EXPECT_TRUE(bernstein_roots({1e-15, -1e-15, 1e-15}, {1e-14, 1e-14, 1e-14}).empty());
    EXPECT_EQ(bernstein_roots(without_roots(0.5, 3e-8), {1e-14, 1e-14, 1e-14}).size(), 1u);  // misses zero by 1e-15
}

TEST(Bernstein, ValueInClosedForm) {
    const std::vector<double> p = times({0, 1}, times({0, 1}, {1, 0}));  // t^2 (1 - t)
    for (int k = 0; k <= 10; ++k) EXPECT_NEAR(bernstein_value(p, k / 10.0), k * k * (10 - k) / 1000.0, 1e-16);
}

TEST(BernsteinChecks, NoticeAFault) {
    std::vector<double> p = with_roots({0.2, 0.6});
    p[1] += 1e-12;
    EXPECT_GT(std::abs(bernstein_roots(p).front() - 0.2), displacement(p, 0.2));
}

}  // namespace

}  // namespace bernstein_test
