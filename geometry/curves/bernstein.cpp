// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/bernstein.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/curves/numbers.hpp"

namespace abut::geometry {

namespace {

/// The polynomial over [a, b] with a running bound of what rounding did to each coefficient.
struct PolynomialPiece {
    double a, b;
    std::vector<double> coefficients, errors;
};

/// Where the polynomial vanishes: a point, or a stretch on which it cannot be told from zero.
struct Zero {
    double a, b;
};

/// -1, 0, 1; zero as far as the coefficient is known.
int coefficient_sign(const PolynomialPiece& piece, std::size_t i) {
    const double c = piece.coefficients[i];
    return std::abs(c) <= piece.errors[i] ? 0 : c < 0 ? -1 : 1;
}

int first_sign(const PolynomialPiece& piece) {
    for (std::size_t i = 0; i < piece.coefficients.size(); ++i)
        if (const int s = coefficient_sign(piece, i)) return s;
    return 0;
}

int sign_changes(const PolynomialPiece& piece) {
    int changes = 0, last = 0;
    for (std::size_t i = 0; i < piece.coefficients.size(); ++i) {
        const int s = coefficient_sign(piece, i);
        if (s != 0 && s == -last) ++changes;
        if (s != 0) last = s;
    }
    return changes;
}

/// Both halves; the right one stays in `piece`. Each mean adds half a rounding to the mean of the errors.
PolynomialPiece take_left_half(PolynomialPiece& piece) {
    std::vector<double>&c = piece.coefficients, &e = piece.errors;
    const double middle = 0.5 * (piece.a + piece.b);
    PolynomialPiece left{piece.a, middle, {c.front()}, {e.front()}};
    for (std::size_t n = c.size() - 1; n > 0; --n) {
        for (std::size_t i = 0; i < n; ++i) {
            c[i] = 0.5 * (c[i] + c[i + 1]);
            e[i] = 0.5 * (e[i] + e[i + 1]) + 0.5 * epsilon * std::abs(c[i]);
        }
        left.coefficients.push_back(c.front());
        left.errors.push_back(e.front());
    }
    piece.a = middle;
    return left;
}

/// The one sign change in (a, b); `sign_at_a` is the sign just right of a. Regula falsi that halves the value of an end that
/// stays (Illinois), and a bisection every third step, so that it always ends.
double bisected(const std::vector<double>& c, double a, double b, int sign_at_a) {
    double value_a = sign_at_a * std::abs(bernstein_value(c, a)), value_b = -sign_at_a * std::abs(bernstein_value(c, b));
    int stayed = 0;
    for (int step = 0;; ++step) {
        const double middle = 0.5 * (a + b);
        if (!(a < middle && middle < b)) return middle;
        const double secant = a - value_a * (b - a) / (value_b - value_a);
        const double t = step % 3 != 2 && a < secant && secant < b ? secant : middle;
        const double value = bernstein_value(c, t);
        if (value == 0) return t;
        const int side = (value < 0 ? -1 : 1) == sign_at_a ? 1 : -1;
        (side == 1 ? a : b) = t;
        (side == 1 ? value_a : value_b) = value;
        if (stayed == side) (side == 1 ? value_b : value_a) *= 0.5;
        stayed = side;
    }
}

void collect_zeros(PolynomialPiece piece, const std::vector<double>& c, int halvings, std::vector<Zero>& zeros) {
    const int changes = sign_changes(piece);
    if (coefficient_sign(piece, 0) == 0) zeros.push_back({piece.a, piece.a});
    if (changes == 1) {
        const double root = bisected(c, piece.a, piece.b, first_sign(piece));
        zeros.push_back({root, root});
    } else if (first_sign(piece) == 0 || (changes > 1 && halvings == most_parameter_halvings)) {
        zeros.push_back({piece.a, piece.b});
    } else if (changes > 1) {
        PolynomialPiece left = take_left_half(piece);
        collect_zeros(std::move(left), c, halvings + 1, zeros);
        collect_zeros(std::move(piece), c, halvings + 1, zeros);
    }
}

}  // namespace

double bernstein_value(const std::vector<double>& coefficients, double t) {
    std::vector<double> c = coefficients;
    for (std::size_t n = c.size() - 1; n > 0; --n)
        for (std::size_t i = 0; i < n; ++i) c[i] = (1 - t) * c[i] + t * c[i + 1];
    return c.front();
}

std::vector<double> bernstein_roots(const std::vector<double>& coefficients, const std::vector<double>& errors) {
    PolynomialPiece all{0, 1, coefficients, errors};
    if (errors.empty()) all.errors.assign(coefficients.size(), 0.0);
    if (coefficients.empty() || first_sign(all) == 0) return {};
    std::vector<Zero> zeros;
    const bool ends_in_zero = coefficient_sign(all, coefficients.size() - 1) == 0;
    collect_zeros(std::move(all), coefficients, 0, zeros);
    if (ends_in_zero) zeros.push_back({1, 1});
    std::vector<double> roots;
    for (std::size_t i = 0; i < zeros.size();) {
        Zero zero = zeros[i++];
        while (i < zeros.size() && zeros[i].a <= zero.b) zero.b = std::max(zero.b, zeros[i++].b);
        roots.push_back(zero.a == zero.b ? zero.a : 0.5 * (zero.a + zero.b));
    }
    return roots;
}

}  // namespace abut::geometry
