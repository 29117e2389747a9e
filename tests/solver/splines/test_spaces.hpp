// SPDX-License-Identifier: GPL-3.0-or-later
// Small parts for the tests of the solver: unions of axis-parallel boxes on a grid, so that full and cut cells are integrated
// by Gauss rules on rectangles and nothing of geometry/ is needed.
#pragma once
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "solver/parts/part_system.hpp"

namespace abut::solver::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Gauss-Legendre rule on [0, 1] from the eigenvalues of the Jacobi matrix (Golub and Welsch 1969).
inline LineRule gauss(int n) {
    MatrixXd jacobi = MatrixXd::Zero(n, n);
    for (int k = 1; k < n; ++k) jacobi(k, k - 1) = k / std::sqrt(4.0 * k * k - 1);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(jacobi);
    LineRule rule;
    for (int k = 0; k < n; ++k) {
        rule.points.push_back(0.5 * (1 + eigen.eigenvalues()[k]));
        rule.weights.push_back(std::pow(eigen.eigenvectors()(0, k), 2));
    }
    return rule;
}

/// Grid lines from a to b: equal cells, or cells whose sides differ by up to a factor of three.
inline std::vector<double> grid_lines(double a, double b, int cells, bool uniform) {
    std::vector<double> step;
    for (int k = 0; k < cells; ++k) step.push_back(uniform ? 1.0 : 2 + std::cos(2.4 * k));
    double total = 0;
    for (double s : step) total += s;
    std::vector<double> lines{a};
    for (double s : step) lines.push_back(lines.back() + (b - a) * s / total);
    lines.back() = b;
    return lines;
}

struct Box {
    double x0, y0, x1, y1;
    double area() const { return (x1 - x0) * (y1 - y0); }
};

struct SpaceCase {
    int degree;
    bool uniform;
    Basis basis;
};
inline std::string name_of(const SpaceCase& c) {
    return "degree" + std::to_string(c.degree) + (c.uniform ? "_uniform" : "_graded") +
           (c.basis == Basis::web ? "_web" : "_plain");
}
inline std::vector<SpaceCase> all_space_cases() {
    std::vector<SpaceCase> cases;
    for (int degree = 1; degree <= 4; ++degree)
        for (bool uniform : {true, false})
            for (Basis basis : {Basis::plain, Basis::web}) cases.push_back({degree, uniform, basis});
    return cases;
}

inline std::vector<Vec2> rule_points(const Box& b, const LineRule& rule, std::vector<double>& weights) {
    std::vector<Vec2> points;
    for (std::size_t j = 0; j < rule.points.size(); ++j)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            points.emplace_back(b.x0 + rule.points[i] * (b.x1 - b.x0), b.y0 + rule.points[j] * (b.y1 - b.y0));
            weights.push_back(rule.weights[i] * rule.weights[j] * b.area());
        }
    return points;
}

/// The part of a box in one cell of a grid; without area where they do not meet.
inline Box in_cell(const Box& b, const std::vector<double>& x, const std::vector<double>& y, std::size_t c, std::size_t r) {
    const double x0 = std::max(b.x0, x[c]), y0 = std::max(b.y0, y[r]);
    return {x0, y0, std::max(x0, std::min(b.x1, x[c + 1])), std::max(y0, std::min(b.y1, y[r + 1]))};
}

/// A part made of boxes that do not overlap, with rules of the given order (0: degree + 1) on its cells.
inline PartInput part_of(const std::vector<Box>& boxes, const std::vector<double>& x, const std::vector<double>& y, int degree,
                         Basis basis, const Elasticity& elasticity = plane_stress(1000, 0.3), double thickness = 1,
                         int order = 0) {
    const LineRule line = gauss(order > 0 ? order : degree + 1);
    std::vector<double> fraction;
    std::vector<CellRule> cut;
    for (std::size_t r = 0; r + 1 < y.size(); ++r)
        for (std::size_t c = 0; c + 1 < x.size(); ++c) {
            CellRule rule{static_cast<int>(fraction.size()), {}, {}};
            double filled = 0;
            for (const Box& box : boxes) {
                const Box piece = in_cell(box, x, y, c, r);
                if (piece.area() <= 0) continue;
                filled += piece.area() / ((x[c + 1] - x[c]) * (y[r + 1] - y[r]));
                const std::vector<Vec2> points = rule_points(piece, line, rule.weights);
                rule.points.insert(rule.points.end(), points.begin(), points.end());
            }
            const bool full = filled > 1 - 1e-12;
            fraction.push_back(full ? 1 : filled);
            if (filled > 0 && !full) cut.push_back(rule);
        }
    return {make_space(x, y, degree, degree, fraction, basis), cut, line, elasticity, thickness};
}

