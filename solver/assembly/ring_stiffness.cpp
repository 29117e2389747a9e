// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/assembly/ring_stiffness.hpp"

#include "solver/assembly/ring.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of one interval along x: integrals with the weight r; without; and of N N' / r.
struct RadialIntegrals {
    LineIntegrals weighted, plain;
    MatrixXd over_r;
};

void add_to(LineIntegrals& m, const VectorXd& value, const VectorXd& slope, double w) {
    m.mass += w * value * value.transpose();
    m.stiffness += w * slope * slope.transpose();
    m.mixed += w * slope * value.transpose();
}

RadialIntegrals radial_integrals(const IntervalKnots& knots, const LineRule& rule, double axis) {
    const Index n = knots.degree + 1;
    const MatrixXd zero = MatrixXd::Zero(n, n);
    RadialIntegrals m{{zero, zero, zero}, {zero, zero, zero}, zero};
    const double a = knots.low(), h = knots.high() - a;
    for (std::size_t k = 0; k < rule.points.size(); ++k) {
        LocalValues v, g;
        const double x = a + rule.points[k] * h, r = x - axis, w = rule.weights[k] * h;
        evaluate(knots, x, v, g);
        const VectorXd value = VectorXd::Map(v.data(), n), slope = VectorXd::Map(g.data(), n);
        add_to(m.weighted, value, slope, w * r);
        add_to(m.plain, value, slope, w);
        m.over_r += w / r * value * value.transpose();
    }
    return m;
}

/// Products over a cell's functions, x fastest.
MatrixXd product(const MatrixXd& x, const MatrixXd& y) {
    const Index p = x.rows(), q = y.rows();
    MatrixXd m(p * q, p * q);
    for (Index b = 0; b < q; ++b)
        for (Index a = 0; a < q; ++a) m.block(a * p, b * p, p, p) = y(a, b) * x;
    return m;
}

/// Room for one element.
struct Element {
    CellIntegrals plane;
    HoopIntegrals hoop;
};

void integrate_full(const RadialIntegrals& x, const LineIntegrals& y, Element& out) {
    integrate_full_cell(x.weighted, y, out.plane);
    out.hoop = {product(x.over_r, y.mass), product(x.plain.mixed, y.mass), product(x.plain.mass, y.mixed)};
}

void integrate_cut(const PartInput& input, const CellRule& rule, Element& out) {
    integrate_cut_cell(input.space, rule.element, rule.points, rule.weights, out.plane);
    Sampled at;
    sample(input.space, rule.element, rule.points, at);
    VectorXd w(static_cast<Index>(rule.points.size()));  // less one radius
    VectorXd over_r = w;
    for (Index k = 0; k < w.size(); ++k) {
        const double r = radius(input, rule.points[static_cast<std::size_t>(k)]);
        w[k] = rule.weights[static_cast<std::size_t>(k)] / r;
        over_r[k] = w[k] / r;
    }
    out.hoop.nn = at.value.transpose() * over_r.asDiagonal() * at.value;
    out.hoop.xn = at.dx.transpose() * w.asDiagonal() * at.value;
    out.hoop.yn = at.dy.transpose() * w.asDiagonal() * at.value;
}

void extract(const Extraction& e, Element& element) {
    extract(e, element.plane);
    for (MatrixXd* m : {&element.hoop.nn, &element.hoop.xn, &element.hoop.yn}) *m = e.matrix.transpose() * *m * e.matrix;
}

/// Adds the hoop's share to blocks of the plane strains.
void add_hoop(const HoopIntegrals& h, const Elasticity& d, double thickness, std::vector<Eigen::Matrix2d>& blocks) {
    const Index n = h.nn.rows();
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) {
            Eigen::Matrix2d& b = blocks[static_cast<std::size_t>(j * n + i)];
            b(0, 0) += thickness * (d.d11 * h.nn(i, j) + d.d12 * (h.xn(i, j) + h.xn(j, i)));
            b(0, 1) += thickness * d.d12 * h.yn(j, i);
            b(1, 0) += thickness * d.d12 * h.yn(i, j);
        }
}

/// The assembly under way.
struct RingStiffness {
    const PartInput& input;
    Elasticity elasticity;
    BlockScatter scatter;
    Element element{};
    std::vector<Eigen::Matrix2d> blocks{};

    void add(int e) {
        const Extraction x = extraction(input.space, e);
        if (!x.identity) extract(x, element);
        stiffness_blocks(element.plane, elasticity, input.thickness, blocks);
        add_hoop(element.hoop, elasticity, input.thickness, blocks);
        scatter.add(x.functions, blocks);
    }
};

void add_full_cells(RingStiffness& s) {
    const SplineSpace& space = s.input.space;
    const IntervalIntegrals y = interval_integrals(space, 1, s.input.line_rule);
    std::vector<RadialIntegrals> x;
    for (int c = 0; c < space.n_intervals(0); ++c)
        x.push_back(radial_integrals(space.interval(0, c), s.input.line_rule, *s.input.axis));
    for (int cell = 0; cell < space.n_cells(); ++cell) {
        if (!is_full(space, cell)) continue;
        const int kind = y.of_interval[static_cast<std::size_t>(space.row_of(cell))];
        integrate_full(x[static_cast<std::size_t>(space.column_of(cell))], y.integrals[static_cast<std::size_t>(kind)],
                       s.element);
        s.add(cell);
    }
}

}  // namespace

BlockMatrix assemble_ring_stiffness(const PartInput& input) {
    const SplineSpace& space = input.space;
    FunctionSets sets;
    for (int cell = 0; cell < space.n_cells(); ++cell)
        if (is_full(space, cell)) sets.add(extraction(space, cell).functions);
    for (const CellRule& rule : input.cut_rules) sets.add(extraction(space, rule.element).functions);
    BlockMatrix k = make_block_matrix(space.n_functions, sets);
    RingStiffness s{input, local_elasticity(input), BlockScatter(k)};
    add_full_cells(s);
    for (const CellRule& rule : input.cut_rules) {
        integrate_cut(input, rule, s.element);
        s.add(rule.element);
    }
    return k;
}

}  // namespace abut::solver
