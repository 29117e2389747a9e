// SPDX-License-Identifier: GPL-3.0-or-later
// Elements against components found without a walk along the boundary (cell_slabs.hpp), on parts with slots, cracks and thin
// arms of 1e-9 to 1, and on grids whose lines lie on edges and vertices, beside them, and anywhere.
#include "geometry/cells/elements.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "geometry/cells/cell_trace.hpp"
#include "tests/geometry/cells/slotted_parts.hpp"
#include "tests/geometry/quadrature/cell_slabs.hpp"

namespace elements_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;

/// Elements of a cell, the cell itself first.
std::vector<int> elements_of(const Elements& elements, int cell) {
    std::vector<int> all{cell};
    const std::size_t n = elements.fraction.size() - elements.cell_of_extra.size();
    for (std::size_t k = 0; k < elements.cell_of_extra.size(); ++k)
        if (elements.cell_of_extra[k] == cell) all.push_back(static_cast<int>(n + k));
    return all;
}

/// The sum over each cell's elements against the cell's fraction, the largest difference.
double sum_error(const CutCells& cells, const Elements& elements) {
    std::vector<double> sum(cells.fraction.size(), 0.0);
    for (std::size_t e = 0; e < elements.fraction.size(); ++e)
        sum[static_cast<std::size_t>(elements.cell_of(static_cast<int>(e)))] += elements.fraction[e];
    double worst = 0;
    for (std::size_t c = 0; c < sum.size(); ++c) worst = std::max(worst, std::abs(sum[c] - cells.fraction[c]));
    return worst;
}

std::vector<int> default_neighbours(const CutCells& cells, int cell) {
    const Grid& grid = cells.grid;
    std::vector<int> around;
    for (const auto& [dx, dy] : {std::pair{0, -1}, {-1, 0}, {1, 0}, {0, 1}})
        grid.for_cells_across(cell, dx, dy, [&](int other) {
            if (cells.fraction[static_cast<std::size_t>(other)] > 0) around.push_back(other);
        });
    std::sort(around.begin(), around.end());
    return around;
}

std::vector<int> neighbours_of(const CutCells& cells, const Elements& elements, int element) {
    const auto it = elements.neighbours.find(element);
    return it != elements.neighbours.end() ? it->second : default_neighbours(cells, elements.cell_of(element));
}

int n_connected(const CutCells& cells, const Elements& elements) {
    std::vector<int> seen(elements.fraction.size(), 0);
    int n = 0;
    for (std::size_t e = 0; e < seen.size(); ++e) {
        if (seen[e] || !(elements.fraction[e] > 0)) continue;
        ++n;
        std::vector<int> open{static_cast<int>(e)};
        seen[e] = 1;
        while (!open.empty()) {
            const int k = open.back();
            open.pop_back();
            for (int other : neighbours_of(cells, elements, k))
                if (!seen[static_cast<std::size_t>(other)]++) open.push_back(other);
        }
    }
    return n;
}

// ---- against slabs ----

double crossing_length(const Part& part) {
    return crossing_fraction * merge_length(part);
}

/// Of a cell that is larger on all sides by `margin`.
SlabbedCell slabs_of(const std::vector<MonotonePiece>& pieces, const Grid& grid, int cell, double margin, double rounding) {
    const Box2 box = box_of(grid, cell);
    const Vec2 wider = Vec2::Constant(margin);
    return slabbed_cell(pieces, {box.min - wider, box.max + wider}, rounding);
}

std::string fraction_problem(const SlabbedCell& slabs, const Elements& elements, int cell, double tolerance) {
    std::vector<double> expected = slabs.fraction, found;
    for (int e : elements_of(elements, cell)) found.push_back(elements.fraction[static_cast<std::size_t>(e)]);
    std::sort(expected.rbegin(), expected.rend());
    const std::size_t n = std::max(expected.size(), found.size());
    expected.resize(n);
    found.resize(n);
    double worst = 0;
    std::string text = "cell " + std::to_string(cell) + ":";
    for (std::size_t k = 0; k < n; ++k) {
        worst = std::max(worst, std::abs(expected[k] - found[k]));
        text += " " + std::to_string(found[k]) + " (" + std::to_string(expected[k]) + ")";
    }
    return worst <= tolerance ? "" : text;
}

/// Intervals with less room around their middle, or components of a smaller fraction, are left out: 1e-11 of a cell may go
/// either way.
constexpr double least_room = 1e-10, least_fraction = 1e-10;

