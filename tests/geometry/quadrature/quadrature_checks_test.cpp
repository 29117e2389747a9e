// SPDX-License-Identifier: GPL-3.0-or-later
// The checks that tests of rules share are right, and notice a fault.
#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <vector>

#include "geometry/quadrature/quadrature.hpp"
#include "tests/geometry/cells/random_parts.hpp"
#include "tests/geometry/cells/swept_parts.hpp"
#include "tests/geometry/quadrature/rule_errors.hpp"

namespace quadrature_checks_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;
constexpr double pi = std::numbers::pi;

/// Polynomial and Laurent oracles against integrals known by heart.
TEST(QuadratureChecks, OraclesAreRight) {
    const LocalFrame same{{0, 0}, {1, 1}};
    const Moments square = part_moments(straight_parts()[0], same, 3);
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j <= 3; ++j) EXPECT_NEAR(square(i, j), 1.0 / ((i + 1) * (j + 1)), 1e-15);
    Part disc;
    add_loop(disc, {Arc{{0, 0}, 1, 0.4, 2 * pi}});
    const Moments round = part_moments(disc, same, 4);
    EXPECT_NEAR(round(0, 0), pi, 1e-14);
    EXPECT_NEAR(round(1, 2), 0, 1e-14);
    EXPECT_NEAR(round(2, 0), pi / 4, 1e-14);
    EXPECT_NEAR(round(0, 2), pi / 4, 1e-14);
    EXPECT_NEAR(round(2, 2), pi / 24, 1e-14);
    EXPECT_NEAR(round(4, 0), pi / 8, 1e-14);
}

TEST(QuadratureChecks, NoticeAFault) {
    const Part straight = straight_parts()[2], round = curved_samples()[0];
    const CutCells cells = cut_cells(straight, {{0, 1, 2}, {0, 0.25, 0.5}});
    std::vector<CellRule> rules = cell_rules(straight, cells, 2);
    ASSERT_LT(straight_error(straight, cells, rules, 2), straight_tolerance);
    EXPECT_GT(straight_error(straight, cells, cell_rules(straight, cells, 1), 2), straight_tolerance);  // a degree too low
    rules[0].points[0].x() += 1e-6;
    EXPECT_GT(straight_error(straight, cells, rules, 2), straight_tolerance);
    EXPECT_GT(whole_error(straight, cells, rules, 2), straight_tolerance);

    const CutCells arcs = cut_cells(round, {{-0.5, 0, 1}, {-1.25, 0, 0.25}});
    rules = cell_rules(round, arcs, 2);
    ASSERT_LT(contour_error(round, arcs, rules, 2), arc_tolerance);
    rules[0].weights[0] *= 1 + 1e-6;
    EXPECT_GT(contour_error(round, arcs, rules, 2), arc_tolerance);
    EXPECT_GT(whole_error(round, arcs, rules, 2), arc_tolerance);

    Random random(41);
    const Part general = random_part(4, random);
    const CutCells general_cells = cut_cells(general, random_grid(general, random, rule_grid_limits));
    rules = cell_rules(general, general_cells, 2);
    ASSERT_LT(contour_error(general, general_cells, rules, 2, 4), general_tolerance);
    rules[0].weights[0] *= 1 + 1e-9;
    EXPECT_GT(contour_error(general, general_cells, rules, 2, 4), general_tolerance);

    std::vector<BoundaryPoint> points = whole_boundary(round, arcs, 3);
    ASSERT_LT(divergence_error(round, points), boundary_tolerance);
    points[0].weight += 1e-12;
    EXPECT_GT(divergence_error(round, points), boundary_tolerance);
}

}  // namespace

}  // namespace quadrature_checks_test
