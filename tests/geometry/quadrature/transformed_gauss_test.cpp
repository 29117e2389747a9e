// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/transformed_gauss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/geometry/cells/slotted_parts.hpp"

namespace transformed_gauss_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;

constexpr int n_kinds = n_slotted_kinds + n_part_kinds;

Part part_of_kind(int kind, Random& random) {
    return kind < n_slotted_kinds ? slotted_part(kind, random) : random_part(kind - n_slotted_kinds, random);
}

bool is_straight(const Part& part) {
    return std::all_of(part.edges.begin(), part.edges.end(),
                       [](const Edge& e) { return std::holds_alternative<Segment>(e.curve); });
}

/// In the cell as the unit square, per its area.
double integral(const CellRule& rule, const Box2& cell, const std::function<double(const Vec2&)>& f) {
    double sum = 0;
    for (std::size_t q = 0; q < rule.points.size(); ++q)
        sum += rule.weights[q] / area_of(cell) * f((rule.points[q] - cell.min).cwiseQuotient(cell.size()));
    return sum;
}

/// Largest difference of the integrals of u^i v^j, i and j to 2 degree, of any element, between the rule and that of the
/// divergence theorem.
double moment_error(const CutCells& cells, const Elements& elements, const std::vector<CellRule>& rules,
                    const std::vector<CellRule>& expected, int degree) {
    if (rules.size() != expected.size()) return 1e300;
    double worst = 0;
    for (std::size_t r = 0; r < rules.size(); ++r) {
        if (rules[r].element != expected[r].element) return 1e300;
        const Box2 cell = box_of(cells.grid, elements.cell_of(rules[r].element));
        for (int i = 0; i <= 2 * degree; ++i)
            for (int j = 0; j <= 2 * degree; ++j) {
                const auto f = [&](const Vec2& u) { return std::pow(u.x(), i) * std::pow(u.y(), j); };
                worst = std::max(worst, std::abs(integral(rules[r], cell, f) - integral(expected[r], cell, f)));
            }
    }
    return worst;
}

/// Empty, or a point that is outside the part or in another element's material, or a weight that is not positive.
std::string point_problem(const Part& part, const CutCells& cells, const Elements& elements,
                          const std::vector<CellRule>& rules) {
    constexpr double on_boundary = 1e-12;
    const SlabbedPieces pieces = slabbed(monotone_pieces(part));
    for (const CellRule& rule : rules)
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const std::string name = "point " + std::to_string(q) + " of element " + std::to_string(rule.element);
            const Vec2& p = rule.points[q];
            if (!(rule.weights[q] > 0)) return name + " has no positive weight";
            const Box2 cell = box_of(cells.grid, elements.cell_of(rule.element));
            if (!cell.overlaps({p, p}, on_boundary)) return name + " is elsewhere";
            const bool inside = contains(pieces, p);
            if (!inside && distance_to_boundary(part, p) > on_boundary) return name + " is outside";
            const bool is_clear = inside && cell.overlaps({p, p}, -on_boundary);
            if (q % 7 != 0 || !is_clear || distance_to_boundary(part, p) < on_boundary) continue;
            if (element_at(part, cells, elements, p) != rule.element) return name + " is in another element";
        }
    return "";
}

/// Coordinates of 1 over cells of 0.02: roundings of 1e-14 to the power of 2 x degree <= 8 in each direction, and a dozen slabs
/// of sliver_fraction left out.
constexpr double straight_tolerance = 1e-11;
/// As the header says for thin rings; the median is 1e-15.
constexpr double curved_tolerance = 1e-7;

void run_cases(unsigned first, unsigned n) {
    for (unsigned k = first; k < first + n && !testing::Test::HasFailure(); ++k) {
        Random random(k);
        SCOPED_TRACE("case " + std::to_string(k));
        const Part part = part_of_kind(static_cast<int>(k % n_kinds), random);
        const CutCells cells = cut_cells(part, random_grid(part, random));
        const Elements elements = find_elements(part, cells);
        const int degree = 1 + static_cast<int>(k / n_kinds % 4);
        const std::vector<CellRule> rules = transformed_rules(part, cells, elements, degree);
        EXPECT_LT(moment_error(cells, elements, rules, cell_rules(part, cells, elements, degree), degree),
                  is_straight(part) ? straight_tolerance : curved_tolerance);
        EXPECT_EQ(point_problem(part, cells, elements, rules), "");
    }
}

TEST(TransformedRules, IntegratePolynomialsWithPointsInside) {
    run_cases(0, 30);
}

TEST(LongTransformedRules, IntegratePolynomialsWithPointsInside) {
    run_cases(1000, 10000);
}

/// A function that no polynomial is, as the weights of a solution structure are none.
double smooth(const Vec2& u) {
    return std::exp(u.x() - 0.5 * u.y()) * std::cos(3 * u.y()) / (1.5 + u.x() * u.y());
}

