// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/solution_structure.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "solver/parts/part_system.hpp"
#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::solution_structure_test {
namespace {

using Eigen::VectorXd;
using test::SpaceCase;

/// Gauss rules on every cell of a part made of boxes.
std::vector<CellRule> all_rules(const PartInput& part, const std::vector<test::Box>& boxes, int order) {
    std::vector<CellRule> rules;
    test::for_points(part, boxes, order, [&](int cell, const Vec2& x, double weight) {
        if (rules.empty() || rules.back().element != cell) rules.push_back({cell, {}, {}});
        rules.back().points.push_back(x);
        rules.back().weights.push_back(weight);
    });
    return rules;
}

/// a + b.(x, y).
ScalarField linear(double a, double bx, double by) {
    return [=](const Vec2& p) { return ScalarAt{a + bx * p.x() + by * p.y(), {bx, by}}; };
}

/// An ell whose lower left corner is at (x0, y0), u_x held on its left, u_y on its bottom side.
struct Held {
    PartInput part;
    std::vector<SupportSet> sets;
};

SupportSet by_structure(SupportSet set, int component) {
    set.side.reset();
    set.by_structure = true;
    set.component = component;
    set.note = "asked for";
    return set;
}

/// data: of both components, linear in x, y.
Held held_ell(const SpaceCase& c, const ScalarField& data_x = {}, const ScalarField& data_y = {}) {
    Held h{test::ell(c), {}};
    const auto boxes = test::ell_boxes(h.part);
    const double x0 = boxes[0].x0, y0 = boxes[0].y0;
    SolutionStructure s;
    s.weight = {linear(-x0 / 2, 0.5, 0), linear(-y0 / 2, 0, 0.5)};
    s.data = {data_x, data_y};
    s.rules = all_rules(h.part, boxes, c.degree + 2);
    h.part.structure = std::make_shared<const SolutionStructure>(std::move(s));
    const SplineSpace& space = h.part.space;
    h.sets = {by_structure(test::support_on(space, {x0, y0}, {x0, boxes[1].y1}, {-1, 0}, {1, 0}), 0),
              by_structure(test::support_on(space, {x0, y0}, {boxes[0].x1, y0}, {0, -1}, {0, 1}), 1)};
    return h;
}

/// Tractions of a constant stress on all sides of an ell that are not held.
std::vector<TractionPoint> tractions(const PartInput& part, const Eigen::Vector3d& s) {
    const auto b = test::ell_boxes(part);
    const auto t = [&](const Vec2& n) { return Vec2(s[0] * n.x() + s[2] * n.y(), s[2] * n.x() + s[1] * n.y()); };
    std::vector<TractionPoint> all;
    const auto side = [&](const Vec2& from, const Vec2& to, const Vec2& n) {
        for (const TractionPoint& p : test::traction_on(part.space, from, to, n, [&](const Vec2&) { return t(n); }))
            all.push_back(p);
    };
    side({b[0].x1, b[0].y0}, {b[0].x1, b[0].y1}, {1, 0});
    side({b[1].x1, b[1].y0}, {b[1].x1, b[1].y1}, {1, 0});
    side({b[1].x0, b[1].y1}, {b[1].x1, b[1].y1}, {0, 1});
    side({b[1].x1, b[0].y1}, {b[0].x1, b[0].y1}, {0, 1});
    return all;
}

PartSystem system_of(const Held& h, const std::vector<TractionPoint>& points) {
    return make_part_system(h.part, h.sets, boundary_load(h.part, points), test::middle_of(h.part), test::size_of(h.part), {},
                            weighted_boundary_load(h.part, points));
}

class StructureTest : public testing::TestWithParam<SpaceCase> {};

/// u_x = a (x - x0), u_y = b (y - y0) + data: linear weights hold it exactly.
TEST_P(StructureTest, PassesThePatchTest) {
    const double shift_x = 0.013, shift_y = -0.02;
    const Held h = held_ell(GetParam(), linear(shift_x, 0, 0), linear(shift_y, 0, 0));
    const auto boxes = test::ell_boxes(h.part);
    const double ex = 0.01, ey = -0.004;
    Eigen::Matrix2d gradient;
    gradient << ex, 0, 0, ey;
    const Eigen::Vector3d stress = stress_of(h.part.elasticity, gradient);
    const PartSystem s = system_of(h, tractions(h.part, stress));
    ASSERT_TRUE(s.failure.empty()) << s.failure;
    const VectorXd u = solve(s, s.load);
    test::for_points(h.part, boxes, 3, [&](int cell, const Vec2& x, double) {
        const DisplacementAt d = displacement_at(s.input, u, cell, x);
        EXPECT_NEAR(d.value.x(), shift_x + ex * (x.x() - boxes[0].x0), 1e-11);
        EXPECT_NEAR(d.value.y(), shift_y + ey * (x.y() - boxes[0].y0), 1e-11);
        EXPECT_LT((d.gradient - gradient).cwiseAbs().maxCoeff(), 1e-9);
    });
    double area = 0;
    for (const test::Box& b : boxes) area += b.area();
    EXPECT_NEAR(strain_energy(s, u), 0.5 * area * (stress[0] * ex + stress[1] * ey), 1e-10);
    const std::vector<Resultant> r = support_reactions(s, u, s.load);
    EXPECT_NEAR(r[0].force.x(), -stress[0] * (boxes[1].y1 - boxes[0].y0), 1e-9);
    EXPECT_NEAR(r[1].force.y(), -stress[1] * (boxes[0].x1 - boxes[0].x0), 1e-9);
    EXPECT_NEAR(traction_resultant(s.input, h.sets[0], u).force.x(), r[0].force.x(), 1e-9);
}

/// The same answer in the same space: for linear weights and degree p the weighted functions are splines of degree p + 1.
TEST_P(StructureTest, WhatItAnswersIsConsistentWithItself) {
    const Held h = held_ell(GetParam(), linear(0.01, 0.002, -0.003), {});
    const PartSystem s = system_of(h, tractions(h.part, {3, -1, 2}));
    ASSERT_TRUE(s.failure.empty()) << s.failure;
    const VectorXd u = solve(s, s.load);
    // gradients by differences
    const auto boxes = test::ell_boxes(h.part);
    const double step = 1e-6;
    test::for_points(h.part, boxes, 2, [&](int cell, const Vec2& x, double) {
        const auto at = [&](const Vec2& p) { return displacement_at(s.input, u, cell, p).value; };
        const Eigen::Matrix2d g = displacement_at(s.input, u, cell, x).gradient;
        const Vec2 dx = (at(x + Vec2(step, 0)) - at(x - Vec2(step, 0))) / (2 * step);
        const Vec2 dy = (at(x + Vec2(0, step)) - at(x - Vec2(0, step))) / (2 * step);
        EXPECT_LT((g.col(0) - dx).norm() + (g.col(1) - dy).norm(), 1e-7 * (1 + g.norm()));
    });
    // held along the edges, whatever the solution
    for (const SupportPoint& p : h.sets[0].points)
        EXPECT_NEAR(displacement_at(s.input, u, p.element, p.x).value.x(), 0.01 + 0.002 * p.x.x() - 0.003 * p.x.y(), 1e-14);
    // reactions balance the loads: forces and moments
    Resultant sum = resultant_of(h.part.space, s.applied);
    for (const Resultant& r : support_reactions(s, u, s.load)) {
        sum.force += r.force;
        sum.moment += r.moment;
    }
    EXPECT_LT(sum.force.norm() + std::abs(sum.moment), 1e-10);
}

std::string case_name(const testing::TestParamInfo<SpaceCase>& info) {
    return test::name_of(info.param);
}
INSTANTIATE_TEST_SUITE_P(Spaces, StructureTest, testing::ValuesIn(test::all_space_cases()), case_name);

/// Nitsche's method on other edges of a weighted part sees the weighted functions and what is prescribed with them.
TEST(Structure, GoesTogetherWithNitscheAndSprings) {
    const SpaceCase c{2, true, Basis::web};
    Held h = held_ell(c, linear(0.02, 0, 0), {});
    const auto b = test::ell_boxes(h.part);
    const double ex = 0.01, k = 50;
    SupportSet right = test::support_on(h.part.space, {b[0].x1, b[0].y0}, {b[0].x1, b[0].y1}, {1, 0}, {1, 0},
                                        [&](const Vec2& x) { return 0.02 + ex * (x.x() - b[0].x0); });
    h.sets.push_back(right);
    Eigen::Matrix2d gradient;
    gradient << ex, 0, 0, -0.3 * ex;
    const Eigen::Vector3d stress = stress_of(h.part.elasticity, gradient);
    std::vector<TractionPoint> points;
    for (const TractionPoint& p : tractions(h.part, stress))
        if (p.x.x() < b[0].x1 - 1e-9) points.push_back(p);
    // a foundation along the notch's side, and the traction that balances it
    SpringSet spring{7, {}, k, 0};
    for (const test::EdgePoint& p : test::edge_points(h.part.space, {b[1].x1, b[1].y0}, {b[1].x1, b[1].y1}, {1, 0}, 4)) {
        spring.points.push_back({p.element, p.x, {1, 0}, p.weight});
        points.push_back({p.element, p.x, p.weight, {k * (0.02 + ex * (p.x.x() - b[0].x0)), 0}});
    }
    const PartSystem s = make_part_system(h.part, h.sets, boundary_load(h.part, points), test::middle_of(h.part),
                                          test::size_of(h.part), {spring}, weighted_boundary_load(h.part, points));
    ASSERT_TRUE(s.failure.empty()) << s.failure;
    EXPECT_EQ(s.supports[2].method, SupportMethod::nitsche);
    const VectorXd u = solve(s, s.load);
    test::for_points(h.part, b, 2, [&](int cell, const Vec2& x, double) {
        EXPECT_NEAR(displacement_at(s.input, u, cell, x).value.x(), 0.02 + ex * (x.x() - b[0].x0), 1e-11);
    });
    const std::vector<Resultant> r = support_reactions(s, u, s.load);
    EXPECT_NEAR(r[2].force.x(), stress[0] * (b[0].y1 - b[0].y0), 1e-9);
    EXPECT_NEAR(r[0].force.x(), -stress[0] * (b[1].y1 - b[0].y0), 1e-9);
}

TEST(Structure, LeavesMotionsFreeThatItsWeightsDoNotTouch) {
    const SpaceCase c{2, true, Basis::web};
    Held h = held_ell(c);
    auto only_x = std::make_shared<SolutionStructure>(*h.part.structure);
    only_x->weight[1] = {};
    h.part.structure = std::shared_ptr<const SolutionStructure>(only_x);
    h.sets.resize(1);
    const PartSystem s = system_of(h, {});
    ASSERT_TRUE(s.failure.empty()) << s.failure;
    ASSERT_EQ(s.free_motions.size(), 1u);
    EXPECT_EQ(s.free_motions[0].translation.x(), 0);
    EXPECT_NEAR(std::abs(s.free_motions[0].translation.y()), 1, 1e-12);
    EXPECT_EQ(s.free_motions[0].rotation, 0);
}

/// Held along itself, an edge leaves the part a rotation about a point of its line, which no weighted function holds.
TEST(Structure, RefusesAMotionThatItCannotFollow) {
    const SpaceCase c{2, true, Basis::web};
    Held h = held_ell(c);
    const auto b = test::ell_boxes(h.part);
    auto along = std::make_shared<SolutionStructure>(*h.part.structure);
    along->weight = {linear(-b[0].y0, 0, 1), {}};
    h.part.structure = std::shared_ptr<const SolutionStructure>(along);
    h.sets = {by_structure(test::support_on(h.part.space, {b[0].x0, b[0].y0}, {b[0].x1, b[0].y0}, {0, -1}, {1, 0}), 0)};
    EXPECT_NE(system_of(h, {}).failure.find("cannot follow"), std::string::npos);
}

/// Two supports of one component share the residual by distance: each gets its own.
TEST(Structure, ReactionsOfOppositeEdgesAreToldApart) {
    const PartInput plain = test::rectangle(2, 1, 8, 4, 2);
    Held h{plain, {}};
    SolutionStructure s;
    s.weight[0] = [](const Vec2& p) { return ScalarAt{p.x() * (2 - p.x()), {2 - 2 * p.x(), 0}}; };
    s.weight[1] = linear(0, 0, 1);
    s.data[0] = linear(0, 0.01, 0);
    s.rules = all_rules(plain, {{0, 0, 2, 1}}, 5);
    h.part.structure = std::make_shared<const SolutionStructure>(std::move(s));
    h.sets = {by_structure(test::side_support(plain.space, GridSide::left, 0), 0),
              by_structure(test::side_support(plain.space, GridSide::right, 0), 0),
              by_structure(test::side_support(plain.space, GridSide::bottom, 1), 1)};
    const PartSystem system = system_of(h, {});
    const VectorXd u = solve(system, system.load);
    const std::vector<Resultant> r = support_reactions(system, u, system.load);
    EXPECT_NEAR(r[0].force.x(), -10, 1e-9);  // E = 1000, strain 0.01
    EXPECT_NEAR(r[1].force.x(), 10, 1e-9);
    EXPECT_NEAR(r[2].force.y(), 0, 1e-9);
}

}  // namespace
}  // namespace abut::solver::solution_structure_test
