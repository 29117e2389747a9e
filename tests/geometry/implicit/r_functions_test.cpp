// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/implicit/r_functions.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>
#include <unsupported/Eigen/AutoDiff>
#include <vector>

#include "geometry/curves/vec2.hpp"
#include "geometry/implicit/jet.hpp"

namespace abut::geometry::r_functions_test {

namespace {

const std::vector<double> alphas{-0.9, -0.5, 0, 0.3, 0.5, 0.9, 1};

std::vector<std::pair<double, double>> random_pairs(int n) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> u(-2, 2);
    std::vector<std::pair<double, double>> pairs;
    for (int i = 0; i < n; ++i) {
        const double x = u(random), y = u(random);
        pairs.emplace_back(x, y);
    }
    return pairs;
}

/// Two functions of the plane with all derivatives, as jets or through Eigen's nested AutoDiffScalar.
template <class T>
T first_function(const T& x, const T& y) {
    using std::sqrt;
    return T(x * y - sqrt(T(x * x + 2.0 * (y * y))) + T(1.0));
}
template <class T>
T second_function(const T& x, const T& y) {
    return T((x * x - y) / T(T(3.0) + y * y));
}

using Inner = Eigen::AutoDiffScalar<Vec2>;
using Nested = Eigen::AutoDiffScalar<Eigen::Matrix<Inner, 2, 1>>;

Nested nested_variable(double at, int axis) {
    Nested x;
    x.value() = Inner(at, 2, axis);
    for (int i = 0; i < 2; ++i) x.derivatives()[i] = Inner(i == axis ? 1.0 : 0.0, Vec2::Zero());
    return x;
}

void expect_same(const Jet& jet, const Nested& nested, double tolerance) {
    const auto near = [&](double a, double b) { EXPECT_NEAR(a, b, tolerance * (1 + std::abs(b))); };
    near(jet.v, nested.value().value());
    near(jet.x, nested.derivatives()[0].value());
    near(jet.y, nested.derivatives()[1].value());
    near(jet.xx, nested.derivatives()[0].derivatives()[0]);
    near(jet.xy, nested.derivatives()[0].derivatives()[1]);
    near(jet.yy, nested.derivatives()[1].derivatives()[1]);
}

}  // namespace

TEST(RFunctions, AreTheFormulasOfTheDissertation) {
    for (const double alpha : alphas)
        for (const auto& [x, y] : random_pairs(300)) {
            const double root = std::sqrt(x * x + y * y - 2 * alpha * x * y);
            // rounding of the squares under the root, as the direct form passes it on
            const double rounding = 2e-15 * (x * x + y * y + root) / (root * (1 + alpha));
            EXPECT_NEAR(conjunction(x, y, alpha), (x + y - root) / (1 + alpha), rounding);
            EXPECT_NEAR(disjunction(x, y, alpha), (x + y + root) / (1 + alpha), rounding);
        }
}

TEST(RFunctions, HaveTheSignsOfTheBooleans) {
    for (const double alpha : alphas)
        for (const auto& [x, y] : random_pairs(300)) {
            EXPECT_EQ(conjunction(x, y, alpha) > 0, x > 0 && y > 0);
            EXPECT_EQ(disjunction(x, y, alpha) > 0, x > 0 || y > 0);
            EXPECT_EQ(negation(x) > 0, x < 0);
        }
}

TEST(RFunctions, AreMinimumAndMaximumForAlphaOne) {
    for (const auto& [x, y] : random_pairs(300)) {
        EXPECT_NEAR(conjunction(x, y, 1.0), std::min(x, y), 1e-15);
        EXPECT_NEAR(disjunction(x, y, 1.0), std::max(x, y), 1e-15);
    }
}

TEST(RFunctions, KeepTinyValuesAndTheirSlope) {
    for (const double alpha : alphas)
        for (const double y : {1e-3, 1.0, 1e3}) {
            EXPECT_EQ(conjunction(0.0, y, alpha), 0);
            EXPECT_EQ(disjunction(0.0, -y, alpha), 0);
            const double x = 1e-20 * y;
            EXPECT_NEAR(conjunction(x, y, alpha) / x, 1, 1e-14);
            EXPECT_NEAR(disjunction(x, -y, alpha) / x, 1, 1e-14);
        }
}

TEST(RFunctions, VanishAtCornersWithoutDerivatives) {
    const Jet x(0, 1, 0, 0, 0, 0), y(0, 0, 1, 0, 0, 0);
    const std::vector<Jet> both{x, y};
    for (const Jet& w : {conjunction(x, y, 0), disjunction(x, y, 0), equivalence(std::span<const Jet>(both), 2)}) {
        EXPECT_EQ(w.v, 0);
        EXPECT_FALSE(std::isfinite(w.x));
        EXPECT_FALSE(std::isfinite(w.yy));
    }
}

