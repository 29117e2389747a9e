// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/cell_integrals.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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

bool is_close(const MatrixXd& a, const MatrixXd& b, double fraction) {
    return (a - b).cwiseAbs().maxCoeff() <= fraction * b.cwiseAbs().maxCoeff();
}

/// Equal cells' sides differ by the rounding of the grid lines, a unit of the largest coordinate; so do, relative to
/// themselves, the integrals, a few times for each degree.
double rounding_of_lines(const KnotVector& knots) {
    const double length = knots.breakpoints.back() - knots.breakpoints.front();
    const double largest = std::max(std::abs(knots.breakpoints.front()), std::abs(knots.breakpoints.back()));
    const double of_side = std::numeric_limits<double>::epsilon() * largest / (length / knots.n_intervals());
    return 4 * (knots.degree + 1) * of_side;
}

/// The non-zero entries of an extraction.
struct PackedExtraction {
    struct Entry {
        Index row, column;
        double value;
    };
    std::vector<Entry> entries;
    Index columns;
};

PackedExtraction packed(const Extraction& e) {
    PackedExtraction p{{}, e.matrix.cols()};
    for (Index c = 0; c < e.matrix.cols(); ++c)
        for (Index r = 0; r < e.matrix.rows(); ++r)
            if (e.matrix(r, c) != 0) p.entries.push_back({r, c, e.matrix(r, c)});
    return p;
}

MatrixXd times(const MatrixXd& a, const PackedExtraction& e) {
    MatrixXd result = MatrixXd::Zero(a.rows(), e.columns);
    for (const auto& entry : e.entries) result.col(entry.column) += entry.value * a.col(entry.row);
    return result;
}

}  // namespace

void sample(const SplineSpace& s, int element, const std::vector<Vec2>& points, Sampled& out) {
    const int c = s.column_of(element), r = s.row_of(element);
    const Index p = s.x.degree + 1, q = s.y.degree + 1, n = static_cast<Index>(points.size());
    for (MatrixXd* m : {&out.value, &out.dx, &out.dy}) m->resize(n, p * q);
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
}

IntervalIntegrals interval_integrals(const KnotVector& knots, const LineRule& rule) {
    const double fraction = rounding_of_lines(knots);
    IntervalIntegrals all;
    for (int i = 0; i < knots.n_intervals(); ++i) {
        LineIntegrals m = line_integrals(knots, i, rule);
        const auto same = [&](const LineIntegrals& o) {
            return is_close(m.mass, o.mass, fraction) && is_close(m.stiffness, o.stiffness, fraction) &&
                   is_close(m.mixed, o.mixed, fraction);
        };
        if (i == 0 || !same(all.integrals.back())) all.integrals.push_back(std::move(m));
        all.of_interval.push_back(static_cast<int>(all.integrals.size()) - 1);
    }
    return all;
}

void integrate_full_cell(const LineIntegrals& x, const LineIntegrals& y, CellIntegrals& out) {
    const Index p = x.mass.rows(), q = y.mass.rows(), n = p * q;
    for (MatrixXd* m : {&out.axx, &out.ayy, &out.axy}) m->resize(n, n);
    for (Index b = 0; b < q; ++b)
        for (Index a = 0; a < q; ++a) {
            out.axx.block(a * p, b * p, p, p) = y.mass(a, b) * x.stiffness;
            out.ayy.block(a * p, b * p, p, p) = y.stiffness(a, b) * x.mass;
            out.axy.block(a * p, b * p, p, p) = y.mixed(b, a) * x.mixed;
        }
}

void integrate_cut_cell(const SplineSpace& space, int element, const std::vector<Vec2>& points,
                        const std::vector<double>& weights, CutWorkspace& work, CellIntegrals& out) {
    sample(space, element, points, work.at);
    const Eigen::Map<const VectorXd> w(weights.data(), static_cast<Index>(weights.size()));
    work.wx.noalias() = w.asDiagonal() * work.at.dx;
    work.wy.noalias() = w.asDiagonal() * work.at.dy;
    out.axx.noalias() = work.at.dx.transpose() * work.wx;
    out.ayy.noalias() = work.at.dy.transpose() * work.wy;
    out.axy.noalias() = work.at.dx.transpose() * work.wy;
}

void extract(const Extraction& e, CellIntegrals& integrals) {
    const PackedExtraction p = packed(e);
    for (MatrixXd* a : {&integrals.axx, &integrals.ayy, &integrals.axy}) {
        const MatrixXd half = times(*a, p).transpose();
        *a = times(half, p).transpose();
    }
}

void stiffness_blocks(const CellIntegrals& c, const Elasticity& d, double thickness, std::vector<Eigen::Matrix2d>& blocks) {
    const double d11 = thickness * d.d11, d12 = thickness * d.d12, d33 = thickness * d.d33;
    const Index n = c.axx.rows();
    blocks.resize(static_cast<std::size_t>(n * n));
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i)
            blocks[static_cast<std::size_t>(j * n + i)] << d11 * c.axx(i, j) + d33 * c.ayy(i, j),
                d12 * c.axy(i, j) + d33 * c.axy(j, i), d12 * c.axy(j, i) + d33 * c.axy(i, j),
                d11 * c.ayy(i, j) + d33 * c.axx(i, j);
}

}  // namespace abut::solver