/// The contract tests' part: 5 x 4 cells, the upper right row and column of cells cut (slivers of 3 % and 10 %), an L with a
/// notch in the upper right corner.
inline std::vector<Box> ell_boxes(const std::vector<double>& x, const std::vector<double>& y) {
    const double right = x[4] + 0.03 * (x[5] - x[4]), top = y[3] + 0.1 * (y[4] - y[3]), notch = x[2] + 0.4 * (x[3] - x[2]);
    return {{x[0], y[0], right, y[2]}, {x[0], y[2], notch, top}};
}
inline PartInput ell(const SpaceCase& c, const Elasticity& elasticity = plane_stress(1000, 0.3), double thickness = 1) {
    const std::vector<double> x = grid_lines(-0.4, 1.7, 5, c.uniform), y = grid_lines(0.3, 1.9, 4, c.uniform);
    return part_of(ell_boxes(x, y), x, y, c.degree, c.basis, elasticity, thickness);
}
inline std::vector<Box> ell_boxes(const PartInput& part) {
    return ell_boxes(part.space.x.breakpoints, part.space.y.breakpoints);
}

inline PartInput rectangle(double width, double height, int nx, int ny, int degree, bool uniform = true,
                           const Elasticity& elasticity = plane_stress(1000, 0.3), double thickness = 1) {
    return part_of({{0, 0, width, height}}, grid_lines(0, width, nx, uniform), grid_lines(0, height, ny, uniform), degree,
                   Basis::web, elasticity, thickness);
}

/// Gauss points of every cell that holds a piece of the part: f(cell, point, weight).
inline void for_points(const PartInput& part, const std::vector<Box>& boxes, int order,
                       const std::function<void(int, const Vec2&, double)>& f) {
    const std::vector<double>&x = part.space.x.breakpoints, &y = part.space.y.breakpoints;
    for (std::size_t r = 0; r + 1 < y.size(); ++r)
        for (std::size_t c = 0; c + 1 < x.size(); ++c)
            for (const Box& box : boxes) {
                const Box piece = in_cell(box, x, y, c, r);
                if (piece.area() <= 0) continue;
                std::vector<double> weights;
                const std::vector<Vec2> points = rule_points(piece, gauss(order), weights);
                for (std::size_t k = 0; k < points.size(); ++k)
                    f(static_cast<int>(r * (x.size() - 1) + c), points[k], weights[k]);
            }
}

struct EdgePoint {
    int element;
    Vec2 x;
    double weight;
};

/// Gauss points along an axis-parallel segment, cell by cell of the grid; cells are looked up slightly inside, against the
/// normal.
inline std::vector<EdgePoint> edge_points(const SplineSpace& s, const Vec2& from, const Vec2& to, const Vec2& normal,
                                          int order) {
    const int along = std::abs(to.x() - from.x()) > std::abs(to.y() - from.y()) ? 0 : 1;
    std::vector<double> cuts{from[along], to[along]};
    for (double line : (along == 0 ? s.x : s.y).breakpoints)
        if ((line - from[along]) * (line - to[along]) < 0) cuts.push_back(line);
    std::sort(cuts.begin(), cuts.end());
    const LineRule rule = gauss(order);
    std::vector<EdgePoint> points;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            Vec2 x = from;
            x[along] = cuts[k] + rule.points[i] * (cuts[k + 1] - cuts[k]);
            points.push_back({s.cell_at(x - 1e-9 * normal), x, rule.weights[i] * (cuts[k + 1] - cuts[k])});
        }
    return points;
}

inline std::vector<TractionPoint> traction_on(const SplineSpace& s, const Vec2& from, const Vec2& to, const Vec2& normal,
                                              const std::function<Vec2(const Vec2&)>& traction) {
    std::vector<TractionPoint> points;
    for (const EdgePoint& p : edge_points(s, from, to, normal, s.x.degree + 2))
        points.push_back({p.element, p.x, p.weight, traction(p.x)});
    return points;
}

/// Holds direction . u = value(x) along a segment, by Nitsche's method unless a side is set afterwards.
inline SupportSet support_on(
    const SplineSpace& s, const Vec2& from, const Vec2& to, const Vec2& normal, const Vec2& direction,
    const std::function<double(const Vec2&)>& value = [](const Vec2&) { return 0.0; }) {
    SupportSet set;
    for (const EdgePoint& p : edge_points(s, from, to, normal, s.x.degree + 2))
        set.points.push_back({p.element, p.x, normal, direction, p.weight, value(p.x)});
    return set;
}