/// Element of each component, by points of it; -1 where none has room. Empty string, or what is wrong: an element in two
/// components, or two in one.
std::string match(const Part& part, const CutCells& cells, const Elements& elements, const SlabbedCell& slabs, int cell,
                  std::vector<int>& element_of) {
    element_of.assign(slabs.fraction.size(), -1);
    for (const SlabInterval& i : slabs.intervals) {
        const double y = 0.5 * (slabs.bounds[i.slab] + slabs.bounds[i.slab + 1]);
        const Box2 box = box_of(cells.grid, cell);
        const double from = std::max(box.min.x(), x_on(slabs.pieces[static_cast<std::size_t>(i.left)], y));
        const double to = std::min(box.max.x(), x_on(slabs.pieces[static_cast<std::size_t>(i.right)], y));
        if (slabs.fraction[static_cast<std::size_t>(i.component)] < least_fraction || to - from < least_room ||
            slabs.bounds[i.slab + 1] - slabs.bounds[i.slab] < least_room)
            continue;
        int& element = element_of[static_cast<std::size_t>(i.component)];
        const int found = element_at(part, cells, elements, {0.5 * (from + to), y});
        if (elements.cell_of(found) != cell) return "a point of cell " + std::to_string(cell) + " is in another cell's element";
        if (element >= 0 && found != element) return "two elements in one component of cell " + std::to_string(cell);
        element = found;
    }
    for (std::size_t a = 0; a < element_of.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            if (element_of[a] >= 0 && element_of[a] == element_of[b])
                return "one element in two components of cell " + std::to_string(cell);
    return "";
}

/// Empty, or what is wrong with the elements of a cell. Where a tip nearly reaches a side, or a side runs along an edge, there
/// is more than one reading: with material connected by a neck of a rounding; of a cell a little larger, or a little smaller.
std::string cell_problem(const Part& part, const std::vector<MonotonePiece>& pieces, const CutCells& cells,
                         const Elements& elements, int cell, double tolerance) {
    // a crack whose area is a rounding of the cell's is not seen
    if (cells.cell_class[static_cast<std::size_t>(cell)] == CellClass::inner) return "";
    std::string first;
    for (const auto& [margin, rounding] : {std::pair{0.0, 1.0}, {0.0, 1e-3}, {10.0, 1.0}, {-10.0, 1.0}}) {
        const double wider = margin * crossing_length(part);
        const double rim = 8 * std::abs(wider) / box_of(cells.grid, cell).size().minCoeff();
        const SlabbedCell slabs = slabs_of(pieces, cells.grid, cell, wider, rounding * crossing_length(part));
        std::string problem = fraction_problem(slabs, elements, cell, tolerance + rim);
        std::vector<int> element_of;
        if (problem.empty()) problem = match(part, cells, elements, slabs, cell, element_of);
        if (problem.empty()) return "";
        if (first.empty()) first = problem;
    }
    return first;
}

/// Empty, or a pair of elements that share no material across a side although they are neighbours.
std::string neighbour_problem(const CutCells& cells, const Elements& elements) {
    for (std::size_t e = 0; e < elements.fraction.size(); ++e) {
        if (!(elements.fraction[e] > 0)) continue;
        for (int other : neighbours_of(cells, elements, static_cast<int>(e))) {
            const std::vector<int> back = neighbours_of(cells, elements, other);
            if (std::find(back.begin(), back.end(), static_cast<int>(e)) == back.end())
                return std::to_string(e) + " and " + std::to_string(other) + " do not agree";
        }
    }
    return "";
}

/// Empty, or a piece whose element does not hold the point beside it, `inside` away, where that is in the piece's cell.
std::string piece_problem(const Part& part, const CutCells& cells, const Elements& elements, double inside) {
    for (std::size_t k = 0; k < cells.pieces.size(); ++k) {
        const BoundaryPiece& piece = cells.pieces[k];
        const std::string name = "piece " + std::to_string(k);
        if (elements.cell_of(elements.of_piece[k]) != piece.cell) return name + " has an element of another cell";
        const Curve& curve = part.edges[static_cast<std::size_t>(piece.edge)].curve;
        const double t = 0.5 * (piece.t0 + piece.t1);
        const Vec2 p = point(curve, t) - inside * outward_normal(curve, t);
        if (length(curve, piece.t0, piece.t1) < 4 * inside || !box_of(cells.grid, piece.cell).overlaps({p, p}, -1e-12))
            continue;
        if (element_at(part, cells, elements, p) != elements.of_piece[k]) return name;
    }
    return "";
}

constexpr int n_kinds = n_slotted_kinds + n_part_kinds;

/// Of polygons areas are exact but for rounding of cells a hundredth of the part; of the others the slabs' areas are rough.
double area_tolerance(const Part& part) {
    const bool straight = std::all_of(part.edges.begin(), part.edges.end(),
                                      [](const Edge& e) { return std::holds_alternative<Segment>(e.curve); });
    return straight ? 1e-10 : 1e-2;
}

/// Each case has a seed of its own, so that one can be run alone.
int run_cases(unsigned first, unsigned n, bool trees = false) {
    int n_extra = 0;
    for (unsigned k = first; k < first + n; ++k) {
        Random random(k);
        SCOPED_TRACE("case " + std::to_string(k));
        const int kind = static_cast<int>(k % n_kinds);
        const Part part = kind < n_slotted_kinds ? slotted_part(kind, random) : random_part(kind - n_slotted_kinds, random);
        const CutCells cells = cut_cells(part, trees ? random_tree(part, random) : random_grid(part, random));
        const Elements elements = find_elements(part, cells);
        n_extra += static_cast<int>(elements.cell_of_extra.size());
        EXPECT_EQ(elements.unclear, 0);
        EXPECT_LT(sum_error(cells, elements), 1e-12);
        EXPECT_EQ(n_connected(cells, elements), 1);
        EXPECT_EQ(neighbour_problem(cells, elements), "");
        EXPECT_EQ(piece_problem(part, cells, elements, 1e-10), "");
        const std::vector<MonotonePiece> pieces = monotone_pieces(part);
        for (int c = 0; c < n_cells(cells.grid) && !testing::Test::HasFailure(); ++c)
            EXPECT_EQ(cell_problem(part, pieces, cells, elements, c, area_tolerance(part)), "");
        if (testing::Test::HasFailure()) break;
    }
    return n_extra;
}

TEST(Elements, AreTheComponentsOfCells) {
    EXPECT_GT(run_cases(0, 45), 50);
}

TEST(Elements, AreTheComponentsOfTheCellsOfTrees) {
    EXPECT_GT(run_cases(0, 45, true), 50);
}

TEST(LongElements, AreTheComponentsOfTheCellsOfTrees) {
    EXPECT_GT(run_cases(1000, 10000, true), 10000);
}

TEST(LongElements, AreTheComponentsOfCells) {
    EXPECT_GT(run_cases(1000, 10000), 10000);
}

// ---- the smallest form of each ----

Part outline(const Corners& polygon) {
    Part part;
    add_loop(part, closed(polygon));
    return part;
}

/// A U with a slot from x = a to b, down to y = bottom, of height 2 and width 2.
Part u_shape(double a, double b, double bottom) {
    return outline({{0, 0}, {2, 0}, {2, 2}, {b, 2}, {b, bottom}, {a, bottom}, {a, 2}, {0, 2}});
}

std::vector<int> neighbours_at(const Part& part, const CutCells& cells, const Elements& elements, const Vec2& p) {
    return neighbours_of(cells, elements, element_at(part, cells, elements, p));
}

TEST(Elements, ASlotInsideOneCellMakesTwo) {
    const Part part = u_shape(0.6, 0.7, 0.5);
    const CutCells cells = cut_cells(part, {{0, 1, 2}, {0, 1, 2}});
    const Elements elements = find_elements(part, cells);
    EXPECT_EQ(elements.cell_of_extra, std::vector<int>{2});
    EXPECT_NEAR(elements.fraction[2], 0.6, 1e-15);
    EXPECT_NEAR(elements.fraction[4], 0.3, 1e-15);
    EXPECT_NEAR(elements.fraction[0], 0.95, 1e-15);
    const std::map<int, std::vector<int>> expected{{0, {1, 2, 4}}, {2, {0}}, {3, {1, 4}}};
    EXPECT_EQ(elements.neighbours, expected);  // those of 4 are the cells around
    EXPECT_EQ(neighbours_of(cells, elements, 4), (std::vector<int>{0, 3}));
    EXPECT_EQ(element_at(part, cells, elements, {0.3, 1.5}), 2);
    EXPECT_EQ(element_at(part, cells, elements, {0.9, 1.5}), 4);
    EXPECT_EQ(element_at(part, cells, elements, {0.61, 1.5}), 2);  // outside, nearer to the left arm
    EXPECT_EQ(element_at(part, cells, elements, {0.69, 3}), 4);    // beyond the grid
}

TEST(Elements, ASlotAlongAGridLineMakesNone) {
    for (const auto& [a, b] : {std::pair{1.0, 1.01}, {0.99, 1.0}, {1.0, 1 + 1e-9}, {1 - 1e-9, 1.0}}) {
        const Part part = u_shape(a, b, 0.5);
        const CutCells cells = cut_cells(part, {{0, 1, 2}, {0, 1, 2}});
        const Elements elements = find_elements(part, cells);
        EXPECT_TRUE(elements.cell_of_extra.empty());
        const std::map<int, std::vector<int>> expected{{2, {0}}, {3, {1}}};
        EXPECT_EQ(elements.neighbours, expected) << a;
    }
}

/// The slot's end on a grid line, with the slot on either side of it, upright and lying: what the cell beyond sees of it is an
/// edge along its side.
TEST(Elements, ASlotEndsOnAGridLine) {
    for (int quarter = 0; quarter < 4; ++quarter) {
        const double c = quarter % 2 == 0 ? 1 - quarter : 0, s = quarter % 2 == 1 ? 2 - quarter : 0;
        const Part part = transformed(u_shape(0.6, 0.7, 1), c, s, {0, 0});
        const Box2 b = bounding_box(part);
        const Vec2 m = b.center();
        const CutCells cells = cut_cells(part, {{b.min.x(), m.x(), b.max.x()}, {b.min.y(), m.y(), b.max.y()}});
        const Elements elements = find_elements(part, cells);
        EXPECT_EQ(elements.cell_of_extra.size(), 1u) << quarter;
        const Vec2 left(c * 0.3 - s * 1.5, s * 0.3 + c * 1.5), right(c * 0.9 - s * 1.5, s * 0.9 + c * 1.5);
        EXPECT_EQ(neighbours_at(part, cells, elements, left).size(), 1u) << quarter;
        EXPECT_EQ(neighbours_at(part, cells, elements, right).size(), 2u) << quarter;
    }
}

/// So does the point of a wedge: the cell that it crosses is in two pieces.
TEST(Elements, AWedgeEndsOnAGridLine) {
    for (int quarter = 0; quarter < 4; ++quarter) {
        const double c = quarter % 2 == 0 ? 1 - quarter : 0, s = quarter % 2 == 1 ? 2 - quarter : 0;
        const Part part = transformed(outline({{0, 0}, {2, 0}, {2, 2}, {0.7, 2}, {0.65, 1}, {0.6, 2}, {0, 2}}), c, s, {0, 0});
        const Box2 b = bounding_box(part);
        const CutCells cells =
            cut_cells(part, {{b.min.x(), b.center().x(), b.max.x()}, {b.min.y(), b.center().y(), b.max.y()}});
        EXPECT_EQ(find_elements(part, cells).cell_of_extra.size(), 1u) << quarter;
    }
}

TEST(Elements, ANotchBetweenCellsPartsThem) {
    const Part part = outline({{0, 0}, {2, 0}, {2, 2}, {1.5, 2}, {1, 0.5}, {0.5, 2}, {0, 2}});
    const CutCells cells = cut_cells(part, {{0, 1, 2}, {0, 1, 2}});
    const Elements elements = find_elements(part, cells);
    EXPECT_TRUE(elements.cell_of_extra.empty());
    const std::map<int, std::vector<int>> expected{{2, {0}}, {3, {1}}};
    EXPECT_EQ(elements.neighbours, expected);
}

TEST(Elements, AnOrdinaryPartHasNothingSpecial) {
    for (int kind = 0; kind < n_part_kinds; ++kind) {
        Random random(7);
        const Part part = random_part(kind == 3 ? 2 : kind, random);  // a thin ellipse is not ordinary
        const Box2 b = bounding_box(part);
        const CutCells cells = cut_cells(part, {{b.min.x(), b.max.x()}, {b.min.y(), b.max.y()}});
        const Elements elements = find_elements(part, cells);
        EXPECT_TRUE(elements.cell_of_extra.empty() && elements.neighbours.empty()) << kind;
        EXPECT_EQ(elements.fraction, cells.fraction);
        for (std::size_t k = 0; k < cells.pieces.size(); ++k) EXPECT_EQ(elements.of_piece[k], cells.pieces[k].cell);
        for (std::size_t k = 0; k < cells.contours.size(); ++k) EXPECT_EQ(elements.of_contour[k], cells.contours[k].cell);
    }
}

/// A ring with an island in it, all in one cell, and holes in both.
TEST(Elements, IslandsAndTheirHolesInOneCell) {
    const double turn = 2 * std::numbers::pi;
    Part part;
    add_loop(part, {Arc{{0, 0}, 1, 0, turn}});
    add_loop(part, {Arc{{0, 0}, 0.6, 1, -turn}});
    add_loop(part, {Arc{{0.1, 0}, 0.4, 2, turn}});
    add_loop(part, {Arc{{0.2, 0.1}, 0.1, 3, -turn}});
    add_loop(part, {Arc{{-0.8, 0}, 0.1, 4, -turn}});
    const CutCells cells = cut_cells(part, {{-2, 2}, {-2, 2}});
    const Elements elements = find_elements(part, cells);
    ASSERT_EQ(elements.cell_of_extra.size(), 1u);
    const double pi = turn / 2;
    EXPECT_NEAR(elements.fraction[0], pi * (1 - 0.36 - 0.01) / 16, 1e-15);
    EXPECT_NEAR(elements.fraction[1], pi * (0.16 - 0.01) / 16, 1e-15);
    EXPECT_EQ(element_at(part, cells, elements, {0, 0.55}), 0);
    EXPECT_EQ(element_at(part, cells, elements, {0, 0.45}), 1);
    const int extra_pieces = static_cast<int>(std::count(elements.of_piece.begin(), elements.of_piece.end(), 1));
    EXPECT_EQ(extra_pieces, cells.first_piece[4] - cells.first_piece[2]);
}

/// A hole in a cell that just touches its sides, all four or some.
TEST(Elements, HolesThatTouchTheSidesOfACell) {
    const double turn = 2 * std::numbers::pi;
    for (double start : {0.0, 0.3, 2.0, 4.5})
        for (const auto& [low, high] : {std::pair{-1.0, 1.0}, {-1.0, 1.5}, {-1.5, 1.0}}) {
            Part part = outline({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}});
            add_loop(part, {Arc{{0, 0}, 1, start, -turn}});
            const CutCells cells = cut_cells(part, {{-3, low, high, 3}, {-3, -1, 1, 3}});
            const Elements elements = find_elements(part, cells);
            EXPECT_EQ(elements.unclear, 0);
            EXPECT_LT(sum_error(cells, elements), 1e-15);
            EXPECT_EQ(n_connected(cells, elements), 1);
            const int n_corners =
                low > -1.5 && high < 1.5 ? 4 : 2;  // touched at three sides: what is left of one is in one piece
            EXPECT_EQ(elements_of(elements, 4).size(), static_cast<std::size_t>(n_corners == 4 ? 4 : 3))
                << start << low << high;
        }
}

