// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/rule_check.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/quadrature/transformed_gauss.hpp"
#include "tests/geometry/cells/slotted_parts.hpp"

namespace rule_check_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;

/// Errors are relative to the part's area, roundings to that of its box: those of a thin ring are larger by their ratio.
double tolerance(const Part& part) {
    return 1e-13 * std::max(1.0, area_of(bounding_box(part)) / area(part));
}
/// Of a thin part the divergence theorem's integrals cancel in curved cells, to what their number of points is chosen for.
constexpr double arc_tolerance = 1e-9;

double worst(const RuleCheck& check) {
    return std::max({check.area, check.centroid, check.divergence});
}

struct Sample {
    Part part;
    CutCells cells;
    Elements elements;
};

Sample sample(unsigned k) {
    Random random(k);
    const int kind = static_cast<int>(k % (n_slotted_kinds + n_part_kinds));
    Sample s{kind < n_slotted_kinds ? slotted_part(kind, random) : random_part(kind - n_slotted_kinds, random), {}, {}};
    s.cells = cut_cells(s.part, random_grid(s.part, random, {0.02, 0.3}));
    s.elements = find_elements(s.part, s.cells);
    return s;
}

bool has_arcs(const Part& part) {
    return std::any_of(part.edges.begin(), part.edges.end(),
                       [](const Edge& e) { return std::holds_alternative<Arc>(e.curve); });
}

TEST(RuleCheck, RulesOfCellsAreRight) {
    for (unsigned k = 0; k < 240; ++k) {
        const Sample s = sample(k);
        const int degree = 1 + static_cast<int>(k / 15 % 4);
        const std::vector<CellRule> rules = cell_rules(s.part, s.cells, s.elements, degree);
        const RuleCheck check = check_rules(s.part, s.cells, s.elements, rules, degree);
        const double ratio = std::max(1.0, area_of(bounding_box(s.part)) / area(s.part));
        EXPECT_LT(worst(check), tolerance(s.part) + (has_arcs(s.part) ? arc_tolerance * ratio : 0)) << k;
        std::size_t points = 0;
        for (const CellRule& rule : rules) points += rule.points.size();
        EXPECT_EQ(check.points, points);
        EXPECT_EQ(check.outside_cell, 0u) << k;
    }
}

TEST(RuleCheck, TransformedRulesAreRightAndPositive) {
    for (unsigned k = 0; k < 30; ++k) {
        const Sample s = sample(k);
        const RuleCheck check = check_rules(s.part, s.cells, s.elements, transformed_rules(s.part, s.cells, s.elements, 2), 2);
        EXPECT_LT(worst(check), 1e-9 * std::max(1.0, area_of(bounding_box(s.part)) / area(s.part))) << k;
        EXPECT_EQ(check.negative_weights, 0u);
        EXPECT_EQ(check.outside_cell, 0u);
    }
}

/// Everything that it is there for, by the smallest amount that is not rounding.
TEST(RuleCheck, NoticesAFault) {
    for (unsigned k : {0u, 8u, 12u, 13u}) {
        const Sample s = sample(k);
        const auto check = [&](const std::vector<CellRule>& rules) {
            return check_rules(s.part, s.cells, s.elements, rules, 2);
        };
        const std::vector<CellRule> good = cell_rules(s.part, s.cells, s.elements, 2);
        const double most = 10 * std::max(worst(check(good)), tolerance(s.part));
        std::vector<CellRule> bad = good;
        bad[0].weights[0] += 2 * most * area(s.part);
        EXPECT_GT(check(bad).area, most) << k;
        bad = good;
        bad.pop_back();  // a cell forgotten
        EXPECT_GT(check(bad).divergence, s.elements.fraction[static_cast<std::size_t>(good.back().element)] > 1e-9 ? most : -1)
            << k;
        bad = cell_rules(s.part, s.cells, s.elements, 1);  // a degree too low
        EXPECT_LT(check(bad).area, most) << k;
        EXPECT_GT(check(bad).divergence, most) << k;
        bad = good;
        for (CellRule& rule : bad)
            for (Vec2& p : rule.points) p += 1e-6 * bounding_box(s.part).size();
        EXPECT_GT(check(bad).centroid, 1e-8) << k;
        bad = good;
        bad[0].points[0] = bounding_box(s.part).max + Vec2(9, 9);
        EXPECT_EQ(check(bad).outside_cell, 1u);
        bad[0].weights[0] = -1;
        bad[0].weights[1] = 1;
        EXPECT_GE(check(bad).negative_weights, 1u);
    }
}

}  // namespace

}  // namespace rule_check_test
