// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

namespace abut::geometry {

/// Gauss-Legendre rule on [0, 1]: exact for polynomials of degree 2n - 1.
struct GaussRule {
    std::vector<double> points, weights;
};

inline constexpr int most_gauss_points = 128;

/// The rule of n points, 1 to most_gauss_points; computed at its first use, then shared. Safe to call from several threads.
const GaussRule& gauss_rule(int n);

}  // namespace abut::geometry
