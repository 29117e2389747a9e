// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: N local B-splines of a cell, gx and gy their derivatives; axx, ayy, axy the integrals of gx gx', gy gy', gx gy'.
#include "solver/assembly.hpp"

#include <utility>

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Integrals over one cell from which the stiffness of an isotropic material follows.
struct CellIntegrals {
    MatrixXd axx, ayy, axy;
};

/// Integrals of N N', N_x N_x' and N_x N' of the univariate functions of one interval.
struct LineIntegrals {
    MatrixXd mass, stiffness, mixed;
};

LineIntegrals line_integrals(const KnotVector& knots, int interval, const LineRule& rule) {
    const Index n = knots.degree + 1;
    LineIntegrals m{MatrixXd::Zero(n, n), MatrixXd::Zero(n, n), MatrixXd::Zero(n, n)};
    const double a = knots.breakpoints[static_cast<std::size_t>(interval)];
    const double h = knots.breakpoints[static_cast<std::size_t>(interval) + 1] - a;
    for (std::size_t k = 0; k < rule.points.size(); ++k) {
        LocalValues v, g;
        evaluate(knots, interval, a + rule.points[k] * h, v, g);
        const Eigen::Map<const VectorXd> value(v.data(), n), slope(g.data(), n);
        const double w = rule.weights[k] * h;
        m.mass += w * value * value.transpose();
        m.stiffness += w * slope * slope.transpose();
        m.mixed += w * slope * value.transpose();
    }
    return m;
}

CellIntegrals product(const LineIntegrals& x, const LineIntegrals& y) {
    const Index p = x.mass.rows(), q = y.mass.rows(), n = p * q;
    CellIntegrals c{MatrixXd(n, n), MatrixXd(n, n), MatrixXd(n, n)};
    for (Index b = 0; b < q; ++b)
        for (Index a = 0; a < q; ++a) {
            c.axx.block(a * p, b * p, p, p) = y.mass(a, b) * x.stiffness;
            c.ayy.block(a * p, b * p, p, p) = y.stiffness(a, b) * x.mass;
            c.axy.block(a * p, b * p, p, p) = y.mixed(b, a) * x.mixed;
        }
    return c;
}

/// Values and derivatives of a cell's local B-splines at the points of a rule: (points x n_local).
struct Sampled {
    MatrixXd value, dx, dy;
};

Sampled sample(const SplineSpace& s, int cell, const std::vector<Vec2>& points) {
    const int c = cell % s.columns(), r = cell / s.columns();
    const Index p = s.x.degree + 1, q = s.y.degree + 1, n = static_cast<Index>(points.size());
    Sampled out{MatrixXd(n, p * q), MatrixXd(n, p * q), MatrixXd(n, p * q)};
    for (Index k = 0; k < n; ++k) {
        LocalValues vx, gx, vy, gy;
        evaluate(s.x, c, points[static_cast<std::size_t>(k)].x(), vx, gx);
        evaluate(s.y, r, points[static_cast<std::size_t>(k)].y(), vy, gy);
        const Eigen::Map<const Eigen::RowVectorXd> x(vx.data(), p), xd(gx.data(), p);
        for (Index b = 0; b < q; ++b) {
            const double y = vy[static_cast<std::size_t>(b)], yd = gy[static_cast<std::size_t>(b)];
            out.value.row(k).segment(b * p, p) = y * x;
            out.dx.row(k).segment(b * p, p) = y * xd;
            out.dy.row(k).segment(b * p, p) = yd * x;
        }
    }
    return out;
}

Eigen::Map<const VectorXd> as_vector(const std::vector<double>& v) {
    return {v.data(), static_cast<Index>(v.size())};
}

CellIntegrals cut_integrals(const SplineSpace& space, const CellRule& rule) {
    const Sampled s = sample(space, rule.cell, rule.points);
    const auto w = as_vector(rule.weights);
    const MatrixXd wx = w.asDiagonal() * s.dx, wy = w.asDiagonal() * s.dy;
    return {s.dx.transpose() * wx, s.dy.transpose() * wy, s.dx.transpose() * wy};
}

void add_to_functions(MatrixXd& m, const Extraction& e) {
    if (!e.identity) m = e.matrix.transpose() * m * e.matrix;
}

void scatter(BlockMatrix& k, const std::vector<int>& f, const CellIntegrals& c, const Elasticity& d, double thickness) {
    const auto n = static_cast<Index>(f.size());
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
            const int row = f[static_cast<std::size_t>(i)], col = f[static_cast<std::size_t>(j)];
            if (col > row) continue;
            Eigen::Matrix2d b;
            b << d.d11 * c.axx(i, j) + d.d33 * c.ayy(i, j), d.d12 * c.axy(i, j) + d.d33 * c.axy(j, i),
                d.d12 * c.axy(j, i) + d.d33 * c.axy(i, j), d.d11 * c.ayy(i, j) + d.d33 * c.axx(i, j);
            k.at(row, col) += thickness * b;
        }
}

bool is_full(const SplineSpace& s, int cell) {
    return s.fraction[static_cast<std::size_t>(cell)] == 1;
}

/// Calls f(cell) for every cell that is wholly inside.
template <class F>
void for_full_cells(const SplineSpace& s, F f) {
    for (int cell = 0; cell < s.columns() * s.rows(); ++cell)
        if (is_full(s, cell)) f(cell);
}

