// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/interface.hpp"

#include <gtest/gtest.h>

#include "tests/solver/contact/two_blocks.hpp"

namespace abut::solver::interface_test {
namespace {

using Eigen::VectorXd;

constexpr double thickness = 1.6;

/// Two blocks whose common line is shorter than either; the gap varies.
struct Setting {
    test::TwoBlocks blocks;
    AssemblyProblem problem;
    Rows rows;
    std::vector<int> first_row;

    Setting() {
        blocks.lower.box = {-0.2, 0, 1.1, 1};
        blocks.lower.overhang = 0.4;
        problem = blocks.problem();
        problem.interfaces = {test::horizontal_interface(problem.parts, 0, 1, 0, 1, 1, 5, drawn_gap, thickness)};
        rows = interface_rows(problem.parts, problem.interfaces, first_row);
    }
    static double drawn_gap(double x) { return 0.1 + 0.3 * x * x; }
    VectorXd times(std::size_t part, const VectorXd& u) const {
        VectorXd v = VectorXd::Zero(rows.n);
        for (const RowEntry& e : rows.by_part[part]) v[e.row] += e.value * u[e.coefficient];
        return v;
    }
};

/// Integrals of every pressure function times f along [0, 1].
VectorXd moments(const KnotVector& k, const std::function<double(double)>& f) {
    VectorXd m = VectorXd::Zero(k.n_functions());
    const LineRule rule = test::gauss(6);
    for (int i = 0; i < k.n_intervals(); ++i)
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const double a = k.breakpoints[static_cast<std::size_t>(i)], h = k.breakpoints[static_cast<std::size_t>(i) + 1] - a;
            LocalValues v;
            evaluate(k, i, a + rule.points[q] * h, v);
            for (int j = 0; j <= k.degree; ++j)
                m[i + j] += thickness * rule.weights[q] * h * v[static_cast<std::size_t>(j)] * f(a + rule.points[q] * h);
        }
    return m;
}

}  // namespace

TEST(Interface, RowsAreIntegralsOfTheGapWithEachPressureFunction) {
    const Setting s;
    const KnotVector& k = s.problem.interfaces[0].pressure;
    ASSERT_EQ(s.rows.n, k.n_functions());
    EXPECT_EQ(s.first_row, std::vector<int>{0});
    EXPECT_EQ(s.rows.unilateral, std::vector<char>(7, 1));
    EXPECT_LT((s.rows.weight - moments(k, [](double) { return 1.0; })).norm(), 1e-14);
    EXPECT_LT((s.rows.gap0 - moments(k, Setting::drawn_gap)).norm(), 1e-14);
    EXPECT_NEAR(s.rows.weight.sum(), thickness, 1e-14);
    EXPECT_NEAR(s.rows.gap0.sum(), thickness * 0.2, 1e-14);
}

/// A round gap, a tenth wide at its least: functions that do not resolve it see more. Bodies that may sink into it begin there.
TEST(Interface, FacesBeginAsFarApartAsTheyAre) {
    Setting s;
    const auto least = [&] { return s.rows.gap0.cwiseQuotient(s.rows.weight).minCoeff(); };
    const auto begin = [&] { begin_touching(s.problem.parts, s.problem.interfaces, s.first_row, s.rows); };
    const VectorXd means = s.rows.gap0;
    EXPECT_GT(least(), 0.1005);
    std::vector<PartSystem> held = s.problem.parts;
    for (PartSystem& part : held) part.modes.resize(2 * part.n(), 0);
    begin_touching(held, s.problem.interfaces, s.first_row, s.rows);
    EXPECT_EQ(s.rows.gap0, means) << "what is held does not sink";
    s.problem.interfaces[0].expected.assign(7, 1.0);
    begin();
    EXPECT_EQ(s.rows.gap0, means) << "resolved";
    s.problem.interfaces[0].expected = {3, 1, 0, 0, 0, 0, 0};
    begin();
    EXPECT_NEAR(least(), 0.1, 5e-4);
    const VectorXd by = (means - s.rows.gap0).cwiseQuotient(s.rows.weight);
    EXPECT_NEAR(by.minCoeff(), by.maxCoeff(), 1e-14) << "all alike: the face keeps its shape";
}

