// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/interfaces/common_grid.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/geometry/cells/random_parts.hpp"

namespace abut::geometry::common_grid_test {
namespace {

using test::Random;

Part block(double x0, double y0, double x1, double y1) {
    Part part;
    test::add_loop(part, test::closed({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}));
    return part;
}

CommonGrid grid_of(const std::vector<Part>& parts, double cell) {
    std::vector<const Part*> pointers;
    for (const Part& part : parts) pointers.push_back(&part);
    return common_grid(pointers, cell);
}

/// Two parts on a grid of unit cells: the case and the cells that make it.
void expect_case(const Part& part1, const Part& part2, char letter, const std::vector<int>& cells1,
                 const std::vector<int>& cells2) {
    SCOPED_TRACE(letter);
    const CommonGrid common = grid_of({part1, part2}, 1);
    EXPECT_EQ(cell_case(part1, part2, 1), letter);
    EXPECT_EQ(case_of_parts(common, 0, 1), letter);
    EXPECT_EQ(case_of_parts(common, 1, 0), letter);
    ASSERT_EQ(common.contacts.size(), letter == 'e' ? 0u : 1u);
    if (letter == 'e') return;
    EXPECT_EQ(common.contacts[0].its_case.cells[0], cells1);
    EXPECT_EQ(common.contacts[0].its_case.cells[1], cells2);
}

TEST(CommonGrid, TheFiveCasesAndTheirCells) {
    expect_case(block(0, 0, 2.5, 2), block(2.7, 0, 5, 2), 'a', {2, 7}, {2, 7});
    expect_case(block(0, 0, 1.5, 2), block(2.5, 0, 4, 2), 'b', {1, 5}, {2, 6});
    expect_case(block(0, 0, 2, 2), block(2.5, 0, 4, 2), 'c', {1, 5}, {2, 6});
    expect_case(block(0, 0, 2, 2), block(2, 0, 4, 2), 'd', {1, 5}, {2, 6});
    expect_case(block(0, 0, 1.5, 2), block(3.5, 0, 5, 2), 'e', {}, {});
    // corner to corner is no side in common
    expect_case(block(0, 0, 2, 2), block(2, 2, 4, 4), 'e', {}, {});
    // deep inside: four boundary cells within inner ones
    expect_case(block(2.25, 2.25, 3.75, 3.75), block(0, 0, 6, 6), 'c', {14, 15, 20, 21},
                {8, 9, 13, 14, 15, 16, 19, 20, 21, 22, 26, 27});
}

/// A face on a grid line with a boundary cell at its end: the case is that of the end, the cells are all along.
TEST(CommonGrid, CellsBesideAreThoseOfAllKinds) {
    const Part part1 = block(0, 0, 2, 3.5), part2 = block(2, 0, 4, 3.5);
    const CommonGrid common = grid_of({part1, part2}, 1);
    EXPECT_EQ(case_of_parts(common, 0, 1), 'b');
    EXPECT_EQ(common.contacts[0].its_case.cells[0], (std::vector<int>{13}));
    EXPECT_EQ(cells_beside(common.parts[0], common.parts[1], common.grid.columns), (std::vector<int>{1, 5, 9, 13}));
    EXPECT_EQ(cells_beside(common.parts[1], common.parts[0], common.grid.columns), (std::vector<int>{2, 6, 10, 14}));
}

TEST(CommonGrid, ThreePartsOnOneGridGiveThreeGrids) {
    // a stack: the first two overlap in a row of boundary cells, the last two meet on a grid line, the outer ones never meet
    const std::vector<Part> parts{block(0, 0, 4, 1.5), block(1, 1.6, 3, 4), block(-2, 4, 6, 5)};
    const CommonGrid common = grid_of(parts, 1);
    ASSERT_TRUE(common.refusal.empty());
    EXPECT_EQ(common.grid.columns, 8);
    EXPECT_EQ(common.grid.rows, 5);
    ASSERT_EQ(common.contacts.size(), 2u);
    EXPECT_EQ(case_of_parts(common, 0, 1), 'a');
    EXPECT_EQ(case_of_parts(common, 1, 2), 'd');
    EXPECT_EQ(case_of_parts(common, 0, 2), 'e');
    EXPECT_EQ(common.contacts[0].its_case.cells[0], (std::vector<int>{11, 12}));
    EXPECT_EQ(common.contacts[1].its_case.cells[0], (std::vector<int>{27, 28}));
    EXPECT_EQ(common.contacts[1].its_case.cells[1], (std::vector<int>{35, 36}));
    const std::vector<std::array<int, 4>> boxes{{2, 0, 4, 2}, {3, 1, 2, 3}, {0, 4, 8, 1}};
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const CellRange& box = common.split[p];
        EXPECT_EQ((std::array{box.column, box.row, box.columns, box.rows}), boxes[p]) << p;
        const Grid grid = split_grid(common, static_cast<int>(p));
        EXPECT_EQ(grid.columns(), box.columns);
        EXPECT_EQ(grid.rows(), box.rows);
        EXPECT_NEAR(cut_cells(parts[p], grid).area, area(parts[p]), 1e-12);
    }
}

TEST(CommonGrid, PartsWithoutCellsHaveAnEmptyGrid) {
    const CommonGrid common = grid_of({block(0, 0, 4, 4), block(2 - 1e-11, 1, 2 + 1e-11, 3)}, 1);
    EXPECT_EQ(common.split[1].n_cells(), 0u);
    EXPECT_TRUE(split_grid(common, 1).x.empty());
    EXPECT_EQ(common.split[0].n_cells(), 16u);
}

TEST(CommonGrid, RefusesWhatItCannotHold) {
    const Part wide = block(0, 0, 2000, 2000);
    EXPECT_TRUE(grid_of({wide}, 1).refusal.empty());  // as many cells as there may be
    EXPECT_NE(grid_of({wide}, 0.999).refusal.find(std::to_string(most_common_cells)), std::string::npos);
    EXPECT_FALSE(grid_of({wide, wide}, 1.01).refusal.empty());  // each alone would do
    EXPECT_TRUE(grid_of({wide, block(0, 0, 1, 1)}, 1.01).refusal.empty());
    for (const double size : {0.0, -1.0, std::nan("")}) EXPECT_FALSE(grid_of({wide}, size).refusal.empty());
    EXPECT_FALSE(grid_of({wide}, 1e-300).refusal.empty());
    EXPECT_FALSE(grid_of({}, 1).refusal.empty());
}

// ---- sweeps over parts of all kinds ----

struct RandomPair {
    std::vector<Part> parts;
    double cell;
};

/// Kinds, places and cell sizes at random; now and then blocks whose sides are grid lines.
RandomPair random_pair(Random& random) {
    if (random() % 8 == 0) {
        const auto whole = [&](int most) { return static_cast<double>(1 + random() % static_cast<unsigned>(most)); };
        const double x = whole(4) + (random() % 2 == 0 ? 0 : 0.5), y = whole(4) - 2;
        return {{block(0, 0, whole(3), whole(3)), block(x, y, x + whole(3), y + whole(3))}, 1};
    }
    const auto kind = [&] { return static_cast<int>(random() % test::n_part_kinds); };
    const Vec2 d(test::between(-3, 3, random), test::between(-3, 3, random));
    return {{test::random_part(kind(), random), transformed(test::random_part(kind(), random), 1, 0, d)},
            std::pow(10.0, test::between(-1.5, 0, random))};
}

/// The case and its cells straight from the definition: every cell of one part with every cell of the other.
CaseCells by_definition(const CommonGrid& common) {
    struct Cell {
        int column, row;
        CellClass cell_class;
    };
    const auto filled = [&](const CellClasses& part) {
        std::vector<Cell> cells;
        for (int row = 0; row < common.grid.rows; ++row)
            for (int column = 0; column < common.grid.columns; ++column)
                if (part.at(column, row) != CellClass::outer) cells.push_back({column, row, part.at(column, row)});
        return cells;
    };
    const auto number = [&](const Cell& c) { return c.row * common.grid.columns + c.column; };
    std::map<char, std::array<std::set<int>, 2>> found;
    const std::vector<Cell> cells1 = filled(common.parts[0]), cells2 = filled(common.parts[1]);
    for (const Cell& a : cells1)
        for (const Cell& b : cells2) {
            const int apart = std::abs(a.column - b.column) + std::abs(a.row - b.row);
            const int n_inner = (a.cell_class == CellClass::inner) + (b.cell_class == CellClass::inner);
            if (apart > 1) continue;
            auto& pair = found[n_inner == 0 ? (apart == 0 ? 'a' : 'b') : n_inner == 1 ? 'c' : 'd'];
            pair[0].insert(number(a));
            pair[1].insert(number(b));
        }
    if (found.empty()) return {};
    const auto& [letter, cells] = *found.begin();
    return {letter, {std::vector<int>(cells[0].begin(), cells[0].end()), std::vector<int>(cells[1].begin(), cells[1].end())}};
}

TEST(CommonGrid, AgreesWithTheDefinitionAndWithTheCaseOfThePair) {
    Random random(20100607);
    std::map<char, int> seen;
    for (int run = 0; run < 800; ++run) {
        SCOPED_TRACE(run);
        const RandomPair pair = random_pair(random);
        const CommonGrid common = grid_of(pair.parts, pair.cell);
        ASSERT_TRUE(common.refusal.empty());
        const char letter = case_of_parts(common, 0, 1);
        ++seen[letter];
        EXPECT_EQ(letter, cell_case(pair.parts[0], pair.parts[1], pair.cell));
        if (common.grid.n_cells() > 2500) continue;  // every cell with every cell takes long
        const CaseCells expected = by_definition(common);
        EXPECT_EQ(letter, expected.letter);
        if (letter == 'e') continue;
        EXPECT_EQ(common.contacts[0].its_case.cells, expected.cells);
    }
    for (const char letter : {'a', 'b', 'c', 'd', 'e'}) EXPECT_GE(seen[letter], 8) << letter;
}

/// Points of all edges, one after the other at most `step` apart.
template <class Visit>
void along_boundary(const Part& part, double step, Visit visit) {
    for (const Edge& edge : part.edges) {
        const int n = 4 + static_cast<int>(4 * length(edge.curve) / step);  // parameters may run unevenly
        for (int i = 0; i <= n; ++i) visit(point(edge.curve, static_cast<double>(i) / n));
    }
}

TEST(CommonGrid, BoundaryCellsAreWhereTheBoundaryIsAndInnerOnesInside) {
    Random random(45);
    int n_inner = 0, n_boundary = 0;
    for (int run = 0; run < 40; ++run) {
        SCOPED_TRACE(run);
        const RandomPair pair = random_pair(random);
        const CommonGrid common = grid_of(pair.parts, pair.cell);
        const UniformGrid& grid = common.grid;
        for (std::size_t p = 0; p < 2; ++p) {
            const Part& part = pair.parts[p];
            std::set<std::array<int, 2>> near;  // cells that the boundary comes within a step of
            const double step = 0.1;            // of a cell
            along_boundary(part, step * grid.cell, [&](const Vec2& x) {
                const Vec2 c = grid.in_cells(x), low = (c.array() - step).floor(), high = (c.array() + step).floor();
                const Vec2 inside = (c.array() - c.array().floor() - 0.5).abs();
                if (inside.maxCoeff() < 0.5 - 1e-6) {
                    EXPECT_EQ(common.parts[p].at(static_cast<int>(std::floor(c.x())), static_cast<int>(std::floor(c.y()))),
                              CellClass::boundary);
                }
                for (const double i : {low.x(), high.x()})
                    for (const double k : {low.y(), high.y()}) near.insert({static_cast<int>(i), static_cast<int>(k)});
            });
            for (int row = 0; row < grid.rows; ++row)
                for (int column = 0; column < grid.columns; ++column) {
                    const CellClass c = common.parts[p].at(column, row);
                    n_boundary += c == CellClass::boundary;
                    n_inner += c == CellClass::inner;
                    if (c == CellClass::boundary) {
                        EXPECT_TRUE(near.count({column, row}));
                        continue;
                    }
                    EXPECT_EQ(c == CellClass::inner, contains(part, grid.point(column + 0.5, row + 0.5)));
                }
        }
    }
    EXPECT_GT(n_inner, 5000);
    EXPECT_GT(n_boundary, 3000);
}

TEST(CommonGrid, CellsOfABoxAreThoseOfTheWholeGrid) {
    Random random(47);
    for (int run = 0; run < 200; ++run) {
        SCOPED_TRACE(run);
        const RandomPair pair = random_pair(random);
        const CommonGrid common = grid_of(pair.parts, pair.cell);
        const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
        CellRange box{below(common.grid.columns), below(common.grid.rows)};
        box.columns = 1 + below(common.grid.columns - box.column);
        box.rows = 1 + below(common.grid.rows - box.row);
        for (std::size_t p = 0; p < 2; ++p) {
            const CellClasses some = classify_cells(pair.parts[p], common.grid, box);
            for (int row = box.row; row < box.row + box.rows; ++row)
                for (int column = box.column; column < box.column + box.columns; ++column)
                    EXPECT_EQ(some.at(column, row), common.parts[p].at(column, row)) << column << " " << row;
        }
    }
}

TEST(CommonGrid, SplitGridsHoldAllCellsOfTheirPartAndNoRowTooMany) {
    Random random(48);
    for (int run = 0; run < 200; ++run) {
        SCOPED_TRACE(run);
        const RandomPair pair = random_pair(random);
        const CommonGrid common = grid_of(pair.parts, pair.cell);
        for (std::size_t p = 0; p < 2; ++p) {
            std::set<int> columns, rows;
            for (int row = 0; row < common.grid.rows; ++row)
                for (int column = 0; column < common.grid.columns; ++column) {
                    if (common.parts[p].at(column, row) == CellClass::outer) continue;
                    columns.insert(column);
                    rows.insert(row);
                }
            ASSERT_FALSE(columns.empty());
            const CellRange& box = common.split[p];
            EXPECT_EQ(box.column, *columns.begin());
            EXPECT_EQ(box.column + box.columns - 1, *columns.rbegin());
            EXPECT_EQ(box.row, *rows.begin());
            EXPECT_EQ(box.row + box.rows - 1, *rows.rbegin());
            const Grid grid = split_grid(common, static_cast<int>(p));
            const double whole = area(pair.parts[p]);
            EXPECT_NEAR(cut_cells(pair.parts[p], grid).area, whole, 1e-9 * whole);
        }
    }
}

}  // namespace
}  // namespace abut::geometry::common_grid_test
