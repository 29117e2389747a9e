// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/gauss.hpp"

#include <array>
#include <cmath>
#include <mutex>
#include <numbers>

#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

struct Legendre {
    double value, derivative;
};

Legendre legendre(int n, double x) {
    double previous = 1, current = x;
    for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * current - (k - 1) * previous) / k;
        previous = current;
        current = next;
    }
    return {current, n * (x * current - previous) / (x * x - 1)};
}

GaussRule make_rule(int n) {
    GaussRule rule{std::vector<double>(static_cast<std::size_t>(n)), std::vector<double>(static_cast<std::size_t>(n))};
    for (int i = 0; i < n; ++i) {
        // Tricomi's estimate is close enough for Newton to converge quadratically at once
        double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
        for (int step = 0; step < 8; ++step) {
            const Legendre p = legendre(n, x);
            x -= p.value / p.derivative;
        }
        const double d = legendre(n, x).derivative;
        rule.points[static_cast<std::size_t>(i)] = 0.5 * (1 + x);
        rule.weights[static_cast<std::size_t>(i)] = 1 / ((1 - x * x) * d * d);
    }
    if (n == 1) rule = {{0.5}, {1.0}};
    return rule;
}

}  // namespace

const GaussRule& gauss_rule(int n) {
    static std::array<GaussRule, most_gauss_points + 1> rules;
    static std::array<std::once_flag, most_gauss_points + 1> made;
    ENSURE(n >= 1 && n <= most_gauss_points, "a Gauss rule has 1 to 128 points");
    const auto k = static_cast<std::size_t>(n);
    std::call_once(made[k], [&] { rules[k] = make_rule(n); });
    return rules[k];
}

}  // namespace abut::geometry
