// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/rule_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abut::geometry {

namespace {

constexpr int most_degree = 64;  // of a Legendre polynomial; beyond, the check uses this degree

/// Values of the Legendre polynomials up to `degree`, one more for antiderivatives.
using Values = std::array<double, most_degree + 2>;

/// Of the recurrence P_k+1 = above_k u P_k - below_k P_k-1.
struct Recurrence {
    Values above{}, below{};
};

Recurrence recurrence(int degree) {
    Recurrence r;
    for (int k = 1; k <= degree; ++k) {
        r.above[static_cast<std::size_t>(k)] = (2.0 * k + 1) / (k + 1);
        r.below[static_cast<std::size_t>(k)] = static_cast<double>(k) / (k + 1);
    }
    return r;
}

double antiderivative(const Values& p, int k) {
    const auto i = static_cast<std::size_t>(k);
    return k == 0 ? p[1] : (p[i + 1] - p[i - 1]) / (2 * k + 1);
}

/// The integrands P_a(u) P_b(v), (u, v) in [-1, 1]^2.
struct Fields {
    Vec2 center, half;
    int degree;
    Recurrence legendre;
    std::array<std::array<int, 2>, 6> degrees;
    Vec2 local(const Vec2& p) const { return (p - center).cwiseQuotient(half); }
};
using Sums = std::array<double, 6>;

/// Over the grid's box: rules may have points outside the part, where a polynomial of its box alone would be large.
Fields make_fields(const Grid& grid, int degree) {
    const Box2 box = grid.box();
    const int m = std::min(2 * degree, most_degree);
    return {box.center(), 0.5 * box.size(), m, recurrence(m), {{{0, 0}, {1, 0}, {0, 1}, {m, 0}, {0, m}, {m, m}}}};
}

void fill(Values& p, const Fields& fields, double u) {
    p[0] = 1;
    p[1] = u;
    for (std::size_t k = 1; k <= static_cast<std::size_t>(fields.degree); ++k)
        p[k + 1] = fields.legendre.above[k] * u * p[k] - fields.legendre.below[k] * p[k - 1];
}

void add_point(Sums& sums, const Fields& fields, const Vec2& x, double weight) {
    Values p, q;
    const Vec2 u = fields.local(x);
    fill(p, fields, u.x());
    fill(q, fields, u.y());
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const auto [a, b] = fields.degrees[k];
        sums[k] += weight * p[static_cast<std::size_t>(a)] * q[static_cast<std::size_t>(b)];
    }
}

/// Exactly.
void add_box(Sums& sums, const Fields& fields, const Box2& box) {
    Values p0, p1, q0, q1;
    const Vec2 low = fields.local(box.min), high = fields.local(box.max);
    fill(p0, fields, low.x());
    fill(p1, fields, high.x());
    fill(q0, fields, low.y());
    fill(q1, fields, high.y());
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const auto [a, b] = fields.degrees[k];
        sums[k] += fields.half.prod() * (antiderivative(p1, a) - antiderivative(p0, a)) *
                   (antiderivative(q1, b) - antiderivative(q0, b));
    }
}

/// Inner cells beside each other as one box.
void add_inner_cells(Sums& sums, const Fields& fields, const CutCells& cells) {
    const Grid& grid = cells.grid;
    if (grid.tree) {
        for (int cell = 0; cell < grid.n_cells(); ++cell)
            if (cells.cell_class[static_cast<std::size_t>(cell)] == CellClass::inner) add_box(sums, fields, grid.box(cell));
        return;
    }
    const auto is_inner = [&](int column, int row) {
        return cells.cell_class[static_cast<std::size_t>(grid.cell(column, row))] == CellClass::inner;
    };
    for (int row = 0; row < grid.rows(); ++row)
        for (int column = 0; column < grid.columns(); ++column) {
            if (!is_inner(column, row)) continue;
            const auto i = static_cast<std::size_t>(column), j = static_cast<std::size_t>(row);
            while (column + 1 < grid.columns() && is_inner(column + 1, row)) ++column;
            add_box(sums, fields, {{grid.x[i], grid.y[j]}, {grid.x[static_cast<std::size_t>(column) + 1], grid.y[j + 1]}});
        }
}

/// Fluxes of (antiderivative by x, 0) and of (0, antiderivative by y): each has the integrand as its divergence.
void add_flux(Sums& by_x, Sums& by_y, const Fields& fields, const BoundaryPoint& point) {
    Values p, q;
    const Vec2 u = fields.local(point.x);
    fill(p, fields, u.x());
    fill(q, fields, u.y());
    for (std::size_t k = 0; k < by_x.size(); ++k) {
        const auto [a, b] = fields.degrees[k];
        by_x[k] += point.weight * point.normal.x() * fields.half.x() * antiderivative(p, a) * q[static_cast<std::size_t>(b)];
        by_y[k] += point.weight * point.normal.y() * fields.half.y() * p[static_cast<std::size_t>(a)] * antiderivative(q, b);
    }
}

void add_rule(RuleCheck& check, Sums& sums, const Fields& fields, const CellRule& rule, const Box2& cell, double merge) {
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
        const Vec2& p = rule.points[q];
        add_point(sums, fields, p, rule.weights[q]);
        check.negative_weights += rule.weights[q] < 0;
        check.outside_cell += !cell.overlaps({p, p}, merge);
    }
    check.points += rule.points.size();
}

}  // namespace

RuleCheck check_rules(const Part& part, const CutCells& cells, const Elements& elements, const std::vector<CellRule>& rules,
                      int degree) {
    const Fields fields = make_fields(cells.grid, degree);
    RuleCheck check;
    Sums volume{}, by_x{}, by_y{};
    for (const CellRule& rule : rules)
        add_rule(check, volume, fields, rule, cells.grid.box(elements.cell_of(rule.element)), cells.merge);
    add_inner_cells(volume, fields, cells);
    for (std::size_t e = 0; e < part.edges.size(); ++e)
        for (const BoundaryPoint& p : boundary_rule(part, cells, static_cast<int>(e), 0, 1, fields.degree + 1))
            add_flux(by_x, by_y, fields, p);
    const double whole = area(part);
    check.area = std::abs(volume[0] - whole) / whole;
    const Vec2 middle = fields.center + Vec2(volume[1], volume[2]).cwiseProduct(fields.half) / volume[0];
    check.centroid = (middle - centroid(part)).norm() / (2 * fields.half.norm());
    for (std::size_t k = 0; k < volume.size(); ++k)
        for (double flux : {by_x[k], by_y[k]})
            check.divergence = std::max(check.divergence, std::abs(volume[k] - flux) / whole);
    return check;
}

}  // namespace abut::geometry