TEST(RFunctions, CoincidentBoundariesLoseTheirNormalisationAsStated) {
    for (const double alpha : {-0.5, 0.0, 0.5}) {
        EXPECT_NEAR(conjunction(0.3, 0.3, alpha), (2 - std::sqrt(2 - 2 * alpha)) / (1 + alpha) * 0.3, 1e-15);
        EXPECT_EQ(disjunction(0.0, 0.0, alpha), 0);
    }
}

TEST(RFunctions, JetsAgreeWithEigensNestedAutoDiff) {
    for (const auto& [x, y] : random_pairs(200)) {
        const Jet jx(x, 1, 0, 0, 0, 0), jy(y, 0, 1, 0, 0, 0);
        const Nested nx = nested_variable(x, 0), ny = nested_variable(y, 1);
        const Jet ja = first_function(jx, jy), jb = second_function(jx, jy);
        const Nested na = first_function(nx, ny), nb = second_function(nx, ny);
        expect_same(ja, na, 1e-13);
        expect_same(jb, nb, 1e-13);
        // second derivatives grow with the inverse of the distance to the corner
        const double corner = std::hypot(ja.v, jb.v);
        for (const double alpha : {-0.5, 0.0, 0.5}) {
            expect_same(conjunction(ja, jb, alpha), conjunction(na, nb, alpha), 1e-12 / corner);
            expect_same(disjunction(ja, jb, alpha), disjunction(na, nb, alpha), 1e-12 / corner);
        }
    }
}

TEST(RFunctions, EquivalenceIsTheJoinOfRanks) {
    for (int m = 1; m <= 4; ++m)
        for (const auto& [x, y] : random_pairs(100)) {
            const std::vector<double> w{x, y, 0.7};
            const double expected =
                std::pow(std::pow(std::abs(x), -m) + std::pow(std::abs(y), -m) + std::pow(0.7, -m), -1.0 / m);
            const double joined = equivalence(std::span<const double>(w), m);
            EXPECT_NEAR(std::abs(joined), expected, 1e-14);
            const std::size_t nearest = nearest_to_zero(std::span<const double>(w));
            EXPECT_EQ(joined < 0, w[nearest] < 0);
            // associative
            const std::vector<double> pair{std::abs(x), std::abs(y)};
            const std::vector<double> nested{equivalence(std::span<const double>(pair), m), 0.7};
            EXPECT_NEAR(equivalence(std::span<const double>(nested), m), expected, 1e-14);
        }
}

TEST(RFunctions, EquivalenceIsNormalisedToItsOrder) {
    // w along a line across x = 0: 1st derivative 1, the 2nd to m-th 0
    for (int m = 2; m <= 4; ++m) {
        const std::vector<Jet> w{Jet(0, 1, 0, 0, 0, 0), Jet(0.3, 2, 1, 0.5, 0, 0)};
        const Jet joined = equivalence(std::span<const Jet>(w), m);
        EXPECT_EQ(joined.v, 0);
        EXPECT_EQ(joined.x, 1);
        EXPECT_EQ(joined.xx, 0);
    }
}

TEST(Jets, QuotientRootAndPowerAgreeWithEachOther) {
    for (const auto& [x, y] : random_pairs(100)) {
        const Jet jx(x, 1, 0, 0, 0, 0), jy(y, 0, 1, 0, 0, 0), a = 1 + jx * jx + jx * jy + jy * jy,
                                                              b = 2 + jx * jy * jy * jy * jy;
        const auto expect_equal = [&](const Jet& p, const Jet& q) {
            const double scale = 1e-12 * (1 + std::abs(q.v) + std::abs(q.xx) + std::abs(q.yy));
            EXPECT_NEAR(p.v, q.v, scale);
            EXPECT_NEAR(p.x, q.x, scale);
            EXPECT_NEAR(p.y, q.y, scale);
            EXPECT_NEAR(p.xx, q.xx, scale);
            EXPECT_NEAR(p.xy, q.xy, scale);
            EXPECT_NEAR(p.yy, q.yy, scale);
        };
        expect_equal(sqrt(a) * sqrt(a), a);
        expect_equal(pow(a, 1.5), a * sqrt(a));
        if (std::abs(b.v) > 0.1) expect_equal((a / b) * b, a);
    }
}

}  // namespace abut::geometry::r_functions_test
