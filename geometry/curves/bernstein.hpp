// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials on [0, 1] by their Bernstein coefficients: as many roots as the coefficients change sign, or an even number less.
#pragma once
#include <limits>
#include <vector>

namespace abut::geometry {

/// The value of the polynomial at t.
double bernstein_value(const std::vector<double>& coefficients, double t);

/// The places in [0, 1] where the polynomial changes sign, ascending, and 0 or 1 where it is zero there: found by halving until
/// the coefficients change sign once, then narrowed down to neighbouring doubles. `errors` bounds the absolute error of each
/// coefficient (empty: they are exact): what cannot be told from zero counts as zero. Of a root of odd multiplicity one or more
/// are given, all within the stretch over which rounding smears it; of one of even multiplicity (the polynomial touches zero
/// without crossing it) also none. A polynomial that is zero throughout has no roots. Cost: about degree^2 operations for each
/// halving, up to most_parameter_halvings for a multiple root.
std::vector<double> bernstein_roots(const std::vector<double>& coefficients, const std::vector<double>& errors = {});

/// Halvings of [0, 1] after which neighbouring parameters near 1 are one.
inline constexpr int most_parameter_halvings = std::numeric_limits<double>::digits - 1;

}  // namespace abut::geometry