TEST(Interface, RowsTakeTheNormalDisplacementOfEitherBody) {
    const Setting s;
    for (std::size_t part : {0u, 1u}) {
        const SplineSpace& space = s.problem.parts[part].input.space;
        // u_y = x^2 - 2 y^2, where the upper body's points lie at 1 + gap
        const VectorXd u =
            test::interleave(test::monomial(space, 1, 1), test::monomial(space, 2, 0) - 2 * test::monomial(space, 0, 2));
        const VectorXd expected = moments(s.problem.interfaces[0].pressure, [&](double x) {
            const double y = part == 0 ? 1 : 1 + Setting::drawn_gap(x);
            return (part == 0 ? -1 : 1) * (x * x - 2 * y * y);
        });
        EXPECT_LT((s.times(part, u) - expected).norm(), 1e-12 * expected.norm());
        EXPECT_GT((s.times(part, 1.001 * u) - expected).norm(), 1e-12 * expected.norm());
    }
}

TEST(Interface, ACommonTranslationAlongTheNormalKeepsTheGap) {
    const Setting s;
    VectorXd sum = VectorXd::Zero(s.rows.n), sideways = sum;
    for (std::size_t part : {0u, 1u}) {
        sum += s.times(part, coefficients_of(s.problem.parts[part].input.space, {{0.3, 2}, 0, {0, 0}}));
        sideways += s.times(part, coefficients_of(s.problem.parts[part].input.space, {{part == 0 ? 1.0 : 2.0, 0}, 0, {0, 0}}))
                        .cwiseAbs();
    }
    EXPECT_LT(sum.norm(), 1e-13);
    EXPECT_LT(sideways.norm(), 1e-15);
}

TEST(Interface, EntriesAreGivenOnce) {
    const Setting s;
    for (const auto& entries : s.rows.by_part)
        for (std::size_t k = 1; k < entries.size(); ++k)
            EXPECT_TRUE(entries[k - 1].row < entries[k].row ||
                        (entries[k - 1].row == entries[k].row && entries[k - 1].coefficient < entries[k].coefficient));
}

TEST(Interface, SeveralInterfacesFollowEachOther) {
    Setting s;
    s.problem.interfaces.push_back(test::horizontal_interface(s.problem.parts, 0, 1, 0.2, 0.6, 1, 2, Setting::drawn_gap, 1));
    const Rows rows = interface_rows(s.problem.parts, s.problem.interfaces, s.first_row);
    EXPECT_EQ(s.first_row, (std::vector<int>{0, 7}));
    EXPECT_EQ(rows.n, 7 + 4);
    EXPECT_EQ(rows.weight.head(7), s.rows.weight);
    EXPECT_NEAR(rows.weight.tail(4).sum(), 0.4, 1e-14);
}

TEST(Interface, PeriodicRowsWrapAround) {
    Setting s;
    Interface& face = s.problem.interfaces[0];
    face.periodic = true;
    face.pressure = periodic_knots(face.pressure.breakpoints, 2);
    EXPECT_EQ(n_rows(face), 5);
    const Rows rows = interface_rows(s.problem.parts, s.problem.interfaces, s.first_row);
    ASSERT_EQ(rows.n, 5);
    for (int k = 0; k < 5; ++k) EXPECT_NEAR(rows.weight[k], thickness / 5, 1e-14);  // all functions are equal on uniform knots
    const VectorXd all = all_coefficients(face, VectorXd::LinSpaced(5, 1, 5));
    EXPECT_EQ(all, (VectorXd(7) << 1, 2, 3, 4, 5, 1, 2).finished());
    EXPECT_NEAR(pressure_at(face.pressure, all, 0), pressure_at(face.pressure, all, 1), 1e-14);
    EXPECT_NEAR(pressure_at(face.pressure, all, 0), 1.5, 1e-14);  // mean of the two functions that meet at a knot
}

