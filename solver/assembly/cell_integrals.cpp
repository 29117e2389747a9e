// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/assembly/cell_integrals.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

LineIntegrals line_integrals(const IntervalKnots& knots, const LineRule& rule) {
    const Index n = knots.degree + 1;
    LineIntegrals m{MatrixXd::Zero(n, n), MatrixXd::Zero(n, n), MatrixXd::Zero(n, n)};
    const double a = knots.low(), h = knots.high() - a;
    for (std::size_t k = 0; k < rule.points.size(); ++k) {
        LocalValues v, g;
        evaluate(knots, a + rule.points[k] * h, v, g);
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
    const IntervalKnots along_x = s.along_x(element), along_y = s.along_y(element);
    const Index p = s.x.degree + 1, q = s.y.degree + 1, n = static_cast<Index>(points.size());
    for (MatrixXd* m : {&out.value, &out.dx, &out.dy}) m->resize(n, p * q);
    for (Index k = 0; k < n; ++k) {
        LocalValues vx, gx, vy, gy;
        evaluate(along_x, points[static_cast<std::size_t>(k)].x(), vx, gx);
        evaluate(along_y, points[static_cast<std::size_t>(k)].y(), vy, gy);
        const Eigen::Map<const Eigen::RowVectorXd> x(vx.data(), p), xd(gx.data(), p);
        for (Index b = 0; b < q; ++b) {
            const double y = vy[static_cast<std::size_t>(b)], yd = gy[static_cast<std::size_t>(b)];
            out.value.row(k).segment(b * p, p) = y * x;
            out.dx.row(k).segment(b * p, p) = y * xd;
            out.dy.row(k).segment(b * p, p) = yd * x;
        }
    }
}

IntervalIntegrals interval_integrals(const SplineSpace& space, int axis, const LineRule& rule) {
    const double fraction = rounding_of_lines(axis == 0 ? space.x : space.y);
    IntervalIntegrals all;
    for (int i = 0; i < space.n_intervals(axis); ++i) {
        LineIntegrals m = line_integrals(space.interval(axis, i), rule);
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
        for (Index i = 0; i < p; ++i)
            for (Index a = 0; a < q; ++a) {
                const Index start = (b * p + i) * n + a * p;
                double *xx = out.axx.data() + start, *yy = out.ayy.data() + start, *xy = out.axy.data() + start;
                const double mass = y.mass(a, b), stiffness = y.stiffness(a, b), mixed = y.mixed(b, a);
                for (Index j = 0; j < p; ++j) {
                    xx[j] = mass * x.stiffness(j, i);
                    yy[j] = stiffness * x.mass(j, i);
                    xy[j] = mixed * x.mixed(j, i);
                }
            }
}

namespace {

/// Derivatives of an element's B-splines at a point: x fastest.
struct Gradients {
    std::array<double, (max_degree + 1) * (max_degree + 1)> dx, dy;
};
void gradients(const IntervalKnots& x, const IntervalKnots& y, const Vec2& point, Gradients& out) {
    LocalValues vx, gx, vy, gy;
    evaluate(x, point.x(), vx, gx);
    evaluate(y, point.y(), vy, gy);
    const auto p = static_cast<std::size_t>(x.degree) + 1, q = static_cast<std::size_t>(y.degree) + 1;
    for (std::size_t b = 0; b < q; ++b)
        for (std::size_t a = 0; a < p; ++a) {
            out.dx[b * p + a] = gx[a] * vy[b];
            out.dy[b * p + a] = vx[a] * gy[b];
        }
}

/// N: of the B-splines, known to the compiler where they are few; a loop over any number of them takes three times as long.
template <int N>
void add_points(const SplineSpace& space, int element, const std::vector<Vec2>& points, const std::vector<double>& weights,
                CellIntegrals& out) {
    const IntervalKnots x = space.along_x(element), y = space.along_y(element);
    const Index n = out.axx.rows();
    Eigen::Matrix<double, N, N> xx = Eigen::Matrix<double, N, N>::Zero(n, n), yy = xx, xy = xx;
    Gradients at;
    for (std::size_t k = 0; k < points.size(); ++k) {
        gradients(x, y, points[k], at);
        const Eigen::Map<const Eigen::Vector<double, N>> dx(at.dx.data(), n), dy(at.dy.data(), n);
        const Eigen::Vector<double, N> wx = weights[k] * dx, wy = weights[k] * dy;
        xx += dx.lazyProduct(wx.transpose());
        yy += dy.lazyProduct(wy.transpose());
        xy += dx.lazyProduct(wy.transpose());
    }
    out.axx = xx;
    out.ayy = yy;
    out.axy = xy;
}

}  // namespace

void integrate_cut_cell(const SplineSpace& space, int element, const std::vector<Vec2>& points,
                        const std::vector<double>& weights, CellIntegrals& out) {
    const Index n = space.n_local();
    for (MatrixXd* m : {&out.axx, &out.ayy, &out.axy}) m->resize(n, n);
    switch (n) {
        case 4:
            return add_points<4>(space, element, points, weights, out);
        case 9:
            return add_points<9>(space, element, points, weights, out);
        case 16:
            return add_points<16>(space, element, points, weights, out);
        default:
            return add_points<Eigen::Dynamic>(space, element, points, weights, out);
    }
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
        for (Index i = 0; i < n; ++i) {
            const double axx = c.axx(i, j), ayy = c.ayy(i, j), axy = c.axy(i, j), ayx = c.axy(j, i);
            blocks[static_cast<std::size_t>(j * n + i)] << d11 * axx + d33 * ayy, d12 * axy + d33 * ayx, d12 * ayx + d33 * axy,
                d11 * ayy + d33 * axx;
        }
}

}  // namespace abut::solver
