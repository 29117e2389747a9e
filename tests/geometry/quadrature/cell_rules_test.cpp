// SPDX-License-Identifier: GPL-3.0-or-later
// Points and weights of cut cells.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "geometry/quadrature/quadrature.hpp"
#include "tests/geometry/cells/random_parts.hpp"
#include "tests/geometry/cells/swept_parts.hpp"
#include "tests/geometry/quadrature/rule_errors.hpp"

namespace cell_rules_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;

TEST(CellRules, ExactInEveryCellOfStraightParts) {
    on_swept_grids(straight_parts(), 120, [](const Part& part, const CutCells& cells, int degree) {
        EXPECT_LT(straight_error(part, cells, cell_rules(part, cells, degree), degree), straight_tolerance);
    });
}

TEST(CellRules, ExactOverTheWholePart) {
    on_swept_grids(straight_parts(), 60, [](const Part& part, const CutCells& cells, int degree) {
        EXPECT_LT(whole_error(part, cells, cell_rules(part, cells, degree), degree), straight_tolerance);
    });
    on_swept_grids(curved_samples(), 60, [](const Part& part, const CutCells& cells, int degree) {
        EXPECT_LT(whole_error(part, cells, cell_rules(part, cells, degree), degree), arc_tolerance);
    });
}

TEST(CellRules, NearlyExactInEveryCellWithArcs) {
    on_swept_grids(curved_samples(), 60, [](const Part& part, const CutCells& cells, int degree) {
        EXPECT_LT(contour_error(part, cells, cell_rules(part, cells, degree), degree), arc_tolerance);
    });
}

/// The longest arcs that a piece can have: quarters of circles as large as their only cell.
TEST(CellRules, OneCellAroundTheWholePart) {
    for (const Part& part : curved_samples()) {
        const Box2 b = bounding_box(part);
        const CutCells cells = cut_cells(part, {{b.min.x(), b.max.x()}, {b.min.y(), b.max.y()}});
        for (int degree = 1; degree <= 4; ++degree) {
            const std::vector<CellRule> rules = cell_rules(part, cells, degree);
            EXPECT_LT(whole_error(part, cells, rules, degree), arc_tolerance) << degree;
            EXPECT_LT(contour_error(part, cells, rules, degree), arc_tolerance) << degree;
        }
    }
}

TEST(CellRules, OneForEachBoundaryCellInOrder) {
    const Part part = curved_samples()[1];
    const CutCells cells = cut_cells(part, {{-1, -0.5, 0, 0.5, 1}, {-1, -0.5, 0, 0.5, 1}});
    std::vector<int> expected, found;
    for (std::size_t c = 0; c < cells.cell_class.size(); ++c)
        if (cells.cell_class[c] == CellClass::boundary) expected.push_back(static_cast<int>(c));
    for (const CellRule& rule : cell_rules(part, cells, 2)) {
        found.push_back(rule.element);
        EXPECT_EQ(rule.points.size(), rule.weights.size());
    }
    EXPECT_EQ(found, expected);
    EXPECT_FALSE(found.empty());
}

TEST(CellRules, NoneWhereTheGridIsTheBoundary) {
    const Part square = straight_parts()[0];
    EXPECT_TRUE(cell_rules(square, cut_cells(square, {{0, 0.5, 1}, {0, 1}}), 2).empty());
}

// ---- ellipses and splines ----

TEST(CellRules, RightInEveryCellWithEllipsesAndSplines) {
    Random random(31);
    for (int k = 0; k < 60; ++k) {
        const Part part = random_part(3 + k % 4, random);
        const CutCells cells = cut_cells(part, random_grid(part, random, rule_grid_limits));
        const int degree = 1 + k / 4 % 4;
        EXPECT_LT(contour_error(part, cells, cell_rules(part, cells, degree), degree, 4), general_tolerance) << k;
    }
}

/// Closed in one cell, so that portions are as long as monotone pieces can be.
TEST(CellRules, OneCellAroundPartsOfEllipsesAndSplines) {
    Random random(37);
    for (int k = 0; k < 40; ++k) {
        const Part part = random_part(3 + k % 4, random);
        const Box2 b = bounding_box(part);
        const CutCells cells = cut_cells(part, {{b.min.x(), b.max.x()}, {b.min.y(), b.max.y()}});
        for (int degree = 1; degree <= 4; ++degree)
            EXPECT_LT(contour_error(part, cells, cell_rules(part, cells, degree), degree, 4), general_tolerance) << k;
    }
}

}  // namespace

}  // namespace cell_rules_test