/// One component of a rectangle's whole side, on the grid's outermost line.
inline SupportSet side_support(const SplineSpace& s, GridSide side, int component, double value = 0) {
    const double x0 = s.x.breakpoints.front(), x1 = s.x.breakpoints.back(), y0 = s.y.breakpoints.front(),
                 y1 = s.y.breakpoints.back();
    const bool vertical = side == GridSide::left || side == GridSide::right;
    const bool low = side == GridSide::left || side == GridSide::bottom;
    const Vec2 normal = (low ? -1 : 1) * (vertical ? Vec2(1, 0) : Vec2(0, 1));
    const Vec2 from(vertical && !low ? x1 : x0, !vertical && !low ? y1 : y0),
        to(vertical && low ? x0 : x1, !vertical && low ? y0 : y1);
    SupportSet set =
        support_on(s, from, to, normal, component == 0 ? Vec2(1, 0) : Vec2(0, 1), [&](const Vec2&) { return value; });
    set.side = side;
    set.component = component;
    set.value = value;
    set.stretches = {vertical ? Stretch{y0, y1} : Stretch{x0, x1}};
    return set;
}
inline SupportSet by_nitsche(SupportSet set) {
    set.side.reset();
    return set;
}

inline Vec2 middle_of(const PartInput& part) {
    const auto &x = part.space.x.breakpoints, &y = part.space.y.breakpoints;
    return {0.5 * (x.front() + x.back()), 0.5 * (y.front() + y.back())};
}
inline double size_of(const PartInput& part) {
    const auto &x = part.space.x.breakpoints, &y = part.space.y.breakpoints;
    return std::hypot(x.back() - x.front(), y.back() - y.front());
}
inline PartSystem system_of(const PartInput& part, const std::vector<SupportSet>& supports, const VectorXd& applied) {
    return make_part_system(part, supports, applied, middle_of(part), size_of(part));
}

/// The whole matrix, by its columns.
inline MatrixXd dense(const BlockMatrix& a) {
    MatrixXd m(2 * a.n, 2 * a.n);
    for (Index k = 0; k < m.cols(); ++k) m.col(k) = multiply(a, VectorXd::Unit(2 * a.n, k));
    return m;
}

/// Coefficients of the monomial t^power: blossoms at the inner knots, mean products of `power` of them.
inline double monomial_coefficient(const KnotVector& knots, int function, int power) {
    std::vector<double> symmetric{1};  // elementary symmetric polynomials of the knots so far
    double choose = 1;
    for (int k = 1; k <= knots.degree; ++k) {
        const double t = knots.knots[static_cast<std::size_t>(function + k)];
        symmetric.push_back(0);
        for (std::size_t e = symmetric.size() - 1; e > 0; --e) symmetric[e] += t * symmetric[e - 1];
    }
    for (int k = 0; k < power; ++k) choose *= static_cast<double>(knots.degree - k) / (k + 1);
    return symmetric[static_cast<std::size_t>(power)] / choose;
}

/// Coefficients, function by function of the space, of x^a y^b.
inline VectorXd monomial(const SplineSpace& s, int a, int b) {
    VectorXd c(s.n_functions);
    for (int f = 0; f < s.n_functions; ++f) {
        const int tensor = s.tensor_of[static_cast<std::size_t>(f)], nx = s.x.n_functions();
        c[f] = monomial_coefficient(s.x, tensor % nx, a) * monomial_coefficient(s.y, tensor / nx, b);
    }
    return c;
}

/// Displacement coefficients from those of its two components.
inline VectorXd interleave(const VectorXd& x, const VectorXd& y) {
    VectorXd u(2 * x.size());
    for (Index k = 0; k < x.size(); ++k) u.segment<2>(2 * k) = Vec2(x[k], y[k]);
    return u;
}

inline double value_at(const SplineSpace& s, const VectorXd& c, int cell, const Vec2& x) {
    const PointBasis b = evaluate(s, cell, x);
    double sum = 0;
    for (std::size_t i = 0; i < b.functions.size(); ++i) sum += b.value[static_cast<Index>(i)] * c[b.functions[i]];
    return sum;
}

/// Largest entry of a difference, relative to the largest entry of the reference.
template <class A, class B>
double relative_difference(const A& a, const B& reference) {
    return (a - reference).cwiseAbs().maxCoeff() / reference.cwiseAbs().maxCoeff();
}

}  // namespace abut::solver::test
