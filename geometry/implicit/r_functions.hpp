// SPDX-License-Identifier: GPL-3.0-or-later
// R-functions: Booleans of functions that are positive inside, zero on the boundary and negative outside [Grishin10, eq 3.3].
//
// alpha in (-1, 1]; 1 gives minimum and maximum. For alpha < 1 they are smooth except where both arguments vanish (corners).
// They keep the first order: where one argument vanishes and the other decides nothing, the result has the gradient of the
// argument that vanishes. Where both vanish together along a curve (two bodies with a common stretch of boundary) they do not:
// x and x give (2 - sqrt(2 - 2 alpha)) / (1 + alpha) x, and the union of two bodies that share an edge is 0 on that edge.
// They are commutative, not associative unless alpha = 1.
//
// The scalar T may be double, Jet (jet.hpp), or any other type for automatic differentiation with sqrt and comparisons.
#pragma once
#include <cmath>
#include <cstddef>
#include <span>

namespace abut::geometry {

template <class T>
T negation(const T& x) {
    return -x;
}

/// x and y: (x + y - sqrt(x^2 + y^2 - 2 alpha x y)) / (1 + alpha). Where the sum is positive in the form
/// 2 x y / (x + y + sqrt(...)), which is the same without cancellation: small values keep all their digits, and x = 0 gives 0.
template <class T>
T conjunction(const T& x, const T& y, double alpha) {
    using std::sqrt;
    const T sum = x + y;
    // (x - y)^2 + 2 (1 - alpha) x y: never below 0 by rounding where alpha is 1
    const T difference = x - y;
    const T root = sqrt(T(difference * difference + 2 * (1 - alpha) * (x * y)));
    if (sum > T(0)) return T(2 * (x * y) / (sum + root));
    return T((sum - root) / (1 + alpha));
}

/// x or y: (x + y + sqrt(x^2 + y^2 - 2 alpha x y)) / (1 + alpha).
template <class T>
T disjunction(const T& x, const T& y, double alpha) {
    return T(-conjunction(T(-x), T(-y), alpha));
}

/// x^m for small m >= 0.
template <class T>
T integer_power(const T& x, int m) {
    T power(1);
    for (int i = 0; i < m; ++i) power = T(power * x);
    return power;
}

/// The index of the number of smallest magnitude; the first of several.
template <class T>
std::size_t nearest_to_zero(std::span<const T> x) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < x.size(); ++i) {
        const T a = x[i] < T(0) ? T(-x[i]) : x[i], b = x[best] < T(0) ? T(-x[best]) : x[best];
        if (a < b) best = i;
    }
    return best;
}

/// "On x[0] or on x[1] or ...": (sum |x_i|^-m)^(-1/m), zero where one of them is, with the sign of the one nearest to zero;
/// m >= 1. It keeps their normalisation to order m [Biswas04], is associative, and smooth for even m except where
/// two vanish together; for odd m derivatives of order m jump where an argument changes sign.
template <class T>
T equivalence(std::span<const T> x, int m) {
    using std::pow;
    using std::sqrt;
    const std::size_t nearest = nearest_to_zero(x);
    T sum(1);
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i == nearest) continue;
        // a corner: 0, without derivatives
        if (!(x[i] < T(0) || x[i] > T(0))) return T(sqrt(T(x[i] * x[i])));
        T ratio(x[nearest] / x[i]);
        if (m % 2 == 1 && ratio < T(0)) ratio = T(-ratio);
        sum = T(sum + integer_power(ratio, m));
    }
    if (m == 1) return T(x[nearest] / sum);
    if (m == 2) return T(x[nearest] / sqrt(sum));
    return T(x[nearest] / pow(sum, 1.0 / m));
}

}  // namespace abut::geometry
