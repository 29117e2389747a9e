// SPDX-License-Identifier: GPL-3.0-or-later
// The penalty formulation against the dissertation's own algebra: (K + k^c) u = F + F^c assembled directly and solved by its
// Newton loop [Grishin10, eqs 4.22-4.24, 4.36, Figure 2.32].
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "solver/contact/assembly_solve.hpp"
#include "tests/solver/contact/two_blocks.hpp"

namespace abut::solver::penalty_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::TwoBlocks;

/// beta varies from point to point, as it does with the cell size.
double beta_at(double x) {
    return 4e4 * (1 + 0.5 * x);
}

Interface with_penalty(Interface face) {
    for (const InterfacePoint& p : face.points) face.penalty.push_back(beta_at(p.s));
    face.pressure = polyline_knots(face.points, face.pressure.breakpoints.front(), face.pressure.breakpoints.back());
    return face;
}

/// Two blocks, cut by their grids; the upper one is held sideways only, so that contact alone carries it.
AssemblyProblem problem_with_gap(const std::function<double(double)>& gap, double load_from, double thickness) {
    TwoBlocks b;
    b.lower.overhang = 0.3;
    b.upper.overhang = 0.4;
    b.lower.thickness = b.upper.thickness = thickness;
    b.load_from = load_from;
    const PartInput above = test::part_of(b.upper, b.degree);
    b.upper_supports = {test::support_on(above.space, {0, 1}, {0, 2}, {-1, 0}, {1, 0})};
    AssemblyProblem p = b.problem();
    p.interfaces[0] = with_penalty(test::horizontal_interface(p.parts, 0, 1, 0, 1, 1, b.n_intervals, gap, thickness));
    p.own_normals[0].assign(p.interfaces[0].points.size(), {Vec2(0, 1), Vec2(0, -1)});
    return p;
}

/// All parts' unknowns one after the other: K with its supports, F, and for every point the row that its gap takes of u.
struct Direct {
    MatrixXd stiffness;
    VectorXd load;
    MatrixXd gap_row;  // (points x unknowns): (0, ..., -B1 n, ..., +B2 n, ...)
    VectorXd gap0, weight, beta;
};

Direct assembled(const AssemblyProblem& p) {
    std::vector<Index> begin{0};
    for (const PartSystem& part : p.parts) begin.push_back(begin.back() + 2 * part.n());
    const Interface& face = p.interfaces[0];
    const auto m = static_cast<Index>(face.points.size());
    Direct d{MatrixXd::Zero(begin.back(), begin.back()),
             VectorXd::Zero(begin.back()),
             MatrixXd::Zero(m, begin.back()),
             VectorXd(m),
             VectorXd(m),
             VectorXd(m)};
    for (std::size_t i = 0; i < p.parts.size(); ++i) {
        const Index n = 2 * p.parts[i].n();
        for (Index k = 0; k < n; ++k)
            d.stiffness.block(begin[i], begin[i] + k, n, 1) = multiply(p.parts[i].stiffness, VectorXd::Unit(n, k));
        d.load.segment(begin[i], n) = p.parts[i].load;
    }
    for (Index q = 0; q < m; ++q) {
        const InterfacePoint& point = face.points[static_cast<std::size_t>(q)];
        d.gap0[q] = point.gap;
        d.weight[q] = point.weight * face.thickness;
        d.beta[q] = face.penalty[static_cast<std::size_t>(q)];
        for (std::size_t side = 0; side < 2; ++side) {
            const auto part = static_cast<std::size_t>(face.part[side]);
            const DisplacementBasis b = displacement_basis(p.parts[part].input, point.element[side], point.x[side]);
            for (std::size_t i = 0; i < b.x.functions.size(); ++i)
                for (int c = 0; c < 2; ++c)
                    d.gap_row(q, begin[part] + 2 * b.x.functions[i] + c) +=
                        (side == 0 ? -1 : 1) * b.of(c).value[static_cast<Index>(i)] * point.normal[side][c];
        }
    }
    return d;
}

struct NewtonResult {
    VectorXd u, pressure;
    int iterations = 0;
};

/// K_i du = F - F_int(u), where F_int holds the springs of the points that penetrate; all are on at first.
NewtonResult newton(const Direct& d) {
    const Index m = d.gap0.size();
    NewtonResult r{VectorXd::Zero(d.load.size()), VectorXd::Zero(m), 0};
    Eigen::Array<bool, Eigen::Dynamic, 1> on = Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(m, true);
    for (; r.iterations < 50; ++r.iterations) {
        const VectorXd spring = on.select(d.weight.cwiseProduct(d.beta), 0.0);
        const MatrixXd tangent = d.stiffness + d.gap_row.transpose() * spring.asDiagonal() * d.gap_row;
        const VectorXd gap = d.gap0 + d.gap_row * r.u;
        const VectorXd residual = d.load - d.stiffness * r.u - d.gap_row.transpose() * spring.cwiseProduct(gap);
        r.u += tangent.partialPivLu().solve(residual);
        const auto penetrates = ((d.gap0 + d.gap_row * r.u).array() < 0).eval();
        if ((penetrates == on).all() && r.iterations > 0) break;
        on = penetrates;
    }
    r.pressure = d.beta.cwiseProduct(-(d.gap0 + d.gap_row * r.u)).cwiseMax(0.0);
    return r;
}