/// Largest error of any element against very many points.
std::vector<double> errors_by_extra(const Part& part, const Grid& grid, const std::vector<int>& extras) {
    const CutCells cells = cut_cells(part, grid);
    const Elements elements = find_elements(part, cells);
    const std::vector<CellRule> reference = transformed_rules(part, cells, elements, 2, 30);
    std::vector<double> errors;
    for (int extra : extras) {
        const std::vector<CellRule> rules = transformed_rules(part, cells, elements, 2, extra);
        double worst = 0;
        for (std::size_t r = 0; r < rules.size(); ++r) {
            const Box2 cell = box_of(grid, elements.cell_of(rules[r].element));
            worst = std::max(worst, std::abs(integral(rules[r], cell, smooth) - integral(reference[r], cell, smooth)));
        }
        errors.push_back(worst);
    }
    return errors;
}

/// A parabola's inner rule of n points has an error of order h^2n: two more points each way leave less than a hundredth. Parts
/// in one cell with all their extreme points, and in several.
TEST(TransformedRules, ConvergeExponentiallyOnEveryCurve) {
    for (int kind = 0; kind < n_part_kinds; ++kind) {
        Random random(static_cast<unsigned>(kind) + 3);
        const Part part = kind == 3 ? random_disc_with_holes(random) : random_part(kind, random);
        const Box2 box = bounding_box(part);
        for (const std::vector<double>& at : {std::vector<double>{0, 1}, {0, 0.37, 0.61, 1}}) {
            Grid grid;
            for (double s : at) {
                grid.x.push_back(box.min.x() + s * box.size().x());
                grid.y.push_back(box.min.y() + s * box.size().y());
            }
            const std::vector<double> errors = errors_by_extra(part, grid, {0, 2, 4, 8});
            for (std::size_t k = 1; k < errors.size(); ++k)
                EXPECT_LT(errors[k], std::max(0.02 * errors[k - 1], 1e-11)) << kind << " " << k << " of " << at.size();
        }
    }
}

/// Four extreme points in one cell: Gauss's rule in the coordinate would converge as n^-3.
TEST(TransformedRules, ADiscInOneCell) {
    const double turn = 2 * std::numbers::pi;
    Part part;
    add_loop(part, {Arc{{0, 0}, 1, 0.4, turn}});
    const CutCells cells = cut_cells(part, {{-1.5, 1.5}, {-1.25, 1.25}});
    const Elements elements = find_elements(part, cells);
    for (int degree = 1; degree <= 4; ++degree) {
        const std::vector<CellRule> rules = transformed_rules(part, cells, elements, degree);
        double sum = 0;
        for (double w : rules[0].weights) sum += w;
        EXPECT_NEAR(sum, turn / 2, 1e-10) << degree;
    }
}

TEST(TransformedRules, NPointsEachWay) {
    const Part part = [] {
        Part p;
        add_loop(p, closed({{0, 0}, {1, 0}, {1, 0.4}, {0, 0.7}}));
        return p;
    }();
    const CutCells cells = cut_cells(part, {{0, 1}, {0, 1}});
    const Elements elements = find_elements(part, cells);
    for (int degree = 1; degree <= 3; ++degree)
        for (int extra : {0, 1, 5}) {
            const std::vector<CellRule> rules = transformed_rules(part, cells, elements, degree, extra);
            ASSERT_EQ(rules.size(), 1u);
            EXPECT_EQ(rules[0].points.size(), static_cast<std::size_t>((2 * degree + 1 + extra) * (degree + 1 + extra)));
        }
}

TEST(TransformedRuleChecks, NoticeAFault) {
    Random random(4);
    const Part part = random_part(4, random);
    const CutCells cells = cut_cells(part, random_grid(part, random));
    const Elements elements = find_elements(part, cells);
    const std::vector<CellRule> expected = cell_rules(part, cells, elements, 2);
    std::vector<CellRule> rules = transformed_rules(part, cells, elements, 2);
    ASSERT_LT(moment_error(cells, elements, rules, expected, 2), curved_tolerance);
    ASSERT_EQ(point_problem(part, cells, elements, rules), "");
    const std::vector<CellRule> good = rules;
    const auto largest = std::max_element(
        rules.begin(), rules.end(), [](const CellRule& a, const CellRule& b) { return a.points.size() < b.points.size(); });
    for (double& w : largest->weights) w *= 1 + 1e-6;
    EXPECT_GT(moment_error(cells, elements, rules, expected, 2), curved_tolerance);
    rules = good;
    rules[0].weights[0] = -1e-9;
    EXPECT_NE(point_problem(part, cells, elements, rules), "");
    rules = good;
    rules[0].points[0] = bounding_box(part).max + Vec2(1, 1);
    EXPECT_NE(point_problem(part, cells, elements, rules), "");
}

}  // namespace

}  // namespace transformed_gauss_test