TEST(ElementChecks, NoticeAFault) {
    const Part part = u_shape(0.6, 0.7, 0.5);
    const CutCells cells = cut_cells(part, {{0, 1, 2}, {0, 1, 2}});
    const Elements good = find_elements(part, cells);
    const std::vector<MonotonePiece> pieces = monotone_pieces(part);
    ASSERT_EQ(cell_problem(part, pieces, cells, good, 2, 1e-10), "");
    ASSERT_EQ(piece_problem(part, cells, good, 1e-9), "");
    ASSERT_EQ(n_connected(cells, good), 1);
    Elements bad = good;
    bad.fraction[4] += 1e-6;
    EXPECT_NE(cell_problem(part, pieces, cells, bad, 2, 1e-10), "");
    EXPECT_GT(sum_error(cells, bad), 1e-12);
    bad = good;
    bad.neighbours[4] = {3};
    bad.neighbours[0] = {1, 2};
    bad.neighbours[1] = {0};
    EXPECT_EQ(n_connected(cells, bad), 2);
    EXPECT_NE(neighbour_problem(cells, bad), "");
    bad = good;
    for (int& e : bad.of_contour)
        if (e == 4) e = 2;
    EXPECT_NE(cell_problem(part, pieces, cells, bad, 2, 1e-10), "");
    bad = good;
    for (int& e : bad.of_piece)
        if (e == 4) e = 2;
    EXPECT_NE(piece_problem(part, cells, bad, 1e-9), "");
}

}  // namespace

}  // namespace elements_test
