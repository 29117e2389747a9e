// SPDX-License-Identifier: GPL-3.0-or-later
// Trees of cells against the tensor grid that has all their lines; what must hold of cells of any grid is in
// random_cells_test.cpp and elements_test.cpp.
#include "geometry/cells/tree_grid.hpp"

#include <gtest/gtest.h>

#include "geometry/cells/elements.hpp"
#include "tests/geometry/cells/slotted_parts.hpp"

namespace tree_grid_test {

namespace {

using namespace abut;
using namespace abut::geometry;
using namespace abut::geometry::test;

std::vector<double> halved(const std::vector<double>& lines, int level) {
    std::vector<double> all;
    const int n = (static_cast<int>(lines.size()) - 1) << level;
    for (int k = 0; k <= n; ++k) all.push_back(level_line(lines, level, k));
    return all;
}

/// The largest difference between a leaf's fraction and that of the finest level's cells in it.
double difference_from_finest(const CutCells& cells, const CutCells& finest) {
    const Quadtree& tree = *cells.grid.tree;
    double worst = 0;
    for (int leaf = 0; leaf < tree.n_leaves(); ++leaf) {
        const TreeCell c = tree.leaf(leaf);
        const int n = 1 << (tree.levels() - c.level);
        double sum = 0;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) sum += finest.fraction[at(finest.grid.cell(c.column * n + i, c.row * n + j))];
        worst = std::max(worst, std::abs(sum / n / n - cells.fraction[at(leaf)]));
    }
    return worst;
}

TEST(TreeGrid, LeavesHoldWhatTheFinestCellsHold) {
    for (unsigned k = 0; k < 120; ++k) {
        Random random(k);
        SCOPED_TRACE("case " + std::to_string(k));
        const int kind = static_cast<int>(k) % (n_slotted_kinds + n_part_kinds);
        const Part part = kind < n_slotted_kinds ? slotted_part(kind, random) : random_part(kind - n_slotted_kinds, random);
        const CutCells cells = cut_cells(part, random_tree(part, random));
        const int levels = cells.grid.tree->levels();
        const CutCells finest = cut_cells(part, {halved(cells.grid.x, levels), halved(cells.grid.y, levels)});
        EXPECT_LT(difference_from_finest(cells, finest), 1e-12);
    }
}

TEST(TreeGrid, NeighboursAreOneLevelApartAtMost) {
    for (unsigned k = 0; k < 60; ++k) {
        Random random(k);
        const Part part = random_part(static_cast<int>(k % n_part_kinds), random);
        const CutCells cells = cut_cells(part, random_tree(part, random));
        for (int leaf = 0; leaf < cells.grid.n_cells(); ++leaf)
            cells.grid.for_cells_in(cells.grid.box(leaf), [&](int other) {
                if (cells.cell_class[at(leaf)] == CellClass::outer || cells.cell_class[at(other)] == CellClass::outer) return;
                EXPECT_LE(std::abs(cells.grid.tree->leaf(leaf).level - cells.grid.tree->leaf(other).level), 1);
            });
    }
}

Part unit_square() {
    return polygon_part({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
}

TEST(TreeGrid, WithoutAWishIsItsBase) {
    const Grid base{{-0.5, 0.25, 1.5}, {-0.25, 0.5, 1.25}};
    const Part part = unit_square();
    const Grid grid = tree_grid(part, base, [](const Box2&, int) { return false; });
    const CutCells cells = cut_cells(part, grid), plain = cut_cells(part, base);
    EXPECT_EQ(cells.fraction, plain.fraction);
    EXPECT_EQ(cells.first_contour, plain.first_contour);
    EXPECT_EQ(cells.pieces.size(), plain.pieces.size());
}

TEST(TreeGrid, CostsWhatItHolds) {
    const Part part = unit_square();
    const Vec2 corner(1.0 / 3, 0);
    const Grid grid = tree_grid(part, {{0, 0.5, 1}, {0, 0.5, 1}}, [&](const Box2& cell, int level) {
        return level < 26 && cell.overlaps({corner, corner}, 0);
    });
    EXPECT_LT(grid.n_cells(), 26 * 20);
    const CutCells cells = cut_cells(part, grid);
    EXPECT_NEAR(cells.area, 1, 1e-13);
    EXPECT_LT(cells.contours.size(), 26 * 20u);
}

TEST(TreeGrid, FindsTheCellsOfPlacesAndBoxes) {
    Random random(3);
    const Part part = random_part(0, random);
    const CutCells cells = cut_cells(part, random_tree(part, random));
    const Grid& grid = cells.grid;
    for (int cell = 0; cell < grid.n_cells(); ++cell) {
        EXPECT_EQ(grid.cell_at(grid.box(cell).center()), cell);
        std::vector<int> found, expected;
        grid.for_cells_in(grid.box(cell), [&](int other) { found.push_back(other); });
        for (int other = 0; other < grid.n_cells(); ++other)
            if (grid.box(other).overlaps(grid.box(cell), 0)) expected.push_back(other);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected);
        std::vector<int> across;
        grid.for_cells_across(cell, 1, 0, [&](int other) { across.push_back(other); });
        for (int other : across) EXPECT_EQ(grid.box(other).min.x(), grid.box(cell).max.x());
        double height = 0;
        for (int other : across)
            height += std::min(grid.box(other).max.y(), grid.box(cell).max.y()) -
                      std::max(grid.box(other).min.y(), grid.box(cell).min.y());
        EXPECT_NEAR(height, across.empty() ? 0 : grid.box(cell).size().y(), 1e-12);
    }
}

}  // namespace

}  // namespace tree_grid_test
