// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold of the cells of any part on any grid, on random parts of every kind of curve and grids whose lines lie on
// edges, vertices, extreme points and knots, beside them by 1e-1 to 1e-14 of the part's extent, and anywhere.
#include <gtest/gtest.h>

#include "geometry/quadrature/quadrature.hpp"
#include "tests/geometry/cells/random_parts.hpp"

namespace random_cells_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;

constexpr double relative_tolerance = 1e-12;

/// Relative to the part's area.
double area_error(const Part& part, const CutCells& cells) {
    const double whole = area(part);
    return std::abs(cells.area - whole) / whole;
}

/// The rules' weights against the fractions, in units of the cell's area.
double weight_error(const CutCells& cells, const std::vector<CellRule>& rules) {
    double worst = 0;
    for (const CellRule& rule : rules) {
        double sum = 0;
        for (double w : rule.weights) sum += w;
        const double full = area_of(box_of(cells.grid, rule.element));
        worst = std::max(worst, std::abs(sum / full - cells.fraction[static_cast<std::size_t>(rule.element)]));
    }
    return worst;
}

/// The integral of n, in units of the perimeter, and that of x.n less twice the area, in units of the area; the larger.
double divergence_error(const Part& part, const CutCells& cells) {
    Vec2 normal(0, 0);
    double flux = 0;
    for (std::size_t e = 0; e < part.edges.size(); ++e)
        for (const BoundaryPoint& p : boundary_rule(part, cells, static_cast<int>(e), 0, 1, 2)) {
            normal += p.weight * p.normal;
            flux += p.weight * p.x.dot(p.normal);
        }
    return std::max(normal.norm() / perimeter(part), std::abs(flux / (2 * area(part)) - 1));
}

/// Number of inner cells with their centre outside the part, of outer ones with it inside (unless the boundary is within
/// rounding of it), and of points that slabs and plain pieces tell apart.
int wrong_centers(const Part& part, const CutCells& cells) {
    const SlabbedPieces slabs = slabbed(monotone_pieces(part));
    int wrong = 0;
    for (int c = 0; c < n_cells(cells.grid); ++c) {
        const CellClass kind = cells.cell_class[static_cast<std::size_t>(c)];
        const Vec2 p = box_of(cells.grid, c).center();
        const bool is_inside = contains(slabs, p);
        if (is_inside != contains(slabs.pieces, p)) ++wrong;
        if (kind != CellClass::boundary && is_inside != (kind == CellClass::inner) && distance_to_boundary(part, p) > 1e-9)
            ++wrong;
    }
    return wrong;
}

/// Empty, or the first piece without a cell that has material.
std::string outer_piece(const CutCells& cells) {
    for (const BoundaryPiece& piece : cells.pieces)
        if (piece.cell < 0 || cells.cell_class[static_cast<std::size_t>(piece.cell)] == CellClass::outer)
            return "piece of edge " + std::to_string(piece.edge) + " from " + std::to_string(piece.t0);
    return "";
}

void check(const Part& part, const Grid& grid, int degree) {
    const CutCells cells = cut_cells(part, grid);
    EXPECT_LT(area_error(part, cells), relative_tolerance);
    EXPECT_EQ(partition_problem(cells), "");
    EXPECT_EQ(cover_problem(part, cells), "");
    EXPECT_EQ(outer_piece(cells), "");
    EXPECT_EQ(wrong_centers(part, cells), 0);
    EXPECT_LT(weight_error(cells, cell_rules(part, cells, degree)), relative_tolerance);
    EXPECT_LT(divergence_error(part, cells), relative_tolerance);
}

/// Each case has a seed of its own, so that one can be run alone.
void run_cases(unsigned first, unsigned n, bool trees = false) {
    for (unsigned k = first; k < first + n; ++k) {
        Random random(k);
        SCOPED_TRACE("case " + std::to_string(k));
        const Part part = random_part(static_cast<int>(k % n_part_kinds), random);
        const Grid grid = trees ? random_tree(part, random) : random_grid(part, random);
        check(part, grid, 1 + static_cast<int>(k / n_part_kinds % 3));
        if (testing::Test::HasFailure()) return;
    }
}

TEST(RandomCells, HoldWhatMustHoldOfAnyCells) {
    run_cases(0, 300);
}

TEST(RandomCells, HoldItOnTrees) {
    run_cases(0, 300, true);
}

TEST(LongRandomCells, HoldItOnTrees) {
    run_cases(1000, 10000, true);
}

TEST(LongRandomCells, HoldWhatMustHoldOfAnyCells) {
    run_cases(1000, 10000);
}

/// The smallest form of each special position, one by one: lines on all vertices, on all extreme points, and slivers of every
/// size beside them, on both sides.
TEST(RandomCells, SliversOfEverySizeBesideEverySpecialValue) {
    for (int kind = 0; kind < n_part_kinds; ++kind)
        for (int digits = 3; digits <= 15; ++digits)
            for (double sign : {-1.0, 0.0, 1.0}) {
                SCOPED_TRACE("kind " + std::to_string(kind) + ", 1e-" + std::to_string(digits) + " * " + std::to_string(sign));
                Random random(static_cast<unsigned>(kind));
                const Part part = random_part(kind, random);
                const Box2 box = bounding_box(part);
                const auto lines = [&](int axis) {
                    std::vector<double> all = special_values(part, axis), apart{box.min[axis] - 0.1};
                    std::sort(all.begin(), all.end());
                    for (double v : all)
                        if (v - apart.back() > 0.05) apart.push_back(v + sign * std::pow(10.0, -digits));
                    apart.push_back(box.max[axis] + 0.2);
                    return apart;
                };
                check(part, {lines(0), lines(1)}, 2);
                if (testing::Test::HasFailure()) return;
            }
}

TEST(RandomCellsChecks, NoticeAFault) {
    Random random(4);
    const Part part = random_part(4, random);
    const CutCells good = cut_cells(part, random_grid(part, random));
    ASSERT_LT(area_error(part, good), relative_tolerance);
    CutCells cells = good;
    cells.area *= 1 + 2 * relative_tolerance;
    EXPECT_GT(area_error(part, cells), relative_tolerance);
    std::vector<CellRule> rules = cell_rules(part, good, 2);
    ASSERT_LT(weight_error(good, rules), relative_tolerance);
    rules[0].weights[0] += 2 * relative_tolerance * area_of(box_of(good.grid, rules[0].element));
    EXPECT_GT(weight_error(good, rules), relative_tolerance);
    cells = good;
    cells.pieces.erase(cells.pieces.begin());  // of the first edge
    for (std::size_t e = 1; e < cells.first_piece.size(); ++e) --cells.first_piece[e];
    EXPECT_GT(divergence_error(part, cells), relative_tolerance);
    EXPECT_NE(cover_problem(part, cells), "");
    cells = good;
    cells.pieces[0].cell = -1;
    EXPECT_NE(outer_piece(cells), "");
    cells = good;
    for (CellClass& c : cells.cell_class)
        if (c == CellClass::inner) c = CellClass::outer;
    EXPECT_GT(wrong_centers(part, cells), 0);
    EXPECT_NE(partition_problem(cells), "");
}

}  // namespace

}  // namespace random_cells_test