TEST(Interface, TractionsOfFrictionLeaveNoCouple) {
    Setting s;
    Interface along = s.problem.interfaces[0];
    along.bilateral = true;
    along.friction = 0.3;
    for (InterfacePoint& p : along.points)
        for (Vec2& n : p.normal) n = Vec2(-n.y(), n.x());
    s.problem.interfaces.push_back(along);
    const Rows rows = interface_rows(s.problem.parts, s.problem.interfaces, s.first_row);
    const Eigen::Index n = n_rows(along);
    VectorXd opening = VectorXd::Zero(rows.n);
    const VectorXd multipliers = VectorXd::LinSpaced(rows.n, 1, 3);
    Resultant sum;
    for (std::size_t part = 0; part < 2; ++part) {
        const SplineSpace& space = s.problem.parts[part].input.space;
        opening += opening_of(rows, part, coefficients_of(space, RigidMotion{{0.3, -0.2}, 0.7, {0.5, 3}}));
        const Resultant own = resultant_of(space, load_of(rows, part, multipliers, 2 * s.problem.parts[part].n()));
        sum.force += own.force;
        sum.moment += own.moment;
    }
    EXPECT_LT(opening.norm(), 1e-14);
    EXPECT_LT(sum.force.norm(), 1e-14);
    EXPECT_LT(std::abs(sum.moment), 1e-14);
    // they act on the faces themselves: the rows of the gap's own are those of no gap
    for (InterfacePoint& p : s.problem.interfaces[1].points) p.gap = 0;
    const Rows closed = interface_rows(s.problem.parts, s.problem.interfaces, s.first_row);
    for (std::size_t part = 0; part < 2; ++part) {
        const VectorXd u = VectorXd::LinSpaced(2 * s.problem.parts[part].n(), -1, 1);
        EXPECT_EQ(rows_times(rows.by_part[part], u, rows.n), rows_times(closed.by_part[part], u, rows.n));
        EXPECT_NEAR((opening_of(rows, part, u) - opening_of(closed, part, u)).tail(n).norm(),
                    std::abs(rows.turning[part].rotation.dot(u)) * rows.turning[part].arm.norm(), 1e-14);
    }
}

TEST(Interface, RefusesWhatDoesNotFit) {
    Setting s;
    EXPECT_THROW(all_coefficients(s.problem.interfaces[0], VectorXd::Ones(s.rows.n - 1)), std::logic_error);
    Interface elsewhere = s.problem.interfaces[0], stiff = elsewhere;
    elsewhere.part[1] = 2;
    stiff.penalty.assign(stiff.points.size() + 1, 1.0);
    for (const Interface& wrong : {elsewhere, stiff})
        EXPECT_THROW(interface_rows(s.problem.parts, {wrong}, s.first_row), std::logic_error);
    EXPECT_THROW(append_mean_constraint(s.rows, s.problem.parts[0], 0, {}, 1, {1, 0, 0}, 1, 0), std::logic_error);
}

TEST(Interface, PressureIsTheSpline) {
    const KnotVector k = clamped_knots({0, 1, 3, 4}, 2);
    VectorXd square(k.n_functions());
    for (int i = 0; i < k.n_functions(); ++i) square[i] = test::monomial_coefficient(k, i, 2);
    for (double s : {0.0, 0.4, 1.0, 2.7, 4.0}) EXPECT_NEAR(pressure_at(k, square, s), s * s, 1e-13);
}

TEST(Interface, MeanConstraintsTakeMeansOfDisplacementAndCurl) {
    for (double overhang : {0.0, 0.4}) {
        test::TwoBlocks blocks;
        blocks.lower.overhang = overhang;
        blocks.lower.box = {0.5, 0, 2.5, 1};
        const AssemblyProblem p = blocks.problem();
        const SplineSpace& space = p.parts[0].input.space;
        const FunctionIntegrals integrals = integrate_functions(p.parts[0].input);
        const VectorXd x = test::monomial(space, 1, 0), y = test::monomial(space, 0, 1);
        const VectorXd u = test::interleave(0.2 * x - 0.3 * y, 0.7 * x + test::monomial(space, 0, 2));
        // means over [0.5, 2.5] x [0, 1]: u_x 0.3 - 0.15, u_y 1.05 + 1/3, half the curl (0.7 + 0.3) / 2
        const Eigen::Vector3d means(0.15, 1.05 + 1.0 / 3, 0.5);
        for (const Eigen::Vector3d& c :
             {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.6, -2, 3)}) {
            Rows rows;
            rows.by_part.resize(2);
            EXPECT_EQ(append_mean_constraint(rows, p.parts[0], 0, integrals, 2, c, 4, 0.25), 0);
            double sum = rows.gap0[0];
            for (const RowEntry& e : rows.by_part[0]) sum += e.value * u[e.coefficient];
            EXPECT_NEAR(sum, c.dot(means.cwiseProduct(Eigen::Vector3d(1, 1, 4))) - 0.25, 1e-12);
            EXPECT_FALSE(rows.unilateral[0]);
            EXPECT_EQ(rows.weight[0], 1);
        }
    }
}

}  // namespace abut::solver::interface_test
