// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/part_grid.hpp"

#include <gtest/gtest.h>

#include <random>

#include "src/discretization/discretize.hpp"
#include "src/scene/read_scene.hpp"

namespace part_grid_test {

namespace {

using namespace abut;
using geometry::Box2;
using geometry::Grid;

Scene square_scene(const std::string& accuracy = "") {
    return read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0.3}},
        "parts": [{"name": "p", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}}],
        "supports": [{"on": "p/bottom", "fix": ["x", "y"]}])" +
                               accuracy + "}",
                           "s.json");
}

/// The largest side of the cells that touch a place of the part.
double cell_at(const PartGrid& grid, const Vec2& place) {
    const Vec2 local = grid.frame.to_local(place);
    double largest = 0;
    grid.grid.for_cells_in({local, local},
                           [&](int cell) { largest = std::max(largest, grid.grid.box(cell).size().maxCoeff()); });
    return largest;
}

std::vector<WantedSize> random_places(int n, double size) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<WantedSize> wanted;
    for (int k = 0; k < n; ++k) wanted.push_back({{{unit(random), unit(random)}}, size, size_growth});
    return wanted;
}

/// Lines of the deepest level are more than an int counts where the base has many.
TEST(PartGrid, LongPartsAreHalvedAsDeepAsTheirLinesCanBeCounted) {
    const Scene scene = read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0.3}}, "parts": [
        {"name": "leaf", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [400, 1]}}}]})",
                                        "s.json");
    const PartGrid grid = grid_of_part(scene, 0, {{{{400, 0}}, 1e-12, size_growth}}, 1, 1);
    ASSERT_TRUE(grid.grid.tree);
    EXPECT_GT(grid.grid.columns(), 128);
    EXPECT_GT(grid.too_fine, 0);
    const PartOnGrid on_grid = discretize(scene, 0, grid.frame, grid.grid, grid.degree);
    EXPECT_TRUE(on_grid.input.space.failure.empty()) << on_grid.input.space.failure;
}

TEST(PartGrid, PartsTooThinForAnyCellsAreRefused) {
    const Scene scene = read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0.3}}, "parts": [
        {"name": "foil", "material": "m", "geometry": {"rectangle": {"min": [2, 10], "max": [18, 10.000000000001]}}}]})",
                                        "s.json");
    try {
        grid_of_part(scene, 0, {}, 1, 1);
        FAIL() << "a grid of 1e13 cells";
    } catch (const InputError& error) { EXPECT_EQ(error.problems().front().where, "/parts/0"); }
}

TEST(PartGrid, ManySmallPlacesAreHalvedCells) {
    const Scene scene = square_scene();
    const std::vector<WantedSize> wanted = random_places(20, 1e-4);
    const PartGrid grid = grid_of_part(scene, 0, wanted, 1, 1);
    ASSERT_TRUE(grid.grid.tree);
    EXPECT_FALSE(grid.limited);
    for (const WantedSize& w : wanted) EXPECT_LE(cell_at(grid, w.points[0]), 1.0001e-4);
    // a level's leaves, up to half as large as they may be, reach 2 / size_growth of them each way: at most 75 without those of
    // the next level, of 10 levels around a place; lines through all of them would make (20 x 40)^2 cells
    EXPECT_LT(grid.grid.n_cells(), 20 * 10 * 75);
}

TEST(PartGrid, CellsGrowWithTheDistanceAsTheyMay) {
    const Scene scene = square_scene();
    const std::vector<WantedSize> wanted = random_places(3, 1e-3);
    const PartGrid grid = grid_of_part(scene, 0, wanted, 1, 1);
    ASSERT_TRUE(grid.grid.tree);
    for (int cell = 0; cell < grid.grid.n_cells(); ++cell) {
        const Box2 box = grid.grid.box(cell);
        for (const WantedSize& w : wanted) {
            const Vec2 p = grid.frame.to_local(w.points[0]);
            const double distance = (p - p.cwiseMax(box.min).cwiseMin(box.max)).norm();
            EXPECT_LE(box.size().maxCoeff(), 1.0001 * (w.size + w.growth * distance));
        }
    }
}

TEST(PartGrid, OneWishThatLinesServeAsWellGetsLines) {
    const PartGrid grid = grid_of_part(square_scene(), 0, {{{{0, 0.5}, {1, 0.5}}, 0.03, size_growth}}, 1, 1);
    EXPECT_FALSE(grid.grid.tree);
}

TEST(PartGrid, WherePartsEndInWedgesMakesNoDifference) {
    // scan lines for walls cross the tips of this groove's lips, and its bottom, at any distance from the corner
    for (int k = 0; k < 60; ++k) {
        const std::string angle = std::to_string(-5 + 10.0 * k / 59), depth = std::to_string(25 + 1.5 * k);
        const Scene scene = read_scene_text(
            R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0.3}}, "parts": [{"name": "p", "material": "m", "geometry":
                {"polygon": [[-60, -30], [60, -30], [60, )" +
                depth + R"(], [0, 0], [-60, )" + depth + R"(]]}, "place": {"rotate": )" + angle +
                R"(}}], "supports": [{"on": "p/e0", "fix": ["x", "y"]}]})",
            "s.json");
        const PartGrid grid = grid_of_part(scene, 0, {{{{10, 15}}, 0.4, size_growth}, {{{-12, 16}}, 0.4, size_growth}}, 2, 1);
        EXPECT_LT(grid.grid.n_cells(), 3000) << k;
    }
}

TEST(PartGrid, BoxesOfTheSceneHalveCells) {
    const std::string grids = R"(, "accuracy": {"grids": {"p": {"cells": [4, 4], "refine": [)";
    const Scene scene = square_scene(grids + R"({"from": [0.3, 0.3], "to": [0.4, 0.35], "levels": 3}]}}})");
    const PartGrid grid = grid_of_part(scene, 0, {}, 1, 1);
    ASSERT_TRUE(grid.grid.tree);
    EXPECT_NEAR(cell_at(grid, {0.35, 0.32}), 0.25 / 8, 1e-12);
    EXPECT_NEAR(cell_at(grid, {0.9, 0.9}), 0.25, 1e-12);
    const Scene beside = square_scene(grids + R"({"from": [2, 2], "to": [3, 3]}]}}})");
    EXPECT_THROW(grid_of_part(beside, 0, {}, 1, 1), InputError);
    const Scene too_many = square_scene(grids + R"({"from": [0, 0], "to": [1, 1], "levels": 20}]}}})");
    EXPECT_THROW(grid_of_part(too_many, 0, {}, 1, 1), InputError);
}

}  // namespace

}  // namespace part_grid_test