std::vector<Vec2> tensor_points(const SplineSpace& s, int cell, const LineRule& rule, std::vector<double>& weights) {
    const auto c = static_cast<std::size_t>(cell % s.columns()), r = static_cast<std::size_t>(cell / s.columns());
    const double x0 = s.x.breakpoints[c], hx = s.x.breakpoints[c + 1] - x0;
    const double y0 = s.y.breakpoints[r], hy = s.y.breakpoints[r + 1] - y0;
    std::vector<Vec2> points;
    weights.clear();
    for (std::size_t j = 0; j < rule.points.size(); ++j)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            points.emplace_back(x0 + rule.points[i] * hx, y0 + rule.points[j] * hy);
            weights.push_back(rule.weights[i] * rule.weights[j] * hx * hy);
        }
    return points;
}

/// Calls f(cell, points, weights) for every cell of the part.
template <class F>
void for_all_cells(const PartInput& input, F f) {
    std::vector<double> weights;
    for_full_cells(input.space, [&](int cell) {
        const std::vector<Vec2> points = tensor_points(input.space, cell, input.line_rule, weights);
        f(cell, points, weights);
    });
    for (const CellRule& rule : input.cut_rules) f(rule.cell, rule.points, rule.weights);
}

void add_at(VectorXd& to, const Extraction& e, const VectorXd& local) {
    const VectorXd v = e.identity ? local : VectorXd(e.matrix.transpose() * local);
    for (std::size_t i = 0; i < e.functions.size(); ++i) to[e.functions[i]] += v[static_cast<Index>(i)];
}

}  // namespace

BlockMatrix assemble_stiffness(const PartInput& input) {
    const SplineSpace& s = input.space;
    std::vector<int> cells;
    for_full_cells(s, [&](int cell) { cells.push_back(cell); });
    for (const CellRule& rule : input.cut_rules) cells.push_back(rule.cell);
    std::vector<Extraction> extractions;
    std::vector<std::vector<int>> coupled;
    for (int cell : cells) {
        extractions.push_back(extraction(s, cell));
        coupled.push_back(extractions.back().functions);
    }
    BlockMatrix k = make_block_matrix(s.n_functions, coupled);

    std::vector<LineIntegrals> x, y;
    for (int i = 0; i < s.columns(); ++i) x.push_back(line_integrals(s.x, i, input.line_rule));
    for (int i = 0; i < s.rows(); ++i) y.push_back(line_integrals(s.y, i, input.line_rule));
    const std::size_t n_full = cells.size() - input.cut_rules.size();
    for (std::size_t i = 0; i < cells.size(); ++i) {
        CellIntegrals c = i < n_full ? product(x[static_cast<std::size_t>(cells[i] % s.columns())],
                                               y[static_cast<std::size_t>(cells[i] / s.columns())])
                                     : cut_integrals(s, input.cut_rules[i - n_full]);
        for (MatrixXd* m : {&c.axx, &c.ayy, &c.axy}) add_to_functions(*m, extractions[i]);
        scatter(k, extractions[i].functions, c, input.elasticity, input.thickness);
    }
    return k;
}

FunctionIntegrals integrate_functions(const PartInput& input) {
    const SplineSpace& s = input.space;
    FunctionIntegrals f{VectorXd::Zero(s.n_functions), VectorXd::Zero(s.n_functions), VectorXd::Zero(s.n_functions)};
    for_all_cells(input, [&](int cell, const std::vector<Vec2>& points, const std::vector<double>& weights) {
        const Sampled at = sample(s, cell, points);
        const Extraction e = extraction(s, cell);
        const auto w = as_vector(weights);
        add_at(f.value, e, at.value.transpose() * w);
        add_at(f.dx, e, at.dx.transpose() * w);
        add_at(f.dy, e, at.dy.transpose() * w);
    });
    return f;
}

VectorXd body_load(const PartInput& input, const std::function<Vec2(const Vec2&)>& force) {
    const SplineSpace& s = input.space;
    VectorXd fx = VectorXd::Zero(s.n_functions), fy = fx;
    for_all_cells(input, [&](int cell, const std::vector<Vec2>& points, const std::vector<double>& weights) {
        const Sampled at = sample(s, cell, points);
        const Extraction e = extraction(s, cell);
        VectorXd wx(static_cast<Index>(points.size())), wy = wx;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Vec2 b = input.thickness * weights[k] * force(points[k]);
            wx[static_cast<Index>(k)] = b.x();
            wy[static_cast<Index>(k)] = b.y();
        }
        add_at(fx, e, at.value.transpose() * wx);
        add_at(fy, e, at.value.transpose() * wy);
    });
    VectorXd load(2 * s.n_functions);
    for (Index i = 0; i < s.n_functions; ++i) load.segment<2>(2 * i) = Vec2(fx[i], fy[i]);
    return load;
}

VectorXd boundary_load(const PartInput& input, const std::vector<TractionPoint>& points) {
    VectorXd load = VectorXd::Zero(2 * input.space.n_functions);
    for (const TractionPoint& p : points) {
        const PointBasis b = evaluate(input.space, p.cell, p.x);
        for (std::size_t i = 0; i < b.functions.size(); ++i)
            load.segment<2>(2 * b.functions[i]) += input.thickness * p.weight * b.value[static_cast<Index>(i)] * p.traction;
    }
    return load;
}

}  // namespace abut::solver
