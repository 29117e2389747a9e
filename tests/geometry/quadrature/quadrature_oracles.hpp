// SPDX-License-Identifier: GPL-3.0-or-later
// Moments about an origin, in units of a scale: of segments and arcs in closed form by Green's theorem (the integral of
// u^(i+1) / (i+1) v^j dv), and of the points and weights of rules.
#pragma once
#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <variant>
#include <vector>

#include "geometry/quadrature/quadrature.hpp"
#include "tests/geometry/cells/random_grids.hpp"

namespace abut::geometry::test {

using Moments = Eigen::MatrixXd;  // (i, j): the integral of u^i v^j

struct LocalFrame {
    Vec2 origin, scale;
    Vec2 operator()(const Vec2& p) const { return (p - origin).cwiseQuotient(scale); }
};

/// Coefficients of t^k; about the segment's middle, where nothing cancels.
using Polynomial = std::vector<double>;

inline Polynomial times(const Polynomial& p, double constant, double slope) {
    Polynomial product(p.size() + 1, 0.0);
    for (std::size_t k = 0; k < p.size(); ++k) {
        product[k] += constant * p[k];
        product[k + 1] += slope * p[k];
    }
    return product;
}

/// Over t from -1/2 to 1/2.
inline double integral(const Polynomial& p) {
    double sum = 0;
    for (std::size_t k = 0; k < p.size(); k += 2)
        sum += p[k] * std::pow(0.5, static_cast<double>(k)) / static_cast<double>(k + 1);
    return sum;
}

inline Moments segment_moments(const Vec2& a, const Vec2& b, int degree) {
    Moments m(degree + 1, degree + 1);
    const Vec2 middle = 0.5 * (a + b), d = b - a;
    Polynomial power_u{1};
    for (int i = 0; i <= degree; ++i) {
        power_u = times(power_u, middle.x(), d.x());
        Polynomial product = power_u;
        for (int j = 0; j <= degree; ++j) {
            m(i, j) = integral(product) * d.y() / (i + 1);
            product = times(product, middle.y(), d.y());
        }
    }
    return m;
}

/// Coefficients of z^-n ... z^n with z = exp(i angle).
using Laurent = std::vector<std::complex<double>>;

/// Times (below / z + constant + above z).
inline Laurent times(const Laurent& p, std::complex<double> below, double constant, std::complex<double> above) {
    Laurent product(p.size() + 2, 0.0);
    for (std::size_t k = 0; k < p.size(); ++k) {
        product[k] += below * p[k];
        product[k + 1] += constant * p[k];
        product[k + 2] += above * p[k];
    }
    return product;
}

inline double integral(const Laurent& p, double from, double to) {
    const int n = static_cast<int>(p.size()) / 2;
    double sum = 0;
    for (int k = -n; k <= n; ++k) {
        const std::complex<double> ik(0, k);
        const std::complex<double> wave = k == 0 ? to - from : (std::exp(ik * to) - std::exp(ik * from)) / ik;
        sum += (p[static_cast<std::size_t>(k + n)] * wave).real();
    }
    return sum;
}

/// Of an arc in the frame, whose scale is the same both ways and not much below the radius: the coefficients grow as their
/// ratio.
inline Moments arc_moments(const Arc& arc, const LocalFrame& frame, int degree) {
    Moments m(degree + 1, degree + 1);
    const Vec2 center = frame(arc.center);
    const double half = 0.5 * arc.radius / frame.scale.x();
    const std::complex<double> i_half(0, half);
    Laurent power_u{1};
    for (int i = 0; i <= degree; ++i) {
        power_u = times(power_u, half, center.x(), half);
        Laurent product = times(power_u, half, 0, half);  // dv = r cos(angle) d(angle)
        for (int j = 0; j <= degree; ++j) {
            m(i, j) = integral(product, arc.start, arc.start + arc.sweep) / (i + 1);
            product = times(product, i_half, center.y(), -i_half);
        }
    }
    return m;
}

inline Moments part_moments(const Part& part, const LocalFrame& frame, int degree) {
    Moments sum = Moments::Zero(degree + 1, degree + 1);
    for (const Edge& e : part.edges) {
        const auto* arc = std::get_if<Arc>(&e.curve);
        sum += arc ? arc_moments(*arc, frame, degree)
                   : segment_moments(frame(point(e.curve, 0)), frame(point(e.curve, 1)), degree);
    }
    return sum;
}

// ---- moments by the rules ----

inline Eigen::VectorXd powers(double x, int degree) {
    Eigen::VectorXd p(degree + 1);
    p[0] = 1;
    for (int k = 1; k <= degree; ++k) p[k] = x * p[k - 1];
    return p;
}

inline Moments rule_moments(const CellRule& rule, const LocalFrame& frame, int degree) {
    Moments sum = Moments::Zero(degree + 1, degree + 1);
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
        const Vec2 p = frame(rule.points[q]);
        sum += rule.weights[q] / frame.scale.prod() * powers(p.x(), degree) * powers(p.y(), degree).transpose();
    }
    return sum;
}

/// The cell as the unit square: moments are then fractions of the cell.
inline LocalFrame unit_frame(const Grid& grid, int cell) {
    const Box2 b = box_of(grid, cell);
    return {b.min, b.size()};
}

inline double worst_of(const Moments& difference) {
    return difference.cwiseAbs().maxCoeff();
}

}  // namespace abut::geometry::test
