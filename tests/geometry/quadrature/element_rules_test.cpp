// SPDX-License-Identifier: GPL-3.0-or-later
// Rules of elements: cells that a slot parts.
#include <gtest/gtest.h>

#include <vector>

#include "geometry/quadrature/quadrature.hpp"
#include "tests/geometry/cells/swept_parts.hpp"
#include "tests/geometry/quadrature/quadrature_oracles.hpp"

namespace element_rules_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;

/// Left of a slot, right of it, and below.
Part u_shape() {
    return of_polygons({{{0, 0}, {2, 0}, {2, 2}, {0.75, 2}, {0.75, 0.5}, {0.625, 0.5}, {0.625, 2}, {0, 2}}});
}

TEST(ElementRules, OneForEachArmBesideASlot) {
    const Part part = u_shape();
    const CutCells cells = cut_cells(part, {{0, 1, 2}, {0, 1, 2}});
    const Elements elements = find_elements(part, cells);
    const std::vector<CellRule> rules = cell_rules(part, cells, elements, 2);
    ASSERT_EQ(rules.size(), 3u);
    const std::vector<Corners> expected{{{0, 0}, {1, 0}, {1, 1}, {0.75, 1}, {0.75, 0.5}, {0.625, 0.5}, {0.625, 1}, {0, 1}},
                                        {{0, 0}, {0.625, 0}, {0.625, 1}, {0, 1}},
                                        {{0.75, 0}, {1, 0}, {1, 1}, {0.75, 1}}};
    const std::vector<int> numbers{0, 2, 4};
    for (std::size_t r = 0; r < 3; ++r) {
        EXPECT_EQ(rules[r].element, numbers[r]);
        Moments moments = rule_moments(rules[r], unit_frame(cells.grid, elements.cell_of(numbers[r])), 4);
        for (std::size_t i = 0; i < expected[r].size(); ++i)
            moments -= segment_moments(expected[r][i], expected[r][(i + 1) % expected[r].size()], 4);
        EXPECT_LT(worst_of(moments), 1e-15) << r;
    }
}

TEST(ElementRules, TheSameBitForBitWithoutSlots) {
    on_swept_grids(curved_samples(), 3, [](const Part& part, const CutCells& cells, int degree) {
        const Elements elements = find_elements(part, cells);
        if (!elements.cell_of_extra.empty()) return;
        const std::vector<CellRule> a = cell_rules(part, cells, degree), b = cell_rules(part, cells, elements, degree);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t r = 0; r < a.size(); ++r) {
            EXPECT_EQ(a[r].element, b[r].element);
            EXPECT_EQ(a[r].points, b[r].points);
            EXPECT_EQ(a[r].weights, b[r].weights);
        }
    });
}

/// The arms' faces along the slot, in one cell each, belong to different elements.
TEST(ElementRules, BoundaryPointsCarryTheElement) {
    const Part part = u_shape();
    const CutCells cells = cut_cells(part, {{0, 1, 2}, {0, 1, 2}});
    const Elements elements = find_elements(part, cells);
    const auto elements_along = [&](int edge) {
        std::vector<int> all;
        for (const BoundaryPoint& p : boundary_rule(part, cells, elements, edge, 0, 1, 2)) {
            EXPECT_EQ(p.element, element_at(part, cells, elements, p.x - 1e-9 * p.normal));
            if (all.empty() || all.back() != p.element) all.push_back(p.element);
        }
        return all;
    };
    EXPECT_EQ(elements_along(3), (std::vector<int>{4, 0}));  // down the right face
    EXPECT_EQ(elements_along(5), (std::vector<int>{0, 2}));  // up the left one
    EXPECT_EQ(elements_along(2), (std::vector<int>{3, 4}));  // the tops
    EXPECT_EQ(elements_along(6), (std::vector<int>{2}));
}

}  // namespace

}  // namespace element_rules_test