VectorXd all_displacements(const AssemblySolution& s) {
    VectorXd u(s.displacement[0].size() + s.displacement[1].size());
    u << s.displacement[0], s.displacement[1];
    return u;
}

/// Largest difference relative to the largest value.
double difference(const VectorXd& a, const VectorXd& b) {
    return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// The tangent's condition times rounding: 1e6 x 1e-16, and a hundred for its assembly.
constexpr double rounding = 1e-8;

}  // namespace

TEST(Penalty, IsTheDirectlyAssembledProblem) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(0, 1);
    int partial = 0;
    for (int k = 0; k < 40; ++k) {
        const double tilt = 2e-3 * number(random), bow = 4e-3 * number(random), open = 1e-3 * (number(random) - 0.3);
        const double load_from = 0.6 * number(random), thickness = k % 2 == 0 ? 1 : 2.5;
        const auto gap = [&](double x) { return open + tilt * x + bow * (x - 0.5) * (x - 0.5); };
        const AssemblyProblem p = problem_with_gap(gap, load_from, thickness);
        const AssemblySolution s = solve_assembly(p);
        ASSERT_TRUE(s.converged && s.mechanism.empty() && s.neutral.empty()) << k;
        const NewtonResult direct = newton(assembled(p));
        ASSERT_LT(direct.iterations, 20) << k;
        const VectorXd pressure = s.pressure[0].segment(1, direct.pressure.size());
        EXPECT_LT(difference(pressure, direct.pressure), rounding) << k;
        EXPECT_LT(difference(all_displacements(s), direct.u), rounding) << k;
        EXPECT_GT(difference(1.001 * pressure, direct.pressure), rounding) << k;
        EXPECT_EQ((pressure.array() > 0).count(), (direct.pressure.array() > 0).count()) << k;
        partial += (pressure.array() > 0).count() < pressure.size();
    }
    EXPECT_GT(partial, 10);  // else the Newton loop had nothing to switch
}

TEST(Penalty, PressesUniformlyWithThePenetrationOfItsStiffness) {
    TwoBlocks b;
    b.lower.overhang = 0.3;
    b.upper.overhang = 0.45;
    AssemblyProblem p = b.problem();
    constexpr double beta = 5e5;
    Interface& face = p.interfaces[0];
    face.penalty.assign(face.points.size(), beta);
    face.pressure = polyline_knots(face.points, 0, 1);
    const AssemblySolution s = solve_assembly(p);
    ASSERT_TRUE(s.converged);
    EXPECT_EQ(s.n_multipliers, static_cast<int>(face.points.size()));
    EXPECT_LT((s.pressure[0].array() - 1).abs().maxCoeff(), 1e-9);
    const SplineSpace &below = p.parts[0].input.space, &above = p.parts[1].input.space;
    for (double x : {0.1, 0.5, 0.9}) {
        const double lower = displacement_at(below, s.displacement[0], below.cell_at({x, 0.999}), {x, 1}).value.y();
        const double upper = displacement_at(above, s.displacement[1], above.cell_at({x, 1.001}), {x, 1}).value.y();
        EXPECT_NEAR((lower - upper) * beta, 1, 1e-6);
    }
}

/// Mortar and penalty in one assembly: each keeps its own, and the constraints' rows after them stay rigid.
TEST(Penalty, LeavesOtherRowsAlone) {
    const TwoBlocks b;
    AssemblyProblem p = b.problem();
    std::vector<int> first_row;
    const Rows mortar = interface_rows(p.parts, p.interfaces, first_row);
    EXPECT_EQ(mortar.softness.size(), 0);
    p.interfaces.push_back(with_penalty(p.interfaces[0]));
    const Rows both = interface_rows(p.parts, p.interfaces, first_row);
    ASSERT_EQ(both.softness.size(), both.n);
    EXPECT_EQ(first_row[1], mortar.n);
    EXPECT_EQ(both.softness.head(mortar.n).norm(), 0);
    EXPECT_GT(both.softness.tail(both.n - mortar.n).minCoeff(), 0);
    EXPECT_EQ(both.gap0.head(mortar.n), mortar.gap0);
}

TEST(Penalty, PolylineRunsThroughItsPoints) {
    Interface face{{0, 1}, 1, {}, false, {}};
    for (double s : {0.1, 0.4, 0.5, 0.9}) face.points.push_back({s, 0.25, 0, {0, 0}, {}, {}});
    face.penalty.assign(4, 1.0);
    face.pressure = polyline_knots(face.points, 0, 1);
    const VectorXd p = (VectorXd(4) << 3, 2, 1, 4).finished();
    const VectorXd all = all_coefficients(face, p);
    for (std::size_t q = 0; q < 4; ++q)
        EXPECT_DOUBLE_EQ(pressure_at(face.pressure, all, face.points[q].s), p[static_cast<Index>(q)]);
    EXPECT_NEAR(pressure_at(face.pressure, all, 0), 3 + 1.0 / 3, 1e-12);
    EXPECT_NEAR(pressure_at(face.pressure, all, 1), 4.75, 1e-12);
    face.periodic = true;
    const VectorXd closed = all_coefficients(face, p);
    EXPECT_NEAR(closed[0], 3.5, 1e-12);  // half way between the last point, 0.1 before the seam, and the first
    EXPECT_EQ(closed[0], closed[5]);
}

}  // namespace abut::solver::penalty_test
