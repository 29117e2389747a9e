// SPDX-License-Identifier: GPL-3.0-or-later
// B-splines over integer knots. The geometry's own: it uses nothing of the solver's.
#pragma once
#include <array>

namespace abut::geometry {

inline constexpr int max_cardinal_degree = 8;

/// Values and first two derivatives of the splines that are not 0 around x: N_k(x) = B(x - k), with B on [0, degree + 1].
struct CardinalValues {
    int first = 0;  ///< k of the first of degree + 1
    std::array<double, max_cardinal_degree + 1> value{}, slope{}, bend{};
};

/// The splines around x, of a degree from 1 on. Their values sum to 1, slopes and bends to 0.
CardinalValues cardinal_splines(int degree, double x);

}  // namespace abut::geometry
